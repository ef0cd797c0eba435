// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/simulate/contact.hpp"

#include <algorithm>
#include <limits>

#include "laboratory/simulate/unbounded.hpp"

namespace flatdyn {
namespace {

constexpr int kMostSweeps = 10000;
constexpr double kRounding = 1e-12;  // relative to the largest force possible

// Finds forces λ within ranges on some coordinates of a = a_0 + B^-1 λ, such that a_i > 0 only where λ_i is at its
// minimum and a_i < 0 only where it is at its maximum. Projected Gauss–Seidel sweeps over B^-1 converge since B^-1 is
// positive definite.
struct BoundedForces {
  std::vector<Eigen::Index> at;
  std::vector<HoldingRange> ranges;  // one per entry of `at`
  Eigen::VectorXd lambda, result;    // lambda: one per entry of `at`; result: a of all coordinates, a_0 before solve()
  Eigen::VectorXd missing;  // per entry of `at`: the force that would make a_i zero with the other forces unchanged
};

void solve(const Eigen::MatrixXd& B, BoundedForces& forces) {
  const Eigen::MatrixXd inverse = B.llt().solve(Eigen::MatrixXd::Identity(B.rows(), B.cols()));
  forces.lambda = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(forces.at.size()));
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    double largest_change = 0;
    for (std::size_t k = 0; k < forces.at.size(); ++k) {
      const Eigen::Index i = forces.at[k];
      double& lambda = forces.lambda(static_cast<Eigen::Index>(k));
      const double wanted = lambda - forces.result(i) / inverse(i, i);
      const double change = std::clamp(wanted, forces.ranges[k].least, forces.ranges[k].most) - lambda;
      lambda += change;
      forces.result += change * inverse.col(i);
      largest_change = std::max(largest_change, std::abs(change));
    }
    if (largest_change <= 1e-15 * (1 + forces.lambda.lpNorm<Eigen::Infinity>())) break;
  }
  forces.missing = forces.result(forces.at).cwiseQuotient(inverse.diagonal()(forces.at));
}

bool rests_on_something(double coulomb, int stop) { return coulomb > 0 || stop != 0; }

int sign(double x) { return (x > 0) - (x < 0); }

std::vector<Eigen::Index> free_joints(const Contacts& contacts) {
  std::vector<Eigen::Index> free;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (!contacts[i].held) free.push_back(static_cast<Eigen::Index>(i));
  }
  return free;
}

}  // namespace

HoldingRange holding_range(const JointContact& contact, double coulomb) {
  return {contact.stop > 0 ? -kUnbounded : -coulomb, contact.stop < 0 ? kUnbounded : coulomb};
}

ContactMotion motion_of(const Eigen::MatrixXd& B, const Eigen::VectorXd& r, const Eigen::VectorXd& coulomb,
                        const Contacts& contacts) {
  const Eigen::Index n = r.size();
  ContactMotion motion{Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n)};
  for (Eigen::Index i = 0; i < n; ++i) motion.lambda(i) = -coulomb(i) * contacts[static_cast<std::size_t>(i)].sliding;
  const std::vector<Eigen::Index> free = free_joints(contacts);
  if (static_cast<Eigen::Index>(free.size()) == n) {
    motion.qdd = B.llt().solve(r + motion.lambda);
    return motion;
  }
  const Eigen::MatrixXd B_free = B(free, free);
  Eigen::VectorXd qdd_free = r(free) + motion.lambda(free);
  if (!free.empty()) B_free.llt().solveInPlace(qdd_free);
  motion.qdd(free) = qdd_free;
  const Eigen::VectorXd needed = B * motion.qdd - r;
  for (Eigen::Index i = 0; i < n; ++i) {
    if (contacts[static_cast<std::size_t>(i)].held) motion.lambda(i) = needed(i);
  }
  return motion;
}

Contacts decided_contacts(const Eigen::MatrixXd& B, const Eigen::VectorXd& r, const Eigen::VectorXd& coulomb,
                          const Eigen::VectorXd& qd, const std::vector<int>& stops) {
  Contacts contacts(stops.size());
  BoundedForces forces;
  Eigen::VectorXd driven = r;
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if (qd(row) != 0) {
      contacts[i].sliding = coulomb(row) > 0 ? sign(qd(row)) : 0;
      driven(row) -= coulomb(row) * contacts[i].sliding;
    } else if (rests_on_something(coulomb(row), stops[i])) {
      contacts[i] = {0, stops[i], true};
      forces.at.push_back(row);
      forces.ranges.push_back(holding_range(contacts[i], coulomb(row)));
    }
  }
  if (forces.at.empty()) return contacts;
  forces.result = B.llt().solve(driven);
  solve(B, forces);
  for (std::size_t k = 0; k < forces.at.size(); ++k) {
    const Eigen::Index i = forces.at[k];
    const double missing = forces.missing(static_cast<Eigen::Index>(k));
    if (std::abs(missing) <= kRounding * (1 + coulomb(i))) continue;
    contacts[static_cast<std::size_t>(i)] = {coulomb(i) > 0 ? sign(missing) : 0, 0, false};
  }
  return contacts;
}

Eigen::VectorXd speeds_after_impact(const Eigen::MatrixXd& B, const Eigen::VectorXd& qd,
                                    const std::vector<int>& stops) {
  BoundedForces impulses;
  for (std::size_t i = 0; i < stops.size(); ++i) {
    if (stops[i] == 0) continue;
    impulses.at.push_back(static_cast<Eigen::Index>(i));
    impulses.ranges.push_back(holding_range({0, stops[i], true}, 0));
  }
  impulses.result = qd;
  solve(B, impulses);
  // The speed of a joint that its stop has caught is exactly 0, not a rounding error.
  for (std::size_t k = 0; k < impulses.at.size(); ++k) {
    if (impulses.lambda(static_cast<Eigen::Index>(k)) != 0) impulses.result(impulses.at[k]) = 0;
  }
  return impulses.result;
}

}  // namespace flatdyn
