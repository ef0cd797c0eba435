// SPDX-License-Identifier: BSD-3-Clause
// A source of sines and cosines that computes those of all joints at once, in SIMD registers (xsimd: Debian's
// libxsimd-dev); it is the last argument of generated functions:
//
//   panda::inverse_dynamics(q, qd, qdd, tau, flatdyn::TogetherSinCos());
//
// In double they are right to 1 ulp up to 1e5 rad; beyond that <cmath> computes them. The width of the registers is
// that of the target machine.
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <xsimd/xsimd.hpp>

#include "flatdyn/interface.hpp"
#include "flatdyn/sincos.hpp"

namespace flatdyn {

namespace detail {

// The widest register that n numbers fill; else the narrowest.
template <class T, std::size_t n, std::size_t width = xsimd::batch<T>::size>
constexpr std::size_t width_for() {
  if constexpr (width <= n || std::is_void_v<xsimd::make_sized_batch_t<T, width / 2>>) {
    return width;
  } else {
    return width_for<T, n, width / 2>();
  }
}

// Writes the sines and cosines of n numbers in a row, at least as many as lanes; the last lanes overlap the previous
// ones.
template <std::size_t n, class T>
inline void sin_cos_of_row(const T* x, T* s, T* c) noexcept {
  constexpr std::size_t width = width_for<T, n>();
  using Batch = xsimd::make_sized_batch_t<T, width>;
  for (std::size_t k = 0; k < n; k += width) {
    const std::size_t first = std::min(k, n - width);
    const auto both = sin_cos(Batch::load_unaligned(x + first));
    both.sine.store_unaligned(s + first);
    both.cosine.store_unaligned(c + first);
  }
}

template <int first, int... joint>
constexpr bool is_row() {
  int next = first + 1;
  return ((joint == next++) && ...);
}

}  // namespace detail

struct TogetherSinCos {
  // Writes the sines and cosines of these joints; Joints<joint...> is a type of the generated header.
  template <class T, template <int...> class Joints, int... joint>
  void operator()(const T* q, Joints<joint...>, T* s, T* c) const noexcept {
    static_assert(detail::interface_of<Joints<joint...>>(nullptr) == kInterface,
                  "flatdyn/trigonometry.hpp is of another version of flatdyn than this generated code: generate it "
                  "again, with the flatdyn that the header came with");
    constexpr int joints[] = {joint...};
    constexpr std::size_t n = sizeof...(joint), width = detail::width_for<T, n>();
    if constexpr (n >= width && detail::is_row<joint...>()) {
      detail::sin_cos_of_row<n>(q + joints[0], s + joints[0], c + joints[0]);
    } else {
      constexpr std::size_t length = std::max(n, width);
      T x[length] = {q[joint]...}, sine[length], cosine[length];
      detail::sin_cos_of_row<length>(x, sine, cosine);
      for (std::size_t k = 0; k < n; ++k) {
        s[joints[k]] = sine[k];
        c[joints[k]] = cosine[k];
      }
    }
  }
};

}  // namespace flatdyn
