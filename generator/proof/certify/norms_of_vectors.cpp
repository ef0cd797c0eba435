// SPDX-License-Identifier: GPL-2.0-or-later
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "proof/certify/atom_numbering.hpp"
#include "proof/certify/norms.hpp"

namespace flatdyn {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

double largest_eigenvalue(const MatrixXd& symmetric) {
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues().cwiseAbs().maxCoeff();
}

// A matrix under construction: columns that are multiples of another matrix's, several per atom.
class Columns {
 public:
  explicit Columns(const MatrixXd& of) : of_(of) {}
  void add(int atom, Index column, double factor) { parts_.push_back({places_(atom), column, factor}); }
  const std::vector<int>& atoms() const { return places_.atoms(); }
  MatrixXd sum() const {
    MatrixXd result = MatrixXd::Zero(of_.rows(), places_.size());
    for (const Part& part : parts_) result.col(part.place) += part.factor * of_.col(part.column);
    return result;
  }

 private:
  struct Part {
    Index place, column;
    double factor;
  };
  const MatrixXd& of_;
  AtomNumbering places_;
  std::vector<Part> parts_;
};

// The two sides of products, such that each product connected to the first factor has one factor on each side.
class Sides {
 public:
  Sides(int first_left, const std::vector<std::pair<int, int>>& products) : left_{first_left} {
    bool grows = true;
    while (grows) {
      grows = false;
      for (const auto& [a, b] : products) grows = join(a, b) || join(b, a) || grows;
    }
  }
  bool is_between(int a, int b) const { return left_.count(a) != 0 && right_.count(b) != 0; }

 private:
  bool join(int a, int b) {
    if (left_.count(a) != 0 && (a == b || left_.count(b) == 0) && right_.insert(b).second) return true;
    return right_.count(a) != 0 && right_.count(b) == 0 && left_.insert(b).second;
  }
  std::set<int> left_, right_;
};

}  // namespace

std::size_t Norms::HashOfKey::operator()(const std::vector<int>& key) const {
  std::size_t hash = key.size();
  for (const int x : key) hash = (hash ^ static_cast<std::size_t>(x)) * 0x9e3779b97f4a7c15u + (hash >> 29);
  return hash;
}

// Results are cached by the vector's row echelon form, divided by its size and rounded to the digits that matter.
double Norms::norm(const Vector& v, int effort) {
  constexpr double kDigits = 0x1p30;
  const double size = v.of.stableNorm();
  if (!(size > 0) || !std::isfinite(size)) return size;
  std::vector<Index> order(v.atoms.size());
  std::iota(order.begin(), order.end(), 0);
  const auto atom_at = [&v](Index k) { return v.atoms[static_cast<std::size_t>(k)]; };
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return atom_at(a) < atom_at(b); });
  const MatrixXd digits = (row_echelon(columns(v.of, order) / size) * kDigits).array().round();
  Vector unit;
  std::vector<int> key = {static_cast<int>(digits.rows())};
  std::vector<Index> kept;
  for (Index k = 0; k < digits.cols(); ++k) {
    if ((digits.col(k).array() == 0).all()) continue;
    kept.push_back(k);
    unit.atoms.push_back(atom_at(order[static_cast<std::size_t>(k)]));
    key.push_back(unit.atoms.back());
    for (const double entry : digits.col(k)) key.push_back(static_cast<int>(entry));
  }
  unit.of = columns(digits, kept) / kDigits;
  const auto found = known_.find(key);
  Known known = found == known_.end() ? Known{0, INFINITY} : found->second;
  if (known.effort < effort) {
    known = {effort, std::min(known.norm, norm_of_unit(unit, effort))};
    known_[std::move(key)] = known;
  }
  // In a column, rounding to digits loses less than kNegligible in each row, and row_echelon twice as much in all.
  const double rows = static_cast<double>(digits.rows()), lost = (2 + std::sqrt(rows)) * kNegligible;
  return (known.norm + static_cast<double>(v.of.cols()) * lost) * size * kRoundingMargin;
}

