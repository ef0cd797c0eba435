// SPDX-License-Identifier: GPL-2.0-or-later
// The usual shapes of outputs in rows of functions.
#pragma once

#include "functions/function_row.hpp"

namespace flatdyn {

constexpr OutputRow scalar(const char* name, OutputQuantity quantity) {
  return {name, Layout::scalar, Extent::one, Extent::one, quantity};
}
constexpr OutputRow vector(const char* name, Extent rows, OutputQuantity quantity) {
  return {name, Layout::vector, rows, Extent::one, quantity};
}
constexpr OutputRow matrix(const char* name, Extent rows, Extent cols, OutputQuantity quantity) {
  return {name, Layout::matrix, rows, cols, quantity};
}
constexpr OutputRow per_joint(const char* name, OutputQuantity quantity) {
  return vector(name, Extent::joints, quantity);
}
constexpr OutputRow square(const char* name, OutputQuantity quantity) {
  return matrix(name, Extent::joints, Extent::joints, quantity);
}

}  // namespace flatdyn
