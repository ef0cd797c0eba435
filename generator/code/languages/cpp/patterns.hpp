// SPDX-License-Identifier: GPL-2.0-or-later
// The helpers of emitted C++, as they have to be. They are written down here once more, not taken from the templates.
#pragma once

namespace flatdyn {

inline constexpr const char* kCppStandard = R"(
#if __cplusplus < 201703L && (!defined(_MSVC_LANG) || _MSVC_LANG < 201703L)
#error "this needs C++17: compile it with -std=c++17, or a later standard"
#endif
)";

inline constexpr const char* kCppObjectArguments = R"(
namespace detail {
struct Objects {
  template <class Of>
  static constexpr bool hold_array(decltype(static_cast<Of*>(nullptr)->data())*) noexcept { return true; }
  template <class Of>
  static constexpr bool hold_array(...) noexcept { return false; }
  template <class Of>
  static constexpr bool are_expressions(decltype(static_cast<Of*>(nullptr)->eval())*) noexcept { return true; }
  template <class Of>
  static constexpr bool are_expressions(...) noexcept { return false; }
};
template <class... Of>
struct ObjectsRefused {
  static_assert(sizeof...(Of) == 0,
      "arguments are plain arrays: of a std::array, std::vector or std::span pass q.data(); of "
      "Eigen's vectors, too, or include flatdyn/eigen.hpp and call flatdyn::eigen<functions::NAME>");
  operator bool() const noexcept;
};
template <bool are_objects, class... Of>
struct ObjectArguments {};
template <class... Of>
struct ObjectArguments<true, Of...> {
  using type = ObjectsRefused<Of...>;
};
template <class... Of>
using IfObjects = typename ObjectArguments<((Objects::hold_array<Of>(nullptr) ||
    Objects::are_expressions<Of>(nullptr)) || ... || false), Of...>::type;
})";

inline constexpr const char* kCppSign = R"(
namespace detail {
template <class Scalar>
static inline Scalar sign(const Scalar& x) noexcept { return Scalar((x > Scalar(0.0)) - (x < Scalar(0.0))); }
})";

inline constexpr const char* kCppSqrt = R"(
namespace detail {
template <class Scalar>
static inline Scalar sqrt(const Scalar& x) noexcept { using std::sqrt; return sqrt(x); }
})";

inline constexpr const char* kCppZeros = R"(
namespace detail {
struct Zeros {
  static constexpr bool are_plain(const float*) noexcept { return true; }
  static constexpr bool are_plain(const double*) noexcept { return true; }
  static constexpr bool are_plain(const void*) noexcept { return false; }
  template <int count, class Scalar>
  [[gnu::always_inline]] static void store(Scalar* entries) noexcept {
    constexpr int together = 4;
    if constexpr (count > 2 * together) {
      constexpr int half = count / (2 * together) * together;
      store<half>(entries);
      store<count - half>(entries + half);
    } else if constexpr (count >= together && are_plain(static_cast<Scalar*>(nullptr))) {
      const Scalar zeros[together] = {};
      memcpy(entries, zeros, sizeof(zeros));
      memcpy(entries + (count - together), zeros, sizeof(zeros));
    } else if constexpr (count > 1) {
      store<count / 2>(entries);
      store<count - count / 2>(entries + count / 2);
    } else {
      entries[0] = Scalar(0.0);
    }
  }
};
})";

inline constexpr const char* kCppExcess = R"(
namespace detail {
template <class Scalar>
struct Excess {
  static Scalar of(const Scalar& sum, const Scalar& term) noexcept { return sum - term; }
};
template <>
struct Excess<double> {
  [[gnu::always_inline]] static double of(double sum, double term) noexcept {
    int64_t bits_of_sum = 0, bits_of_term = 0;
    memcpy(&bits_of_sum, &sum, sizeof(sum));
    memcpy(&bits_of_term, &term, sizeof(term));
    return double(bits_of_sum > bits_of_term);
  }
};
template <>
struct Excess<float> {
  [[gnu::always_inline]] static float of(float sum, float term) noexcept {
    int32_t bits_of_sum = 0, bits_of_term = 0;
    memcpy(&bits_of_sum, &sum, sizeof(sum));
    memcpy(&bits_of_term, &term, sizeof(term));
    return float(bits_of_sum > bits_of_term);
  }
};
})";