// The latest atom that can be replaced; -1 if there is no such atom.
int Norms::latest(const Vector& v) const {
  int result = -1;
  for (const int atom : v.atoms) {
    const Atom::Kind kind = atoms_[atom].kind;
    const bool is_replaced = kind == Atom::Kind::turned || kind == Atom::Kind::product;
    if (is_replaced && (result < 0 || atoms_.is_later(atom, result))) result = atom;
  }
  return result;
}

// The latest factor of all products, if it is a result, which may be a sum; else -1.
int Norms::latest_factor(const Vector& v) const {
  int result = -1;
  for (const int atom : v.atoms) {
    const Atom& of = atoms_[atom];
    if (of.kind != Atom::Kind::product) continue;
    for (const int factor : {of.a, of.b}) {
      if (result < 0 || atoms_.is_later(factor, result)) result = factor;
    }
  }
  return result >= 0 && atoms_[result].kind == Atom::Kind::result ? result : -1;
}

// Half of the effort goes to multiplying products out, if that is possible; the rest to the other methods, in the order
// in which they tend to be good.
double Norms::norm_of_unit(const Vector& v, int effort) {
  double least = length(v);
  const int last = latest(v);
  if (last < 0) return least;
  const Atom& of = atoms_[last];
  const auto try_bound = [&least](double bound) { least = std::min(least, bound); };
  if (of.kind == Atom::Kind::turned) {
    try_bound(norm_by_rotation(v, of.joint, effort));
    return least;
  }
  if (const int factor = latest_factor(v); factor >= 0) {
    try_bound(norm_by_opening(v, factor, (effort + 1) / 2));
    effort /= 2;
  }
  if (effort == 0) return least;
  const int ways = std::min(4, effort), each = effort / ways;
  try_bound(norm_by_squares(v, true, each));
  if (ways > 1) try_bound(norm_by_factors(v, of.a, each));
  if (ways > 2 && of.a != of.b) try_bound(norm_by_factors(v, of.b, each));
  if (ways > 3) try_bound(norm_by_squares(v, false, each));
  return least;
}

Norms::Chosen Norms::chosen(const Vector& v, const std::function<bool(const Atom&)>& is_chosen) const {
  Chosen result;
  std::vector<Index> of, others;
  for (Index k = 0; k < v.of.cols(); ++k) {
    const int atom = v.atoms[static_cast<std::size_t>(k)];
    const bool is_one = is_chosen(atoms_[atom]);
    (is_one ? of : others).push_back(k);
    (is_one ? result.atoms : result.others).push_back(atom);
  }
  result.rows = gathered(columns(v.of, of), columns(v.of, others));
  return result;
}

// A bound of |c_i A + s_i B + C|.
double Norms::norm_by_rotation(const Vector& v, int joint, int effort) {
  const Chosen turning =
      chosen(v, [joint](const Atom& of) { return of.kind == Atom::Kind::turned && of.joint == joint; });
  AtomNumbering factors;
  for (const int atom : turning.atoms) factors(atoms_[atom].a);
  MatrixXd A = MatrixXd::Zero(turning.rows.of.rows(), factors.size()), B = A;
  for (Index k = 0; k < turning.rows.of.cols(); ++k) {
    const Atom& of = atoms_[turning.atoms[static_cast<std::size_t>(k)]];
    (of.is_cosine ? A : B).col(factors(of.a)) = turning.rows.of.col(k);
  }
  // If a vector x is longer by this much, every sum with it is longer by no more.
  return (norm_of_sum({factors.atoms(), bound_over_all_angles(A, B)}, turning, effort) + kNegligibleOfAngles) *
         kRoundingMargin;
}

