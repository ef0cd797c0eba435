// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/gravity_search.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "flatdyn/reference/newton_euler.hpp"
#include "truth/reference/regressor_by_columns.hpp"

namespace flatdyn {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Y as an affine function of gravity: Y = still + Σ_d g_d of[d], by instant. It has a column for every index of a
// parameter, also for those that no parameter has.
struct AffineRows {
  std::vector<MatrixXd> still, of[3];

  std::vector<MatrixXd> at(const Vector3d& g) const {
    std::vector<MatrixXd> rows = still;
    for (std::size_t t = 0; t < rows.size(); ++t) {
      for (int d = 0; d < 3; ++d) rows[t] += g[d] * of[d][t];
    }
    return rows;
  }
};

// directions: how many of `of` are needed.
AffineRows affine_rows(const TorqueModel& model, const LoadedRobot& robot, const RowSample& rows, int directions) {
  const RegressorReference<double> reference(model.mechanism(), reference_robot<double>(robot.robot, {}), {},
                                             RegressorColumns::all);
  std::vector<reference::Robot<double>> units = reference.units();
  AffineRows result;
  for (const RowSample::Instant& instant : rows.instants()) {
    const VectorXd zero = VectorXd::Zero(instant.qd.size());
    for (int d = -1; d < directions; ++d) {
      const Index more = instant.Y.cols() - model.parameters();
      MatrixXd Y = MatrixXd::Zero(instant.qd.size(), kParametersPerJoint * model.mechanism().body_count() + more);
      for (std::size_t k = 0; k < units.size(); ++k) {
        units[k].gravity = d < 0 ? Vector3d::Zero().eval() : Vector3d::Unit(d).eval();
        Y.col(reference.indices()[k]) = reference::inverse_dynamics<double>(
            units[k], instant.q, d < 0 ? instant.qd : zero, d < 0 ? instant.qdd : zero);
      }
      if (d < 0) {
        for (int k = 0; k < model.parameters(); ++k) {
          const int index = model.base().columns[static_cast<std::size_t>(k)];
          const Parameter parameter = parameter_of(index);
          if (parameter == Parameter::Fv || parameter == Parameter::Fs) Y.col(index) = instant.Y.col(k);
        }
        Y.rightCols(more) = instant.Y.rightCols(more);
      }
      (d < 0 ? result.still : result.of[d]).push_back(std::move(Y));
    }
  }
  return result;
}

// The directions of the corners, edges and faces of a cube, and slight tilts of `file`, of either sign: the wrong sign
// of a slight tilt may lead to the other side.
std::vector<Vector3d> directions_around(const Vector3d& file) {
  std::vector<Vector3d> directions;
  for (const double tilt : {0.1, 0.3, 0.6}) {
    for (int k = 0; k < 6; ++k) {
      const Vector3d axis = (k < 3 ? 1 : -1) * Vector3d::Unit(k % 3);
      const Vector3d tilted = file.normalized() + tilt * axis;
      if (tilted.norm() > 0) directions.push_back(tilted.normalized());
    }
  }
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (x != 0 || y != 0 || z != 0) directions.push_back(Vector3d(x, y, z).normalized());
      }
    }
  }
  return directions;
}

// The space of the directions along which gravity makes torques in some row.
Matrix3Xd directions_that_act(const AffineRows& affine) {
  constexpr double kRounding = 1e-12;  // share of the largest square
  Matrix3d squares = Matrix3d::Zero();
  for (std::size_t t = 0; t < affine.still.size(); ++t) {
    for (int d = 0; d < 3; ++d) {
      for (int e = 0; e < 3; ++e) squares(d, e) += affine.of[d][t].cwiseProduct(affine.of[e][t]).sum();
    }
  }
  const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(squares);
  Index first = 0;
  while (first < 3 && eigen.eigenvalues()[first] <= kRounding * eigen.eigenvalues()[2]) ++first;
  return first == 0 ? Matrix3Xd(Matrix3d::Identity()) : Matrix3Xd(eigen.eigenvectors().rightCols(3 - first));
}

// An orthonormal basis of what is in `space`, and across `direction`.
Matrix3Xd across(const Matrix3Xd& space, const Vector3d& direction) {
  const Eigen::VectorXd inside = space.transpose() * direction;
  const Index size = space.cols();
  if (size == 0 || inside.norm() == 0) return space;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(MatrixXd(inside * inside.transpose() / inside.squaredNorm()));
  return space * eigen.eigenvectors().leftCols(size - 1);
}