inline constexpr const char* kCppMultiplyAdd = R"(
namespace detail {
void fma();
template <class Scalar>
struct MultiplyAdd {
  template <class S>
  static S of(const S& a, const S& b, const S& c, int decltype(fma(a, b, c))::*) noexcept {
    return S(fma(a, b, c));
  }
  template <class S>
  static S of(const S& a, const S& b, const S& c, ...) noexcept {
    return a * b + c;
  }
  Scalar operator()(const Scalar& a, const Scalar& b, const Scalar& c) const noexcept {
    return of(a, b, c, nullptr);
  }
};
template <>
struct MultiplyAdd<double> {
  [[gnu::always_inline]] double operator()(double a, double b, double c) const noexcept {
#if defined(__FMA__) || defined(__aarch64__) || defined(__FP_FAST_FMA) || \
    (defined(__ARM_FEATURE_FMA) && (__ARM_FP & 8)) || (defined(__riscv_flen) && __riscv_flen >= 64)
    return std::fma(a, b, c);
#else
    return a * b + c;
#endif
  }
};
template <>
struct MultiplyAdd<float> {
  [[gnu::always_inline]] float operator()(float a, float b, float c) const noexcept {
#if defined(__FMA__) || defined(__aarch64__) || defined(__FP_FAST_FMAF) || \
    (defined(__ARM_FEATURE_FMA) && (__ARM_FP & 4)) || (defined(__riscv_flen) && __riscv_flen >= 32)
    return std::fma(a, b, c);
#else
    return a * b + c;
#endif
  }
};
})";

inline constexpr const char* kCppInterface = R"(
namespace detail {
struct Interface {
  template <class Scalar>
  static constexpr bool has_fractions(int Scalar::*) noexcept { return true; }
  template <class Scalar>
  static constexpr bool has_fractions(...) noexcept { return Scalar(1.5) > Scalar(1.0); }
  template <class Scalar>
  static constexpr bool fits(decltype(Scalar::flatdyn_interface)*) noexcept {
    return Scalar::flatdyn_interface == $interface$;
  }
  template <class Scalar>
  static constexpr bool fits(...) noexcept { return true; }
  template <class Scalar>
  static constexpr bool checked() noexcept {
    static_assert(has_fractions<Scalar>(nullptr),
        "integers cannot hold positions, velocities or torques: use arrays of double or float");
    static_assert(fits<Scalar>(nullptr),
        "this scalar is of another version of flatdyn's runtime than this generated code: generate "
        "it again, with the flatdyn that the runtime came with");
    return true;
  }
};
})";

inline constexpr const char* kCppLibrarySines = R"(
template <int... joint>
struct Joints { static constexpr int flatdyn_interface = $interface$; };
struct LibrarySinCos {
  template <class Scalar, int... joint>
  void operator()(const Scalar* q, Joints<joint...>, Scalar* s, Scalar* c) const noexcept {
    using std::cos;
    using std::sin;
    ((s[joint] = sin(q[joint]), c[joint] = cos(q[joint])), ...);
  }
};)";

// Sines and cosines by polynomials, in a namespace of their own: their types, the function for doubles and that for
// floats, and the functions that call them.
inline constexpr const char* kCppTypesOfSines = R"(
namespace detail {
#if defined(__GNUC__) && (defined(__SSE2__) || defined(__aarch64__))
#ifdef __AVX__
constexpr int bytes_of_doubles = 32;
#else
constexpr int bytes_of_doubles = 16;
#endif
typedef double Doubles __attribute__((vector_size(bytes_of_doubles)));
typedef uint64_t BitsOfDoubles __attribute__((vector_size(bytes_of_doubles)));
typedef float Floats __attribute__((vector_size(16)));
typedef uint32_t BitsOfFloats __attribute__((vector_size(16)));
#define $guard$_IN_LANES
#else
typedef double Doubles;
typedef uint64_t BitsOfDoubles;
typedef float Floats;
typedef uint32_t BitsOfFloats;
#endif
)";