// A bound by expanding one factor of products.
double Norms::norm_by_opening(const Vector& v, int factor, int effort) {
  constexpr std::size_t kMost = 60;  // largest number of atoms
  const Expansion& sum = expansion(atoms_[factor].a);
  double size_of_sum = 0;
  for (const auto& [x, c] : sum.form) size_of_sum += std::abs(c) * largest_of(x);
  Columns opened(v.of);
  double slack = 0;
  for (Index k = 0; k < v.of.cols(); ++k) {
    const int atom = v.atoms[static_cast<std::size_t>(k)];
    const Atom& of = atoms_[atom];
    const double size = largest_of(atom);
    if (of.kind != Atom::Kind::product || (of.a != factor && of.b != factor)) {
      opened.add(atom, k, 1);
      continue;
    }
    if (!(size > 0)) continue;
    const int other = of.a == factor ? of.b : of.a;
    // The slack times another factor; times the same one, (x + e)² = x² + x e + e (x + e).
    const double of_slack = largest_of(other) + (other == factor ? size_of_sum : 0);
    slack += v.of.col(k).norm() * (sum.slack * of_slack / size) * kRoundingMargin;
    for (const auto& [x, c] : sum.form) {
      for (const auto& [y, d] : other == factor ? sum.form : Form{{other, 1}}) {
        const int product = atoms_.product(x, y);
        opened.add(product, k, c * d * (largest_of(product) / size));
      }
    }
    if (opened.atoms().size() > kMost) return INFINITY;
  }
  return norm({{opened.atoms(), opened.sum()}, slack}, effort);
}

// A bound of Σ x_l y_r m_lr = Σ x_l Y_l, which is no longer than |(w_l x_l)| |(Y_l / w_l)| for any weights.
double Norms::norm_by_factors(const Vector& v, int left, int effort) {
  std::vector<std::pair<int, int>> all;
  for (const int atom : v.atoms) {
    if (atoms_[atom].kind == Atom::Kind::product) all.emplace_back(atoms_[atom].a, atoms_[atom].b);
  }
  const Sides sides(left, all);
  const Chosen products = chosen(v, [&sides](const Atom& of) {
    return of.kind == Atom::Kind::product && (sides.is_between(of.a, of.b) || sides.is_between(of.b, of.a));
  });
  AtomNumbering lefts, rights;
  std::vector<std::pair<Index, Index>> places;
  for (const int atom : products.atoms) {
    const Atom& of = atoms_[atom];
    const bool is_forward = sides.is_between(of.a, of.b);
    places.emplace_back(lefts(is_forward ? of.a : of.b), rights(is_forward ? of.b : of.a));
  }
  const MatrixXd& m = products.rows.of;
  Vector x = {lefts.atoms(), MatrixXd::Zero(lefts.size(), lefts.size())};
  MatrixXd of_rights(0, rights.size());
  for (Index l = 0; l < lefts.size(); ++l) {
    MatrixXd Y = MatrixXd::Zero(m.rows(), rights.size());
    for (Index k = 0; k < m.cols(); ++k) {
      const auto& [at_left, at_right] = places[static_cast<std::size_t>(k)];
      if (at_left == l) Y.col(at_right) += m.col(k);
    }
    const double weight = std::sqrt(length_in_box(Y));
    if (!(weight > 0)) continue;
    x.of(l, l) = weight;
    of_rights = stacked(of_rights, Y / weight);
  }
  const double of_lefts = std::min(norm(substituted(x), effort), length(x));
  return norm_of_sum({rights.atoms(), of_lefts * of_rights}, products, effort);
}

