// SPDX-License-Identifier: BSD-3-Clause
// Evaluates a generated function at many states: several states at a time in the lanes of SIMD registers (xsimd:
// Debian's libxsimd-dev), and with OpenMP (-fopenmp) on all cores. The width of the lanes is that of the target
// machine: -march=native, or -mavx2 -mfma.
//
//   std::vector<double> q(flatdyn::tiles_length<double, 7>(n)), qd(q.size()), qdd(q.size()), tau(q.size());
//   flatdyn::for_each_state<double>(n, [](auto... of) { return panda::inverse_dynamics(of...); },
//                                   flatdyn::in_tiles<7>(q.data()), flatdyn::in_tiles<7>(qd.data()),
//                                   flatdyn::in_tiles<7>(qdd.data()), flatdyn::out_tiles<7>(tau.data()));
//
// Joint i of state k is at [k / 8][i][k % 8].
// flatdyn/states.hpp has the other layout, columns, and outputs without zeros. Arrays that begin at a multiple of 64
// bytes are fastest: no access crosses cache lines.
//
// The results of a state do not depend on the states next to it. They differ from those of single calls only by the
// rounding of sines and cosines, and with flatdyn::AsWrittenSinCos (flatdyn/lanes.hpp) not at all, provided that the
// compiler contracts products and sums alike in both.
#pragma once

#include <cstddef>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>
#include <xsimd/xsimd.hpp>

#include "flatdyn/lanes.hpp"
#include "flatdyn/states.hpp"

namespace flatdyn {

namespace detail {

template <class Array>
using NumberOf = std::remove_const_t<typename Array::Number>;

template <class Array>
inline constexpr bool is_input = std::is_const_v<typename Array::Number>;

// Calls visit(place) for the places from `first` on, with constants, so that compilers need not keep an array that is
// only indexed by them; in halves since compilers limit the lengths of folds.
template <int first, int count, class Visit>
[[gnu::always_inline]] inline void for_each_place(const Visit& visit) noexcept {
  if constexpr (count == 1) {
    visit(std::integral_constant<int, first>());
  } else if constexpr (count > 1) {
    for_each_place<first, count / 2>(visit);
    for_each_place<first + count / 2, count - count / 2>(visit);
  }
}

// Some states of an array, at most one per lane: `count` of them from `first` on.
template <class Array>
struct States {
  const Array& array;
  std::size_t first, count;
};

// The entries of one argument at these states.
template <class Array>
class Argument {
  using Entries = typename Array::Entries;
  using T = NumberOf<Array>;
  static constexpr std::size_t width = Lanes<T>::width;
  static_assert(Array::together % width == 0, "a tile has a multiple of as many states as registers have lanes");

 public:
  // Loads the states if it is an input; if there are more lanes, the last state is repeated.
  Argument(const States<Array>& states) noexcept {  // NOLINT(google-explicit-constructor): std::tuple converts
    if constexpr (is_input<Array>) {
      for (int i = 0; i < Entries::count; ++i) {
        lanes_[i] = loaded(states.array.at_place(i, states.first), states.count);
      }
    }
  }
  Argument(const Argument&) = delete;
  Argument& operator=(const Argument&) = delete;

  Lanes<T>* lanes() noexcept { return lanes_; }

  void store(const States<Array>& states) const noexcept {
    if constexpr (!is_input<Array>) {
      if (states.count == width) {
        for_each_place<0, Entries::count>([&](auto place) {
          lanes_[Entries::entry_at(place)].batch().store_unaligned(states.array.at_place(place, states.first));
        });
      } else {
        store_some(states);
      }
    }
  }

 private:
  static Lanes<T> loaded(const T* from, std::size_t count) noexcept {
    if (count == width) return Lanes<T>(xsimd::batch<T>::load_unaligned(from));
    alignas(64) T padded[width];
    for (std::size_t k = 0; k < width; ++k) padded[k] = from[k < count ? k : count - 1];
    return Lanes<T>(xsimd::batch<T>::load_aligned(padded));
  }

  void store_some(const States<Array>& states) const noexcept {
    for (int place = 0; place < Entries::count; ++place) {
      alignas(64) T all[width];
      lanes_[Entries::entry_at(place)].batch().store_aligned(all);
      T* const to = states.array.at_place(place, states.first);
      for (std::size_t k = 0; k < states.count; ++k) to[k] = all[k];
    }
  }

  Lanes<T> lanes_[Entries::length];
};

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
template <class Array>
void spoil(const Array& array, std::size_t state) noexcept {
  if constexpr (!is_input<Array>) {
    for (int place = 0; place < Array::Entries::count; ++place) {
      *array.at_place(place, state) = std::numeric_limits<typename Array::Number>::quiet_NaN();
    }
  }
}

// Asks for each of `count` states by itself whether the call returns true, and spoils the outputs of the others.
template <class Call, std::size_t... k, class... Arrays>
[[gnu::noinline, gnu::cold]] void spoil_invalid(Call& call, std::size_t state, std::size_t count,
                                                std::index_sequence<k...>, const Arrays&... arrays) noexcept {
  for (std::size_t one = state; one < state + count; ++one) {
    std::tuple<Argument<Arrays>...> arguments(States<Arrays>{arrays, one, 1}...);
    if (!holds(call, std::get<k>(arguments).lanes()...)) (spoil(arrays, one), ...);
  }
}

// Applies `call` to `count` states from `state` on, at most one per lane.
template <class Call, std::size_t... k, class... Arrays>
bool at_lanes(Call& call, std::size_t state, std::size_t count, std::index_sequence<k...> all,
              const Arrays&... arrays) noexcept {
  std::tuple<Argument<Arrays>...> arguments(States<Arrays>{arrays, state, count}...);
  const bool result = holds(call, std::get<k>(arguments).lanes()...);
  (std::get<k>(arguments).store(States<Arrays>{arrays, state, count}), ...);
  if (!result) spoil_invalid(call, state, count, all, arrays...);
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
