// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/operational.hpp"

#include <fmt/format.h>

#include <numeric>

#include "base/diagnostics/diagnostics.hpp"
#include "derivation/dynamics/composite.hpp"
#include "derivation/dynamics/energy.hpp"
#include "derivation/dynamics/factorisation.hpp"
#include "derivation/dynamics/task_rows.hpp"

namespace flatdyn {
namespace {

// By independent coordinate, the square of how far a unit of it can move the tip, m, or turn it, rad: links stretched,
// slides at 0.
std::vector<Number> squares_of_motion(const Mechanism& mechanism, bool is_translation) {
  const std::vector<int> path = path_to(mechanism, mechanism.tip.body);
  std::vector<Number> of_body(static_cast<std::size_t>(mechanism.body_count()), 0);
  Number squares = dot(mechanism.tip.p, mechanism.tip.p);
  int count = 1;
  for (auto k = path.rbegin(); k != path.rend(); ++k) {
    const Body& body = mechanism.bodies[static_cast<std::size_t>(*k)];
    Number& motion = of_body[static_cast<std::size_t>(*k)];
    if (is_translation) {
      motion = body.prismatic ? Number(1) : Number(count * squares);
      squares += dot(body.p, body.p);
      ++count;
    } else {
      motion = body.prismatic ? 0 : 1;
    }
  }
  const Rows rates = mechanism.rate_coupling();
  std::vector<Number> result;
  for (int k = 0; k < mechanism.size(); ++k) {
    if (!mechanism.is_coupled()) {
      result.push_back(of_body[static_cast<std::size_t>(k)]);
      continue;
    }
    const int base = mechanism.base_bodies(), column = k < base ? k : base + mechanism.position_of(k);
    Number sum = 0;
    for (std::size_t i = 0; i < of_body.size(); ++i) {
      const Number& factor = rates[i][static_cast<std::size_t>(column)];
      sum += factor * factor * of_body[i];
    }
    result.push_back(sum);
  }
  return result;
}

// The matrices of the task, with rows for its directions and for joints, and sums over the joints.
class OperationalSpace {
 public:
  explicit OperationalSpace(DerivationContext& context)
      : context_(context),
        task_{task_rows(context.mechanism), context.mechanism.task.orientation, context.mechanism.task.damping},
        B_(context.frames, context.inertia()),
        J_(task_jacobian(context, task_.rows, task_.orientation)),
        Y_(solved_transposed_rows()),
        Z_(divided_by_pivots()),
        mobility_(damped_mobility()),
        factors_(context.derivation, chain(size()), mobility_, "J B^-1 J^T", "m_") {}

  std::size_t size() const { return task_.rows.size(); }
  const Task& task() const { return task_; }

  // The product B_A b.
  std::vector<Number> inertia_times(std::vector<Number> b, const std::string& name) const {
    return factors_.solve(std::move(b), name);
  }
  Rows inertia() const { return factors_.inverse("b_a"); }

  // r² / (tr M tr M^-1) of the matrix M that is inverted, with eigenvalues λ_1 … λ_r: 1 if all of them are equal. As tr
  // M ≥ max λ and tr M^-1 ≥ 1 / min λ, it is between min λ / max λ and r² times that.
  Number condition(const Rows& inverse) const {
    if (size() == 1) return 1;
    Derivation& d = context_.derivation;
    Number trace = 0, trace_of_inverse = 0;
    for (std::size_t i = 0; i < size(); ++i) {
      trace += mobility_[i][i];
      trace_of_inverse += inverse[i][i];
    }
    const Number traces = d.named(trace, "tr_m") * d.named(trace_of_inverse, "tr_b_a");
    return d.quotient(static_cast<int>(size() * size()), traces, "condition");
  }

  // J B^-1 b, where b has an entry per joint.
  std::vector<Number> acceleration(const std::vector<Number>& b, const std::string& name) const {
    const std::vector<Number> y = B_.solved_transposed(b, "y_" + name);
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
    for (std::size_t i = 0; i < size(); ++i) result.push_back(B_.finished(Y_[i], "x_" + label(task_.rows[i])));
    return result;
  }

