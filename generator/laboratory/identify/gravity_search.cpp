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

// Rows as an affine function of gravity: A = still + Σ_d g_d of[d]. There is a column for every index of a parameter,
// also for those that no parameter has.
struct AffineRows {
  MatrixXd still, of[3];
  VectorXd b;

  WeightedEquations at(const Vector3d& g) const { return {still + g[0] * of[0] + g[1] * of[1] + g[2] * of[2], b}; }
};

// The rows of bodies with one parameter each, in a gravity of 1 m/s² along an axis, at rest; or, with axis < 0, without
// gravity, where further columns and friction are the sample's.
WeightedEquations rows_of_units(std::vector<reference::Robot<double>> units, const std::vector<int>& indices,
                                const RowSample& sample, int axis) {
  const TorqueModel& model = sample.model();
  for (auto& unit : units) unit.gravity = axis < 0 ? Vector3d::Zero().eval() : Vector3d::Unit(axis).eval();
  return sample.rows([&](RowSample::Instant& t) {
    const MatrixXd of_sample = std::move(t.Y);
    const Index more = of_sample.cols() - model.parameters();
    t.Y = MatrixXd::Zero(of_sample.rows(), kParametersPerJoint * model.mechanism().body_count() + more);
    if (axis >= 0) t.qd.setZero(), t.qdd.setZero();
    for (std::size_t k = 0; k < units.size(); ++k) {
      t.Y.col(indices[k]) = reference::inverse_dynamics<double>(units[k], t.q, t.qd, t.qdd);
    }
    if (axis >= 0) return;
    for (int k = 0; k < model.parameters(); ++k) {
      const int index = model.base().columns[static_cast<std::size_t>(k)];
      const Parameter parameter = parameter_of(index);
      if (parameter == Parameter::Fv || parameter == Parameter::Fs) t.Y.col(index) = of_sample.col(k);
    }
    t.Y.rightCols(more) = of_sample.rightCols(more);
  });
}

// With `is_still`, without the parts of gravity.
AffineRows affine_rows(const LoadedRobot& robot, const RowSample& sample, bool is_still) {
  const RegressorReference<double> reference(sample.model().mechanism(), reference_robot<double>(robot.robot, {}), {},
                                             RegressorColumns::all);
  auto [still, b] = rows_of_units(reference.units(), reference.indices(), sample, -1);
  AffineRows result{std::move(still), {}, std::move(b)};
  for (int axis = 0; axis < 3 && !is_still; ++axis) {
    result.of[axis] = rows_of_units(reference.units(), reference.indices(), sample, axis).A;
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
  Matrix3d squares;
  for (int d = 0; d < 3; ++d) {
    for (int e = 0; e < 3; ++e) squares(d, e) = affine.of[d].cwiseProduct(affine.of[e]).sum();
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

// Gravity whose component within `told` points along a direction, and is as long as before.
Vector3d pointed(const Vector3d& gravity, const Matrix3Xd& told, const Vector3d& direction) {
  const Vector3d inside = told * (told.transpose() * gravity), along = told * (told.transpose() * direction);
  return along.norm() > 0 ? Vector3d(gravity - inside + inside.norm() * along.normalized()) : gravity;
}

// The fit that says most for itself of those that are about as good: masses may come out negative, so that gravity the
// other way round fits nearly as well, or a little better.
class DirectionSearch {
 public:
  // masses: the robot file's parameters, all 13 of each joint. rows: how many there are.
  DirectionSearch(AffineRows affine, double rows, const Vector3d& file, VectorXd masses)
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
      const Direction best = best_within();
      const auto [turn, deviation] = least_told_turn(best);
      if (deviation < kUntold) return {best.gravity, 0, best.cost, told_};
      // The same turn of the file's gravity, which stays; the best one may be anywhere along the turn.
      const Matrix3Xd ways = across(told_, file_);
      const Vector3d of_file = ways * (ways.transpose() * turn);
      told_ = across(told_, of_file.isZero(1e-3) ? turn : of_file);
    }
  }

 private:
  struct Direction {
    Vector3d gravity;
    double cost = 0;
    double likeness = 0;  // how like the robot file's masses and first moments are to these: the sum of cosines by link
  };

  // Gravity that is turned from where it is by unknown angles along turns_of_gravity().
  Hypothesis turned_from(const Vector3d& gravity) const {
    return {std::vector<Unknown>(static_cast<std::size_t>(turns_of_gravity(gravity, told_).cols())),
            [this, gravity](const VectorXd& angles) { return affine_.at(turned_gravity(gravity, told_, angles)); }};
  }

  // The best direction in the valley of one.
  Direction improved(const Vector3d& gravity) const {
    const Hypothesis turned = turned_from(gravity);
    const HypothesisFit fit = fit_near(turned, VectorXd::Zero(static_cast<Index>(turned.unknowns.size())));
    return {turned_gravity(gravity, told_, fit.x), fit.cost, likeness_of(fit.pi)};
  }

  Direction best_within() const {
    constexpr double kClearly = 0.5;  // share of the cost
    const Direction near = improved(file_);
    Vector3d start = near.gravity;
    double least = near.cost;
    for (const Vector3d& direction : directions_around(file_)) {
      const Vector3d gravity = pointed(file_, told_, direction);
      const double cost = fit_of(affine_.at(gravity)).cost;
      if (cost < least) std::tie(start, least) = std::pair(gravity, cost);
    }
    const Direction around = improved(start);
    const bool is_better = around.cost < near.cost - kAlike && around.likeness > near.likeness - kLikeness;
    return with_positive_masses(is_better || around.cost < kClearly * near.cost ? around : near);
  }

  // Where gravity and masses can be reversed together, in some of gravity's components, positive masses are right.
  Direction with_positive_masses(const Direction& found) const {
    Direction best = found;
    for (int signs = 1; signs < 1 << told_.cols(); ++signs) {
      Vector3d mirrored = found.gravity;
      for (Index k = 0; k < told_.cols(); ++k) {
        const Vector3d axis = axis_of(k);
        if ((signs >> k & 1) != 0) mirrored -= 2 * axis.dot(found.gravity) * axis;
      }
      const Direction next = improved(mirrored);
      if (next.cost <= found.cost + kAlike && next.likeness >= best.likeness + kLikeness) best = next;
    }
    return best;
  }

  // An axis of the space that is determined (`told_`): one of the base frame, where that is possible.
  Vector3d axis_of(Index k) const { return told_.cols() == 3 ? Vector3d(Vector3d::Unit(k)) : Vector3d(told_.col(k)); }

  double likeness_of(const VectorXd& found) const {
    constexpr Index kOfMass = 4;  // m, mlx, mly, mlz
    double sum = 0;
    for (Index at = 0; at < masses_.size(); at += kParametersPerJoint) {
      const double sizes = masses_.segment(at, kOfMass).norm() * found.segment(at, kOfMass).norm();
      if (sizes > 0) sum += masses_.segment(at, kOfMass).dot(found.segment(at, kOfMass)) / sizes;
    }
    return sum;
  }

  // The turn that the rows determine least, of unit length, and its standard deviation, rad; 0 if there is no turn.
  std::pair<Vector3d, double> least_told_turn(const Direction& fit) const {
    const Matrix3Xd turns = turns_of_gravity(fit.gravity, told_);
    if (turns.cols() == 0) return {Vector3d::Zero(), 0};
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(
        information_on_unknowns(turned_from(fit.gravity), VectorXd::Zero(turns.cols())));
    const double least = std::max(eigen.eigenvalues()[0], 1e-9), scatter = std::max(1.0, fit.cost / rows_);
    return {(turns * eigen.eigenvectors().col(0)).normalized(), std::sqrt(scatter / least)};
  }

  static constexpr double kAlike = 20, kLikeness = 0.3;  // differences that count for nothing, of cost and of likeness

  AffineRows affine_;
  double rows_;
  Vector3d file_;
  VectorXd masses_;
  Matrix3Xd told_;
};

}  // namespace

