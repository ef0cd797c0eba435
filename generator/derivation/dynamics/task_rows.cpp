// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/task_rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>

#include "base/diagnostics/diagnostics.hpp"
#include "derivation/dynamics/euler_angles.hpp"
#include "derivation/dynamics/kinematics.hpp"
#include "derivation/kernel/elimination.hpp"
#include "graph/mod_p.hpp"

namespace flatdyn {
namespace {

// The rates of Euler angles, if any of the rows needs them.
std::optional<EulerRates> euler_rates(DerivationContext& context, const std::vector<int>& rows,
                                      Orientation orientation) {
  const bool turns = std::any_of(rows.begin(), rows.end(), [](int row) { return row >= 3; });
  if (!turns || orientation == Orientation::angular_velocity) return std::nullopt;
  return EulerRates(context, orientation);
}

std::vector<Number> chosen_rows(const Vec3& linear, const Vec3& angular, const std::vector<int>& rows) {
  std::vector<Number> result;
  for (const int row : rows) {
    const auto r = static_cast<std::size_t>(row);
    result.push_back(r < 3 ? linear[r] : angular[r - 3]);
  }
  return result;
}

std::vector<JacobianColumn> tip_jacobian(DerivationContext& context) {
  return at_coordinates(context.mechanism, context.derivation, jacobian(context.frames, context.mechanism.tip));
}

using FieldColumns = std::vector<std::vector<ModP<kMersenne61>>>;

// The Jacobian's columns, by joint, at a random point of a large prime field.
FieldColumns drawn_columns(const Function& jacobian, std::uint64_t seed) {
  ModPArithmetic<kMersenne61> arithmetic(seed);
  const auto values = evaluate(jacobian, arithmetic);
  const Output& J = jacobian.outputs.front();
  FieldColumns columns(static_cast<std::size_t>(J.cols));
  for (std::size_t k = 0; k < J.entries.size(); ++k) {
    columns[k % columns.size()].push_back(values[static_cast<std::size_t>(J.entries[k])]);
  }
  return columns;
}

// The columns at a point where the angles have a sine, see FieldArithmetic::sqrt.
FieldColumns columns_somewhere(const Function& jacobian, Orientation orientation) {
  constexpr std::uint64_t kAttempts = 64;
  for (std::uint64_t seed = 1; seed <= kAttempts; ++seed) {
    try {
      return drawn_columns(jacobian, seed);
    } catch (const std::domain_error&) {
      continue;
    }
  }
  fail_without_angles(orientation);
}

// These rows of the Jacobian at a random point, as columns by joint. If they are independent, or not zero, anywhere,
// they are so at this point, except with a probability of about 1e-17.
FieldColumns columns_of(const Mechanism& mechanism, const std::vector<int>& rows) {
  DerivationContext context(mechanism);
  const std::vector<NodeId> entries = context.nodes(task_jacobian(context, rows, mechanism.task.orientation));
  const Function jacobian =
      finished(context, {matrix_output("J", static_cast<int>(rows.size()), context.size(), entries, "")});
  return columns_somewhere(jacobian, mechanism.task.orientation);
}

// Those of the rows, in this order, that are independent of the ones before.
std::vector<int> independent(const Mechanism& mechanism, const std::vector<int>& rows) {
  FieldColumns columns = columns_of(mechanism, rows);
  std::vector<int> kept;
  for (const std::size_t k : reduced_echelon(std::move(columns), [](const auto& x) { return x.value() == 0; }).pivots) {
    kept.push_back(rows[k]);
  }
  return kept;
}

}  // namespace

std::string task_text(const std::vector<int>& rows, Orientation orientation) {
  static constexpr std::array kVelocities = {"x", "y", "z", "rx", "ry", "rz"};
  static constexpr std::array kAngles = {"x", "y", "z", "phi", "theta", "psi"};
  std::vector<std::string> names;
  for (const int row : rows) {
    const auto r = static_cast<std::size_t>(row);
    names.emplace_back(orientation == Orientation::angular_velocity ? kVelocities[r] : kAngles[r]);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

Rows task_jacobian(DerivationContext& context, const std::vector<int>& rows, Orientation orientation) {
  const std::optional<EulerRates> rates = euler_rates(context, rows, orientation);
  Rows J(rows.size());
  for (const JacobianColumn& column : tip_jacobian(context)) {
    const std::vector<Number> entries =
        chosen_rows(column.linear, rates ? rates->of(column.angular) : column.angular, rows);
    for (std::size_t i = 0; i < rows.size(); ++i) J[i].push_back(entries[i]);
  }
  return J;
}

std::optional<Number> divisor_of_angles(DerivationContext& context, const std::vector<int>& rows,
                                        Orientation orientation) {
  const std::optional<EulerRates> rates = euler_rates(context, rows, orientation);
  return rates ? std::optional(rates->divisor()) : std::nullopt;
}

std::vector<Number> task_drift(DerivationContext& context, const std::vector<int>& rows, Orientation orientation) {
  const JacobianColumn drift = jacobian_dot_qd(context.frames, context.mechanism.tip);
  const std::optional<EulerRates> rates = euler_rates(context, rows, orientation);
  if (!rates) return chosen_rows(drift.linear, drift.angular, rows);
  Vec3 omega = zero_vector();
  const std::vector<JacobianColumn> columns = tip_jacobian(context);
  const std::vector<Number> qd = context.all(InputKind::qd);
  for (std::size_t k = 0; k < columns.size(); ++k) omega = omega + qd[k] * columns[k].angular;
  return chosen_rows(drift.linear, rates->changes(context.derivation.named(omega, "omega_e"), drift.angular), rows);
}

std::vector<int> task_rows(const Mechanism& mechanism) {
  const Task& task = mechanism.task;
  const std::vector<int> wanted = task.empty() ? std::vector{0, 1, 2, 3, 4, 5} : task.rows;
  std::vector<int> rows = independent(mechanism, wanted);
  if (rows.empty() || (!task.empty() && rows != wanted)) {
    throw Failure(FailureKind::unsupported,
                  fmt::format("operational space: the tip \"{}\" cannot move along {} independently",
                              mechanism.tip.link, task_text(wanted, task.orientation)),
                  rows.empty()
                      ? "no joint moves it: choose another with --tip"
                      : fmt::format("of the scene's `task` it can along {}", task_text(rows, task.orientation)));
  }
  return rows;
}

}  // namespace flatdyn