// A bound of quadratic forms of x, row by row: their largest eigenvalue times |x|², with x scaled by the bounds of its
// entries, or not.
double Norms::norm_by_squares(const Vector& v, bool in_units, int effort) {
  const Chosen products = chosen(v, [](const Atom& of) { return of.kind == Atom::Kind::product; });
  AtomNumbering factors;
  double largest = 0;
  for (const int atom : products.atoms) {
    for (const int factor : {atoms_[atom].a, atoms_[atom].b}) {
      factors(factor);
      largest = std::max(largest, largest_of(factor));
    }
  }
  const Index size = factors.size();
  Vector x = {factors.atoms(), MatrixXd::Identity(size, size)};
  for (Index k = 0; in_units && k < size; ++k) {
    x.of(k, k) = largest_of(x.atoms[static_cast<std::size_t>(k)]) / largest;
    if (!(x.of(k, k) > 0)) return INFINITY;
  }
  double squares = 0;
  MatrixXd all(products.rows.of.rows(), size * size);
  for (Index row = 0; row < all.rows(); ++row) {
    MatrixXd form = MatrixXd::Zero(size, size);
    for (std::size_t k = 0; k < products.atoms.size(); ++k) {
      const Index i = factors(atoms_[products.atoms[k]].a), j = factors(atoms_[products.atoms[k]].b);
      const double half = products.rows.of(row, static_cast<Index>(k)) / (x.of(i, i) * x.of(j, j)) / 2;
      form(i, j) += half;
      form(j, i) += half;
    }
    const double eigenvalue = largest_eigenvalue(form);
    squares += eigenvalue * eigenvalue;
    all.row(row) = form.reshaped().transpose();
  }
  if (all.rows() > 1) squares = std::min(squares, largest_eigenvalue(all * all.transpose()));
  const double of_x = std::min(norm(substituted(x), effort), length(x));
  return norm_of_sum({{Atoms::kOne}, MatrixXd::Constant(1, 1, std::sqrt(squares) * of_x * of_x)}, products, effort);
}

// A bound of |(x + y, z)|, where x has replaced the chosen part; λ is the ratio of their lengths.
double Norms::norm_of_sum(const Vector& x, const Chosen& chosen, int effort) {
  constexpr int kForTheRatio = 4;
  const Vector y = {chosen.others, chosen.rows.coupled};
  const MatrixXd& z = chosen.rows.apart;
  double of_x = length(x), of_y = length(y), slack = chosen.rows.lost;
  if (effort >= kForTheRatio && of_y > kNegligible && of_x > kNegligible) {
    of_x = std::min(of_x, norm(substituted(x), 1));
    of_y = std::min(of_y, norm(substituted(y), 1));
  }
  Vector sum = {x.atoms, {}};
  sum.atoms.insert(sum.atoms.end(), y.atoms.begin(), y.atoms.end());
  if (of_y <= kNegligible) {
    slack += of_y;
    sum.of = block_diagonal(x.of, z);
  } else if (of_x <= kNegligible) {
    slack += of_x;
    sum.of = block_diagonal(MatrixXd::Zero(0, x.of.cols()), stacked(y.of, z));
  } else {
    const double ratio = of_y / of_x;
    sum.of = block_diagonal(std::sqrt(1 + ratio) * x.of, stacked(std::sqrt(1 + 1 / ratio) * y.of, z));
  }
  return (std::min(norm(substituted(sum), effort), length(sum)) + slack) * kRoundingMargin;
}

// Expands results in it into their sums.
Norms::BoundedVector Norms::substituted(const Vector& v) {
  Columns written(v.of);
  double slack = 0;
  for (Index k = 0; k < v.of.cols(); ++k) {
    const int atom = v.atoms[static_cast<std::size_t>(k)];
    if (atoms_[atom].kind != Atom::Kind::result) {
      written.add(atom, k, 1);
      continue;
    }
    const Expansion& sum = expansion(atoms_[atom].a);
    const double size = largest_of(atom);
    if (!(size > 0)) continue;
    slack += v.of.col(k).norm() * (sum.slack / size) * kRoundingMargin;
    for (const auto& [b, coefficient] : sum.form) written.add(b, k, coefficient * (largest_of(b) / size));
  }
  return {{written.atoms(), written.sum()}, slack};
}

}  // namespace flatdyn
