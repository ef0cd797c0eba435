// SPDX-License-Identifier: GPL-2.0-or-later
// The payload of the tip: ten inertial parameters, identified as a change of the last link (7.4).
#pragma once

#include "identify/least_squares.hpp"
#include "identify/torque_model.hpp"

namespace flatdyn {

// An estimate of a payload.
struct PayloadEstimate {
  // The ten parameters m, m l (3), Î_xx, xy, xz, yy, yz, zz in the frame of the tip's link, about its origin, SI.
  Eigen::VectorXd values, standard_deviations;  // infinite if the motion does not tell
  // The nearest parameters of a real body, in the metric of the estimate's information.
  Eigen::VectorXd body;
  double largest_misfit = 0;  // the largest distance of body from values, in standard deviations
};

// Estimates the payload from motion with and without it. Both together decide the robot's own base parameters (`prior`
// where they do not tell); the uncertainty of these enters that of the payload.
PayloadEstimate estimate_payload(const TorqueModel& model, const Observations& with_payload,
                                 const Observations& without_payload, const Eigen::VectorXd& prior);

// Estimates the payload of a robot whose base parameters without it are known: Y_b (π_b + K_L π_payload) = τ, where K_L
// holds the columns of K for the tip's link.
PayloadEstimate estimate_payload(const TorqueModel& model, const Observations& with_payload,
                                 const Eigen::VectorXd& without_payload);

// The first ten parameters of an estimate, and the nearest ones of a real body.
PayloadEstimate payload_of(const Estimate& estimate);

}  // namespace flatdyn
