// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>

#include "proof/certify/atom_numbering.hpp"
#include "proof/certify/norms.hpp"

namespace flatdyn {

using Eigen::Index;
using Eigen::MatrixXd;

double Norms::norm(const std::vector<Form>& rows, int effort) {
  AtomNumbering places;
  for (const Form& row : rows) {
    for (const auto& term : row) places(term.first);
  }
  if (places.size() == 0) return 0;
  Vector v = {places.atoms(), MatrixXd::Zero(static_cast<Index>(rows.size()), places.size())};
  for (Index k = 0; k < v.of.rows(); ++k) {
    for (const auto& [atom, coefficient] : rows[static_cast<std::size_t>(k)]) {
      v.of(k, places(atom)) = coefficient * largest_of(atom);
    }
  }
  return std::max(norm(v, effort), kLeastSize);
}

double Norms::largest_length(const std::vector<int>& operations, int effort) {
  std::vector<Form> rows;
  double slack = 0;
  for (const int k : operations) {
    rows.push_back(expansion(k).form);
    slack = std::hypot(slack, expansion(k).slack);
  }
  return (norm(rows, effort) + slack) * kRoundingMargin;
}

// The joint by whose angle the latest term of a sum is turned, followed by the factor that it turns.
std::vector<int> Norms::turned_last(const Form& form) const {
  int last = -1;
  for (const auto& term : form) {
    if (atoms_[term.first].kind == Atom::Kind::turned && (last < 0 || atoms_.is_later(term.first, last))) {
      last = term.first;
    }
  }
  std::vector<int> result;
  for (const auto& term : form) {
    const Atom& of = atoms_[term.first];
    if (of.kind == Atom::Kind::turned && of.joint == atoms_[last].joint) result.push_back(of.a);
  }
  return result;
}

bool Norms::may_rotate_together(int j, int k) {
  if (motions_ != nullptr && motions_->group(j) >= 0 && motions_->group(j) == motions_->group(k)) return true;
  const std::vector<int> a = turned_last(expansion(j).form), b = turned_last(expansion(k).form);
  return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
}

}  // namespace flatdyn
