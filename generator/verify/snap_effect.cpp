// SPDX-License-Identifier: GPL-2.0-or-later
#include "verify/snap_effect.hpp"

#include "flatdyn/reference/newton_euler.hpp"
#include "input/reader.hpp"
#include "model/states.hpp"
#include "reference/reference_model.hpp"

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

Robot undone(const Snap& snap, Robot robot) {
  snap.undo(robot);
  return robot;
}

// The torques of the robot as read with all of its snaps but that of the k-th angle; with all snaps if k is none.
std::vector<Vector50> torques_as_read(const Robot& robot, ReadOptions options, std::optional<std::size_t> k,
                                      const std::vector<State>& states) {
  options.left_unsnapped = k;
  Diagnostics ignored;  // the same as those of the model
  const std::optional<Robot> read = read_robot(robot.file, options, ignored);
  return read ? torques(*read, states) : std::vector<Vector50>();
}

double largest_difference(const std::vector<Vector50>& a, const std::vector<Vector50>& b) {
  double largest = 0;
  for (std::size_t s = 0; s < std::min(a.size(), b.size()); ++s) {
    if (a[s].size() != b[s].size()) continue;  // a loop closes on another branch
    largest = std::max(largest, (a[s] - b[s]).cwiseAbs().maxCoeff().convert_to<double>());
  }
  return largest;
}

}  // namespace

std::vector<double> snap_effects(const LoadedRobot& model, const ReadOptions& options) {
  std::vector<double> effects;
  if (model.robot.snaps.empty()) return effects;
  const std::vector<State> states = random_states(model.mechanism, kStates, kSeed);
  const std::vector<Vector50> snapped = torques(model.robot, states);
  Robot without_list = model.robot;  // copies are made of it
  without_list.snaps.clear();
  // An angle affects many numbers, so the file is read again. Snaps made after reading are left out on both sides.
  const std::vector<Vector50> as_read = torques_as_read(model.robot, options, {}, states);
  for (std::size_t k = 0; k < model.robot.snaps.size(); ++k) {
    const Snap& snap = model.robot.snaps[k];
    effects.push_back(!snap.undo ? largest_difference(torques_as_read(model.robot, options, k, states), as_read)
                                 : largest_difference(torques(undone(snap, without_list), states), snapped));
  }
  return effects;
}

}  // namespace flatdyn
