// SPDX-License-Identifier: GPL-2.0-or-later
// The helpers of emitted C over vectors, as they have to be. They are written down here once more, not taken from the
// templates. What they compute is that of flatdyn's sincos.hpp.
#pragma once

namespace flatdyn {

inline constexpr const char* kLanesTypes = R"(
#if defined __AVX512F__
enum { $lanes$_bytes = 64 };
#elif defined __AVX__
enum { $lanes$_bytes = 32 };
#else
enum { $lanes$_bytes = 16 };
#endif
typedef $real$ $lanes$ __attribute__((vector_size($lanes$_bytes)));
static const size_t $lanes$_count = sizeof($lanes$) / sizeof($real$);
typedef $integer$ $mask$ __attribute__((vector_size($lanes$_bytes)));
static inline $lanes$ $lanes$_all($real$ x) {
  const $lanes$ zeros = {0};
  return x - zeros;
}
static inline $lanes$ $lanes$_where($mask$ condition, $lanes$ yes,
    $lanes$ no) {
  return ($lanes$)((condition & ($mask$)yes) | (~condition & ($mask$)no));
}
)";

inline constexpr const char* kLanesSign = R"(
static inline $lanes$ $lanes$_sign($lanes$ x) {
  const $lanes$ zeros = {0}, ones = $lanes$_all(1.0);
  return $lanes$_where(x > zeros, ones, zeros) - $lanes$_where(x < zeros, ones, zeros);
}
)";

inline constexpr const char* kLanesExcess = R"(
static inline $lanes$ $lanes$_excess($lanes$ sum, $lanes$ term) {
  const $lanes$ zeros = {0};
  return $lanes$_where(($mask$)sum > ($mask$)term, $lanes$_all(1.0), zeros);
}
)";

inline constexpr const char* kLanesSqrt = R"(
static inline $lanes$ $lanes$_sqrt($lanes$ x) {
  for (size_t lane = 0; lane < $lanes$_count; ++lane) x[lane] = sqrt(x[lane]);
  return x;
}
)";

inline constexpr const char* kLanesRows = R"(
static inline size_t $lanes$_states(size_t left) {
  return left < $lanes$_count ? left : $lanes$_count;
}
typedef $real$ $lanes$_piece __attribute__((vector_size(16)));
typedef $real$ $lanes$_piece_there
    __attribute__((vector_size(16), aligned(sizeof($real$)), may_alias));
enum { $lanes$_side = sizeof($lanes$_piece) / sizeof($real$) };
static inline $lanes$_piece $lanes$_piece_at(const $real$* from) {
  return *(const $lanes$_piece_there*)from;
}
static inline void $lanes$_put($lanes$_piece piece, $real$* to) {
  *($lanes$_piece_there*)to = piece;
}
#if defined __clang__
static inline $lanes$_piece $lanes$_first_halves($lanes$_piece a, $lanes$_piece b) {
  return __builtin_shufflevector(a, b, $first_halves$);
}
static inline $lanes$_piece $lanes$_second_halves($lanes$_piece a, $lanes$_piece b) {
  return __builtin_shufflevector(a, b, $second_halves$);
}
#else
typedef $integer$ $lanes$_places __attribute__((vector_size(16)));
static inline $lanes$_piece $lanes$_first_halves($lanes$_piece a, $lanes$_piece b) {
  return __builtin_shuffle(a, b, ($lanes$_places){ $first_halves$ });
}
static inline $lanes$_piece $lanes$_second_halves($lanes$_piece a, $lanes$_piece b) {
  return __builtin_shuffle(a, b, ($lanes$_places){ $second_halves$ });
}
#endif
)";

inline constexpr const char* kLanesSquareOfDoubles = R"(
static inline void $lanes$_transpose_square(const $real$* restrict from, size_t from_step,
    $real$* restrict to, size_t to_step) {
  const $lanes$_piece a = $lanes$_piece_at(from), b = $lanes$_piece_at(from + from_step);
  $lanes$_put($lanes$_first_halves(a, b), to);
  $lanes$_put($lanes$_second_halves(a, b), to + to_step);
}
)";