  // The joint torques Jᵀ f.
  std::vector<Number> torques_of(const std::vector<Number>& f) const {
    std::vector<Number> result(J_.front().size(), 0);
    for (std::size_t i = 0; i < size(); ++i) {
      for (std::size_t k = 0; k < result.size(); ++k) result[k] += J_[i][k] * f[i];
    }
    return result;
  }

  // The power of the divisor of Euler angles' rates, sin θ or cos θ, in terms that cancel in the outputs.
  enum class Powers { two, four };

  Function finished(std::vector<Output> outputs, Powers powers) const {
    // Every arm has poses in which J B⁻¹ Jᵀ or its angles are singular, so they are always guarded, and come first.
    Conditions conditions{context_.nodes(factors_.pivots()), context_.nodes(factors_.pivot_scales(sizes()))};
    if (const auto divisor = divisor_of_angles(context_, task_.rows, task_.orientation)) {
      const Number square = context_.derivation.named(*divisor * *divisor, "divisor2");
      const Number lost = powers == Powers::two ? square : context_.derivation.named(square * square, "divisor4");
      conditions.append({{context_.node(lost)}, {context_.node(1)}});
    }
    conditions.append(conditions_of(context_, B_));
    Function function = flatdyn::finished(context_, std::move(outputs), std::move(conditions));
    function.task = task_;
    return function;
  }

 private:
  // The parents for a chain of bodies, with which all entries of a matrix may be non-zero.
  static std::vector<int> chain(std::size_t size) {
    std::vector<int> parents(size);
    std::iota(parents.begin(), parents.end(), -1);
    return parents;
  }

  // Σ_k r_k² / d_k with r_k the largest motion of the tip per unit of coordinate k: the size of J B⁻¹ Jᵀ along
  // directions that are not in the task.
  Number largest_motion(bool is_translation) const {
    const std::vector<Number> squares = squares_of_motion(context_.mechanism, is_translation);
    Number sum = 0;
    for (std::size_t k = 0; k < squares.size(); ++k) sum += squares[k] * B_.inverse_pivots()[k];
    return context_.derivation.named(sum, is_translation ? "largest_p" : "largest_o");
  }

  // By row, the size of the terms whose sums are in J B⁻¹ Jᵀ. A diagonal entry may itself be what is left of large
  // terms, where the tip cannot move along its axis, so that the mean of all rows of one unit counts: of translations
  // or of rotations.
  std::vector<Number> sizes() const {
    Number sum[2] = {0, 0};
    int count[2] = {0, 0};
    const auto kind = [this](std::size_t i) { return task_.rows[i] < 3 ? 0 : 1; };
    for (std::size_t i = 0; i < size(); ++i) {
      sum[kind(i)] += mobility_[i][i];
      ++count[kind(i)];
    }
    for (const int k : {0, 1}) {
      if (count[k] == 0 || count[k] == 3) continue;
      sum[k] += largest_motion(k == 0);
      ++count[k];
    }
    std::vector<Number> result;
    for (std::size_t i = 0; i < size(); ++i) {
      const Number mean = sum[kind(i)] / count[kind(i)];
      result.push_back(context_.derivation.named(mean, kind(i) == 0 ? "size_p" : "size_o"));
    }
    return result;
  }

  Number named(const Number& value, const std::string& name, std::size_t row) const {
    return context_.derivation.named(value, name + "_" + label(static_cast<int>(row)));
  }

  Rows solved_transposed_rows() const {
    Rows Y;
    for (std::size_t i = 0; i < size(); ++i)
      Y.push_back(B_.solved_transposed(J_[i], "y_" + label(static_cast<int>(i))));
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

  // J B^-1 Jᵀ, the acceleration of the tip by a unit force, plus λ² 1.
  Rows damped_mobility() const {
    const Number damping = GiNaC::numeric(Rational(task_.damping * task_.damping).str().c_str());
    Rows M(size(), std::vector<Number>(size(), 0));
    for (std::size_t i = 0; i < size(); ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        Number sum = i == j ? damping : Number(0);
        for (std::size_t k = 0; k < Y_[i].size(); ++k) sum += Z_[i][k] * Y_[j][k];
        M[i][j] = M[j][i] = named(sum, "m_" + label(static_cast<int>(i)), j);
      }
    }
    return M;
  }

