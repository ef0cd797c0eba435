// SPDX-License-Identifier: GPL-2.0-or-later
// The helpers of emitted C++ that compute limbs together, as they have to be. They are written down here once more, not
// taken from the template.
#pragma once

namespace flatdyn {

// Vectors with a number of each limb.
inline constexpr const char* kCppLimbs = R"(
namespace detail {
template <class Scalar, int lanes, class Half>
struct LimbPair {
  Half low, high;

  LimbPair() = default;
  LimbPair(const Scalar& a, const Scalar& b) noexcept : low{a}, high{b} {}
  LimbPair(const Scalar& a, const Scalar& b, const Scalar& c, const Scalar& d) noexcept
      : low{a, b}, high{c, d} {}
  LimbPair(const Scalar& a, const Scalar& b, const Scalar& c, const Scalar& d, const Scalar& e,
      const Scalar& f, const Scalar& g, const Scalar& h) noexcept
      : low{a, b, c, d}, high{e, f, g, h} {}
  Scalar operator[](int k) const noexcept {
    if constexpr (lanes == 2) {
      return k == 0 ? low : high;
    } else {
      return k < lanes / 2 ? low[k] : high[k - lanes / 2];
    }
  }
  static LimbPair of(const Half& low, const Half& high) noexcept {
    LimbPair pair;
    pair.low = low;
    pair.high = high;
    return pair;
  }
  friend LimbPair operator-(const LimbPair& a) noexcept { return of(-a.low, -a.high); }
  friend LimbPair operator+(const LimbPair& a, const LimbPair& b) noexcept {
    return of(a.low + b.low, a.high + b.high);
  }
  friend LimbPair operator+(const LimbPair& a, const Scalar& b) noexcept {
    return of(a.low + b, a.high + b);
  }
  friend LimbPair operator+(const Scalar& a, const LimbPair& b) noexcept {
    return of(a + b.low, a + b.high);
  }
  friend LimbPair operator-(const LimbPair& a, const LimbPair& b) noexcept {
    return of(a.low - b.low, a.high - b.high);
  }
  friend LimbPair operator-(const LimbPair& a, const Scalar& b) noexcept {
    return of(a.low - b, a.high - b);
  }
  friend LimbPair operator-(const Scalar& a, const LimbPair& b) noexcept {
    return of(a - b.low, a - b.high);
  }
  friend LimbPair operator*(const LimbPair& a, const LimbPair& b) noexcept {
    return of(a.low * b.low, a.high * b.high);
  }
  friend LimbPair operator*(const LimbPair& a, const Scalar& b) noexcept {
    return of(a.low * b, a.high * b);
  }
  friend LimbPair operator*(const Scalar& a, const LimbPair& b) noexcept {
    return of(a * b.low, a * b.high);
  }
  friend LimbPair operator/(const LimbPair& a, const LimbPair& b) noexcept {
    return of(a.low / b.low, a.high / b.high);
  }
  friend LimbPair operator/(const LimbPair& a, const Scalar& b) noexcept {
    return of(a.low / b, a.high / b);
  }
  friend LimbPair operator/(const Scalar& a, const LimbPair& b) noexcept {
    return of(a / b.low, a / b.high);
  }
};
template <class Scalar, int lanes>
struct LimbLanes {
  using Type = LimbPair<Scalar, lanes, typename LimbLanes<Scalar, lanes / 2>::Type>;
};
template <class Scalar>
struct LimbLanes<Scalar, 1> {
  using Type = Scalar;
};
#if defined(__GNUC__) && (defined(__SSE2__) || defined(__aarch64__))
template <>
struct LimbLanes<double, 2> {
  typedef double Type __attribute__((vector_size(16)));
};
template <>
struct LimbLanes<float, 4> {
  typedef float Type __attribute__((vector_size(16)));
};
#ifdef __AVX__
template <>
struct LimbLanes<double, 4> {
  typedef double Type __attribute__((vector_size(32)));
};
template <>
struct LimbLanes<float, 8> {
  typedef float Type __attribute__((vector_size(32)));
};
#endif
#endif
template <class Scalar, int lanes>
using Limbs = typename LimbLanes<Scalar, lanes>::Type;
})";

}  // namespace flatdyn
