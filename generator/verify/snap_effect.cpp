// SPDX-License-Identifier: GPL-2.0-or-later
#include "verify/snap_effect.hpp"

#include "flatdyn/reference/newton_euler.hpp"
#include "model/states.hpp"
#include "verify/reference_model.hpp"

namespace flatdyn {
namespace {

constexpr unsigned kSeed = 1;
constexpr int kStates = 5;

using Vector50 = reference::VectorX<Real50>;

std::vector<Vector50> torques(const Robot& robot, const std::vector<State>& states) {
  const auto numeric = reference_robot<Real50>(robot, random_symbol_values(robot, kSeed));
  const auto wide = [](const std::vector<double>& v) {
    return Vector50(Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Eigen::Index>(v.size())).cast<Real50>());
  };
  std::vector<Vector50> result;
  for (const State& state : states) {
    result.push_back(reference::inverse_dynamics(numeric, wide(state.q), wide(state.qd), wide(state.qdd)));
  }
  return result;
}

}  // namespace

std::vector<double> snap_effects(const Model& model, const ReadOptions& options) {
  std::vector<double> effects;
  if (model.robot.snaps.empty()) return effects;
  const std::vector<State> states = random_states(model.mechanism, kStates, kSeed);
  const std::vector<Vector50> snapped = torques(model.robot, states);
  for (std::size_t k = 0; k < model.robot.snaps.size(); ++k) {
    ReadOptions without = options;
    without.left_unsnapped = k;
    Diagnostics ignored;  // the same as of the model
    const std::optional<Robot> robot = read_robot(model.robot.file, without, ignored);
    double largest = 0;
    if (robot) {
      const std::vector<Vector50> written = torques(*robot, states);
      for (std::size_t s = 0; s < states.size(); ++s) {
        largest = std::max(largest, (written[s] - snapped[s]).cwiseAbs().maxCoeff().convert_to<double>());
      }
    }
    effects.push_back(largest);
  }
  return effects;
}

}  // namespace flatdyn
