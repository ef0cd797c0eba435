// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/gravity_search.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "flatdyn/reference/newton_euler.hpp"
#include "reference/regressor_by_columns.hpp"

namespace flatdyn {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Y of all parameters as an affine function of gravity: Y = still + Σ_d g_d of[d], by instant.
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

AffineRows affine_rows(const TorqueModel& model, const LoadedRobot& robot, const RowSample& rows) {
  const RegressorReference<double> reference(model.mechanism(), reference_robot<double>(robot.robot, {}), {},
                                             RegressorColumns::all);
  std::vector<reference::Robot<double>> units = reference.units();
  AffineRows result;
  for (const RowSample::Instant& instant : rows.instants()) {
    const VectorXd zero = VectorXd::Zero(instant.qd.size());
    for (int d = -1; d < 3; ++d) {
      const Index more = instant.Y.cols() - model.parameters();
      MatrixXd Y = MatrixXd::Zero(instant.qd.size(), static_cast<Index>(units.size()) + more);
      for (std::size_t k = 0; k < units.size(); ++k) {
        units[k].gravity = d < 0 ? Vector3d::Zero().eval() : Vector3d::Unit(d).eval();
        Y.col(static_cast<Index>(k)) = reference::inverse_dynamics<double>(
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

// The directions of the corners, edges and faces of a cube.
std::vector<Vector3d> directions_around() {
  std::vector<Vector3d> directions;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (x != 0 || y != 0 || z != 0) directions.push_back(Vector3d(x, y, z).normalized());
      }
    }
  }
  return directions;
}

}  // namespace

GravityFit gravity_direction(const TorqueModel& model, const LoadedRobot& robot, const RowSample& rows) {
  constexpr double kFirstStep = 0.2, kLastStep = 1e-4;  // rad
  constexpr double kClearly = 0.8;                      // share of the cost
  const Vec3& file = model.mechanism().gravity;
  const Vector3d nominal(nearest_double(file[0]), nearest_double(file[1]), nearest_double(file[2]));
  const double size = nominal.norm();
  GravityFit best{nominal, 0, rows.cost()};
  if (size == 0) return best;
  const AffineRows affine = affine_rows(model, robot, rows);
  const auto cost_of = [&](const Vector3d& direction) {
    return rows.cost_of(affine.at(size * direction.normalized()));
  };
  // Improves a direction by steps across it, half as long whenever none helps.
  const auto improved = [&](GravityFit fit) {
    for (double step = kFirstStep; step > kLastStep;) {
      const Vector3d direction = fit.gravity / size, across = direction.unitOrthogonal(),
                     other = direction.cross(across);
      bool is_better = false;
      for (const Vector3d& way : {across, other, (-across).eval(), (-other).eval()}) {
        const Vector3d next = (direction + step * way).normalized();
        const double cost = cost_of(next);
        if (is_better || cost >= fit.cost) continue;
        fit = {size * next, 0, cost};
        is_better = true;
      }
      if (!is_better) step /= 2;
    }
    return fit;
  };
  best = improved({nominal, 0, cost_of(nominal)});
  GravityFit around = best;
  for (const Vector3d& direction : directions_around()) {
    const double cost = cost_of(direction);
    if (cost < around.cost) around = {size * direction, 0, cost};
  }
  around = improved(around);
  // Masses may come out negative, so that the opposite direction fits nearly as well.
  if (around.cost < kClearly * best.cost) best = around;
  best.gravity = (best.gravity.array().abs() > kLastStep * size / 10).select(best.gravity, 0);
  best.angle = std::acos(std::clamp(best.gravity.dot(nominal) / (size * size), -1.0, 1.0));
  return best;
}

}  // namespace flatdyn