// A function over numbers of these types, up to its statements.
inline constexpr const char* kCppSineAndCosine = R"(
template <class = void>
static inline void sine_and_cosine(const $sine_number$& x, $sine_number$& sine, $sine_number$& cosine) noexcept {
)";

inline constexpr const char* kCppSinesOfJoints = R"(
template <class Lanes, class Scalar>
static inline Scalar evaluate(Lanes squares, const Scalar* q, const int* joints, int count, Scalar* s,
    Scalar* c) noexcept {
#ifdef $guard$_IN_LANES
  constexpr int lanes = sizeof(Lanes) / sizeof(Scalar);
#pragma GCC unroll 4
  for (int first = 0; first < count; first += lanes) {
    Lanes x = squares, sine, cosine;
#pragma GCC unroll 4
    for (int k = 0; k < lanes; ++k) x[k] = q[joints[first + k < count ? first + k : count - 1]];
    sine_and_cosine(x, sine, cosine);
    squares += x * x;
#pragma GCC unroll 4
    for (int k = 0; k < lanes; ++k) {
      const int joint = joints[first + k < count ? first + k : count - 1];
      s[joint] = sine[k];
      c[joint] = cosine[k];
    }
  }
  Scalar sum = squares[0];
#pragma GCC unroll 4
  for (int k = 1; k < lanes; ++k) sum += squares[k];
  return sum;
#else
  for (int k = 0; k < count; ++k) {
    const Scalar x = q[joints[k]];
    sine_and_cosine(x, s[joints[k]], c[joints[k]]);
    squares += x * x;
  }
  return squares;
#endif
}
template <class Scalar>
[[gnu::noinline, gnu::cold]] static void ask_library(Scalar most, const Scalar* q, const int* joints, int count, Scalar* s,
    Scalar* c) noexcept {
  for (int k = 0; k < count; ++k) {
    const Scalar x = q[joints[k]];
    if (x <= most && x >= -most) continue;
    s[joints[k]] = std::sin(x);
    c[joints[k]] = std::cos(x);
  }
}
template <int... joint>
static inline void sines_and_cosines(const double* q, Joints<joint...>, double* s, double* c) noexcept {
  static constexpr int joints[] = {joint...};
  constexpr int count = sizeof...(joint);
  constexpr double most = 1e5;
  const double squares = evaluate(Doubles{}, q, joints, count, s, c);
  if (!(squares <= most * most)) ask_library(most, q, joints, count, s, c);
}
template <int... joint>
static inline void sines_and_cosines(const float* q, Joints<joint...>, float* s, float* c) noexcept {
  static constexpr int joints[] = {joint...};
  constexpr int count = sizeof...(joint);
  constexpr float most = 6400.0f;
  const float squares = evaluate(Floats{}, q, joints, count, s, c);
  if (!(squares <= most * most)) ask_library(most, q, joints, count, s, c);
}
template <class Scalar, int... joint>
static inline void sines_and_cosines(const Scalar* q, Joints<joint...> all, Scalar* s, Scalar* c) noexcept {
  LibrarySinCos()(q, all, s, c);
}
}  // namespace detail
)";

// The source that calls them; in a header with a source it is declared in one and defined in the other.
inline constexpr const char* kCppPolynomialSines = R"(
struct PolynomialSinCos {
  template <class Scalar, int... joint>
  [[gnu::always_inline]] void operator()(const Scalar* q, Joints<joint...> all, Scalar* s, Scalar* c) const noexcept {
    detail::sines_and_cosines(q, all, s, c);
  }
};)";

inline constexpr const char* kCppPolynomialSinesDeclared = R"(
struct PolynomialSinCos {
  template <class Scalar, int... joint>
  void operator()(const Scalar* q, Joints<joint...> all, Scalar* s, Scalar* c) const noexcept;
};)";

