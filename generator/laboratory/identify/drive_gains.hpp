// SPDX-License-Identifier: GPL-2.0-or-later
// The gains of a robot's drives, from motion with a payload of known mass and without it (Gautier and Briot, "Global
// identification of joint drive gains and dynamic parameters of robots", J. Dyn. Sys. Meas. Control 136, 2014): the
// mass fixes the scale of all torques, which motion without it leaves open.
#pragma once

#include "laboratory/identify/payload.hpp"

namespace flatdyn {

struct DriveGains {
  // By joint: the factor that makes the logged torques right, and the standard deviation of its estimate, infinite
  // where the logs do not tell it.
  Eigen::VectorXd factors, standard_deviations;
  // The payload's ten parameters; its mass has no deviation. The unknowns are its other nine, π_b of the robot without
  // it, and by joint the relative change of 1/factor, which has become small.
  FittedPayload fit;
  bool converged = false;
};

// `mass`: of the payload, kg, which counts as exact. The equations of a floating base's force count as they are. Noise
// of the logged torques does not bias the factors, as it would where torques stand among the regressors. Throws
// Failure(input) if the logs are too short.
DriveGains drive_gains(const TorqueModel& model, std::vector<Measurement> measurements, double mass);

}  // namespace flatdyn
