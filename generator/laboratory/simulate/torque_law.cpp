// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/simulate/torque_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "laboratory/simulate/unbounded.hpp"
#include "laboratory/trajectory/interpolation.hpp"
#include "laboratory/trajectory/pace_limits.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {

namespace {

// The largest force of each entry of τ.
Eigen::VectorXd effort_limits(const Mechanism& mechanism) {
  std::vector<double> limits(static_cast<std::size_t>(mechanism.base_bodies()), kUnbounded);
  const std::vector<double> of_joints = given_limits(mechanism).torque;
  limits.insert(limits.end(), of_joints.begin(), of_joints.end());
  return vector_of(limits);
}

}  // namespace

TorqueLaw::TorqueLaw(const Simulation& simulation, JointDynamics& dynamics)
    : simulation_(simulation),
      dynamics_(dynamics),
      constant_(vector_of(simulation.constant)),
      limits_(effort_limits(dynamics.mechanism())),
      torque_(constant_) {
  if (const auto& law = simulation.feedback) {
    kp_ = vector_of(law->kp);
    kd_ = vector_of(law->kd);
    position_ = vector_of(law->position);
  }
}

double TorqueLaw::next_knot(double t) const {
  if (simulation_.feedback && simulation_.period > 0) {
    // The factor keeps a knot at t from being returned when the division rounds down.
    return (std::floor(t / simulation_.period * (1 + 1e-12)) + 1) * simulation_.period;
  }
  if (!simulation_.samples) return kUnbounded;
  const std::vector<double>& times = simulation_.samples->times;
  const auto next = std::upper_bound(times.begin(), times.end(), t);
  return next == times.end() ? kUnbounded : *next;
}

void TorqueLaw::start(double t, const double* q, const double* qd) {
  held_ = false;
  if (simulation_.samples) {
    const std::vector<double>& times = simulation_.samples->times;
    const auto next = std::upper_bound(times.begin(), times.end(), t);
    sample_ = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, next - times.begin() - 1));
  }
  at(t, q, qd);
  held_ = simulation_.feedback && simulation_.period > 0;
}

const Eigen::VectorXd& TorqueLaw::at(double t, const double* q, const double* qd) {
  if (held_) return torque_;
  if (simulation_.feedback) feedback(t, q, qd);
  if (simulation_.samples) sampled(t);
  if (simulation_.saturate) saturate();
  return torque_;
}

void TorqueLaw::feedback(double t, const double* q, const double* qd) {
  const Eigen::Index n = dynamics_.joints();
  const Eigen::Map<const Eigen::VectorXd> position(q, n), speed(qd, n);
  const std::optional<Trajectory>& trajectory = simulation_.feedback->trajectory;
  Eigen::VectorXd wanted = -kd_.cwiseProduct(speed);
  if (trajectory) {
    const TrajectoryPoint desired = interpolated(*trajectory, trajectory->points.front().time + t);
    wanted += kp_.cwiseProduct(vector_of(desired.q) - position) + kd_.cwiseProduct(vector_of(desired.qd));
    if (simulation_.feedback->kind == FeedbackLaw::Kind::computed_torque) wanted += vector_of(desired.qdd);
  } else {
    wanted += kp_.cwiseProduct(position_ - position);
  }
  torque_ = constant_;
  if (simulation_.feedback->kind == FeedbackLaw::Kind::computed_torque) {
    const MotionTerms& terms = dynamics_.at(q, qd);
    torque_ += terms.B * wanted + terms.n;
  } else {
    torque_ += wanted;
    if (simulation_.feedback->gravity) torque_ += dynamics_.gravity(q);
  }
  const int of_base = dynamics_.mechanism().base_bodies();  // motors act on joints alone
  torque_.head(of_base) = constant_.head(of_base);
}

// The torques interpolated at t; before the first sample and after the last one, those of that sample.
void TorqueLaw::sampled(double t) {
  const TorqueSamples& samples = *simulation_.samples;
  const std::vector<double>& from = samples.torques[sample_];
  torque_ = constant_ + vector_of(from);
  const bool is_between = t > samples.times[sample_] && sample_ + 1 < samples.times.size();
  if (samples.between == TorqueSamples::Between::hold || !is_between) return;
  const double part = (t - samples.times[sample_]) / (samples.times[sample_ + 1] - samples.times[sample_]);
  torque_ += part * (vector_of(samples.torques[sample_ + 1]) - vector_of(from));
}

void TorqueLaw::saturate() { torque_ = torque_.cwiseMin(limits_).cwiseMax(-limits_); }

}  // namespace flatdyn
