// SPDX-License-Identifier: GPL-2.0-or-later
#include "symbolic/operational.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <numeric>

#include "diagnostics/diagnostics.hpp"
#include "graph/mod_p.hpp"
#include "symbolic/composite.hpp"
#include "symbolic/elimination.hpp"
#include "symbolic/energy.hpp"
#include "symbolic/factorisation.hpp"
#include "symbolic/functions.hpp"
#include "symbolic/kinematics.hpp"

namespace flatdyn {
namespace {

// Of the Jacobian's rows in this order, those that do not depend on the ones before. At a random point of a large prime
// field: rows that are independent anywhere are so there, but for a chance of about 1e-17.
std::vector<int> independent(const Mechanism& mechanism, const std::vector<int>& rows) {
  using Arithmetic = ModPArithmetic<kMersenne61>;
  using F = Arithmetic::Scalar;
  Arithmetic arithmetic(1);
  const Function function = link_derivation("jacobian")(mechanism, mechanism.tip);
  const std::vector<F> values = evaluate(function, arithmetic);
  const Output& J = function.outputs.front();
  std::vector<std::vector<F>> columns(static_cast<std::size_t>(J.cols));
  for (std::size_t j = 0; j < columns.size(); ++j) {
    for (const int row : rows) {
      const NodeId entry = J.entries[static_cast<std::size_t>(row * J.cols) + j];
      columns[j].push_back(values[static_cast<std::size_t>(entry)]);
    }
  }
  std::vector<int> kept;
  for (const std::size_t k : reduced_echelon(columns, [](const F& x) { return x == F(0); }).pivots) {
    kept.push_back(rows[k]);
  }
  return kept;
}

// Several numbers of rows of a task, or of joints, as a matrix; and sums over the joints.
class OperationalSpace {
 public:
  explicit OperationalSpace(Workbench& bench)
      : bench_(bench),
        rows_(task_rows(bench.mechanism)),
        B_(bench.frames, bench.inertia()),
        J_(jacobian_rows()),
        Y_(half_solved_rows()),
        Z_(divided_by_pivots()),
        mobility_(bench.derivation, chain(rows_.size()), mobility(), "J B^-1 J^T", "m_") {}

  std::size_t size() const { return rows_.size(); }
  const std::vector<int>& rows() const { return rows_; }

  // B_A b.
  std::vector<Number> inertia_times(std::vector<Number> b, const std::string& name) const {
    return mobility_.solve(std::move(b), name);
  }
  Rows inertia() const { return mobility_.inverse("b_a"); }

  // J B^-1 b, for b by joint.
  std::vector<Number> acceleration(const std::vector<Number>& b, const std::string& name) const {
    const std::vector<Number> y = B_.half_solved(b, "y_" + name);
    std::vector<Number> result;
    for (std::size_t i = 0; i < size(); ++i) {
      Number sum = 0;
      for (std::size_t k = 0; k < y.size(); ++k) sum += Z_[i][k] * y[k];
      result.push_back(named(sum, "a_" + name, i));
    }
    return result;
  }

  // B^-1 J^T, by row of the task.
  Rows inverse_inertia_times_jacobian() const {
    Rows result;
    for (std::size_t i = 0; i < size(); ++i) result.push_back(B_.finished(Y_[i], "x_" + label(rows_[i])));
    return result;
  }

  // Jᵀ f.
  std::vector<Number> torques_of(const std::vector<Number>& f) const {
    std::vector<Number> result(J_.front().size(), 0);
    for (std::size_t i = 0; i < size(); ++i) {
      for (std::size_t k = 0; k < result.size(); ++k) result[k] += J_[i][k] * f[i];
    }
    return result;
  }

  Function finished(std::vector<InputKind> inputs, std::vector<Output> outputs) const {
    std::vector<NodeId> positive = bench_.nodes(B_.pivots()), more = bench_.nodes(mobility_.pivots());
    positive.insert(positive.end(), more.begin(), more.end());
    Function function = flatdyn::finished(bench_, std::move(inputs), std::move(outputs), std::move(positive));
    function.task = rows_;
    return function;
  }

 private:
  // Of a chain of k bodies: all entries of a matrix may be there.
  static std::vector<int> chain(std::size_t size) {
    std::vector<int> parents(size);
    std::iota(parents.begin(), parents.end(), -1);
    return parents;
  }

  Number named(const Number& value, const std::string& name, std::size_t row) const {
    return bench_.derivation.named(value, name + "_" + label(static_cast<int>(row)));
  }

  Rows jacobian_rows() const {
    const std::vector<JacobianColumn> columns =
        at_coordinates(bench_.mechanism, bench_.derivation, jacobian(bench_.frames, bench_.mechanism.tip));
    Rows J;
    for (const int row : rows_) {
      J.emplace_back();
      const auto r = static_cast<std::size_t>(row);
      for (const JacobianColumn& column : columns) J.back().push_back(r < 3 ? column.linear[r] : column.angular[r - 3]);
    }
    return J;
  }

  Rows half_solved_rows() const {
    Rows Y;
    for (std::size_t i = 0; i < size(); ++i) Y.push_back(B_.half_solved(J_[i], "y_" + label(static_cast<int>(i))));
    return Y;
  }

