// SPDX-License-Identifier: GPL-2.0-or-later
// The helpers of emitted C++, as they have to be. They are written down here once more, not taken from the templates.
#pragma once

namespace flatdyn {

inline constexpr const char* kCppSign = R"(
namespace detail {
template <class Scalar>
inline Scalar sign(const Scalar& x) noexcept { return Scalar((x > Scalar(0.0)) - (x < Scalar(0.0))); }
})";

inline constexpr const char* kCppSqrt = R"(
namespace detail {
template <class Scalar>
inline Scalar sqrt(const Scalar& x) noexcept { using std::sqrt; return sqrt(x); }
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

inline constexpr const char* kCppSinesAndCosines = R"(
template <int... joint>
struct Joints { static constexpr int flatdyn_interface = $interface$; };
struct LibrarySinCos {
  template <class Scalar, int... joint>
  void operator()(const Scalar* q, Joints<joint...>, Scalar* s, Scalar* c) const noexcept {
    using std::cos;
    using std::sin;
    ((s[joint] = sin(q[joint]), c[joint] = cos(q[joint])), ...);
  }
};
template <class Scalar>
struct GivenSinCos {
  const Scalar* sine;
  const Scalar* cosine;
  template <int... joint>
  void operator()(const Scalar*, Joints<joint...>, Scalar* s, Scalar* c) const noexcept {
    ((s[joint] = sine[joint], c[joint] = cosine[joint]), ...);
  }
};)";

inline constexpr const char* kCppCloseLoops = R"(
template <class Scalar>
inline bool close_loops($parameters_argument$ Scalar* q, Scalar tolerance, int most_steps = 20) noexcept {
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
  if (!(gap <= tolerance * tolerance)) return false;
  for (int k = 0; k < position_count; ++k) q[k] = here[k];
  return true;
})";

// The statements of rounding_is_as_written().
inline constexpr const char* kCppRounding = R"({
  constexpr bool is_float = sizeof(Scalar) == sizeof(float);
  const volatile Scalar a = Scalar(0.1), b = Scalar(0.7), one = Scalar(1.0), tiny = Scalar(1e-17),
      nine = Scalar(9.0), seven = Scalar(7.0), half = Scalar(0.5),
      half_a_place = is_float ? Scalar(0x1.001p-24) : Scalar(0x1.001p-53),
      smallest = is_float ? Scalar(0x1p-126) : Scalar(0x1p-1022);
  const volatile Scalar product = a * b, quotient = nine / seven, next = one + half_a_place;
  const Scalar x = one, y = tiny;
  const auto is_zero = [](Scalar r) { return !(r < Scalar(0.0)) && !(r > Scalar(0.0)); };
  return is_zero(a * b - product) && next > one && is_zero((x + y) - x) && is_zero((x - y) - x) &&
         is_zero(nine / Scalar(7.0) - quotient) && smallest * half > Scalar(0.0);
})";

}  // namespace flatdyn