inline constexpr const char* kLanesSquareOfFloats = R"(
static inline void $lanes$_transpose_square(const $real$* restrict from, size_t from_step,
    $real$* restrict to, size_t to_step) {
  const $lanes$_piece a = $lanes$_piece_at(from), b = $lanes$_piece_at(from + from_step);
  const $lanes$_piece c = $lanes$_piece_at(from + 2 * from_step);
  const $lanes$_piece d = $lanes$_piece_at(from + 3 * from_step);
  const $lanes$_piece ac = $lanes$_first_halves(a, c), bd = $lanes$_first_halves(b, d);
  $lanes$_put($lanes$_first_halves(ac, bd), to);
  $lanes$_put($lanes$_second_halves(ac, bd), to + to_step);
  const $lanes$_piece last_ac = $lanes$_second_halves(a, c);
  const $lanes$_piece last_bd = $lanes$_second_halves(b, d);
  $lanes$_put($lanes$_first_halves(last_ac, last_bd), to + 2 * to_step);
  $lanes$_put($lanes$_second_halves(last_ac, last_bd), to + 3 * to_step);
}
)";

inline constexpr const char* kLanesTransposes = R"(
static inline void $lanes$_transpose(const $real$* restrict from, size_t from_step,
    size_t rows, size_t columns, $real$* restrict to, size_t to_step) {
  const size_t last_row = rows - $lanes$_side, last_column = columns - $lanes$_side;
  for (size_t j = 0; j < columns; j += $lanes$_side) {
    const size_t column = j < last_column ? j : last_column;
    for (size_t i = 0; i < rows; i += $lanes$_side) {
      const size_t row = i < last_row ? i : last_row;
      $lanes$_transpose_square(from + from_step * row + column, from_step,
          to + to_step * column + row, to_step);
    }
  }
}
static inline void $lanes$_read(const $real$* restrict rows, size_t step, size_t states,
    size_t length, $lanes$* restrict block) {
  $real$* const numbers = ($real$*)block;
  if (states == $lanes$_count && length >= $lanes$_side) {
    $lanes$_transpose(rows, step, $lanes$_count, length, numbers, $lanes$_count);
    return;
  }
  for (size_t lane = 0; lane < $lanes$_count; ++lane) {
    const $real$* row = rows + step * (lane < states ? lane : states - 1);
    for (size_t entry = 0; entry < length; ++entry) {
      numbers[$lanes$_count * entry + lane] = row[entry];
    }
  }
}
static inline void $lanes$_write(const $lanes$* restrict block, size_t states, size_t length,
    $real$* restrict rows) {
  const $real$* const numbers = (const $real$*)block;
  if (states == $lanes$_count && length >= $lanes$_side) {
    $lanes$_transpose(numbers, $lanes$_count, length, $lanes$_count, rows, length);
    return;
  }
  for (size_t lane = 0; lane < states; ++lane) {
    for (size_t entry = 0; entry < length; ++entry) {
      rows[length * lane + entry] = numbers[$lanes$_count * entry + lane];
    }
  }
}
)";

inline constexpr const char* kLanesNoNumber = R"(
static inline void $lanes$_or_not_a_number($mask$ $verdict$, size_t length,
    $lanes$* restrict block) {
  for (size_t entry = 0; entry < length; ++entry) {
    block[entry] = $lanes$_where($verdict$, block[entry], $lanes$_all(($real$)NAN));
  }
}
)";

inline constexpr const char* kLanesReducedAngles = R"(
static const $real$ $lanes$_reduced_angles = $reduced_angles$;
typedef unsigned $integer$ $lanes$_bits __attribute__((vector_size($lanes$_bytes)));
static const unsigned $integer$ $lanes$_next = $next$;
)";

inline constexpr const char* kLanesReductionOfDoubles = R"(
static inline $lanes$_bits $lanes$_reduced($lanes$ x, $lanes$* restrict r,
    $lanes$* restrict missing) {
  const $lanes$ turns = x * $lanes$_all(0x1.45f306dc9c883p-1) + $lanes$_all(0x1.8p+52);
  const $lanes$_bits quadrant = ($lanes$_bits)turns;
  const $lanes$ n = ($lanes$)(quadrant + $lanes$_next) - $lanes$_all(0x1.c000000000001p+52);
  const $lanes$ above = x - n * $lanes$_all(0x1.921fb544p+0);
  const $lanes$ below = n * $lanes$_all(0x1.0b4611a6p-34);
  *r = above - below;
  *missing = (below - (above - *r)) + n * $lanes$_all(0x1.3198a2e037073p-69);
  return quadrant;
}
)";

