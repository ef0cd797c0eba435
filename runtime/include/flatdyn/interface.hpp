// SPDX-License-Identifier: BSD-3-Clause
// The version of the interface between generated code and these headers, a number that rises with every change of it.
// Each side checks the other's, so mixing two versions in a build is a compile-time message instead of a wrong torque.
#pragma once

namespace flatdyn {

// Version 1: sources of sines and cosines are called with the joints by index; scalars are made from a double.
inline constexpr int kInterface = 1;

namespace detail {

// The version of a type of generated code; 0 if it has none, as before versions existed. Call it with nullptr.
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
