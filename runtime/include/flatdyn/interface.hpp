// SPDX-License-Identifier: BSD-3-Clause
// What generated code and these headers expect of each other, as a number that goes up whenever it changes. Where they
// meet, each asks the other for it: files of two versions in one build are a message then, and no wrong torque.
#pragma once

namespace flatdyn {

// 1: sources of sines and cosines are called with the joints by index; scalars are made from a double.
inline constexpr int kInterface = 1;

namespace detail {

// The number of a type of generated code; 0 where it has none, as before there were numbers. Called with nullptr.
template <class Type>
constexpr int interface_of(decltype(Type::flatdyn_interface)*) noexcept {
  return Type::flatdyn_interface;
}
template <class Type>
constexpr int interface_of(...) noexcept {
  return 0;
}

}  // namespace detail

}  // namespace flatdyn