class DirectionSearch {
 public:
  // masses: the robot file's parameters, all 13 of each joint.
  DirectionSearch(AffineRows affine, const RowSample& rows, const Vector3d& file, VectorXd masses)
      : affine_(std::move(affine)),
        rows_(rows),
        file_(file),
        masses_(std::move(masses)),
        told_(directions_that_act(affine_)) {
    // Where the file's gravity is across all of these, it must turn for any of it to act.
    if ((told_.transpose() * file_).isZero(1e-9)) told_ = Matrix3d::Identity();
  }

  GravityFit run() {
    constexpr double kUntold = 0.25;  // rad, a standard deviation
    for (;;) {
      const GravityFit best = best_within();
      const auto [turn, deviation] = least_told_turn(best);
      if (deviation < kUntold) return best;
      // The same turn of the file's gravity, which stays; the best one may be anywhere along the turn.
      const Matrix3Xd ways = across(told_, told_ * (told_.transpose() * file_));
      const Vector3d of_file = ways * (ways.transpose() * turn);
      told_ = across(told_, of_file.isZero(1e-3) ? turn : of_file);
    }
  }

 private:
  // Gravity with a component within `told_` that points along `direction`.
  Vector3d gravity_along(const Vector3d& direction) const {
    const Vector3d inside = told_ * (told_.transpose() * file_), toward = told_ * (told_.transpose() * direction);
    return file_ - inside + (toward.norm() > 0 ? Vector3d(inside.norm() * toward.normalized()) : inside);
  }

  GravityFit fit_at(const Vector3d& gravity) const { return {gravity, 0, rows_.cost_of(affine_.at(gravity)), told_}; }

  GravityFit best_within() const {
    constexpr double kClearly = 0.5;  // share of the cost
    GravityFit best = improved(fit_at(file_));
    GravityFit around = best;
    for (const Vector3d& direction : directions_around(file_)) {
      const GravityFit next = fit_at(gravity_along(direction));
      if (next.cost < around.cost) around = next;
    }
    around = improved(around);
    // Masses may come out negative, so that the opposite direction fits nearly as well, or a little better.
    const bool is_better = around.cost < best.cost - kAlike &&
                           likeness_of_masses(around.gravity) > likeness_of_masses(best.gravity) - kLikeness;
    return with_positive_masses(is_better || around.cost < kClearly * best.cost ? around : best);
  }

  // Where gravity and masses can be reversed together, in some of gravity's components, positive masses are right.
  GravityFit with_positive_masses(const GravityFit& fit) const {
    GravityFit best = fit;
    double likeness = likeness_of_masses(fit.gravity);
    for (int signs = 1; signs < 1 << told_.cols(); ++signs) {
      Vector3d mirrored = fit.gravity;
      for (Index k = 0; k < told_.cols(); ++k) {
        const Vector3d axis = axis_of(k);
        if ((signs >> k & 1) != 0) mirrored -= 2 * axis.dot(fit.gravity) * axis;
      }
      const GravityFit next = improved(fit_at(mirrored));
      const double next_likeness = likeness_of_masses(next.gravity);
      if (next.cost > fit.cost + kAlike || next_likeness < likeness + kLikeness) continue;
      best = next;
      likeness = next_likeness;
    }
    return best;
  }

  // An axis of the space that is determined (`told_`): one of the base frame, where that is possible.
  Vector3d axis_of(Index k) const { return told_.cols() == 3 ? Vector3d(Vector3d::Unit(k)) : Vector3d(told_.col(k)); }

  // How like the robot file's masses and first moments those are that fit best: the sum of their cosines by link.
  double likeness_of_masses(const Vector3d& gravity) const {
    constexpr Index kOfMass = 4;  // m, mlx, mly, mlz
    VectorXd found;
    rows_.cost_of(affine_.at(gravity), &found);
    double sum = 0;
    for (Index at = 0; at < masses_.size(); at += kParametersPerJoint) {
      const double sizes = masses_.segment(at, kOfMass).norm() * found.segment(at, kOfMass).norm();
      if (sizes > 0) sum += masses_.segment(at, kOfMass).dot(found.segment(at, kOfMass)) / sizes;
    }
    return sum;
  }

  // Improves a direction by turns, half as large whenever none helps.
  GravityFit improved(GravityFit fit) const {
    for (double step = kFirstStep; step > kLastStep;) {
      const auto turns = static_cast<Index>(turns_of_gravity(fit.gravity, told_).size());
      bool is_better = false;
      for (Index k = 0; k < 2 * turns && !is_better; ++k) {
        const VectorXd angles = (k % 2 == 0 ? step : -step) * VectorXd::Unit(turns, k / 2);
        const GravityFit next = fit_at(turned_gravity(fit.gravity, told_, angles));
        is_better = next.cost < fit.cost;
        if (is_better) fit = next;
      }
      if (!is_better) step /= 2;
    }
    return fit;
  }

