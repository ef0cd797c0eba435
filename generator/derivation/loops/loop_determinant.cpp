// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/loops/loop_determinant.hpp"

namespace flatdyn {
namespace {

constexpr std::size_t kAtOnce = 3;

// By its first row.
Number expanded_determinant(const Rows& A) {
  if (A.size() == 1) return A[0][0];
  Number sum = 0;
  for (std::size_t k = 0; k < A.size(); ++k) {
    Rows minor;
    for (std::size_t i = 1; i < A.size(); ++i) {
      minor.push_back(A[i]);
      minor.back().erase(minor.back().begin() + static_cast<std::ptrdiff_t>(k));
    }
    sum += (k % 2 == 0 ? A[0][k] : Number(-A[0][k])) * expanded_determinant(minor);
  }
  return sum;
}

// Minors of a matrix, by the rows that they begin with and by their columns.
class Minors {
 public:
  Minors(const Rows& A, Derivation& derivation, const std::string& name) : A_(A), d_(derivation), name_(name) {}

  Number whole() const {
    const std::size_t n = A_.size();
    Number sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 1; j < n; ++j) {
        std::vector<std::size_t> others;
        for (std::size_t k = 0; k < n; ++k) {
          if (k != i && k != j) others.push_back(k);
        }
        const Number product = minor(n - 2, {i, j}) * minor(0, others);
        sum += (i + j) % 2 == 1 ? product : Number(-product);
      }
    }
    return sum;
  }

 private:
  // By its first row, for a minor of three.
  Number minor(std::size_t row, const std::vector<std::size_t>& columns) const {
    if (columns.size() == 1) return A_[row][columns[0]];
    Number sum = 0;
    std::string name = name_ + std::to_string(row + 1);
    for (std::size_t k = 0; k < columns.size(); ++k) {
      std::vector<std::size_t> others = columns;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
      const Number product = A_[row][columns[k]] * minor(row + 1, others);
      sum += k % 2 == 0 ? product : Number(-product);
      name += "_" + std::to_string(columns[k] + 1);
    }
    return d_.named(sum, name);
  }

  const Rows& A_;
  Derivation& d_;
  const std::string& name_;
};

}  // namespace

Number determinant(const Rows& A, Derivation& derivation, const std::string& name) {
  return A.size() <= kAtOnce ? expanded_determinant(A) : Minors(A, derivation, name).whole();
}

// Beyond three rows b is the last column, wherever it came to be: so minors with it are found again, too.
Number determinant_with(const Rows& A, std::size_t c, const std::vector<Number>& b, Derivation& derivation,
                        const std::string& name) {
  Rows replaced = A;
  if (A.size() <= kAtOnce) {
    for (std::size_t r = 0; r < b.size(); ++r) replaced[r][c] = -b[r];
    return expanded_determinant(replaced);
  }
  for (std::size_t r = 0; r < b.size(); ++r) {
    replaced[r].erase(replaced[r].begin() + static_cast<std::ptrdiff_t>(c));
    replaced[r].push_back(b[r]);
  }
  const Number det = Minors(replaced, derivation, name).whole();
  return (A.size() - c) % 2 == 1 ? Number(-det) : det;
}

}  // namespace flatdyn
