// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/verify/snap_effect.hpp"

#include <algorithm>

#include "flatdyn/reference/newton_euler.hpp"
#include "proof/verify/torque_difference.hpp"
#include "robot/input/reader.hpp"
#include "robot/model/states.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {
namespace {

constexpr unsigned kSeed = 1;
constexpr int kStates = 5;
constexpr double kLeastRegularity = 1e-3;  // closer to a singular loop, every change is large

using Robot50 = reference::Robot<Real50>;
using Vector50 = reference::VectorX<Real50>;

// A robot in numbers, and its torques at the states; none where its loops cannot be closed.
struct Sample {
  Robot50 robot;
  std::vector<Vector50> torques;
};

// Random states at which the loops are closed and not singular.
std::vector<State> closed_states(const LoadedRobot& model) {
  std::vector<State> states = random_states(model.mechanism, kStates, kSeed);
  if (!model.mechanism.has_loops()) return states;
  const auto robot = reference_robot<double>(model.robot, random_symbol_values(model.robot, kSeed));
  std::erase_if(states, [&robot](State& state) {
    constexpr double kClosedWithin = 1e-12;
    Eigen::VectorXd q = vector_of(state.q);
    if (!reference::close_loops(robot, q, kClosedWithin)) return true;
    state.q.assign(q.begin(), q.end());
    return reference::loop_regularity(robot, q) < kLeastRegularity;
  });
  return states;
}

class SnapComparison {
 public:
  SnapComparison(const LoadedRobot& model, const ReadOptions& options)
      : model_(model), options_(options), states_(closed_states(model)) {
    const Mechanism& mechanism = model.mechanism;
    if (!mechanism.is_coupled() && mechanism.symbols.empty()) {
      limits_ = largest_motion(mechanism);
      base_ = largest_motion_of_base(mechanism);
    }
  }

  // An angle affects many numbers, so the file is read again. Snaps made after reading are left out on both sides.
  SnapEffects effects() const {
    const std::vector<Snap>& snaps = model_.robot.snaps;
    Robot plain = model_.robot;  // copies are made of it
    plain.snaps.clear();
    const Sample snapped = sample(plain);
    const std::optional<Sample> as_read = read(options_);
    SnapEffects result;
    Robot all_undone = plain;
    for (std::size_t k = 0; k < snaps.size(); ++k) {
      if (snaps[k].undo) {
        Robot undone = plain;
        snaps[k].undo(undone);
        result.each.push_back(difference(sample(undone), snapped));
      } else {
        ReadOptions left_out = options_;
        left_out.left_unsnapped = k;
        const std::optional<Sample> without = read(left_out);
        result.each.push_back(without && as_read ? difference(*without, *as_read) : SnapEffect{});
      }
    }
    for (auto snap = snaps.rbegin(); snap != snaps.rend(); ++snap) {
      if (snap->undo) snap->undo(all_undone);
    }
    result.bound = bound_of_all(sample(all_undone), snapped, as_read);
    return result;
  }

 private:
  Sample sample(const Robot& robot) const {
    Sample result{reference_robot<Real50>(robot, random_symbol_values(robot, kSeed)), {}};
    for (const State& state : states_) {
      const StateOf<Real50> wide = widened<Real50>(state);
      Vector50 q = vector_of(wide.q);
      const bool is_closed = result.robot.loops.empty() || reference::close_loops(result.robot, q, Real50("1e-40"));
      result.torques.push_back(
          is_closed ? Vector50(reference::inverse_dynamics(result.robot, q, vector_of(wide.qd), vector_of(wide.qdd)))
                    : Vector50());
    }
    return result;
  }

  std::optional<Sample> read(const ReadOptions& options) const {
    Diagnostics ignored;  // the same as those of the model
    const std::optional<Robot> robot = read_robot(model_.robot.file, options, ignored);
    return robot ? std::optional(sample(*robot)) : std::nullopt;
  }

  SnapEffect difference(const Sample& a, const Sample& b) const {
    SnapEffect effect;
    for (std::size_t s = 0; s < states_.size(); ++s) {
      if (a.torques[s].size() != b.torques[s].size()) continue;  // a loop closes in one of them only
      effect.seen = std::max(effect.seen, (a.torques[s] - b.torques[s]).cwiseAbs().maxCoeff().convert_to<double>());
    }
    effect.bound = bound(a, b);
    return effect;
  }

  std::optional<double> bound(const Sample& a, const Sample& b) const {
    return limits_ ? std::optional(torque_difference_bound(a.robot, b.robot, *limits_, base_)) : std::nullopt;
  }

  // The change by all snaps made after reading, and that by all snaps of angles, together.
  std::optional<double> bound_of_all(const Sample& undone, const Sample& snapped,
                                     const std::optional<Sample>& as_read) const {
    const bool has_angles =
        std::any_of(model_.robot.snaps.begin(), model_.robot.snaps.end(), [](const Snap& snap) { return !snap.undo; });
    const std::optional<double> after_reading = bound(undone, snapped);
    if (!has_angles || !after_reading) return after_reading;
    ReadOptions unsnapped = options_;
    unsnapped.snap_tolerance = 0;
    const std::optional<Sample> written = read(unsnapped);
    if (!written || !as_read) return std::nullopt;
    return *after_reading + *bound(*written, *as_read);
  }

  const LoadedRobot& model_;
  const ReadOptions& options_;
  std::vector<State> states_;
  std::optional<std::vector<MotionLimits>> limits_;
  MotionOfBase base_;
};

}  // namespace

SnapEffects snap_effects(const LoadedRobot& model, const ReadOptions& options) {
  return model.robot.snaps.empty() ? SnapEffects{{}, 0} : SnapComparison(model, options).effects();
}

}  // namespace flatdyn
