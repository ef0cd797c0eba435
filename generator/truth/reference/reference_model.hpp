// SPDX-License-Identifier: GPL-2.0-or-later
// Robot, as written → the numeric reference's robot, over any scalar. The frames, merging and regrouping of the
// mechanism are not used.
#pragma once

#include "flatdyn/reference/kinematics.hpp"
#include "flatdyn/reference/real50.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

using reference::Real50;

// The values of the robot's free symbols, in their order.
using SymbolValues = std::vector<Number>;

// Small positive numbers, different for each symbol and seed, that doubles hold exactly.
SymbolValues random_symbol_values(const Robot& robot, unsigned seed);

// The number nearest to `a`, with the symbols' values substituted.
template <class S>
S to_scalar(const Number& a, const GiNaC::exmap& values);

// The robot as written, over S, with values for its free symbols.
template <class S>
reference::Robot<S> reference_robot(const Robot& robot, const SymbolValues& values);

template <class S>
reference::VectorX<S> vector_of(const std::vector<S>& values) {
  return Eigen::Map<const reference::VectorX<S>>(values.data(), static_cast<Eigen::Index>(values.size()));
}

template <class Matrix>
std::vector<typename Matrix::Scalar> row_by_row(const Matrix& m) {
  std::vector<typename Matrix::Scalar> entries;
  for (Eigen::Index i = 0; i < m.rows(); ++i) {
    for (Eigen::Index j = 0; j < m.cols(); ++j) entries.push_back(m(i, j));
  }
  return entries;
}

extern template double to_scalar<double>(const Number&, const GiNaC::exmap&);
extern template Real50 to_scalar<Real50>(const Number&, const GiNaC::exmap&);
extern template reference::Robot<double> reference_robot(const Robot&, const SymbolValues&);
extern template reference::Robot<Real50> reference_robot(const Robot&, const SymbolValues&);

}  // namespace flatdyn
