// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/observations.hpp"

#include <algorithm>
#include <cstdint>
#include <tuple>

namespace flatdyn {

double JointObservations::rms_residual(const Eigen::VectorXd& pi_b) const {
  const Eigen::VectorXd residual = A() * restricted(pi_b) - b();
  return rows > 0 ? residual.norm() / std::sqrt(static_cast<double>(rows)) : 0;
}

double JointObservations::rms_torque() const {
  return rows > 0 ? b().norm() / std::sqrt(static_cast<double>(rows)) : 0;
}

void Observations::set_correlation(double correlation) {
  for (JointObservations& joint : joints) joint.correlation = correlation;
}

namespace {

// Whether a run of instants is kept, one of `stride`, a power of two. Runs are kept at irregular places, so that of all
// logs some are, and at all distances from each other; those of a larger stride are among those of a smaller one.
bool is_kept(int log, long run, long stride) {
  // The finaliser of SplitMix64 (Steele, Lea, Flood 2014) mixes all bits into the low ones.
  std::uint64_t mixed = (static_cast<std::uint64_t>(log) << 40U) + static_cast<std::uint64_t>(run);
  mixed = (mixed ^ (mixed >> 30U)) * 0xbf58476d1ce4e5b9U;
  mixed = (mixed ^ (mixed >> 27U)) * 0x94d049bb133111ebU;
  return ((mixed ^ (mixed >> 31U)) & static_cast<std::uint64_t>(stride - 1)) == 0;
}

void keep_every(long stride, std::vector<EquationInstant>& instants) {
  const auto dropped = [stride](const EquationInstant& each) {
    return !is_kept(each.log, each.index / each.run, stride);
  };
  instants.erase(std::remove_if(instants.begin(), instants.end(), dropped), instants.end());
}

// Doubles the stride until no more than kMost instants are left. Returns it.
long thin_out(std::vector<EquationInstant>& instants, long stride) {
  while (instants.size() > InstantSample::kMost) keep_every(stride *= 2, instants);
  return stride;
}

}  // namespace

void InstantSample::offer(const FilteredEquations& equations, const EquationModel& model, int log,
                          const NoiseShape& shape) {
  if (!is_kept(log, equations.index / shape.run, stride_)) return;
  const auto numbers = [](const double* from, std::size_t count) { return std::vector<double>(from, from + count); };
  const auto n = static_cast<std::size_t>(model.equations());
  EquationInstant instant{log, equations.index, equations.motion.time};
  instant.q = numbers(equations.motion.q, equations.positions);
  instant.qd = numbers(equations.motion.qd, equations.rates);
  instant.qdd = numbers(equations.motion.qdd, equations.rates);
  instant.entries = numbers(equations.entries, static_cast<std::size_t>(model.entries()));
  instant.right = numbers(equations.right, n);
  instant.measured_rates = numbers(equations.measured_rates, n);
  if (equations.fast != nullptr) instant.fast = numbers(equations.fast, n);
  instant.used.assign(equations.used, equations.used + n);
  instant.run = shape.run;
  if (equations.instruments != nullptr) {
    instant.instruments = numbers(equations.instruments, static_cast<std::size_t>(model.entries()));
  }
  kept_.push_back(std::move(instant));
  stride_ = thin_out(kept_, stride_);
}

void InstantSample::move_to(Observations& observations) {
  observations.instants = std::move(kept_);
  observations.stride = stride_;
}

ObservationFolder::ObservationFolder(const EquationModel& model) : model_(model) {
  for (const std::vector<int>& columns : model.columns()) factors_.emplace_back(static_cast<int>(columns.size()));
}

void ObservationFolder::add(const FilteredEquations& equations) {
  const double* entries = equations.entries;
  for (std::size_t i = 0; i < factors_.size(); ++i) {
    const auto count = static_cast<Eigen::Index>(model_.columns()[i].size());
    if (equations.used[i] != 0) {
      auto row = factors_[i].next_row();
      row.head(count) = Eigen::Map<const Eigen::RowVectorXd>(entries, count);
      row[count] = equations.right[i];
    }
    entries += count;
  }
}

Observations ObservationFolder::observations() {
  Observations result{model_.parameters(), {}};
  for (std::size_t i = 0; i < factors_.size(); ++i) {
    const std::vector<int>& columns = model_.columns()[i];
    result.joints.push_back({columns, factors_[i].factor(), factors_[i].count()});
  }
  return result;
}

void leave_out_short_motions(Observations& observations, long used) {
  constexpr long kLeast = 40;     // rows; 13 periods of the filter's band
  constexpr double kMuch = 0.25;  // share of the instants
  const auto is_filtered = [](const NoiseShape& shape) { return shape.run > 1; };
  if (!std::all_of(observations.shapes.begin(), observations.shapes.end(), is_filtered)) return;
  for (std::size_t i = 0; i < observations.joints.size(); ++i) {
    JointObservations& joint = observations.joints[i];
    if (joint.rows >= kLeast || static_cast<double>(joint.rows) >= kMuch * static_cast<double>(used)) continue;
    joint.left_out = joint.rows;
    joint.rows = 0;
    joint.R.setZero();
    for (EquationInstant& instant : observations.instants) instant.used[i] = 0;
  }
}

Observations joined(const Observations& a, const Observations& b) {
  Observations result{a.parameters, {}, a.instants, std::max(a.stride, b.stride), a.shapes};
  for (std::size_t i = 0; i < a.joints.size(); ++i) {
    TriangularFactor factor(static_cast<int>(a.joints[i].columns.size()));
    for (const Observations* each : {&a, &b}) factor.join(each->joints[i].R, each->joints[i].rows);
    result.joints.push_back({a.joints[i].columns, factor.factor(), factor.count(), a.joints[i].correlation});
  }
  result.instants.insert(result.instants.end(), b.instants.begin(), b.instants.end());
  keep_every(result.stride, result.instants);
  result.stride = thin_out(result.instants, result.stride);
  std::stable_sort(result.instants.begin(), result.instants.end(),
                   [](const EquationInstant& x, const EquationInstant& y) {
                     return std::tie(x.log, x.index) < std::tie(y.log, y.index);
                   });
  return result;
}

}  // namespace flatdyn
