// SPDX-License-Identifier: GPL-2.0-or-later
// Gauss-Jordan elimination over any field, without tolerances.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "robot/model/number.hpp"

namespace flatdyn {

// The reduced row echelon form: row r has 1 at pivots[r], where all other rows have 0.
template <class F>
struct Echelon {
  std::vector<std::vector<F>> rows;
  std::vector<std::size_t> pivots;
};

// Simplifies an element where the field needs it: expressions in symbols do not cancel by themselves.
template <class F>
F simplified(const F& x) {
  return x;
}
template <>
inline Number simplified(const Number& x) {
  return is_rational(x) ? x : x.normal();
}

// row -= factor · other.
template <class F>
void subtract_multiple(std::vector<F>& row, const F& factor, const std::vector<F>& other) {
  for (std::size_t k = 0; k < row.size(); ++k) row[k] = simplified<F>(row[k] - factor * other[k]);
}

// The reduced echelon form of the rows. Pivots are taken from the left: a column has one if and only if it does not
// depend on those before it. `is_zero` decides whether an element is zero.
template <class F, class IsZero>
Echelon<F> reduced_echelon(std::vector<std::vector<F>> rows, IsZero is_zero) {
  Echelon<F> result;
  const std::size_t columns = rows.empty() ? 0 : rows[0].size();
  std::size_t rank = 0;
  for (std::size_t column = 0; column < columns && rank < rows.size(); ++column) {
    const auto found = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(rank), rows.end(),
                                    [&](const std::vector<F>& row) { return !is_zero(row[column]); });
    if (found == rows.end()) continue;
    std::swap(rows[rank], *found);
    const F pivot = rows[rank][column];
    for (F& entry : rows[rank]) entry = simplified<F>(entry / pivot);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (r == rank || is_zero(rows[r][column])) continue;
      const F factor = rows[r][column];
      subtract_multiple(rows[r], factor, rows[rank]);
    }
    result.pivots.push_back(column);
    ++rank;
  }
  rows.resize(rank);
  result.rows = std::move(rows);
  return result;
}

// The space that rows span, in a field whose elements can be compared.
template <class F>
class RowSpace {
 public:
  std::size_t rank() const { return rows_.size(); }

  // Extends the space by a row; returns false if it is in the space already.
  bool extend(std::vector<F> row) {
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      const F factor = row[pivots_[r]];
      if (factor != F(0)) subtract_multiple(row, factor, rows_[r]);
    }
    const auto pivot = std::find_if(row.begin(), row.end(), [](const F& x) { return x != F(0); });
    if (pivot == row.end()) return false;
    pivots_.push_back(static_cast<std::size_t>(pivot - row.begin()));
    const F leading = *pivot;
    for (F& entry : row) entry = entry / leading;
    rows_.push_back(std::move(row));
    return true;
  }

 private:
  std::vector<std::vector<F>> rows_;  // each has 1 at its pivot, where those after it have 0
  std::vector<std::size_t> pivots_;
};

}  // namespace flatdyn
