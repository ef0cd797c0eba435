// SPDX-License-Identifier: GPL-2.0-or-later
// The arm as a system of differential equations that are valid until an event: a joint comes to rest, breaks away, or
// reaches the end of its range.
#pragma once

#include <vector>

#include "laboratory/simulate/contact.hpp"
#include "laboratory/simulate/joint_dynamics.hpp"
#include "laboratory/simulate/torque_law.hpp"

namespace flatdyn {

// q, q̇, the work of the torques so far, and the energy that friction and stops have dissipated: 2 n + 2 numbers, SI.
// With a floating base the first six of q are its position and x, y, z of its unit quaternion, and there are seven more
// numbers: w of the quaternion, and what force and moment about the centre of mass add up to over time, in world axes.
// The three of q of a spherical joint are x, y, z of its unit quaternion; w of each comes last.
using MotionState = std::vector<double>;

// The robot's momentum, kg m/s, and its moment about the centre of mass, kg m²/s.
struct Momentum {
  Eigen::Vector3d linear = Eigen::Vector3d::Zero(), angular = Eigen::Vector3d::Zero();
};

enum class EventKind { rests, slides, meets_lower_limit, meets_upper_limit, leaves_limit };
const char* to_string(EventKind kind);

struct MotionEvent {
  double time = 0;  // s
  int joint = 0;
  EventKind kind = EventKind::rests;
};

class MotionEquation {
 public:
  MotionEquation(const Simulation& simulation, JointDynamics& dynamics);

  double next_knot(double t) const { return law_.next_knot(t); }
  void start_law(const MotionState& x, double t);  // TorqueLaw::start()
  const Contacts& contacts() const { return contacts_; }
  Eigen::VectorXd smooth_friction(const Eigen::VectorXd& qd) const { return dynamics_.smooth_friction(qd); }
  long evaluations() const { return evaluations_; }

  MotionState initial_state() const;
  // dx/dt, as Boost.Odeint calls it.
  void operator()(const MotionState& x, MotionState& dx, double t);
  ContactMotion motion(const MotionState& x, double t);
  const Eigen::VectorXd& tau() const { return tau_; }  // τ at the last motion()
  // The kinetic energy, J, with B of the last motion() or decide().
  double kinetic_energy(const MotionState& x) const;
  Eigen::VectorXd positions(const MotionState& x);  // positions of all joints that are not coupled
  double potential_energy(const MotionState& x);

  // With a floating base, in world axes; momentum with B of the last motion() or decide().
  bool has_base() const { return dynamics_.mechanism().floating_base; }
  BasePose pose(const MotionState& x) const;
  Eigen::Vector3d base_gravity(const MotionState& x) const { return orientation(x).conjugate() * gravity_; }
  Momentum momentum(const MotionState& x) const;
  Momentum impulse(const MotionState& x) const;  // what forces have added to the momentum since the start
  // Rescales all quaternions to unit length, and returns whether the length of any was another one.
  bool rescale_orientations(MotionState& x) const;

  // Whether there is any dry friction or stop.
  bool has_events() const;

  // A margin that becomes negative as soon as an event ends the validity of contacts().
  double margin(const MotionState& x, double t);
  // Brings joints to rest, or against their stops, and decides contacts anew. Returns true if that ends the simulation.
  // Changes are appended to `events`.
  bool meet_event(MotionState& x, double t, std::vector<MotionEvent>& events);
  // Decides which joints move from now on, at the start and at knots, where torques may jump.
  void decide(const MotionState& x, double t, std::vector<MotionEvent>& events);

 private:
  struct Range {
    double lower, upper;
  };

  // A quaternion whose x, y, z begin at one place of the state, and whose w is at another.
  struct Turn {
    Eigen::Index r, w;
  };
  std::vector<Turn> turns() const;
  Eigen::Quaterniond orientation(const MotionState& x) const;
  void turn_bodies(const MotionState& x);  // before anything is evaluated at x
  const MotionTerms& terms_at(const MotionState& x);
  void move_base(const MotionState& x, const ContactMotion& now, MotionState& dx) const;
  Eigen::VectorXd wrench_on_links(const MotionState& x, const ContactMotion& now) const;
  void turn_by_rates(const MotionState& x, MotionState& dx) const;
  double mass() const { return dynamics_.last().B(0, 0) - dynamics_.base_armature(); }
  Eigen::Vector3d centre_of_mass() const;
  double w_of(const MotionState& x) const { return x[static_cast<std::size_t>(2 * n_ + 2)]; }

  bool is_limit_met(const MotionState& x, std::size_t i, int side) const;
  double limit_margin(const MotionState& x, std::size_t i) const;
  double rest_margin(const MotionState& x, const Eigen::VectorXd& lambda, std::size_t i) const;
  std::vector<int> stops(const MotionState& x) const;
  void settle(MotionState& x) const;
  void record(const Contacts& before, double t, std::vector<MotionEvent>& events) const;

  const Simulation& simulation_;
  JointDynamics& dynamics_;
  TorqueLaw law_;
  Eigen::Index n_;
  std::vector<Turn> turns_;
  std::vector<Range> ranges_;
  Contacts contacts_;
  Eigen::VectorXd tau_;
  Eigen::Vector3d gravity_;  // g_0, m/s^2
  long evaluations_ = 0;
};

}  // namespace flatdyn
