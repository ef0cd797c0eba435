// SPDX-License-Identifier: GPL-2.0-or-later
#include "simulate/motion_equation.hpp"

#include <algorithm>
#include <limits>

#include "simulate/unbounded.hpp"

namespace flatdyn {
namespace {

// An event has happened once it is exceeded by this much: rad/s (m/s), rad (m), and the share of the force that
// friction can hold. The slack is far below the integration error and far above rounding.
constexpr double kSpeedSlack = 1e-11, kPositionSlack = 1e-11, kForceSlack = 1e-9;
// A joint that an impact leaves slower than this, in rad/s or m/s, stays at its stop.
constexpr double kSettlingSpeed = 1e-3;

}  // namespace

const char* to_string(EventKind kind) {
  static constexpr const char* kNames[] = {"rests", "slides", "meets its lower limit", "meets its upper limit",
                                           "leaves its limit"};  // in the order of EventKind
  return kNames[static_cast<std::size_t>(kind)];
}

MotionEquation::MotionEquation(const Simulation& simulation, JointDynamics& dynamics)
    : simulation_(simulation), dynamics_(dynamics), law_(simulation, dynamics), n_(dynamics.joints()) {
  contacts_.resize(static_cast<std::size_t>(n_));
  for (const Body& body : dynamics.mechanism().joints()) {
    const Limits& limits = body.limits;
    ranges_.push_back({limits.lower ? nearest_double(limits.lower->number) : -kUnbounded,
                       limits.upper ? nearest_double(limits.upper->number) : kUnbounded});
  }
}

Eigen::VectorXd MotionEquation::positions(const MotionState& x) {
  const std::span<const double> q = dynamics_.positions(x.data());
  return Eigen::Map<const Eigen::VectorXd>(q.data(), static_cast<Eigen::Index>(q.size()));
}

MotionState MotionEquation::initial_state() const {
  MotionState x = simulation_.q;
  x.insert(x.end(), simulation_.qd.begin(), simulation_.qd.end());
  x.insert(x.end(), {0, 0});
  return x;
}

ContactMotion MotionEquation::motion(const MotionState& x, double t) {
  const double *q = x.data(), *qd = q + n_;
  tau_ = law_.at(t, q, qd);
  const MotionTerms& terms = dynamics_.at(q, qd);
  return motion_of(terms.B, tau_ - terms.n, dynamics_.coulomb(), contacts_);
}

void MotionEquation::operator()(const MotionState& x, MotionState& dx, double t) {
  ++evaluations_;
  const ContactMotion now = motion(x, t);
  const Eigen::Map<const Eigen::VectorXd> qd(x.data() + n_, n_);
  Eigen::Map<Eigen::VectorXd> derivative(dx.data(), 2 * n_ + 2);
  derivative.head(n_) = qd;
  derivative.segment(n_, n_) = now.qdd;
  derivative(2 * n_) = qd.dot(tau_);
  derivative(2 * n_ + 1) = qd.dot(dynamics_.viscous().cwiseProduct(qd) - now.lambda);
}

double MotionEquation::kinetic_energy(const MotionState& x) const {
  const Eigen::Map<const Eigen::VectorXd> qd(x.data() + n_, n_);
  return qd.dot(dynamics_.last().B * qd) / 2;
}

bool MotionEquation::has_events() const {
  return simulation_.at_limits != AtLimits::go_on || (dynamics_.coulomb().array() > 0).any();
}

double MotionEquation::limit_margin(const MotionState& x, std::size_t i) const {
  if (simulation_.at_limits == AtLimits::go_on) return kUnbounded;
  const int stop = contacts_[i].stop;
  const double below = stop < 0 ? kUnbounded : x[i] - ranges_[i].lower;
  const double above = stop > 0 ? kUnbounded : ranges_[i].upper - x[i];
  return std::min(below, above) + kPositionSlack;
}

// The distance of a joint from reversing, or from breaking away.
double MotionEquation::rest_margin(const MotionState& x, const Eigen::VectorXd& lambda, std::size_t i) const {
  const JointContact& contact = contacts_[i];
  const auto row = static_cast<Eigen::Index>(i);
  if (contact.sliding != 0) return contact.sliding * x[static_cast<std::size_t>(n_) + i] + kSpeedSlack;
  if (!contact.held) return kUnbounded;
  const double coulomb = dynamics_.coulomb()(row);
  const HoldingRange range = holding_range(contact, coulomb);
  return std::min(lambda(row) - range.least, range.most - lambda(row)) + kForceSlack * (1 + coulomb);
}

double MotionEquation::margin(const MotionState& x, double t) {
  const bool holds = std::any_of(contacts_.begin(), contacts_.end(), [](const JointContact& c) { return c.held; });
  const Eigen::VectorXd lambda = holds ? motion(x, t).lambda : Eigen::VectorXd();
  double least = kUnbounded;
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    least = std::min({least, limit_margin(x, i), rest_margin(x, lambda, i)});
  }
  return least;
}

