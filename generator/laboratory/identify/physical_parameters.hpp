// SPDX-License-Identifier: GPL-2.0-or-later
// From base parameters to a robot: of all physically consistent dynamic parameters that agree with π_b, those nearest
// to the robot file's in the log-determinant divergence of pseudo-inertias (Lee, Wensing, Park, 2020). The divergence
// is infinite unless masses are positive and pseudo-inertias positive definite, so the result can be simulated and its
// inertia matrix inverted.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "derivation/parameters/base_parameters.hpp"
#include "laboratory/identify/least_squares.hpp"

namespace flatdyn {

struct PhysicalParameters {
  std::vector<double> pi;  // 13 n, in the order of (7.77)
  Eigen::VectorXd pi_b;    // K π
  // The largest distance of K π from π_b over all directions that the data determine, in standard deviations
  double largest_misfit = 0;
  // The divergence from the file, summed over links and joints: tr(A) - log det A - 4 with A = L⁻¹ P L⁻ᵀ, P_file = L
  // Lᵀ, and x - log x - 1 for each ratio x of I_m, F_v, F_s that the file has. A link that is twice as heavy
  // counts 1.2.
  double divergence = 0;
  bool converged = false;
};

// `mechanism` is the robot of the file. Links that are not real bodies there, or have no mass, start from a small
// sphere, so that a missing inertia is no obstacle; a body that is too thin is made a hundredth of its length thick.
// I_m, F_v and F_s that the file lacks start from the sizes that π_b leaves room for: from far below a real rotor's,
// the search would hardly get there. Parameters that the data do not determine are the file's. The links without the
// rotors that they carry are real bodies, too.
PhysicalParameters physical_parameters(const Mechanism& mechanism, const BaseParameters& base,
                                       const Estimate& estimate);

// The ten parameters of a real body that are nearest to an estimate.
struct NearestBody {
  Eigen::VectorXd ten;
  double largest_misfit = 0;  // distance from the estimate, in standard deviations
};
// Finds that body. estimate: ten parameters in the order of (7.77); root_information: r × 10.
NearestBody nearest_body(const Eigen::VectorXd& estimate, const Eigen::MatrixXd& root_information);

// The pseudo-inertia [Σ, h; hᵀ, m], Σ = tr(Î)/2 E - Î, of ten inertial parameters as in (7.77). It is positive definite
// if and only if some distribution of mass in space has them (Wensing, Kim, Slotine, 2018).
Eigen::Matrix4d pseudo_inertia(const double* ten);

}  // namespace flatdyn