  // The turn that the rows determine least, of unit length, and its standard deviation, rad; 0 if there is no turn.
  std::pair<Vector3d, double> least_told_turn(const GravityFit& fit) const {
    constexpr double kStep = 0.02;  // rad
    const std::vector<Vector3d> turns = turns_of_gravity(fit.gravity, told_);
    const auto size = static_cast<Index>(turns.size());
    if (size == 0) return {Vector3d::Zero(), 0};
    const auto cost_at = [&](const VectorXd& angles) {
      return fit_at(turned_gravity(fit.gravity, told_, angles)).cost;
    };
    const auto curvature = [&](const VectorXd& way) {
      return (cost_at(kStep * way) + cost_at(-kStep * way) - 2 * fit.cost) / (kStep * kStep);
    };
    MatrixXd curvatures = MatrixXd::Zero(size, size);
    for (Index k = 0; k < size; ++k) curvatures(k, k) = curvature(VectorXd::Unit(size, k));
    if (size == 2) {
      curvatures(0, 1) = (curvature(VectorXd::Ones(2)) - curvatures.trace()) / 2;
      curvatures(1, 0) = curvatures(0, 1);
    }
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(curvatures);
    const double least = std::max(eigen.eigenvalues()[0], 1e-9), scatter = std::max(1.0, fit.cost / rows_.count());
    Vector3d turn = Vector3d::Zero();
    for (Index k = 0; k < size; ++k) turn += eigen.eigenvectors()(k, 0) * turns[static_cast<std::size_t>(k)];
    return {turn.normalized(), std::sqrt(2 * scatter / least)};
  }

  static constexpr double kAlike = 20, kLikeness = 0.3;  // differences that count for nothing, of cost and of likeness
  static constexpr double kFirstStep = 0.2, kLastStep = 1e-4;  // rad

  AffineRows affine_;
  const RowSample& rows_;
  Vector3d file_;
  VectorXd masses_;
  Matrix3Xd told_;
};

}  // namespace

GravityFit gravity_direction(const TorqueModel& model, const LoadedRobot& robot, const RowSample& rows) {
  constexpr double kRounding = 1e-5;
  const Vec3& file = model.mechanism().gravity;
  const Vector3d nominal(nearest_double(file[0]), nearest_double(file[1]), nearest_double(file[2]));
  if (nominal.isZero()) return {nominal, 0, rows.cost()};
  const std::vector<Number> file_masses = dynamic_parameters(model.mechanism());
  VectorXd masses(static_cast<Index>(file_masses.size()));
  std::transform(file_masses.begin(), file_masses.end(), masses.begin(),
                 [](const Number& value) { return nearest_double(value); });
  GravityFit best = DirectionSearch(affine_rows(model, robot, rows, 3), rows, nominal, std::move(masses)).run();
  const double size = nominal.norm();
  best.gravity = (best.gravity.array().abs() > kRounding * size).select(best.gravity, 0);
  best.angle = std::acos(std::clamp(best.gravity.dot(nominal) / (size * size), -1.0, 1.0));
  return best;
}

double cost_without_gravity(const TorqueModel& model, const LoadedRobot& robot, const RowSample& rows) {
  return rows.cost_of(affine_rows(model, robot, rows, 0).still);
}

std::vector<Vector3d> turns_of_gravity(const Vector3d& gravity, const Matrix3Xd& told) {
  const Vector3d inside = told * (told.transpose() * gravity);
  std::vector<Vector3d> turns;
  if (inside.norm() == 0) return turns;
  const Matrix3Xd ways = across(told, inside);
  for (Index k = 0; k < ways.cols(); ++k) turns.emplace_back(inside.norm() * ways.col(k));
  return turns;
}

Vector3d turned_gravity(const Vector3d& gravity, const Matrix3Xd& told, const VectorXd& angles) {
  const Vector3d inside = told * (told.transpose() * gravity);
  Vector3d turned = inside;
  const std::vector<Vector3d> turns = turns_of_gravity(gravity, told);
  for (Index k = 0; k < angles.size(); ++k) turned += angles[k] * turns[static_cast<std::size_t>(k)];
  return gravity - inside + (turned.norm() > 0 ? Vector3d(inside.norm() * turned.normalized()) : inside);
}

std::vector<Vector3d> untold_directions(const Matrix3Xd& told) {
  const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(Matrix3d(told * told.transpose()));
  std::vector<Vector3d> directions;
  for (Index k = 0; k < 3 - told.cols(); ++k) {
    Vector3d direction = eigen.eigenvectors().col(k);
    Index largest = 0;
    direction.cwiseAbs().maxCoeff(&largest);
    if (direction[largest] < 0) direction = -direction;
    directions.emplace_back((direction.array().abs() > 1e-9).select(direction, 0));
  }
  return directions;
}

}  // namespace flatdyn
