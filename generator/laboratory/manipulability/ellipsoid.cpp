// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/manipulability/ellipsoid.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "functions/planning/make_functions.hpp"
#include "laboratory/manipulability/tip_directions.hpp"
#include "laboratory/trajectory/pace_limits.hpp"
#include "robot/model/spherical_joint.hpp"

namespace flatdyn {
namespace {

// The centre of an ellipsoid is how the robot falls: with such armature, its parts do not fall alike.
void refuse_base_armature(const Mechanism& mechanism) {
  if (!mechanism.floating_base || vanishes(mechanism.bodies.front().armature)) return;
  throw Failure(FailureKind::unsupported, "manipulability: a floating base with armature of its own is not supported",
                "a real base has none: write <freejoint/>, or leave armature out of [base]");
}

void refuse_angles(const Mechanism& mechanism) {
  if (!mechanism.task.has_angles()) return;
  throw Failure(FailureKind::unsupported, "an ellipsoid has base axes, and the scene asks for Euler angles",
                "take `orientation` out of the scene");
}

// Refuses a singular B, judged by the pivots of its Cholesky factor: that of a joint that moves no inertia is only
// rounding.
void refuse_singular(const Eigen::MatrixXd& B, const std::vector<double>& q) {
  constexpr double kRounding = 1e-13;
  const Eigen::LLT<Eigen::MatrixXd> factor(B);
  const Eigen::ArrayXd pivots = Eigen::MatrixXd(factor.matrixL()).diagonal().array().square();
  const bool is_positive = (pivots > kRounding * B.diagonal().array()).all();  // false for NaN
  if (factor.info() == Eigen::Success && is_positive) return;
  throw Failure(FailureKind::input,
                fmt::format("the inertia matrix is not positive definite at q = {}", fmt::join(q, ", ")),
                "leave such positions out; where it is so everywhere, give the last links inertia");
}

// The tip's Jacobian, and the inertia matrix.
struct MotionOfJoint {
  Eigen::MatrixXd J, B;
};

// The part of the joints while nothing holds the base, whose `base` entries come first (none if it is fixed): from
// B_bb a_b + B_bq q̈ = 0 its accelerations are a_b = -B_bb^-1 B_bq q̈, so the tip's are J* q̈ with
//     J* = J_q - J_b B_bb^-1 B_bq
// the generalised Jacobian of Umetani and Yoshida (1989), and the torques are B* q̈ with B* = B_qq - B_qb B_bb^-1 B_bq.
MotionOfJoint of_joints(MotionOfJoint whole, Eigen::Index base) {
  if (base == 0) return whole;
  const Eigen::Index joints = whole.B.cols() - base;
  const Eigen::LLT<Eigen::MatrixXd> held(Eigen::MatrixXd(whole.B.topLeftCorner(base, base)));
  const Eigen::MatrixXd follows = -held.solve(Eigen::MatrixXd(whole.B.topRightCorner(base, joints)));
  return {whole.J.rightCols(joints) + whole.J.leftCols(base) * follows,
          whole.B.bottomRightCorner(joints, joints) + whole.B.bottomLeftCorner(joints, base) * follows};
}

Eigen::VectorXd torque_units(const Mechanism& mechanism, TorqueNorm norm) {
  const auto joints = static_cast<Eigen::Index>(mechanism.joints().size());
  if (norm == TorqueNorm::plain) return Eigen::VectorXd::Ones(joints);
  const std::vector<double> limits = given_limits(mechanism).torque;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    if (std::isfinite(limits[i])) continue;
    throw Failure(FailureKind::unsupported,
                  fmt::format("joint \"{}\" has no effort limit", joint_name(mechanism.joints()[i])),
                  "give one in the robot file or in the scene's [limits], or leave out --norm");
  }
  return Eigen::Map<const Eigen::VectorXd>(limits.data(), joints);
}

// Whether the tip's origin coincides with the frame of this link.
bool is_at_tip(const Mechanism& mechanism, const std::string& name) {
  const auto link = std::find_if(mechanism.links.begin(), mechanism.links.end(),
                                 [&name](const LinkFrame& each) { return each.link == name; });
  const LinkFrame& tip = mechanism.tip;
  return std::equal(tip.p.begin(), tip.p.end(), link->p.begin(),
                    [](const Number& a, const Number& b) { return vanishes(a - b); });
}

// The names of the frames to draw: the last link of each body on the way from the base to the tip, and the tip. The
// base's own frame is the origin, and bodies inside spherical joints are no links.
std::vector<std::string> poses_to_tip(const Mechanism& mechanism) {
  std::vector<std::string> names = {"forward_kinematics"};
  for (int i = mechanism.tip.body; i >= mechanism.base_bodies(); i = parent_of_joint(mechanism, i)) {
    const std::string& link = mechanism.bodies[static_cast<std::size_t>(i)].link;
    if (i != mechanism.tip.body || !is_at_tip(mechanism, link)) names.push_back("forward_kinematics:" + link);
  }
  std::reverse(names.begin(), names.end());
  return names;
}

}  // namespace

// The half axes of the image of the unit ball under onto · axes · lengths. With the SVD U Σ Vᵀ, it is the image under U
// Σ.
Eigen::Matrix2d projected_axes(const Ellipsoid& ellipsoid, const Eigen::MatrixXd& onto) {
  const Eigen::MatrixXd half = onto * ellipsoid.axes * ellipsoid.lengths.asDiagonal();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(half, Eigen::ComputeThinU);
  Eigen::Matrix2d axes = Eigen::Matrix2d::Zero();
  for (Eigen::Index k = 0; k < svd.singularValues().size(); ++k)
    axes.col(k) = svd.matrixU().col(k) * svd.singularValues()(k);
  return axes;
}