inline constexpr const char* kLanesReductionOfFloats = R"(
static inline $lanes$_bits $lanes$_reduced($lanes$ x, $lanes$* restrict r,
    $lanes$* restrict missing) {
  const $lanes$ turns = x * $lanes$_all(0x1.45f306p-1f) + $lanes$_all(0x1.8p+23f);
  const $lanes$_bits quadrant = ($lanes$_bits)turns;
  const $lanes$ n = ($lanes$)(quadrant + $lanes$_next) - $lanes$_all(0x1.c00002p+23f);
  const $lanes$ above = (x - n * $lanes$_all(0x1.922p+0f)) - n * $lanes$_all(-0x1.2cp-18f);
  const $lanes$ below = n * $lanes$_all(0x1.11p-26f);
  *r = above - below;
  *missing = (below - (above - *r)) + n * $lanes$_all(0x1.68c234p-39f);
  return quadrant;
}
)";

inline constexpr const char* kLanesSineNearZero = R"(
static inline $lanes$ $lanes$_sine_near_zero($lanes$ r, $lanes$ missing) {
)";

inline constexpr const char* kLanesCosineNearZero = R"(
static inline $lanes$ $lanes$_cosine_near_zero($lanes$ r, $lanes$ missing) {
)";

inline constexpr const char* kLanesSines = R"(
static inline $lanes$ $lanes$_with_sign_of($lanes$_bits quadrant, $lanes$ x) {
  return ($lanes$)(($lanes$_bits)x ^ ((quadrant & 2u) << (8 * sizeof($real$) - 2)));
}
static inline void $lanes$_sine_and_cosine($lanes$ x, $lanes$* restrict sine,
    $lanes$* restrict cosine) {
  $lanes$ r, missing;
  const $lanes$_bits quadrant = $lanes$_reduced(x, &r, &missing);
  const $lanes$ s = $lanes$_sine_near_zero(r, missing), c = $lanes$_cosine_near_zero(r, missing);
  const $mask$ is_swapped = ($mask$)-(quadrant & 1u);
  *sine = $lanes$_with_sign_of(quadrant, $lanes$_where(is_swapped, c, s));
  *cosine = $lanes$_with_sign_of(quadrant + $lanes$_next, $lanes$_where(is_swapped, s, c));
}
static inline bool $lanes$_is_large($real$ x) {
  return !(x <= $lanes$_reduced_angles && x >= -$lanes$_reduced_angles);
}
static __attribute__((noinline)) void $lanes$_ask_library(const $lanes$* restrict q, int first, int last,
    $lanes$* restrict sine, $lanes$* restrict cosine) {
  for (int joint = first; joint <= last; ++joint) {
    for (size_t lane = 0; lane < $lanes$_count; ++lane) {
      if (!$lanes$_is_large(q[joint][lane])) continue;
      sine[joint][lane] = sin$f$(q[joint][lane]);
      cosine[joint][lane] = cos$f$(q[joint][lane]);
    }
  }
}
static inline bool $lanes$_holds_in_all($mask$ condition) {
  typedef long long halves __attribute__((vector_size(16), may_alias));
  const halves* const part = (const halves*)&condition;
  halves all = part[0];
  for (size_t k = 1; k < sizeof condition / sizeof all; ++k) all &= part[k];
  return (all[0] & all[1]) == -1;
}
static inline void $lanes$_sines_and_cosines(const $lanes$* restrict q, int first, int last,
    $lanes$* restrict sine, $lanes$* restrict cosine) {
  const $lanes$ most = $lanes$_all($lanes$_reduced_angles);
  $mask$ are_small = most == most;
  for (int joint = first; joint <= last; ++joint) {
    $lanes$_sine_and_cosine(q[joint], &sine[joint], &cosine[joint]);
    are_small &= (q[joint] <= most) & (q[joint] >= -most);
  }
  if (!$lanes$_holds_in_all(are_small)) $lanes$_ask_library(q, first, last, sine, cosine);
}
)";

}  // namespace flatdyn
