// SPDX-License-Identifier: GPL-2.0-or-later
// Bounds of the length of vectors M φ whose unknowns φ_k are only known to be within [-1, 1], or are rotated by an
// arbitrary angle. A vector may be replaced by Q M φ with any orthogonal Q.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace flatdyn {

// Columns shorter than this count as zero if the longest has length 1. It is much larger than the rounding errors of
// matrices with a few dozen entries, as used here.
inline constexpr double kNegligible = 1e-9;

// A bound of |M φ|: |M φ|² = Σ φ_i φ_j (Mᵀ M)_ij is no more than the sum of the terms' absolute values.
double length_in_box(const Eigen::MatrixXd& M);

// N with |(c C + s S) φ|² ≤ |N φ|² + kRestOfAngles² for every unit vector (c, s), if |(C, S)| ≤ 1. With Z = C + i S,
// the left side is
//     φᵀ Re(Z^H Z + e^(-2iθ) Zᵀ Z) φ / 2  ≤  φᵀ Re(Z^H Z + |Zᵀ Z|) φ / 2,  |T| = (T^H T)^(1/2),
// by Takagi's factorisation of the symmetric Zᵀ Z. A single row gives (C, S); rows that turn into each other, as x and
// y do in (c x - s y, s x + c y), give their own length.
inline constexpr double kNegligibleOfAngles = 1e-6;
Eigen::MatrixXd bound_over_all_angles(const Eigen::MatrixXd& C, const Eigen::MatrixXd& S);

// Q (chosen, others) = (of, coupled; 0, apart): the chosen columns occupy as few rows as possible. Below these rows
// they are not exactly zero, but add no more than `lost` to the length.
struct GatheredRows {
  Eigen::MatrixXd of, coupled, apart;
  double lost = 0;
};
GatheredRows gathered(const Eigen::MatrixXd& chosen, const Eigen::MatrixXd& others);

// Q M in row echelon form, with as few rows as possible; entries up to kNegligible are dropped.
Eigen::MatrixXd row_echelon(Eigen::MatrixXd M);

// These columns of M.
Eigen::MatrixXd columns(const Eigen::MatrixXd& M, const std::vector<Eigen::Index>& which);

// (a; b), and (a, 0; 0, b).
Eigen::MatrixXd stacked(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
Eigen::MatrixXd block_diagonal(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

}  // namespace flatdyn