inline constexpr const char* kCppPolynomialSinesDefined = R"(
template <class Scalar, int... joint>
void PolynomialSinCos::operator()(const Scalar* q, Joints<joint...> all, Scalar* s, Scalar* c) const noexcept {
  detail::sines_and_cosines(q, all, s, c);
})";

inline constexpr const char* kCppGivenSines = R"(
template <class Scalar>
struct GivenSinCos {
  const Scalar* sine;
  const Scalar* cosine;
  template <int... joint>
  void operator()(const Scalar*, Joints<joint...>, Scalar* s, Scalar* c) const noexcept {
    ((s[joint] = sine[joint], c[joint] = cosine[joint]), ...);
  }
};
using DefaultSinCos = $default_sines$;)";

inline constexpr const char* kCppCloseLoops = R"(
template <class Scalar>
[[nodiscard]] static inline bool close_loops($parameters_argument$ Scalar* q, Scalar tolerance, int most_steps = 20) noexcept {
  Scalar here[position_count], next[position_count], dq[position_count], phi[$rows$];
  const auto gap_at = [&](const Scalar* position) {
    $closure$($parameters$ position, phi);
    Scalar sum = Scalar(0.0);
    for (const Scalar& entry : phi) sum = sum + entry * entry;
    return sum;
  };
  for (int k = 0; k < position_count; ++k) here[k] = q[k];
  Scalar gap = gap_at(here);
  for (int step = 0; step < most_steps && gap > tolerance * tolerance; ++step) {
    if (!$step$($parameters$ here, dq)) return false;
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

inline constexpr const char* kCppRoundingIncludes = R"(
#include <float.h>
#include <stdint.h>
#include <string.h>
)";

// The functions that rounding_is_as_written() calls, with sines_are_right() only if there are sines.
inline constexpr const char* kCppRoundingHelpers = R"(
namespace detail {
template <class Scalar>
static void fill(Scalar* x, int count, uint32_t seed) noexcept {
  for (int k = 0; k < count; ++k) {
    seed = seed * 1664525u + 1013904223u;
    x[k] = (Scalar(seed >> 8) - Scalar(8388608.0)) / Scalar(8388608.0);
  }
}
template <class Scalar>
static void fill_sines(Scalar* sine, Scalar* cosine, int count, uint32_t seed) noexcept {
  fill(sine, count, seed);
  for (int k = 0; k < count; ++k) {
    const Scalar t = sine[k], square = t * t, divisor = Scalar(1.0) + square;
    sine[k] = Scalar(2.0) * t / divisor;
    cosine[k] = (Scalar(1.0) - square) / divisor;
  }
}
template <class Scalar>
static uint64_t hash_of(const Scalar* x, int count, uint64_t hash) noexcept {
  for (int k = 0; k < count; ++k) {
    const bool is_number = x[k] < Scalar(0.0) || x[k] >= Scalar(0.0);
    uint64_t bits = 0;
    if constexpr (sizeof(Scalar) == sizeof(float)) {
      uint32_t of_float = 0;
      memcpy(&of_float, x + k, sizeof(of_float));
      bits = of_float;
    } else {
      memcpy(&bits, x + k, sizeof(bits));
    }
    hash = (hash ^ (is_number ? bits : 0u)) * 1099511628211u;
    hash ^= hash >> 32;
  }
  return hash;
}
)";

inline constexpr const char* kCppPolynomialsAreRight = R"(
template <class Scalar>
static bool sines_are_right() noexcept {
  const volatile Scalar zero = Scalar(0.0);
  const Scalar angles[8] = {
      Scalar(0.5), Scalar(0.6875), Scalar(1.28125), Scalar(1.53125), Scalar(1.796875),
      Scalar(3.125), Scalar(10.28125), Scalar(11.125)
  };
  Scalar x[8], s[8], c[8];
  for (int k = 0; k < 8; ++k) x[k] = angles[k] + zero;
  PolynomialSinCos()(x, Joints<0, 1, 2, 3, 4, 5, 6, 7>(), s, c);
  const uint64_t hash = hash_of(c, 8, hash_of(s, 8, 14695981039346656037u));
  return hash == (sizeof(Scalar) == sizeof(float) ? $hash_of_float_sines$u : $hash_of_sines$u);
}
)";

