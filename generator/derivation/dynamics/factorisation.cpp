// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/factorisation.hpp"

#include <fmt/format.h>

namespace flatdyn {

namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

SingularInertia::SingularInertia(const Body& body)
    : Failure(FailureKind::unsupported,
              fmt::format("B(q) is singular, because joint \"{}\" moves no inertia", body.joint),
              "give the links that it moves their inertia, or its motor a rotor"),
      joint(body.joint) {}

Factorisation::Factorisation(Frames& frames, Rows B)
    : derivation_(frames.derivation()),
      base_bodies_(frames.mechanism().base_bodies()),
      L_(std::move(B)),
      inverse_(L_.size()) {
  const Mechanism& mechanism = frames.mechanism();
  // Coupled joints on different branches may have non-zero entries; zeros are then found one by one.
  for (int k = 0; k < mechanism.size(); ++k) parents_.push_back(mechanism.is_coupled() ? k - 1 : frames.body(k).parent);
  factorise([&mechanism](std::size_t k) { throw SingularInertia(mechanism.joint(static_cast<int>(k))); });
}

Factorisation::Factorisation(Derivation& derivation, std::vector<int> parents, Rows matrix, const std::string& what,
                             const std::string& prefix)
    : derivation_(derivation),
      parents_(std::move(parents)),
      prefix_(prefix),
      L_(std::move(matrix)),
      inverse_(L_.size()) {
  factorise([&what](std::size_t) { throw Failure(FailureKind::unsupported, what + " is singular everywhere"); });
}

void Factorisation::factorise(const std::function<void(std::size_t)>& fail_as_zero) {
  Derivation& d = derivation_;
  for (std::size_t k = 0; k < L_.size(); ++k) diagonal_.push_back(L_[k][k]);
  eliminated_.assign(L_.size(), std::vector<Number>(L_.size(), 0));
  for (std::size_t k = L_.size(); k-- > 0;) {
    const std::string row = name_of(k);
    if (vanishes(L_[k][k])) fail_as_zero(k);
    inverse_[k] = d.quotient(1, L_[k][k], prefix_ + "d_" + row);
    for (int i = parent(k); i >= 0; i = parent(index(i))) {
      const Number l = d.named(L_[k][index(i)] * inverse_[k], prefix_ + "l_" + row + "_" + name_of(index(i)));
      for (int j = i; j >= 0; j = parent(index(j))) {
        L_[index(i)][index(j)] = d.named(L_[index(i)][index(j)] - l * L_[k][index(j)],
                                         prefix_ + "b_" + row + "_" + name_of(index(i)) + "_" + name_of(index(j)));
      }
      eliminated_[k][index(i)] = l * L_[k][index(i)];
      L_[k][index(i)] = l;
    }
  }
  for (std::size_t k = 0; k < L_.size(); ++k) pivots_.push_back(L_[k][k]);
}

std::vector<Number> Factorisation::pivot_scales(const std::vector<Number>& sizes) const {
  Derivation& d = derivation_;
  std::vector<Number> scales = sizes;
  for (std::size_t k = L_.size(); k-- > 0;) {
    const std::string row = name_of(k);
    scales[k] = d.named(scales[k], prefix_ + "scale_" + row);
    const Number growth =
        scales[k].is_equal(pivots_[k]) ? Number(1) : d.named(scales[k] * inverse_[k], prefix_ + "growth_" + row);
    for (int i = parent(k); i >= 0; i = parent(index(i))) {
      const std::string name = prefix_ + "e_" + row + "_" + name_of(index(i));
      scales[index(i)] += growth * d.named(eliminated_[k][index(i)], name);
    }
  }
  return scales;
}

std::vector<Number> Factorisation::solved_transposed(std::vector<Number> b, const std::string& name) const {
  for (std::size_t k = b.size(); k-- > 0;) {
    for (int i = parent(k); i >= 0; i = parent(index(i))) {
      b[index(i)] =
          derivation_.named(b[index(i)] - L_[k][index(i)] * b[k], name + "_" + name_of(k) + "_" + name_of(index(i)));
    }
  }
  return b;
}

std::vector<Number> Factorisation::finished(const std::vector<Number>& y, const std::string& name) const {
  std::vector<Number> result;
  for (std::size_t k = 0; k < y.size(); ++k) {
    Number x = inverse_[k] * y[k];
    for (int i = parent(k); i >= 0; i = parent(index(i))) x -= L_[k][index(i)] * result[index(i)];
    result.push_back(derivation_.named(x, name + "_" + name_of(k)));
  }
  return result;
}

std::vector<Number> Factorisation::solve(std::vector<Number> b, const std::string& name) const {
  return finished(solved_transposed(std::move(b), "y"), name);
}

// Column k is found from L x = D⁻¹ y, Lᵀ y = e_k. The entries of x before k are known from the previous columns, by
// symmetry, and of y only its end is needed, which is that of e_k.
Rows Factorisation::inverse(const std::string& name) const {
  const std::size_t n = L_.size();
  Rows result(n, std::vector<Number>(n, 0));
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t j = k; j < n; ++j) {
      Number x = j == k ? inverse_[k] : Number(0);
      for (int i = parent(j); i >= 0; i = parent(index(i))) x -= L_[j][index(i)] * result[index(i)][k];
      const std::string entry = name + "_" + name_of(j) + "_" + name_of(k);
      result[j][k] = result[k][j] = derivation_.named(x, entry);
    }
  }
  return result;
}

}  // namespace flatdyn
