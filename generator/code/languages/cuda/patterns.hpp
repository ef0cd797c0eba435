// SPDX-License-Identifier: GPL-2.0-or-later
// The helpers of emitted CUDA, as they have to be. They are written down here once more, not taken from the templates.
#pragma once

namespace flatdyn {

inline constexpr const char* kCudaIncludes = R"(
#include <stdint.h>
#include <string.h>
#include <cmath>
)";

inline constexpr const char* kCudaHead = R"(
#ifndef FLATDYN_FUNCTION
#ifdef __CUDACC__
#define FLATDYN_FUNCTION static __host__ __device__ __forceinline__
#define FLATDYN_MEMBER __host__ __device__ __forceinline__
#define FLATDYN_SELDOM static __host__ __device__ __noinline__
#else
#define FLATDYN_FUNCTION static inline
#define FLATDYN_MEMBER inline
#define FLATDYN_SELDOM static
#endif
#endif
)";

inline constexpr const char* kCudaSign = R"(
namespace detail {
template <class Scalar>
FLATDYN_FUNCTION Scalar sign(const Scalar& x) noexcept { return Scalar((x > Scalar(0.0)) - (x < Scalar(0.0))); }
})";

inline constexpr const char* kCudaSqrt = R"(
namespace detail {
template <class Scalar>
FLATDYN_FUNCTION Scalar sqrt(const Scalar& x) noexcept { using std::sqrt; return sqrt(x); }
})";

inline constexpr const char* kCudaExcess = R"(
namespace detail {
template <class Scalar>
struct Excess {
  static FLATDYN_MEMBER Scalar of(Scalar sum, Scalar term) noexcept { return sum - term; }
};
template <>
struct Excess<double> {
  static FLATDYN_MEMBER double of(double sum, double term) noexcept {
    int64_t bits_of_sum = 0, bits_of_term = 0;
    memcpy(&bits_of_sum, &sum, sizeof(sum));
    memcpy(&bits_of_term, &term, sizeof(term));
    return double(bits_of_sum > bits_of_term);
  }
};
template <>
struct Excess<float> {
  static FLATDYN_MEMBER float of(float sum, float term) noexcept {
    int32_t bits_of_sum = 0, bits_of_term = 0;
    memcpy(&bits_of_sum, &sum, sizeof(sum));
    memcpy(&bits_of_term, &term, sizeof(term));
    return float(bits_of_sum > bits_of_term);
  }
};
})";

inline constexpr const char* kCudaMultiplyAdd = R"(
namespace detail {
template <class Scalar>
struct MultiplyAdd {
  FLATDYN_MEMBER Scalar operator()(Scalar a, Scalar b, Scalar c) const noexcept {
#if defined(__CUDA_ARCH__) || defined(__FMA__) || defined(__aarch64__)
    return std::fma(a, b, c);
#else
    return a * b + c;
#endif
  }
};
})";

inline constexpr const char* kCudaStored = R"(
namespace detail {
template <class Scalar>
FLATDYN_FUNCTION Scalar stored(const Scalar* output, int entry) noexcept { return output[entry]; }
template <class Out>
FLATDYN_FUNCTION auto stored(const Out& output, int entry) noexcept -> decltype(output.stored(entry)) {
  return output.stored(entry);
}
})";

inline constexpr const char* kCudaLibrarySines = R"(
template <int... joint>
struct Joints {};
struct LibrarySinCos {
  template <class Scalar, class In, int... joint>
  FLATDYN_MEMBER void operator()(const In& q, Joints<joint...>, Scalar* s, Scalar* c) const noexcept {
    using std::cos;
    using std::sin;
    ((s[joint] = sin(q[joint]), c[joint] = cos(q[joint])), ...);
  }
};)";

// A function for numbers of this type, up to its statements.
inline constexpr const char* kCudaSineAndCosine = R"(
template <class = void>
FLATDYN_FUNCTION void sine_and_cosine($sine_number$ x, $sine_number$& sine, $sine_number$& cosine) noexcept {
)";

inline constexpr const char* kCudaSinesOfJoints = R"(
template <bool of_sine, class Scalar>
FLATDYN_SELDOM Scalar ask_library(Scalar most, Scalar x, Scalar known) noexcept {
  if (x <= most && x >= -most) return known;
  return of_sine ? std::sin(x) : std::cos(x);
}
template <class Scalar, class In, int... joint>
FLATDYN_FUNCTION void sines_and_cosines(const In& q, Joints<joint...>, Scalar* s, Scalar* c) noexcept {
  constexpr Scalar most = sizeof(Scalar) == sizeof(float) ? Scalar(6400.0) : Scalar(1e5);
  const Scalar x[] = {q[joint]...};
  Scalar squares = Scalar(0.0);
  int k = 0;
  ((sine_and_cosine(x[k], s[joint], c[joint]), squares += x[k] * x[k], ++k), ...);
  if (squares <= most * most) return;
  k = 0;
  ((s[joint] = ask_library<true>(most, x[k], s[joint]), c[joint] = ask_library<false>(most, x[k], c[joint]), ++k),
   ...);
}
}
struct PolynomialSinCos {
  template <class Scalar, class In, int... joint>
  FLATDYN_MEMBER void operator()(const In& q, Joints<joint...> all, Scalar* s, Scalar* c) const noexcept {
    detail::sines_and_cosines(q, all, s, c);
  }
};)";

inline constexpr const char* kCudaGivenSines = R"(
template <class Sine, class Cosine = Sine>
struct GivenSinCos {
  Sine sine;
  Cosine cosine;
  template <class Scalar, class In, int... joint>
  FLATDYN_MEMBER void operator()(const In&, Joints<joint...>, Scalar* s, Scalar* c) const noexcept {
    ((s[joint] = sine[joint], c[joint] = cosine[joint]), ...);
  }
};
using DefaultSinCos = $default_sines$;)";

inline constexpr const char* kCudaCloseLoops = R"(
template <class Scalar, class InOut>
[[nodiscard]] FLATDYN_FUNCTION bool close_loops($parameters_argument$ InOut q, Scalar tolerance, int most_steps = 20) noexcept {
  Scalar here[position_count], next[position_count], dq[position_count], phi[$rows$];
  const auto gap_at = [&](const Scalar* position) {
    $closure$<Scalar>($parameters$ position, phi);
    Scalar sum = Scalar(0.0);
    for (const Scalar& entry : phi) sum = sum + entry * entry;
    return sum;
  };
  for (int k = 0; k < position_count; ++k) here[k] = q[k];
  Scalar gap = gap_at(here);
  for (int step = 0; step < most_steps && gap > tolerance * tolerance; ++step) {
    if (!$step$<Scalar>($parameters$ here, dq)) return false;
    Scalar next_gap = gap, size = Scalar(1.0);
    for (int halving = 0; halving < 20 && !(next_gap < gap); ++halving, size = size * Scalar(0.5)) {
      for (int k = 0; k < position_count; ++k) next[k] = here[k] + size * dq[k];
      next_gap = gap_at(next);
    }
    if (!(next_gap < gap)) return false;
    for (int k = 0; k < position_count; ++k) here[k] = next[k];
    gap = next_gap;
  }
  if (!(tolerance >= Scalar(0.0) && gap <= tolerance * tolerance)) return false;
  for (int k = 0; k < position_count; ++k) q[k] = here[k];
  return true;
})";

}  // namespace flatdyn
