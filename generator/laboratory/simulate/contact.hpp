// SPDX-License-Identifier: GPL-2.0-or-later
// Joint forces that are no functions of the state: dry friction, and the stops at the ends of a joint's range.
//
// The textbook's F_s sgn(q̇) does not define friction at q̇ = 0. Here any force up to F_s holds a joint at rest; the
// joint starts to slide where that is not enough (Coulomb's law). A stop pushes as much as necessary and never pulls.
// Both are holding forces within a range, at one end of which the joint moves. Which joints move is decided for all
// together, as the solution of a convex problem, so nothing chatters.
#pragma once

#include <Eigen/Dense>
#include <vector>

namespace flatdyn {

struct JointContact {
  int sliding = 0;    // the sign of q̇ that dry friction opposes; 0: the joint is held, or has no dry friction
  int stop = 0;       // -1: pushed against the lower end of its range, 1: against the upper end, 0: no stop
  bool held = false;  // q̇ = 0 and q̈ = 0
};
using Contacts = std::vector<JointContact>;

// The least and the largest force with which dry friction F_s and the stop can hold a joint; infinite where a stop
// pushes.
struct HoldingRange {
  double least = 0, most = 0;
};
// The range for a joint with F_s = `coulomb`, N m or N.
HoldingRange holding_range(const JointContact& contact, double coulomb);

// q̈ of all joints, and the force of dry friction and stops on each of them, from B q̈ = r + λ with r = τ − n.
struct ContactMotion {
  Eigen::VectorXd qdd, lambda;
};
// The motion for these contacts. B: n × n; r: N m or N; coulomb: F_s of each joint.
ContactMotion motion_of(const Eigen::MatrixXd& B, const Eigen::VectorXd& r, const Eigen::VectorXd& coulomb,
                        const Contacts& contacts);

// Decides which joints are held from now on: of the joints with speed exactly 0, those that have dry friction or are at
// a stop; the others slide in the direction of their speed. `stops`: one per joint, as JointContact::stop.
Contacts decided_contacts(const Eigen::MatrixXd& B, const Eigen::VectorXd& r, const Eigen::VectorXd& coulomb,
                          const Eigen::VectorXd& qd, const std::vector<int>& stops);

// The speeds after joints have hit their stops, all at once and without bouncing: the speeds nearest to q̇ in the norm
// of the kinetic energy among those that do not pass a stop.
Eigen::VectorXd speeds_after_impact(const Eigen::MatrixXd& B, const Eigen::VectorXd& qd, const std::vector<int>& stops);

}  // namespace flatdyn