  Rows divided_by_pivots() const {
    Rows Z = Y_;
    for (std::size_t i = 0; i < size(); ++i) {
      for (std::size_t k = 0; k < Z[i].size(); ++k) {
        Z[i][k] = named(Y_[i][k] * B_.inverse_pivots()[k], "z_" + label(static_cast<int>(i)), k);
      }
    }
    return Z;
  }

  // J B^-1 Jᵀ: what a unit force at the tip accelerates it by.
  Rows mobility() const {
    Rows M(size(), std::vector<Number>(size(), 0));
    for (std::size_t i = 0; i < size(); ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        Number sum = 0;
        for (std::size_t k = 0; k < Y_[i].size(); ++k) sum += Z_[i][k] * Y_[j][k];
        M[i][j] = M[j][i] = named(sum, "m_" + label(static_cast<int>(i)), j);
      }
    }
    return M;
  }

  Workbench& bench_;
  std::vector<int> rows_;
  Factorisation B_;
  Rows J_, Y_, Z_;
  Factorisation mobility_;
};

std::vector<Number> coriolis_torques(Workbench& bench) {
  return bench.at_coordinates(
      torques(bench.frames, {bench.joint_motion(InputKind::qd), bench.no_motion(), zero_vector(), false}));
}

std::string of_task(const std::string& what, const OperationalSpace& space) {
  return what + " of the task " + task_text(space.rows());
}

}  // namespace

std::string task_text(const std::vector<int>& rows) {
  static constexpr const char* kNames[] = {"x", "y", "z", "rx", "ry", "rz"};
  std::vector<std::string> names;
  for (const int row : rows) names.emplace_back(kNames[row]);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::vector<int> task_rows(const Mechanism& mechanism) {
  const std::vector<int> wanted = mechanism.task.empty() ? std::vector{0, 1, 2, 3, 4, 5} : mechanism.task;
  std::vector<int> rows = independent(mechanism, wanted);
  if (rows.empty() || (!mechanism.task.empty() && rows != wanted)) {
    throw Failure(ExitCode::unsupported,
                  fmt::format("operational space: the tip \"{}\" cannot move along {} independently",
                              mechanism.tip.link, task_text(wanted)),
                  rows.empty() ? "no joint moves it: choose another with --tip"
                               : fmt::format("of the scene's `task` it can along {}", task_text(rows)));
  }
  return rows;
}

Function operational_inertia_function(Workbench& bench) {
  const OperationalSpace space(bench);
  const Rows B_A = space.inertia(), X = space.inverse_inertia_times_jacobian();
  const int r = static_cast<int>(space.size()), n = bench.size();
  std::vector<NodeId> J_bar;
  for (std::size_t k = 0; k < static_cast<std::size_t>(n); ++k) {
    for (std::size_t j = 0; j < space.size(); ++j) {
      Number sum = 0;
      for (std::size_t i = 0; i < space.size(); ++i) sum += X[i][k] * B_A[i][j];
      J_bar.push_back(bench.node(sum));
    }
  }
  return space.finished(
      {InputKind::q},
      {matrix_output("B_A", r, r, bench.nodes(B_A), of_task("inertia matrix", space) + ", symmetric, SI units"),
       matrix_output("J_bar", n, r, J_bar, "B^-1 J^T B_A: J_bar^T tau is the force on the task, SI units")});
}

Function operational_bias_function(Workbench& bench) {
  const OperationalSpace space(bench);
  const JacobianColumn drift = jacobian_dot_qd(bench.frames, bench.mechanism.tip);
  std::vector<Number> c = space.acceleration(coriolis_torques(bench), "c");
  for (std::size_t i = 0; i < space.size(); ++i) {
    const auto row = static_cast<std::size_t>(space.rows()[i]);
    c[i] -= row < 3 ? drift.linear[row] : drift.angular[row - 3];
  }
  const std::vector<Number> g = space.acceleration(bench.at_coordinates(gravity_torques(bench.frames)), "g");
  const std::vector<Number> c_A = space.inertia_times(c, "c_a"), g_A = space.inertia_times(g, "g_a");
  return space.finished({InputKind::q, InputKind::qd},
                        {vector_output("c_A", bench.nodes(c_A), of_task("C_A times the velocity", space) + ", N, N m"),
                         vector_output("g_A", bench.nodes(g_A), of_task("gravity", space) + ", N, N m")});
}

Function null_space_torque_function(Workbench& bench) {
  const OperationalSpace space(bench);
  if (static_cast<int>(space.size()) == bench.size()) {
    throw Failure(ExitCode::unsupported,
                  fmt::format("null_space_torque: the task {} takes all joints", task_text(space.rows())),
                  "name fewer directions in the scene's `task`");
  }
  const std::vector<Number> tau = bench.all(InputKind::tau);
  const std::vector<Number> f = space.inertia_times(space.acceleration(tau, "tau"), "f");
  std::vector<Number> rest = space.torques_of(f);
  for (std::size_t k = 0; k < rest.size(); ++k) rest[k] = tau[k] - rest[k];
  return space.finished({InputKind::q, InputKind::tau},
                        {vector_output("tau_n", bench.nodes(rest),
                                       of_task("what of tau does not accelerate the tip along any", space) + ", N m")});
}

}  // namespace flatdyn
