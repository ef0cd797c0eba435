// SPDX-License-Identifier: GPL-2.0-or-later
// The payload of the tip: ten inertial parameters, identified as a change of the last link (7.4).
#pragma once

#include <algorithm>

#include "laboratory/identify/fit_quality.hpp"
#include "laboratory/identify/least_squares.hpp"
#include "laboratory/identify/torque_model.hpp"

namespace flatdyn {

// An estimate of a payload.
struct PayloadEstimate {
  // The ten parameters m, m l (3), Î_xx, xy, xz, yy, yz, zz in the frame of the tip's link, about its origin, SI.
  Eigen::VectorXd values, standard_deviations;  // infinite if the motion does not determine them
  // The nearest parameters of a real body, in the metric of the estimate's information.
  Eigen::VectorXd body;
  double largest_misfit = 0;  // the largest distance of body from values, in standard deviations
  Eigen::VectorXd unknowns;   // values of all unknowns of the problem
  // Changes of the ten parameters that nothing in the logs shows, one column each: a basis in which each has a 1 for a
  // parameter that the others lack.
  Eigen::MatrixXd untold;
};

// Equations whose first ten unknowns are the payload's parameters.
struct PayloadProblem {
  Observations observations;
  AccelerationRows acceleration_rows;
  Eigen::VectorXd prior;  // of all unknowns
};

// Motion with and without the payload. Both together determine the robot's own base parameters (`prior` where they do
// not); the uncertainty of these enters that of the payload. The equations without payload come behind those with it.
PayloadProblem payload_problem(const TorqueModel& model, const Observations& with_payload,
                               const Observations& without_payload, const Eigen::VectorXd& prior);

// Motion of a robot whose links are known: Y_b (π_b + K_L π_payload + K_F π_F) = τ, where K_L holds the columns of K
// for the tip's link, and π_F are the rotors and the friction that the robot file lacks and the model has.
PayloadProblem payload_problem(const TorqueModel& model, const LoadedRobot& robot, const Observations& with_payload);

PayloadEstimate estimate_payload(const PayloadProblem& problem);

// A payload, and how well the equations fit that it comes from: those of the joints with it, after those of a floating
// base's force, then those without it, if there is such a log. Of a sensor at the wrist there are no fits.
struct FittedPayload {
  PayloadEstimate payload;
  std::vector<JointFit> fits;
  Observations observations;
  std::vector<Measurement> measurements;  // with the payload, then without it
  // Whether the robot file's numbers count as exact, as there is but the log with the payload.
  bool is_by_file = false;

  // Deviations count noise alone: where a file does not fit, they would pretend.
  bool has_deviations() const {
    return !is_by_file || std::all_of(fits.begin(), fits.end(), [](const JointFit& each) { return each.is_sound(); });
  }
  bool is_of_wrist() const { return fits.empty(); }
};

// The payload from torques with it, as the change against those without it, or against the robot file if there is but
// one measurement. All are made with the equations of `model`.
FittedPayload fitted_payload(const TorqueModel& model, const LoadedRobot& robot, std::vector<Measurement> measurements);

// The logs of all measurements, one behind the other.
std::vector<MeasuredLog> all_logs(const std::vector<Measurement>& measurements);

// The first ten parameters of an estimate, and the nearest ones of a real body.
PayloadEstimate payload_of(const Estimate& estimate);

}  // namespace flatdyn
