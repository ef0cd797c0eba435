// SPDX-License-Identifier: GPL-2.0-or-later
// The arm as a system of differential equations that are valid until an event: a joint comes to rest, breaks away, or
// reaches the end of its range.
#pragma once

#include <vector>

#include "simulate/contact.hpp"
#include "simulate/joint_dynamics.hpp"
#include "simulate/torque_law.hpp"

namespace flatdyn {

// q, q̇, the work of the torques so far, and the energy that friction and stops have dissipated: 2 n + 2 numbers, SI.
using MotionState = std::vector<double>;

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

  TorqueLaw& law() { return law_; }
  const Contacts& contacts() const { return contacts_; }
  const Eigen::VectorXd& viscous() const { return dynamics_.viscous(); }
  long evaluations() const { return evaluations_; }

  MotionState initial_state() const;
  // dx/dt, as Boost.Odeint calls it.
  void operator()(const MotionState& x, MotionState& dx, double t);
  ContactMotion motion(const MotionState& x, double t);
  const Eigen::VectorXd& tau() const { return tau_; }  // τ at the last motion()
  // The kinetic energy, J, with B of the last motion() or decide().
  double kinetic_energy(const MotionState& x) const;
  Eigen::VectorXd positions(const MotionState& x);  // positions of all joints that are not coupled
  double potential_energy(const MotionState& x) { return dynamics_.potential_energy(x.data()); }

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
  std::vector<Range> ranges_;
  Contacts contacts_;
  Eigen::VectorXd tau_;
  long evaluations_ = 0;
};

}  // namespace flatdyn
