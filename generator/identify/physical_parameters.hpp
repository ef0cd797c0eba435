// SPDX-License-Identifier: GPL-2.0-or-later
// From base parameters to a robot: of all dynamic parameters that some real body has, those that agree with π_b and are
// nearest to the robot file's in the log-determinant divergence of pseudo-inertias (Lee, Wensing, Park, 2020). That is
// infinite where a mass is not positive or a pseudo-inertia not positive definite, so that the result can be simulated
// and inverted.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "identify/least_squares.hpp"
#include "symbolic/parameters/base_parameters.hpp"

namespace flatdyn {

struct PhysicalParameters {
  std::vector<double> pi;     // 13 n, in the order of (7.77)
  Eigen::VectorXd pi_b;       // K π
  double largest_misfit = 0;  // of K π from π_b, over all directions that the data tell, in standard deviations
  // From the file, summed over links and joints: tr(A) - log det A - 4 with A = L⁻¹ P L⁻ᵀ, P_file = L Lᵀ, and
  // x - log x - 1 of each ratio x of I_m, F_v, F_s. A link that is twice as heavy counts 1.2.
  double divergence = 0;
  bool converged = false;
};

// `mechanism` is the robot as in the file; links that no body could have there (or that have no mass) start from a
// small sphere instead, so that a missing inertia is no obstacle, and what is thinner than a body can be is made a
// hundredth of its length thick. What the data do not tell is the file's. The links without the rotors that they carry
// are bodies, too.
PhysicalParameters physical_parameters(const Mechanism& mechanism, const BaseParameters& base,
                                       const Estimate& estimate);

// Of one body: the ten parameters nearest to an estimate that a body can have. root_information: r × 10.
struct NearestBody {
  Eigen::VectorXd ten;
  double largest_misfit = 0;  // from the estimate, in standard deviations
};
NearestBody nearest_body(const Eigen::VectorXd& estimate, const Eigen::MatrixXd& root_information);

// [Σ, h; hᵀ, m] with Σ = tr(Î)/2 E - Î, of ten inertial parameters as in (7.77): positive definite if and only if some
// body with a distribution of mass in space has them (Wensing, Kim, Slotine, 2018).
Eigen::Matrix4d pseudo_inertia(const double* ten);

}  // namespace flatdyn
