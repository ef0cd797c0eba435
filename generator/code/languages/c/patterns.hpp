// SPDX-License-Identifier: GPL-2.0-or-later
// The helpers of emitted C, as they have to be. They are written down here once more, not taken from the templates.
#pragma once

namespace flatdyn {

// The lines before the declarations of a header.
inline constexpr const char* kCStandard = R"(
#if !defined(__cplusplus) && (!defined(__STDC_VERSION__) || __STDC_VERSION__ < 199901L)
#error "this needs C99: compile it with -std=c99, or a later standard"
#endif
#include <stdbool.h>
#ifndef $nodiscard$
#if defined(__cplusplus) && __cplusplus >= 201703L
#define $nodiscard$ [[nodiscard]]
#elif !defined(__cplusplus) && __STDC_VERSION__ > 201710L
#define $nodiscard$ [[nodiscard]]
#elif defined(__GNUC__)
#define $nodiscard$ __attribute__((warn_unused_result))
#else
#define $nodiscard$
#endif
#endif
#ifdef __cplusplus
extern "C" {
#endif
)";

inline constexpr const char* kCSign = R"(
static $real$ $prefix$sign($real$ x) { return ($real$)((x > 0.0$f$) - (x < 0.0$f$)); }
)";

inline constexpr const char* kCExcess = R"(
static $real$ $prefix$excess($real$ sum, $real$ term) {
  $signed_bits$ bits_of_sum = 0, bits_of_term = 0;
  (void)memcpy(&bits_of_sum, &sum, sizeof(sum));
  (void)memcpy(&bits_of_term, &term, sizeof(term));
  return ($real$)(bits_of_sum > bits_of_term);
}
)";

inline constexpr const char* kCMultiplyAdd = R"(
static inline $real$ $prefix$fma($real$ a, $real$ b, $real$ c) {
#if defined(__FMA__) || defined(__aarch64__) || defined(__FP_FAST_FMA$F$) || \
    (defined(__ARM_FEATURE_FMA) && (__ARM_FP & $floats_bit$)) || \
    (defined(__riscv_flen) && __riscv_flen >= $floats_length$)
  return fma$f$(a, b, c);
#else
  return a * b + c;
#endif
}
)";

inline constexpr const char* kCSineAndCosine = R"(
static void $prefix$sine_and_cosine($real$ x, $real$* restrict sine, $real$* restrict cosine) {
)";

inline constexpr const char* kCPolynomialSines = R"(
static void $prefix$sines_and_cosines(const $real$* q, int first, int last,
    $real$* restrict sine, $real$* restrict cosine) {
  const $real$ most = $most_angle$;
  $real$ squares = 0.0$f$;
  for (int joint = first; joint <= last; ++joint) {
    $prefix$sine_and_cosine(q[joint], &sine[joint], &cosine[joint]);
    squares += q[joint] * q[joint];
  }
  const bool all_are_small = squares <= most * most;
  for (int joint = first; joint <= last && !all_are_small; ++joint) {
    if (!(q[joint] <= most && q[joint] >= -most)) {
      sine[joint] = sin$f$(q[joint]);
      cosine[joint] = cos$f$(q[joint]);
    }
  }
}
)";

inline constexpr const char* kCLibrarySines = R"(
static void $prefix$sines_and_cosines(const $real$* q, int first, int last, $real$* restrict sine,
    $real$* restrict cosine) {
  for (int joint = first; joint <= last; ++joint) {
    sine[joint] = sin$f$(q[joint]);
    cosine[joint] = cos$f$(q[joint]);
  }
}
)";

inline constexpr const char* kCCloseLoops = R"(
static $real$ $prefix$gap_at($parameters_argument$ const $real$* q) {
  $real$ phi[$rows$], sum = 0.0$f$;
  $closure$($parameters$ q, phi);
  for (int row = 0; row < $rows$; ++row) sum += phi[row] * phi[row];
  return sum;
}
bool $prefix$close_loops($parameters_argument$ $real$ q[$position_count$], $real$ tolerance, int most_steps) {
  $real$ here[$positions$], next[$positions$], dq[$positions$];
  for (int k = 0; k < $positions$; ++k) here[k] = q[k];
  $real$ gap = $prefix$gap_at($parameters$ here);
  for (int step = 0; step < most_steps && gap > tolerance * tolerance; ++step) {
    if (!$step$($parameters$ here, dq)) return false;
    $real$ next_gap = gap, size = 1.0$f$;
    for (int halving = 0; halving < 20 && !(next_gap < gap); ++halving, size *= 0.5$f$) {
      for (int k = 0; k < $positions$; ++k) next[k] = here[k] + size * dq[k];
      next_gap = $prefix$gap_at($parameters$ next);
    }
    if (!(next_gap < gap)) return false;
    for (int k = 0; k < $positions$; ++k) here[k] = next[k];
    gap = next_gap;
  }
  if (!(tolerance >= 0.0$f$ && gap <= tolerance * tolerance)) return false;
  for (int k = 0; k < $positions$; ++k) q[k] = here[k];
  return true;
}
)";

inline constexpr const char* kCIsZero = R"(
static bool $prefix$is_zero($real$ r) { return !(r < 0.0$f$) && !(r > 0.0$f$); }
)";

