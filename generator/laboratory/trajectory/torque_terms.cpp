// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/trajectory/torque_terms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "functions/planning/make_functions.hpp"
#include "laboratory/trajectory/tip_torque.hpp"

namespace flatdyn {
namespace {

enum : std::size_t { kInertia, kSymbols, kGravity, kInverse, kAtRest };

double sign(double x) { return static_cast<double>((x > 0) - (x < 0)); }

}  // namespace

const char* name_of(TermKind kind) {
  switch (kind) {
    case TermKind::own_inertia:
    case TermKind::coupling:
      return "inertia";
    case TermKind::centrifugal:
      return "centrifugal";
    case TermKind::coriolis:
      return "coriolis";
    case TermKind::gravity:
      return "gravity";
    case TermKind::viscous:
      return "viscous";
    case TermKind::coulomb:
      return "coulomb";
    case TermKind::spring:
      return "spring";
    case TermKind::tip_force:
      return "tip_force";
  }
  return "";
}

std::string TorqueTerm::name() const {
  std::string text = fmt::format("{}_{}", name_of(kind), joint + 1);
  if (j >= 0) text += fmt::format("_{}", j + 1);
  if (k >= 0) text += fmt::format("_{}", k + 1);
  return text;
}

TorqueTerms::TorqueTerms(const LoadedRobot& model, bool tip_force, Progress& progress)
    : n_(model.mechanism.size()), has_springs_(model.mechanism.has_springs()), closed_(model) {
  std::vector<std::string> names = {"inertia_matrix", "christoffel", "gravity",
                                    tip_force ? "inverse_dynamics_tip_force" : "inverse_dynamics"};
  if (has_springs_) names.emplace_back("bias");
  if (tip_force) names.emplace_back("jacobian");
  const std::vector<Function> functions = derive_numeric_functions(model, names, "a trajectory", progress);
  for (const Function& function : functions) {
    tapes_.emplace_back(function);
    results_.emplace_back(tapes_.back().results());
  }
  friction_ = joint_friction(model.mechanism);
  for (int i = 0; i < n_; ++i) {
    add_terms_of(i, functions[kInertia], functions[kSymbols]);
    const auto at = static_cast<std::size_t>(i);
    const Function& g = functions[kGravity];
    if (!g.graph.is_zero(g.outputs[0].entries[at])) terms_.push_back({TermKind::gravity, i, -1, -1, at});
    if (has_springs_) terms_.push_back({TermKind::spring, i, -1, -1, at});
    if (friction_.viscous[at] != 0) terms_.push_back({TermKind::viscous, i, -1, -1, at});
    if (friction_.coulomb[at] != 0 || friction_.is_smooth_at(at)) terms_.push_back({TermKind::coulomb, i, -1, -1, at});
    if (tip_force) terms_.push_back({TermKind::tip_force, i, -1, -1, at});
  }
}

void TorqueTerms::add_terms_of(int i, const Function& B, const Function& symbols) {
  for (int j = 0; j < n_; ++j) {
    const auto entry = static_cast<std::size_t>(i * n_ + j);
    if (B.graph.is_zero(B.outputs[0].entries[entry])) continue;
    terms_.push_back({i == j ? TermKind::own_inertia : TermKind::coupling, i, j, -1, entry});
  }
  const int pairs = n_ * (n_ + 1) / 2;
  for (const bool mixed : {false, true}) {
    for (int k = 0; k < n_; ++k) {
      for (int j = mixed ? 0 : k; j < (mixed ? k : k + 1); ++j) {
        const auto entry = static_cast<std::size_t>(i * pairs + k * (k + 1) / 2 + j);
        if (symbols.graph.is_zero(symbols.outputs[0].entries[entry])) continue;
        terms_.push_back({mixed ? TermKind::coriolis : TermKind::centrifugal, i, j, mixed ? k : -1, entry});
      }
    }
  }
}

double TorqueTerms::value_of(const TorqueTerm& term, const TrajectoryPoint& point) const {
  const auto i = static_cast<std::size_t>(term.joint), j = static_cast<std::size_t>(term.j);
  switch (term.kind) {
    case TermKind::own_inertia:
    case TermKind::coupling:
      return results_[kInertia][term.entry] * point.qdd[j];
    case TermKind::centrifugal:
      return results_[kSymbols][term.entry] * point.qd[j] * point.qd[j];
    case TermKind::coriolis:
      return 2 * results_[kSymbols][term.entry] * point.qd[j] * point.qd[static_cast<std::size_t>(term.k)];
    case TermKind::gravity:
      return results_[kGravity][term.entry];
    case TermKind::viscous:
      return friction_.viscous[i] * point.qd[i];
    case TermKind::coulomb:
      return friction_.coulomb[i] * sign(point.qd[i]) + friction_.smooth_torque(i, point.qd[i]);
    case TermKind::spring:
      return results_[kAtRest][term.entry] - results_[kGravity][term.entry];
    case TermKind::tip_force:
      return tip_torque(results_.back(), point.h_e, i);
  }
  return 0;
}

void TorqueTerms::evaluate(const TrajectoryPoint& point, std::span<double> values, std::span<double> tau) {
  TapeInputs given;
  given[InputKind::q] = closed_.at(point);
  given[InputKind::qd] = point.qd;
  given[InputKind::qdd] = point.qdd;
  given[InputKind::h_e] = point.h_e;
  const std::vector<double> rest(static_cast<std::size_t>(n_), 0);
  for (std::size_t k = 0; k < tapes_.size(); ++k) {
    given[InputKind::qd] = has_springs_ && k == kAtRest ? rest : point.qd;
    if (!tapes_[k].run(given, results_[k])) closed_.refuse_singular();
  }
  for (std::size_t k = 0; k < terms_.size(); ++k) values[k] = value_of(terms_[k], point);
  std::copy(results_[kInverse].begin(), results_[kInverse].end(), tau.begin());
}

namespace {

double disagreement_of(const std::vector<TorqueTerm>& terms, const std::vector<double>& values, int joint, double tau) {
  double sum = 0, size = 0;
  for (std::size_t k = 0; k < terms.size(); ++k) {
    if (terms[k].joint != joint) continue;
    sum += values[k];
    size += std::abs(values[k]);
  }
  return size > 0 ? std::abs(tau - sum) / size : std::abs(tau);
}

}  // namespace

TorqueHistory torque_history(TorqueTerms& terms, const Trajectory& trajectory) {
  TorqueHistory history{terms.terms(), {}, {}, 0};
  for (const TrajectoryPoint& point : trajectory.points) {
    std::vector<double>& values = history.values.emplace_back(history.terms.size());
    std::vector<double>& tau = history.tau.emplace_back(static_cast<std::size_t>(terms.joints()));
    terms.evaluate(point, values, tau);
    for (int i = 0; i < terms.joints(); ++i) {
      history.disagreement =
          std::max(history.disagreement, disagreement_of(history.terms, values, i, tau[static_cast<std::size_t>(i)]));
    }
  }
  return history;
}

}  // namespace flatdyn