  DerivationContext& context_;
  Task task_;
  Factorisation B_;
  Rows J_, Y_, Z_, mobility_;
  Factorisation factors_;
};

std::vector<Number> coriolis_torques(DerivationContext& context) {
  return context.at_coordinates(
      torques(context.frames, {context.joint_motion(InputKind::qd), context.joint_drift(), zero_vector(), false}));
}

std::string of_task(const std::string& what, const OperationalSpace& space) {
  return what + " of the task " + task_text(space.task().rows, space.task().orientation);
}

// The meaning of the condition of the inverted matrix, M = J B^-1 Jᵀ + λ² 1.
std::string condition_meaning(const OperationalSpace& space) {
  return space.task().is_damped()
             ? "0..1, r^2 / (tr M tr M^-1) of M = J B^-1 J^T + lambda^2 1: small where the task is singular"
             : "0..1, r^2 / (tr M tr M^-1) of M = J B^-1 J^T: 0 where the task is singular";
}

Function operational_inertia_at(DerivationContext& context) {
  const OperationalSpace space(context);
  const Rows B_A = space.inertia(), X = space.inverse_inertia_times_jacobian();
  const int r = static_cast<int>(space.size()), n = context.size();
  std::vector<NodeId> J_bar;
  for (std::size_t k = 0; k < static_cast<std::size_t>(n); ++k) {
    for (std::size_t j = 0; j < space.size(); ++j) {
      Number sum = 0;
      for (std::size_t i = 0; i < space.size(); ++i) sum += X[i][k] * B_A[i][j];
      J_bar.push_back(context.node(sum));
    }
  }
  return space.finished(
      {matrix_output("B_A", r, r, context.nodes(B_A), of_task("inertia matrix", space) + ", symmetric, SI units"),
       matrix_output("J_bar", n, r, J_bar, "B^-1 J^T B_A: J_bar^T tau is the force on the task, SI units"),
       vector_output("condition", {context.node(space.condition(B_A))}, condition_meaning(space))},
      OperationalSpace::Powers::two);
}

Function operational_bias_at(DerivationContext& context) {
  const OperationalSpace space(context);
  const std::vector<Number> drift = task_drift(context, space.task().rows, space.task().orientation);
  std::vector<Number> c = space.acceleration(coriolis_torques(context), "c");
  for (std::size_t i = 0; i < space.size(); ++i) c[i] -= drift[i];
  const std::vector<Number> g = space.acceleration(context.at_coordinates(gravity_torques(context.frames)), "g");
  const std::vector<Number> c_A = space.inertia_times(c, "c_a"), g_A = space.inertia_times(g, "g_a");
  return space.finished(
      {vector_output("c_A", context.nodes(c_A), of_task("C_A times the velocity", space) + ", N, N m"),
       vector_output("g_A", context.nodes(g_A), of_task("gravity", space) + ", N, N m")},
      OperationalSpace::Powers::four);
}

Function null_space_torque_at(DerivationContext& context) {
  const OperationalSpace space(context);
  if (static_cast<int>(space.size()) == context.size()) {
    throw Failure(FailureKind::unsupported,
                  fmt::format("null_space_torque: the task {} takes all joints",
                              task_text(space.task().rows, space.task().orientation)),
                  "name fewer directions in the scene's `task`");
  }
  const std::vector<Number> tau = context.all(InputKind::tau);
  const std::vector<Number> f = space.inertia_times(space.acceleration(tau, "tau"), "f");
  std::vector<Number> rest = space.torques_of(f);
  for (std::size_t k = 0; k < rest.size(); ++k) rest[k] = tau[k] - rest[k];
  return space.finished({vector_output("tau_n", context.nodes(rest),
                                       of_task("what of tau does not accelerate the tip along any", space) + ", N m")},
                        OperationalSpace::Powers::two);
}

}  // namespace

Function derive_operational_inertia(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, at_the_tip(choices, mechanism.tip), operational_inertia_at);
}

Function derive_operational_bias(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, at_the_tip(choices, mechanism.tip), operational_bias_at);
}

Function derive_null_space_torque(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, at_the_tip(choices, mechanism.tip), null_space_torque_at);
}

}  // namespace flatdyn