inline constexpr const char* kCppLibraryIsRight = R"(
template <class Scalar>
static bool sines_are_right() noexcept {
  const volatile Scalar zero = Scalar(0.0);
  const Scalar angles[8] = {
      Scalar(0.5), Scalar(0.6875), Scalar(1.28125), Scalar(1.53125), Scalar(1.796875),
      Scalar(3.125), Scalar(10.28125), Scalar(11.125)
  };
  const Scalar sines[8] = {
      Scalar(0.479425538604203), Scalar(0.6346070800152693), Scalar(0.9583735057581397),
      Scalar(0.999218145922396), Scalar(0.9745528811569866), Scalar(0.016591892229347906),
      Scalar(-0.7555360776363961), Scalar(-0.9916361774750792)
  };
  const Scalar cosines[8] = {
      Scalar(0.8775825618903728), Scalar(0.7728349461524715), Scalar(0.28551746612221973),
      Scalar(0.03953601977196579), Scalar(-0.2241577164155103), Scalar(-0.9998623450816866),
      Scalar(-0.6551070411694638), Scalar(0.12906467960915324)
  };
  const Scalar places = Scalar(sizeof(Scalar) == sizeof(float) ? 8388608.0 : 4503599627370496.0);
  Scalar x[8], s[8], c[8];
  for (int k = 0; k < 8; ++k) x[k] = angles[k] + zero;
  LibrarySinCos()(x, Joints<0, 1, 2, 3, 4, 5, 6, 7>(), s, c);
  const auto is_near = [places](Scalar a, Scalar b) {
    const Scalar error = (a - b) * places, size = b < Scalar(0.0) ? -b : b;
    return error <= size && -error <= size;
  };
  bool right = true;
  for (int k = 0; k < 8; ++k) right &= is_near(s[k], sines[k]) && is_near(c[k], cosines[k]);
  return right;
}
)";

// The statements of rounding_is_as_written() before the known state.
inline constexpr const char* kCppRounding = R"({
  constexpr bool is_float = sizeof(Scalar) == sizeof(float);
  constexpr int method = FLT_EVAL_METHOD;
  if (method != 0 && method != 16 && (is_float || method != 1)) return false;
  const volatile Scalar u = Scalar(0.1), w = Scalar(0.7), one = Scalar(1.0), tiny = Scalar(1e-17),
      nine = Scalar(9.0), seven = Scalar(7.0), half = Scalar(0.5), zero = Scalar(0.0),
      half_a_place = is_float ? Scalar(0x1.001p-24) : Scalar(0x1.001p-53),
      smallest = is_float ? Scalar(0x1p-126) : Scalar(0x1p-1022);
  const volatile Scalar product = u * w, quotient = nine / seven, next = one + half_a_place;
  const Scalar x = one, y = tiny, nothing = zero, infinite = one / nothing, no_number = nothing / nothing;
  const auto is_zero = [](Scalar r) { return !(r < Scalar(0.0)) && !(r > Scalar(0.0)); };
  if (!is_zero(u * w - product) || !(next > one) || !is_zero((x + y) - x) || !is_zero((x - y) - x) ||
      !is_zero(nine / Scalar(7.0) - quotient) || !(smallest * half > Scalar(0.0)) ||
      !(Scalar(1.0) / (Scalar(0.0) - nothing) > Scalar(0.0)) || Scalar(0.0) * infinite < Scalar(1.0) ||
      Scalar(0.0) * no_number < Scalar(1.0)) {
    return false;
  }
)";

inline constexpr const char* kCppKnownState = R"(
  const volatile uint32_t first = 0;
  const uint32_t seed = first;
  uint64_t hash = 14695981039346656037u;
)";

}  // namespace flatdyn
