// SPDX-License-Identifier: GPL-2.0-or-later
// What the tip carries: ten inertial parameters, identified as a change of the last link (7.4).
#pragma once

#include "identify/least_squares.hpp"

namespace flatdyn {

struct PayloadEstimate {
  // m, m l (3), Î_xx, xy, xz, yy, yz, zz in the frame of the tip's link, about its origin; SI.
  Eigen::VectorXd values, standard_deviations;  // infinite where the motion does not tell
  // The nearest ten that a body can have, in the metric of the estimate's information.
  Eigen::VectorXd body;
  double largest_misfit = 0;  // of body from values, in standard deviations
};

// From motion with the payload, and motion without it: both decide together what the robot's own base parameters are
// (`prior` where they do not tell), and what is not known of those is not known of the payload.
PayloadEstimate estimate_payload(const TorqueModel& model, const Observations& with_payload,
                                 const Observations& without_payload, const Eigen::VectorXd& prior);

// From motion with the payload, of a robot whose base parameters without it are known: Y_b (π_b + K_L π_payload) = τ,
// with K_L the columns of K for the link that the tip is on.
PayloadEstimate estimate_payload(const TorqueModel& model, const Observations& with_payload,
                                 const Eigen::VectorXd& without_payload);

// The first ten of an estimate, and the nearest ten that a body can have.
PayloadEstimate payload_of(const Estimate& estimate);

}  // namespace flatdyn