double length_of(const std::vector<Eigen::Vector3d>& skeleton) {
  double length = 0;
  for (std::size_t k = 1; k < skeleton.size(); ++k) length += (skeleton[k] - skeleton[k - 1]).norm();
  return length;
}

Manipulability::Manipulability(const LoadedRobot& model, const TorqueBall& torques, Progress& progress)
    : base_(model.mechanism.base_bodies()),
      set_(torques.set),
      torque_unit_(torques.radius * torque_units(model.mechanism, torques.norm)) {
  refuse_angles(model.mechanism);
  refuse_base_armature(model.mechanism);
  const bool has_springs = model.mechanism.has_springs(), has_torques = base_ == 0 || has_springs;
  std::vector<std::string> names = {"inertia_matrix", "jacobian"};
  if (has_torques) names.emplace_back(has_springs ? "bias" : "gravity");
  const std::size_t first_frame = names.size();
  for (const std::string& pose : poses_to_tip(model.mechanism)) names.push_back(pose);
  const std::vector<Function> functions = derive_numeric_functions(model, names, "an ellipsoid", progress);
  const TipDirections directions = tip_directions(model.mechanism, functions[0], functions[1]);
  task_ = directions.rows;
  rank_ = directions.rank;
  inertia_.emplace(functions[0]);
  jacobian_.emplace(functions[1]);
  if (has_torques) torques_at_rest_.emplace(functions[2]);
  for (std::size_t k = first_frame; k < functions.size(); ++k) frames_.emplace_back(functions[k]);
}

std::vector<double> Manipulability::values(Tape& tape, const std::vector<double>& q) const {
  TapeInputs given;
  const std::vector<double> rest(static_cast<std::size_t>(base_ + torque_unit_.size()), 0), weightless(3, 0);
  given[InputKind::q] = q;
  given[InputKind::qd] = rest;
  given[InputKind::v] = rest;
  given[InputKind::g_b] = weightless;
  std::vector<double> results(tape.results());
  tape.run(given, results);
  return results;
}

Ellipsoid Manipulability::at(const std::vector<double>& q, const Eigen::Vector3d& g_b) {
  const Eigen::Index joints = torque_unit_.size(), n = base_ + joints;
  const std::vector<double> b = values(*inertia_, q), j = values(*jacobian_, q);
  // The matrices are stored row by row, hence transposed.
  const Eigen::Map<const Eigen::MatrixXd> whole(b.data(), n, n), columns(j.data(), n, 6);
  refuse_singular(whole, q);
  const auto [J, B] = of_joints({Eigen::MatrixXd(columns.transpose())(task_, Eigen::all), whole}, base_);
  const Eigen::LLT<Eigen::MatrixXd> factor(B);
  Ellipsoid ellipsoid = set_ == TorqueSet::all ? of_all_torques(J, factor) : of_least_accelerations(J, B);
  ellipsoid.centre = Eigen::VectorXd::Zero(J.rows());
  if (torques_at_rest_) {
    const std::vector<double> tau = values(*torques_at_rest_, q);
    ellipsoid.centre = -J * factor.solve(Eigen::Map<const Eigen::VectorXd>(tau.data() + base_, joints));
  }
  for (std::size_t i = 0; base_ > 0 && i < task_.size() && task_[i] < 3; ++i) {
    ellipsoid.centre[static_cast<Eigen::Index>(i)] += g_b[task_[i]];
  }
  ellipsoid.measure = ellipsoid.lengths.prod();
  return ellipsoid;
}

Ellipsoid Manipulability::of_least_accelerations(const Eigen::MatrixXd& J, const Eigen::MatrixXd& B) const {
  // J = U Σ Vᵀ. Accelerations q̈ = V z of least norm need the torques B V z = Q R z, so the ellipsoid is the image of
  // the ball under U Σ R^-1: (7.148) without an inverse of J, which may be singular.
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(J, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Eigen::MatrixXd torques = torque_unit_.cwiseInverse().asDiagonal() * (B * svd.matrixV().leftCols(rank_));
  const Eigen::MatrixXd R = torques.householderQr().matrixQR().topRows(rank_).triangularView<Eigen::Upper>();
  const Eigen::MatrixXd sizes = svd.singularValues().head(rank_).asDiagonal();
  const Eigen::MatrixXd image = R.transpose().triangularView<Eigen::Lower>().solve(sizes).transpose();
  const Eigen::JacobiSVD<Eigen::MatrixXd> half_axes(image, Eigen::ComputeFullU);
  return {{}, svd.matrixU().leftCols(rank_) * half_axes.matrixU(), half_axes.singularValues()};
}

// The image of the ball of torques under J B^-1.
Ellipsoid Manipulability::of_all_torques(const Eigen::MatrixXd& J, const Eigen::LLT<Eigen::MatrixXd>& B) const {
  const Eigen::MatrixXd image = B.solve(J.transpose()).transpose() * torque_unit_.asDiagonal();
  const Eigen::JacobiSVD<Eigen::MatrixXd> half_axes(image, Eigen::ComputeThinU);
  return {{}, half_axes.matrixU().leftCols(rank_), half_axes.singularValues().head(rank_)};
}

std::vector<Eigen::Vector3d> Manipulability::skeleton(const std::vector<double>& q) {
  constexpr std::size_t kPosition = 9;  // the position follows R
  std::vector<Eigen::Vector3d> points = {Eigen::Vector3d::Zero()};
  for (Tape& frame : frames_) {
    const std::vector<double> pose = values(frame, q);
    points.emplace_back(pose[kPosition], pose[kPosition + 1], pose[kPosition + 2]);
  }
  return points;
}

}  // namespace flatdyn