bool MotionEquation::is_limit_met(const MotionState& x, std::size_t i, int side) const {
  if (simulation_.at_limits == AtLimits::go_on || contacts_[i].stop == side) return false;
  const double beyond = side < 0 ? ranges_[i].lower - x[i] : x[i] - ranges_[i].upper;
  return beyond > kPositionSlack;
}

// The end of its range, -1 or 1, at which a joint is exactly, because meet_event() has put it there or it started
// there; 0 for other joints.
std::vector<int> MotionEquation::stops(const MotionState& x) const {
  std::vector<int> sides(contacts_.size(), 0);
  if (simulation_.at_limits != AtLimits::stop) return sides;
  for (std::size_t i = 0; i < sides.size(); ++i) sides[i] = (x[i] == ranges_[i].upper) - (x[i] == ranges_[i].lower);
  return sides;
}

bool MotionEquation::meet_event(MotionState& x, double t, std::vector<MotionEvent>& events) {
  const auto n = static_cast<std::size_t>(n_);
  bool meets = false;
  for (std::size_t i = 0; i < n; ++i) {
    for (const int side : {-1, 1}) {
      if (!is_limit_met(x, i, side)) continue;
      meets = true;
      x[i] = side < 0 ? ranges_[i].lower : ranges_[i].upper;
      events.push_back(
          {t, static_cast<int>(i), side < 0 ? EventKind::meets_lower_limit : EventKind::meets_upper_limit});
    }
    if (contacts_[i].sliding * x[n + i] < 0) x[n + i] = 0;
  }
  if (meets && simulation_.at_limits == AtLimits::end) return true;
  if (meets) {
    Eigen::Map<Eigen::VectorXd> qd(x.data() + n_, n_);
    dynamics_.at(x.data(), qd.data());
    const double before = kinetic_energy(x);
    qd = speeds_after_impact(dynamics_.last().B, qd, stops(x));
    settle(x);
    x[2 * n + 1] += before - kinetic_energy(x);
  }
  decide(x, t, events);
  return false;
}

// Without this, joints at stops push each other off at ever shorter intervals, without end.
void MotionEquation::settle(MotionState& x) const {
  const std::vector<int> at = stops(x);
  for (std::size_t i = 0; i < at.size(); ++i) {
    double& speed = x[static_cast<std::size_t>(n_) + i];
    if (at[i] != 0 && std::abs(speed) < kSettlingSpeed) speed = 0;
  }
}

void MotionEquation::decide(const MotionState& x, double t, std::vector<MotionEvent>& events) {
  const double *q = x.data(), *qd = q + n_;
  const Eigen::VectorXd tau = law_.at(t, q, qd);
  const MotionTerms& terms = dynamics_.at(q, qd);
  const Contacts before = contacts_;
  contacts_ = decided_contacts(terms.B, tau - terms.n, dynamics_.coulomb(), Eigen::Map<const Eigen::VectorXd>(qd, n_),
                               stops(x));
  record(before, t, events);
}

void MotionEquation::record(const Contacts& before, double t, std::vector<MotionEvent>& events) const {
  for (std::size_t i = 0; i < before.size(); ++i) {
    const int joint = static_cast<int>(i);
    if (contacts_[i].held && !before[i].held) events.push_back({t, joint, EventKind::rests});
    if (before[i].stop != 0 && contacts_[i].stop == 0) events.push_back({t, joint, EventKind::leaves_limit});
    if (contacts_[i].sliding != 0 && contacts_[i].sliding != before[i].sliding) {
      events.push_back({t, joint, EventKind::slides});
    }
  }
}

}  // namespace flatdyn
