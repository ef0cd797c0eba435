// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/simulate/motion_equation.hpp"

#include <algorithm>
#include <limits>

#include "laboratory/simulate/unbounded.hpp"

namespace flatdyn {
namespace {

// An event has happened once it is exceeded by this much: rad/s (m/s), rad (m), and the share of the force that
// friction can hold. The slack is far below the integration error and far above rounding.
constexpr double kSpeedSlack = 1e-11, kPositionSlack = 1e-11, kForceSlack = 1e-9;
// A joint that an impact leaves slower than this, in rad/s or m/s, stays at its stop.
constexpr double kSettlingSpeed = 1e-3;

constexpr int kDirections = 3;

}  // namespace

const char* to_string(EventKind kind) {
  static constexpr const char* kNames[] = {"rests", "slides", "meets its lower limit", "meets its upper limit",
                                           "leaves its limit"};  // in the order of EventKind
  return kNames[static_cast<std::size_t>(kind)];
}

MotionEquation::MotionEquation(const Simulation& simulation, JointDynamics& dynamics)
    : simulation_(simulation), dynamics_(dynamics), law_(simulation, dynamics), n_(dynamics.joints()) {
  contacts_.resize(static_cast<std::size_t>(n_));
  turns_ = turns();
  const Mechanism& mechanism = dynamics.mechanism();
  ranges_.assign(static_cast<std::size_t>(mechanism.base_bodies()), {-kUnbounded, kUnbounded});
  for (const Body& body : mechanism.joints()) {
    const Limits& limits = body.limits;
    ranges_.push_back({limits.lower ? nearest_double(limits.lower->number) : -kUnbounded,
                       limits.upper ? nearest_double(limits.upper->number) : kUnbounded});
  }
  const Vec3& g_0 = mechanism.gravity;
  gravity_ = {nearest_double(g_0[0]), nearest_double(g_0[1]), nearest_double(g_0[2])};
}

Eigen::VectorXd MotionEquation::positions(const MotionState& x) {
  const std::span<const double> q = dynamics_.positions(x.data());
  return Eigen::Map<const Eigen::VectorXd>(q.data(), static_cast<Eigen::Index>(q.size()));
}

void MotionEquation::start_law(const MotionState& x, double t) {
  turn_bodies(x);
  law_.start(t, x.data(), x.data() + n_);
}

MotionState MotionEquation::initial_state() const {
  MotionState x = simulation_.q;
  x.insert(x.end(), simulation_.qd.begin(), simulation_.qd.end());
  x.insert(x.end(), {0, 0});
  if (has_base()) {
    const auto& [position, orientation] = simulation_.base;
    std::copy(position.begin(), position.end(), x.begin());
    std::copy(orientation.begin() + 1, orientation.end(), x.begin() + kDirections);
    x.push_back(orientation[0]);
    x.insert(x.end(), 2 * kDirections, 0);
  }
  x.insert(x.end(), simulation_.w.begin(), simulation_.w.end());
  return x;
}

// The base's turn comes first.
std::vector<MotionEquation::Turn> MotionEquation::turns() const {
  std::vector<Turn> result;
  Eigen::Index w = 2 * n_ + 2;
  if (has_base()) {
    result.push_back({kDirections, w});
    w += 1 + 2 * kDirections;
  }
  for (const int first : dynamics_.mechanism().spherical) result.push_back({first, w++});
  return result;
}

void MotionEquation::turn_bodies(const MotionState& x) {
  if (has_base()) dynamics_.turn_base(orientation(x));
  dynamics_.turn_spherical_joints(x.data() + x.size() - dynamics_.mechanism().spherical.size());
}

Eigen::Quaterniond MotionEquation::orientation(const MotionState& x) const {
  return Eigen::Quaterniond(w_of(x), x[3], x[4], x[5]).normalized();
}

BasePose MotionEquation::pose(const MotionState& x) const {
  const Eigen::Quaterniond turned = orientation(x);
  return {{x[0], x[1], x[2]}, {turned.w(), turned.x(), turned.y(), turned.z()}};
}

bool MotionEquation::rescale_orientations(MotionState& x) const {
  bool is_changed = false;
  for (const Turn& turn : turns_) {
    double &w = *(x.data() + turn.w), *const r = x.data() + turn.r;
    const Eigen::Quaterniond unit = Eigen::Quaterniond(w, r[0], r[1], r[2]).normalized();
    is_changed = is_changed || unit.w() != w || unit.x() != r[0] || unit.y() != r[1] || unit.z() != r[2];
    w = unit.w(), r[0] = unit.x(), r[1] = unit.y(), r[2] = unit.z();
  }
  return is_changed;
}

// The centre of mass from the base's block of B, which contains m and S(m r_C).
Eigen::Vector3d MotionEquation::centre_of_mass() const {
  const Eigen::MatrixXd& B = dynamics_.last().B;
  return Eigen::Vector3d(B(1, 5), B(2, 3), B(0, 4)) / mass();
}

Momentum MotionEquation::momentum(const MotionState& x) const {
  const Eigen::Map<const Eigen::VectorXd> v(x.data() + n_, n_);
  Eigen::Matrix<double, 2 * kDirections, 1> about_origin = dynamics_.last().B.topRows<2 * kDirections>() * v;
  about_origin -= dynamics_.base_armature() * v.head<2 * kDirections>();
  const Eigen::Vector3d linear = about_origin.head<kDirections>(), angular = about_origin.tail<kDirections>();
  const Eigen::Quaterniond turned = orientation(x);
  return {turned * linear, turned * Eigen::Vector3d(angular - centre_of_mass().cross(linear))};
}

Momentum MotionEquation::impulse(const MotionState& x) const {
  const double* const first = x.data() + 2 * n_ + 3;
  return {Eigen::Map<const Eigen::Vector3d>(first), Eigen::Map<const Eigen::Vector3d>(first + kDirections)};
}

double MotionEquation::potential_energy(const MotionState& x) {
  turn_bodies(x);
  if (!has_base()) return dynamics_.potential_energy(x.data());
  return dynamics_.potential_energy(x.data()) - mass() * gravity_.dot(Eigen::Vector3d(x[0], x[1], x[2]));
}

// B and n where the base is.
const MotionTerms& MotionEquation::terms_at(const MotionState& x) { return dynamics_.at(x.data(), x.data() + n_); }

// Half the products of the quaternions and (0, ω).
void MotionEquation::turn_by_rates(const MotionState& x, MotionState& dx) const {
  for (const Turn& turn : turns_) {
    const double *const r = x.data() + turn.r, *const omega = x.data() + n_ + turn.r;
    const Eigen::Quaterniond turned = Eigen::Quaterniond(*(x.data() + turn.w), r[0], r[1], r[2]).normalized();
    const Eigen::Quaterniond rate = turned * Eigen::Quaterniond(0, omega[0] / 2, omega[1] / 2, omega[2] / 2);
    double* const rates = dx.data() + turn.r;
    rates[0] = rate.x(), rates[1] = rate.y(), rates[2] = rate.z(), *(dx.data() + turn.w) = rate.w();
  }
}

// The force and moment on the base, of which its own armature and friction take some.
Eigen::VectorXd MotionEquation::wrench_on_links(const MotionState& x, const ContactMotion& now) const {
  constexpr Eigen::Index kBase = 2 * kDirections;
  const Eigen::Map<const Eigen::VectorXd> v(x.data() + n_, kBase);
  Eigen::VectorXd acceleration = now.qdd.head(kBase);
  acceleration.head<kDirections>() += v.tail<kDirections>().cross(v.head<kDirections>());
  return tau_.head(kBase) + now.lambda.head(kBase) - dynamics_.viscous().head(kBase).cwiseProduct(v) -
         dynamics_.base_armature() * acceleration;
}

// ṗ = R v; forces of the base and gravity add to the momentum.
void MotionEquation::move_base(const MotionState& x, const ContactMotion& now, MotionState& dx) const {
  const Eigen::Map<const Eigen::Vector3d> v(x.data() + n_);
  const Eigen::Quaterniond turned = orientation(x);
  Eigen::Map<Eigen::Vector3d>(dx.data()) = turned * v;
  const Eigen::VectorXd wrench = wrench_on_links(x, now);
  const Eigen::Vector3d force = wrench.head<kDirections>(), moment = wrench.tail<kDirections>();
  double* const first = dx.data() + 2 * n_ + 3;
  Eigen::Map<Eigen::Vector3d>{first} = turned * force + mass() * gravity_;
  Eigen::Map<Eigen::Vector3d>{first + kDirections} = turned * Eigen::Vector3d(moment - centre_of_mass().cross(force));
}

ContactMotion MotionEquation::motion(const MotionState& x, double t) {
  turn_bodies(x);
  tau_ = law_.at(t, x.data(), x.data() + n_);
  const MotionTerms& terms = terms_at(x);
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
  derivative(2 * n_ + 1) = qd.dot(dynamics_.smooth_friction(qd) - now.lambda);
  turn_by_rates(x, dx);
  if (has_base()) move_base(x, now, dx);
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
    turn_bodies(x);
    terms_at(x);
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
  const double* const qd = x.data() + n_;
  turn_bodies(x);
  const Eigen::VectorXd tau = law_.at(t, x.data(), qd);
  const MotionTerms& terms = terms_at(x);
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
