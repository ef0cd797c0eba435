// SPDX-License-Identifier: BSD-3-Clause
// A scalar type for generated code that holds one number for each of several states, in the lanes of a SIMD register
// (xsimd: Debian's libxsimd-dev). flatdyn/batch.hpp applies functions to it.
#pragma once

#include <cstddef>
#include <type_traits>
#include <xsimd/xsimd.hpp>

#include "flatdyn/interface.hpp"
#include "flatdyn/sincos.hpp"

namespace flatdyn {

// A scalar type for generated code: as many numbers of type T as a register holds.
template <class T>
class Lanes {
  static_assert(std::is_floating_point_v<T>, "lanes are of float or double");

 public:
  using Batch = xsimd::batch<T>;
  static constexpr std::size_t width = Batch::size;
  static constexpr int flatdyn_interface = kInterface;  // checked by generated code

  Lanes() = default;
  explicit Lanes(double x) noexcept : batch_(static_cast<T>(x)) {}
  explicit Lanes(const Batch& batch) noexcept : batch_(batch) {}

  const Batch& batch() const noexcept { return batch_; }

  // The result of a comparison in each lane. Converted to bool it is true if it is true in all lanes.
  class Mask {
   public:
    explicit Mask(const typename Batch::batch_bool_type& lanes) noexcept : lanes_(lanes) {}
    operator bool() const noexcept { return xsimd::all(lanes_); }
    // 1, 0 or -1 in each lane.
    friend Lanes operator-(const Mask& a, const Mask& b) noexcept { return Lanes(Batch(a.lanes_) - Batch(b.lanes_)); }

   private:
    typename Batch::batch_bool_type lanes_;
  };

  friend Lanes operator+(const Lanes& a, const Lanes& b) noexcept { return Lanes(a.batch_ + b.batch_); }
  friend Lanes operator-(const Lanes& a, const Lanes& b) noexcept { return Lanes(a.batch_ - b.batch_); }
  friend Lanes operator*(const Lanes& a, const Lanes& b) noexcept { return Lanes(a.batch_ * b.batch_); }
  friend Lanes operator/(const Lanes& a, const Lanes& b) noexcept { return Lanes(a.batch_ / b.batch_); }
  friend Lanes operator-(const Lanes& a) noexcept { return Lanes(-a.batch_); }
  friend Mask operator<(const Lanes& a, const Lanes& b) noexcept { return Mask(a.batch_ < b.batch_); }
  friend Mask operator>(const Lanes& a, const Lanes& b) noexcept { return Mask(a.batch_ > b.batch_); }
  friend Lanes sin(const Lanes& a) noexcept { return Lanes(sine(a.batch_)); }
  friend Lanes cos(const Lanes& a) noexcept { return Lanes(cosine(a.batch_)); }
  friend Lanes sqrt(const Lanes& a) noexcept { return Lanes(xsimd::sqrt(a.batch_)); }
  friend Lanes fma(const Lanes& a, const Lanes& b, const Lanes& c) noexcept {
    return Lanes(xsimd::fma(a.batch_, b.batch_, c.batch_));
  }

 private:
  Batch batch_;
};

// A source of sines and cosines for lanes, the last argument of generated functions: with it the results of a state
// have the bits of a single call with the code's own sines. (The default fuses products and sums where the processor
// can, and takes less time.)
//
//   [](auto... of) { panda::inverse_dynamics(of..., flatdyn::AsWrittenSinCos()); }
struct AsWrittenSinCos {
  // Writes the sines and cosines of these joints; Joints<joint...> is a type of the generated header.
  template <class T, template <int...> class Joints, int... joint>
  void operator()(const Lanes<T>* q, Joints<joint...>, Lanes<T>* s, Lanes<T>* c) const noexcept {
    static_assert(
        detail::interface_of<Joints<joint...>>(nullptr) == kInterface,
        "flatdyn/lanes.hpp is of another version of flatdyn than this generated code: generate it again, with "
        "the flatdyn that the header came with");
    (write(q[joint], s[joint], c[joint]), ...);
  }

 private:
  template <class T>
  static void write(const Lanes<T>& angle, Lanes<T>& sine, Lanes<T>& cosine) noexcept {
    const auto both = detail::sin_cos_of_any<detail::AsWritten>(angle.batch());
    sine = Lanes<T>(both.sine);
    cosine = Lanes<T>(both.cosine);
  }
};

}  // namespace flatdyn
