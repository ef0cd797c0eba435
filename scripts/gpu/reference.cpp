// SPDX-License-Identifier: GPL-2.0-or-later
// Writes what a function has to be at the first states, in 50 digits: two doubles for each entry of its outputs, whose
// sum it is. Compiled with -D HEADER="panda.cuh" -D SPACE=panda -D FUNCTION=gravity.
#include HEADER

#include <cstdio>
#include <tuple>
#include <type_traits>
#include <vector>

#include "flatdyn/reference/real50.hpp"
#include "states.hpp"

using Real = flatdyn::reference::Real50;

namespace {

std::vector<double> written;

void write(const Real& x) {
  const double high = static_cast<double>(x);
  written.push_back(high);
  written.push_back(static_cast<double>(x - high));
}

// The arguments of a call: arrays of 50 digits, inputs filled.
template <class A>
struct Array;
template <std::size_t count>
struct Array<const Real (&)[count]> {
  Real entries[count];
  void fill(std::size_t state, int& input) {
    for (std::size_t k = 0; k < count; ++k) entries[k] = number_at(state, input, static_cast<int>(k));
    ++input;
  }
  void write_out() const {}
};
template <std::size_t count>
struct Array<Real (&)[count]> {
  Real entries[count];
  void fill(std::size_t, int&) {}
  void write_out() const {
    for (const Real& entry : entries) write(entry);
  }
};
template <std::size_t rows, std::size_t columns>
struct Array<Real (&)[rows][columns]> : Array<Real (&)[rows * columns]> {};

template <class Shape>
struct Call;
template <class R, class... A>
struct Call<R(A...)> {
  static void run() {
    for (std::size_t state = 0; state < reference_states; ++state) {
      int input = 0;
      std::tuple<Array<A>...> arrays;
      std::apply([&](auto&... each) { (each.fill(state, input), ...); }, arrays);
      std::apply(
          [](auto&... each) {
            if constexpr (std::is_same_v<R, Real>) {
              write(SPACE::FUNCTION<Real>(&each.entries[0]..., SPACE::LibrarySinCos()));
            } else {
              SPACE::FUNCTION<Real>(&each.entries[0]..., SPACE::LibrarySinCos());
            }
            (each.write_out(), ...);
          },
          arrays);
    }
  }
};

}  // namespace

int main() {
  Call<SPACE::functions::FUNCTION::Shape<Real>>::run();
  return std::fwrite(written.data(), sizeof(double), written.size(), stdout) == written.size() ? 0 : 1;
}
