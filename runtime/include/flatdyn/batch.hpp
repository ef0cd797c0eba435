// SPDX-License-Identifier: BSD-3-Clause
// Evaluates a generated function at many states: several states at a time in the lanes of SIMD registers (xsimd:
// Debian's libxsimd-dev), and with OpenMP (-fopenmp) on all cores. The width of the lanes is that of the target
// machine: -march=native, or -mavx2 -mfma.
//
//   std::vector<double> q(7 * n), qd(7 * n), qdd(7 * n), tau(7 * n);   // joint i of state k at [i * n + k]
//   flatdyn::for_each_state<double>(n, [](auto... of) { return panda::inverse_dynamics(of...); },
//                                   flatdyn::in<7>(q.data(), n), flatdyn::in<7>(qd.data(), n),
//                                   flatdyn::in<7>(qdd.data(), n), flatdyn::out<7>(tau.data(), n));
//
// Arrays that begin at a multiple of 64 bytes, and n a multiple of 64 / sizeof(T), are fastest: no access crosses cache
// lines. The results of a state do not depend on the states beside it. They differ from those of scalar calls only by
// the rounding of sines and cosines, provided that the compiler contracts products and sums alike in both.
#pragma once

#include <cstddef>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>
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

// The entries of an argument: entry i of state k is at first[i * stride + k].
template <int entries, class T>
struct Columns {
  T* first;
  std::size_t stride;  // at least the number of states
};

template <int entries, class T>
Columns<entries, const T> in(const T* first, std::size_t stride) noexcept {
  return {first, stride};
}

template <int entries, class T>
Columns<entries, T> out(T* first, std::size_t stride) noexcept {
  return {first, stride};
}

namespace detail {

// The entries of one argument at as many states as there are lanes.
template <int entries, class T>
class Argument {
 public:
  // Loads `count` states from `state` on; if there are more lanes, the last state is repeated.
  Argument(const Columns<entries, const T>& columns, std::size_t state, std::size_t count) noexcept {
    for (std::size_t i = 0; i < entries; ++i) {
      const T* from = columns.first + i * columns.stride + state;
      if (count == Lanes<T>::width) {
        lanes_[i] = Lanes<T>(xsimd::batch<T>::load_unaligned(from));
        continue;
      }
      alignas(64) T padded[Lanes<T>::width];
      for (std::size_t k = 0; k < Lanes<T>::width; ++k) padded[k] = from[k < count ? k : count - 1];
      lanes_[i] = Lanes<T>(xsimd::batch<T>::load_aligned(padded));
    }
  }
  Argument(const Columns<entries, T>&, std::size_t, std::size_t) noexcept {}  // an output

  Lanes<T>* lanes() noexcept { return lanes_; }

  void store(const Columns<entries, T>& columns, std::size_t state, std::size_t count) const noexcept {
    for (std::size_t i = 0; i < entries; ++i) {
      T* const to = columns.first + i * columns.stride + state;
      if (count == Lanes<T>::width) {
        lanes_[i].batch().store_unaligned(to);
        continue;
      }
      alignas(64) T all[Lanes<T>::width];
      lanes_[i].batch().store_aligned(all);
      for (std::size_t k = 0; k < count; ++k) to[k] = all[k];
    }
  }
  void store(const Columns<entries, const T>&, std::size_t, std::size_t) const noexcept {}  // an input

 private:
  Lanes<T> lanes_[entries];
};

template <int entries, class T>
Argument<entries, std::remove_const_t<T>> argument(const Columns<entries, T>& columns, std::size_t state,
                                                   std::size_t count) noexcept {
  return {columns, state, count};
}

template <class Call, class... Pointers>
bool holds(Call& call, Pointers... pointers) noexcept {
  if constexpr (std::is_same_v<decltype(call(pointers...)), bool>) {
    return call(pointers...);
  } else {
    call(pointers...);
    return true;
  }
}

// Writes not-a-numbers to the outputs of a state.
template <int entries, class T>
void spoil(const Columns<entries, T>& columns, std::size_t state) noexcept {
  if constexpr (!std::is_const_v<T>) {
    for (std::size_t i = 0; i < entries; ++i) {
      columns.first[i * columns.stride + state] = std::numeric_limits<T>::quiet_NaN();
    }
  }
}

// Asks for each of `count` states by itself whether the call returns true, and spoils the outputs of the others.
template <class Call, std::size_t... k, class... Arrays>
void spoil_invalid(Call& call, std::size_t state, std::size_t count, std::index_sequence<k...>,
                   const Arrays&... arrays) noexcept {
  for (std::size_t one = state; one < state + count; ++one) {
    auto arguments = std::make_tuple(argument(arrays, one, 1)...);
    if (!holds(call, std::get<k>(arguments).lanes()...)) (spoil(arrays, one), ...);
  }
}

// Applies `call` to `count` states from `state` on, at most one per lane.
template <class Call, std::size_t... k, class... Arrays>
bool at_lanes(Call& call, std::size_t state, std::size_t count, std::index_sequence<k...>,
              const Arrays&... arrays) noexcept {
  auto arguments = std::make_tuple(argument(arrays, state, count)...);
  const bool result = holds(call, std::get<k>(arguments).lanes()...);
  (std::get<k>(arguments).store(arrays, state, count), ...);
  if (!result) spoil_invalid(call, state, count, std::index_sequence<k...>{}, arrays...);
  return result;
}

}  // namespace detail

// Applies call(a, b, …), with pointers to Lanes<T>, to all `states`; the arrays are in the order of its arguments. What
// the call returns counts: write `return` before a function that returns bool.
// Inputs may share an array; outputs must overlap neither inputs nor each other. Returns false if the call returns
// false for any state, as forward_dynamics does if B is not positive definite; the outputs of such states are not
// numbers.
template <class T, class Call, class... Arrays>
bool for_each_state(std::size_t states, Call call, const Arrays&... arrays) noexcept {
  constexpr std::size_t width = Lanes<T>::width;
  const auto groups = static_cast<std::ptrdiff_t>((states + width - 1) / width);
  bool result = true;
#ifdef _OPENMP
#pragma omp parallel for schedule(static) reduction(&& : result)
#endif
  for (std::ptrdiff_t group = 0; group < groups; ++group) {
    const std::size_t state = static_cast<std::size_t>(group) * width;
    const std::size_t count = states - state < width ? states - state : width;
    const bool held = detail::at_lanes(call, state, count, std::index_sequence_for<Arrays...>{}, arrays...);
    result = result && held;
  }
  return result;
}

}  // namespace flatdyn