// The functions that rounding_is_as_written() calls, in this order; those about sines only if there are sines.
inline constexpr const char* kCFill = R"(
static void $prefix$fill($real$* x, int count, uint32_t seed) {
  uint32_t state = seed;
  for (int k = 0; k < count; ++k) {
    state = state * 1664525u + 1013904223u;
    x[k] = (($real$)(state >> 8) - 8388608.0$f$) / 8388608.0$f$;
  }
}
)";

inline constexpr const char* kCFillSines = R"(
static void $prefix$fill_sines($real$* sine, $real$* cosine, int count, uint32_t seed) {
  $prefix$fill(sine, count, seed);
  for (int k = 0; k < count; ++k) {
    const $real$ t = sine[k], square = t * t, divisor = 1.0$f$ + square;
    sine[k] = 2.0$f$ * t / divisor;
    cosine[k] = (1.0$f$ - square) / divisor;
  }
}
)";

inline constexpr const char* kCHash = R"(
static uint64_t $prefix$hash_of(const $real$* x, int count, uint64_t hash) {
  uint64_t sum = hash;
  for (int k = 0; k < count; ++k) {
    $bits$ bits = 0;
    if (x[k] < 0.0$f$ || x[k] >= 0.0$f$) {
      (void)memcpy(&bits, &x[k], sizeof(bits));
    }
    sum = (sum ^ bits) * 1099511628211u;
    sum ^= sum >> 32;
  }
  return sum;
}
)";

inline constexpr const char* kCPolynomialsAreRight = R"(
static bool $prefix$sines_are_right(void) {
  const volatile $real$ zero = 0.0$f$;
  static const $real$ angles[8] = {
      0.5$f$, 0.6875$f$, 1.28125$f$, 1.53125$f$, 1.796875$f$, 3.125$f$, 10.28125$f$, 11.125$f$
  };
  $real$ x[8], sine[8], cosine[8];
  for (int k = 0; k < 8; ++k) {
    x[k] = angles[k] + zero;
  }
  $prefix$sines_and_cosines(x, 0, 7, sine, cosine);
  const uint64_t hash = $prefix$hash_of(sine, 8, 14695981039346656037u);
  return $prefix$hash_of(cosine, 8, hash) == $hash_of_sines$u;
}
)";

inline constexpr const char* kCLibraryIsRight = R"(
static bool $prefix$sines_are_right(void) {
  const volatile $real$ zero = 0.0$f$;
  static const $real$ angles[8] = {
      0.5$f$, 0.6875$f$, 1.28125$f$, 1.53125$f$, 1.796875$f$, 3.125$f$, 10.28125$f$, 11.125$f$
  };
  static const $real$ sines[8] = {
      0.479425538604203$f$, 0.6346070800152693$f$, 0.9583735057581397$f$, 0.999218145922396$f$,
      0.9745528811569866$f$, 0.016591892229347906$f$, -0.7555360776363961$f$, -0.9916361774750792$f$
  };
  static const $real$ cosines[8] = {
      0.8775825618903728$f$, 0.7728349461524715$f$, 0.28551746612221973$f$, 0.03953601977196579$f$,
      -0.2241577164155103$f$, -0.9998623450816866$f$, -0.6551070411694638$f$, 0.12906467960915324$f$
  };
  $real$ x[8], sine[8], cosine[8];
  bool right = true;
  for (int k = 0; k < 8; ++k) {
    x[k] = angles[k] + zero;
  }
  $prefix$sines_and_cosines(x, 0, 7, sine, cosine);
  for (int k = 0; k < 8; ++k) {
    const $real$ a = (sine[k] - sines[k]) * $places$;
    const $real$ b = (cosine[k] - cosines[k]) * $places$;
    const $real$ c = sines[k] < 0.0$f$ ? -sines[k] : sines[k];
    const $real$ d = cosines[k] < 0.0$f$ ? -cosines[k] : cosines[k];
    right &= a <= c && -a <= c && b <= d && -b <= d;
  }
  return right;
}
)";

// The statements of rounding_is_as_written() before the known state.
inline constexpr const char* kCRounding = R"(
bool $prefix$rounding_is_as_written(void) {
  const int method = FLT_EVAL_METHOD;
  if (method != 0 && method != 16 $or_double$) return false;
  const volatile $real$ u = 0.1$f$, w = 0.7$f$, one = 1.0$f$, tiny = 1e-17$f$, nine = 9.0$f$, seven = 7.0$f$,
      half = 0.5$f$, zero = 0.0$f$, smallest = $smallest$;
  const volatile $real$ half_a_place = $half_a_place$;
  const volatile $real$ product = u * w, quotient = nine / seven, next = one + half_a_place;
  const $real$ x = one, y = tiny, nothing = zero;
  const $real$ infinite = one / nothing, no_number = nothing / nothing;
  if (!$prefix$is_zero(u * w - product) || !(next > one) || !$prefix$is_zero((x + y) - x) ||
      !$prefix$is_zero((x - y) - x) || !$prefix$is_zero(nine / 7.0$f$ - quotient) || !(smallest * half > 0.0$f$) ||
      !(1.0$f$ / (0.0$f$ - nothing) > 0.0$f$) || 0.0$f$ * infinite < 1.0$f$ || 0.0$f$ * no_number < 1.0$f$) {
    return false;
  }
)";

inline constexpr const char* kCKnownState = R"(
  const volatile uint32_t first = 0;
  const uint32_t seed = first;
  uint64_t hash = 14695981039346656037u;
)";

}  // namespace flatdyn
