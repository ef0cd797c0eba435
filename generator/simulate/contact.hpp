// SPDX-License-Identifier: GPL-2.0-or-later
// What a joint meets that is no function of the state: dry friction, and the stops at the ends of its range.
//
// The textbook's F_s sgn(q̇) says nothing of q̇ = 0. Here a joint at rest is held by whatever force up to F_s it takes,
// and starts to slide where that is not enough (Coulomb's law). A stop pushes as much as it takes, and never pulls.
// Both are one thing: a holding force within a range, at one end of which the joint moves. Which joints move is decided
// for all together, as the solution of a convex problem, so nothing chatters.
#pragma once

#include <Eigen/Dense>
#include <vector>

namespace flatdyn {

struct JointContact {
  int sliding = 0;    // the sign of q̇ that dry friction opposes; 0: the joint is held, or it has no dry friction
  int stop = 0;       // -1: at the lower end of its range, 1: at the upper one, pushed against it
  bool held = false;  // q̇ = 0 and q̈ = 0
};
using Contacts = std::vector<JointContact>;

// Least and largest force that dry friction F_s and the stop can hold a joint with; infinite for a stop's push.
struct HoldingRange {
  double least = 0, most = 0;
};
HoldingRange holding_range(const JointContact& contact, double coulomb);

// q̈ of all joints, and the force of dry friction and stops on each, from B q̈ = r + λ with r = τ − n.
struct ContactMotion {
  Eigen::VectorXd qdd, lambda;
};
ContactMotion motion_of(const Eigen::MatrixXd& B, const Eigen::VectorXd& r, const Eigen::VectorXd& coulomb,
                        const Contacts& contacts);

// Which joints are held from now on. Joints with speed exactly 0 that have dry friction or are at a stop are decided
// upon; the others slide as their speed says. `stops`: by joint, as JointContact::stop.
Contacts decided(const Eigen::MatrixXd& B, const Eigen::VectorXd& r, const Eigen::VectorXd& coulomb,
                 const Eigen::VectorXd& qd, const std::vector<int>& stops);

// The speeds after joints have run into their stops, all at once and without bouncing: what is nearest to q̇ in the norm
// of the kinetic energy, of all speeds that do not go through a stop.
Eigen::VectorXd stopped(const Eigen::MatrixXd& B, const Eigen::VectorXd& qd, const std::vector<int>& stops);

}  // namespace flatdyn