GravityFit gravity_direction(const LoadedRobot& robot, const RowSample& sample) {
  constexpr double kRounding = 1e-5;
  const Mechanism& mechanism = sample.model().mechanism();
  const Vec3& file = mechanism.gravity;
  const Vector3d nominal(nearest_double(file[0]), nearest_double(file[1]), nearest_double(file[2]));
  if (nominal.isZero()) {
    return {nominal, 0, fit_of(sample.rows()).cost};
  }
  const std::vector<Number> file_masses = dynamic_parameters(mechanism);
  VectorXd masses(static_cast<Index>(file_masses.size()));
  std::transform(file_masses.begin(), file_masses.end(), masses.begin(),
                 [](const Number& value) { return nearest_double(value); });
  GravityFit best =
      DirectionSearch(affine_rows(robot, sample, false), sample.count(), nominal, std::move(masses)).run();
  const double size = nominal.norm();
  best.gravity = (best.gravity.array().abs() > kRounding * size).select(best.gravity, 0);
  best.angle = std::acos(std::clamp(best.gravity.dot(nominal) / (size * size), -1.0, 1.0));
  return best;
}

double cost_without_gravity(const LoadedRobot& robot, const RowSample& sample) {
  const AffineRows affine = affine_rows(robot, sample, true);
  return fit_of({affine.still, affine.b}).cost;
}

Matrix3Xd turns_of_gravity(const Vector3d& gravity, const Matrix3Xd& told) {
  const double size = (told.transpose() * gravity).norm();
  return size == 0 ? Matrix3Xd(3, 0) : Matrix3Xd(size * across(told, gravity));
}

Vector3d turned_gravity(const Vector3d& gravity, const Matrix3Xd& told, const VectorXd& angles) {
  const Vector3d inside = told * (told.transpose() * gravity);
  if (angles.size() == 0) return pointed(gravity, told, inside);  // a pendulum tells no turn
  return pointed(gravity, told, inside + turns_of_gravity(gravity, told) * angles);
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
