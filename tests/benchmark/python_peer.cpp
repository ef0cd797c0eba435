// SPDX-License-Identifier: GPL-2.0-or-later
// The C++ batch of the functions that python_batch.py times, as a library that it calls: the same states, in the layout
// of flatdyn/batch.hpp, joint by joint.
#include <cstddef>

#include "flatdyn/batch.hpp"
#include "panda.hpp"

using Number = NUMBER;  // "double" or "float", set by a compiler option

namespace {

using flatdyn::in;
using flatdyn::out;

template <int entries, class Call>
void three_inputs(std::size_t n, const Number* a, const Number* b, const Number* c, Number* result, Call call) {
  flatdyn::for_each_state<Number>(n, call, in<7>(a, n), in<7>(b, n), in<7>(c, n), out<entries>(result, n));
}

}  // namespace

extern "C" {

void inverse_dynamics(std::size_t n, const Number* q, const Number* qd, const Number* qdd, Number* tau) {
  three_inputs<7>(n, q, qd, qdd, tau, [](auto... of) { panda::inverse_dynamics(of...); });
}

void forward_dynamics(std::size_t n, const Number* q, const Number* qd, const Number* tau, Number* qdd) {
  three_inputs<7>(n, q, qd, tau, qdd, [](auto... of) { return panda::forward_dynamics(of...); });
}

void inertia_matrix(std::size_t n, const Number* q, Number* B) {
  flatdyn::for_each_state<Number>(
      n, [](auto... of) { panda::inertia_matrix(of...); }, in<7>(q, n), out<49>(B, n));
}

void gravity(std::size_t n, const Number* q, Number* g) {
  flatdyn::for_each_state<Number>(
      n, [](auto... of) { panda::gravity(of...); }, in<7>(q, n), out<7>(g, n));
}
}
