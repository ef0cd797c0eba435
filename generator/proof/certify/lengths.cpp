// SPDX-License-Identifier: GPL-2.0-or-later
// Bounds of the length of a vector whose atoms are within their sizes; atoms that belong to one motion are bounded
// together.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "proof/certify/norms.hpp"

namespace flatdyn {

using Eigen::Index;
using Eigen::MatrixXd;

namespace {

// A summand of a vector, and its non-zero rows.
struct Part {
  std::set<Index> rows;
  double length = 0;

  bool is_apart(const Part& other) const {
    return std::none_of(rows.begin(), rows.end(), [&](Index row) { return other.rows.count(row) != 0; });
  }
  void add(const Part& other) {
    rows.insert(other.rows.begin(), other.rows.end());
    length += other.length;
  }
};

// A bound of the length of a sum; parts that have no row in common are orthogonal.
double length_of_sum(const std::vector<Part>& parts) {
  std::vector<Part> apart;
  for (Part part : parts) {
    const auto together =
        std::partition(apart.begin(), apart.end(), [&part](const Part& other) { return part.is_apart(other); });
    for (auto other = together; other != apart.end(); ++other) part.add(*other);
    apart.erase(together, apart.end());
    apart.push_back(std::move(part));
  }
  double squares = 0;
  for (const Part& part : apart) squares += part.length * part.length;
  return std::sqrt(squares);
}

}  // namespace

Norms::Vector Norms::part(const Vector& v, const std::vector<Index>& places) const {
  Vector result{{}, columns(v.of, places)};
  for (const Index k : places) result.atoms.push_back(v.atoms[static_cast<std::size_t>(k)]);
  return result;
}

double Norms::length(const Vector& v) {
  const double in_box = length_in_box(v.of);
  if (motions_ == nullptr || v.of.size() == 0) return in_box;
  std::map<int, std::vector<Index>> groups;
  for (Index k = 0; k < v.of.cols(); ++k) {
    const Atom& of = atoms_[v.atoms[static_cast<std::size_t>(k)]];
    groups[of.kind == Atom::Kind::given ? motions_->group(of.a) : -1].push_back(k);
  }
  std::vector<Part> parts;
  double rest = 0;
  for (const auto& [group, places] : groups) {
    const Vector summand = part(v, places);
    Part part;
    for (Index row = 0; row < summand.of.rows(); ++row) {
      const double size = summand.of.row(row).cwiseAbs().sum();
      if (size > kNegligible) {
        part.rows.insert(row);
      } else {
        rest += size;
      }
    }
    part.length = length_in_box(summand.of);
    if (group >= 0 && places.size() > 1) part.length = std::min(part.length, length_of_motion(summand));
    parts.push_back(std::move(part));
  }
  return std::min(in_box, (length_of_sum(parts) + rest) * kRoundingMargin);
}

// The length of a vector of results that belong to one motion.
double Norms::length_of_motion(const Vector& v) {
  MatrixXd rows = v.of;
  std::vector<int> operations;
  double slack = 0;
  for (Index k = 0; k < rows.cols(); ++k) {
    const int atom = v.atoms[static_cast<std::size_t>(k)];
    operations.push_back(atoms_[atom].a);
    rows.col(k) /= largest_of(atom);
    slack += rows.col(k).norm() * deviation(operations.back()).error;
  }
  return (motions_->largest_length(operations, rows) + slack) * kRoundingMargin;
}

}  // namespace flatdyn
