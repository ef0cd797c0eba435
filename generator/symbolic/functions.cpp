// SPDX-License-Identifier: GPL-2.0-or-later
#include "symbolic/functions.hpp"

#include <functional>
#include <optional>

#include "symbolic/dynamics/accelerations.hpp"
#include "symbolic/dynamics/articulated.hpp"
#include "symbolic/dynamics/composite.hpp"
#include "symbolic/dynamics/composite_bias.hpp"
#include "symbolic/dynamics/derivative_functions.hpp"
#include "symbolic/dynamics/derivatives.hpp"
#include "symbolic/dynamics/energy.hpp"
#include "symbolic/dynamics/kinematics.hpp"
#include "symbolic/dynamics/loop_functions.hpp"
#include "symbolic/dynamics/operational.hpp"
#include "symbolic/dynamics/workbench.hpp"
#include "symbolic/parameters/regressor_functions.hpp"

namespace flatdyn {
namespace {

Function derived(const Mechanism& mechanism, const Choices& choices,
                 const std::function<Function(Workbench&)>& derive) {
  const Mechanism described = chosen(mechanism, choices);
  Workbench bench(described, axes_of(choices));
  bench.guards_pivots = choices.guards_pivots;
  return derive(bench);
}

Function inverse_dynamics(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](Workbench& bench) {
    const Motion motion{bench.joint_motion(InputKind::qd), bench.joint_motion(InputKind::qdd), bench.mechanism.gravity,
                        true};
    const std::vector<Number> tau = torques(bench.frames, motion);
    return finished(bench, {InputKind::q, InputKind::qd, InputKind::qdd},
                    {vector_output("tau", bench.nodes(bench.at_coordinates(tau)), kTorqueMeaning)});
  });
}

// Choices with metres and with the axes of the tip's link, as the wrench at the tip is given in these.
Choices as_given(Choices choices, const LinkFrame& tip) {
  if (tip.body >= 0) choices.joints[static_cast<std::size_t>(tip.body)].axes = Axes::turning;
  choices.length_unit = 1;
  return choices;
}

Function inverse_dynamics_tip_force(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, as_given(choices, mechanism.tip), [](Workbench& bench) {
    const std::vector<Number> h = inputs(bench.derivation, InputKind::h_e, 6);
    const Wrench tip = wrench_on_body(bench.frames, bench.mechanism.tip, {{h[0], h[1], h[2]}, {h[3], h[4], h[5]}});
    const Motion motion{bench.joint_motion(InputKind::qd), bench.joint_motion(InputKind::qdd), bench.mechanism.gravity,
                        true};
    const std::vector<Number> tau = torques(bench.frames, motion, tip);
    return finished(bench, {InputKind::q, InputKind::qd, InputKind::qdd, InputKind::h_e},
                    {vector_output("tau", bench.nodes(bench.at_coordinates(tau)), kTorqueMeaning)});
  });
}

Function inertia_matrix_function(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](Workbench& bench) {
    std::vector<NodeId> entries;
    for (const std::vector<Number>& row : bench.inertia()) {
      for (const Number& b : row) entries.push_back(bench.node(b));
    }
    return finished(bench, {InputKind::q},
                    {matrix_output("B", bench.size(), bench.size(), entries,
                                   "inertia matrix, symmetric, kg m^2 (kg for prismatic joints)")});
  });
}

// Adds the contribution of closed loops: (A G)ᵀ B times the second derivatives of the joints' positions. `bench`: that
// of half the inertia.
void add_curvature(Workbench& bench, ChristoffelSymbols& symbols) {
  Rows B = inertia_matrix(bench.frames);
  for (std::vector<Number>& row : B) {
    for (Number& b : row) b *= 2;
  }
  const Rows GB = rows_at_coordinates(bench.mechanism, bench.derivation, B, "b");
  for (int k = 0; k < bench.size(); ++k) {
    for (int j = 0; j <= k; ++j) {
      const std::vector<Number> H = joint_curvature(bench.mechanism, bench.derivation, j, k);
      for (int i = 0; i < bench.size(); ++i) {
        Number sum = symbols[{i, j, k}];
        for (std::size_t r = 0; r < H.size(); ++r) sum += GB[static_cast<std::size_t>(i)][r] * H[r];
        symbols[{i, j, k}] = bench.derivation.named(sum, "c_l" + label(i) + "_" + label(j) + "_" + label(k));
      }
    }
  }
}

ChristoffelSymbols christoffel_at_coordinates(Workbench& bench) {
  ChristoffelSymbols symbols = at_coordinates(bench.mechanism, bench.derivation, christoffel_symbols(bench.frames));
  if (bench.mechanism.has_loops()) add_curvature(bench, symbols);
  return symbols;
}

Function christoffel(const Mechanism& mechanism, const Choices& choices) {
  return derived(with_half_inertia(mechanism), choices, [](Workbench& bench) {
    const int n = bench.size(), columns = n * (n + 1) / 2;
    std::vector<NodeId> entries(static_cast<std::size_t>(n * columns), bench.node(0));
    for (const auto& [key, value] : christoffel_at_coordinates(bench)) {
      const auto [i, j, k] = key;
      entries[static_cast<std::size_t>(i * columns + k * (k + 1) / 2 + j)] = bench.node(value);
    }
    return finished(bench, {InputKind::q},
                    {{"c", Layout::christoffel, n, columns, entries, "Christoffel symbols c_ijk = c_ikj, j <= k"}});
  });
}

Function finished_coriolis(Workbench& bench, const std::vector<NodeId>& entries) {
  return finished(bench, {InputKind::q, InputKind::qd},
                  {matrix_output("C", bench.size(), bench.size(), entries,
                                 "c_ij = sum_k c_ijk qd_k, so that dB/dt - 2 C is skew-symmetric")});
}

Function coriolis_from_christoffel(const Mechanism& mechanism, const Choices& choices) {
  return derived(with_half_inertia(mechanism), choices, [](Workbench& bench) {
    const auto n = static_cast<std::size_t>(bench.size());
    const std::vector<Number> qd = bench.all(InputKind::qd);
    Rows C(n, std::vector<Number>(n, 0));
    for (const auto& [key, c] : christoffel_at_coordinates(bench)) {
      const auto i = static_cast<std::size_t>(key[0]), j = static_cast<std::size_t>(key[1]),
                 k = static_cast<std::size_t>(key[2]);
      C[i][j] += c * qd[k];
      if (j != k) C[i][k] += c * qd[j];
    }
    return finished_coriolis(bench, bench.nodes(C));
  });
}

// C q̇ is a quadratic form in q̇ with the coefficients c_ijk = c_ikj, so C is half its derivative.
std::optional<Function> coriolis_from_momenta(const Mechanism& mechanism, const Choices& choices) {
  if (mechanism.has_loops()) return std::nullopt;
  return derived(with_half_inertia(mechanism), choices, [](Workbench& bench) {
    const Motion motion{bench.joint_motion(InputKind::qd), bench.joint_drift(), zero_vector(), false};
    const Rows C = torque_derivatives(bench.frames, motion).dqd;
    return finished_coriolis(bench,
                             bench.nodes(at_coordinates(bench.mechanism, bench.derivation, C, Shape::general, "C")));
  });
}

Function gravity(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](Workbench& bench) {
    return finished(
        bench, {InputKind::q},
        {vector_output("g", bench.nodes(bench.at_coordinates(gravity_torques(bench.frames))), kTorqueMeaning)});
  });
}

Function bias(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](Workbench& bench) {
    return finished(bench, {InputKind::q, InputKind::qd},
                    {vector_output("n", bench.nodes(bias_torques(bench)), kTorqueMeaning)});
  });
}

Function finished_accelerations(Workbench& bench, const std::vector<Number>& qdd, Conditions conditions) {
  const std::vector<NodeId> entries = bench.nodes(qdd);
  return finished(bench, {InputKind::q, InputKind::qd, InputKind::tau},
                  {vector_output("qdd", entries, "joint accelerations, rad/s^2 (m/s^2 for prismatic joints)")},
                  std::move(conditions));
}

Function forward_dynamics(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](Workbench& bench) {
    const Factorisation B(bench.frames, bench.inertia());
    return finished_accelerations(bench, accelerations(bench, B), conditions_of(bench, B));
  });
}

// Forward dynamics without the diagonal entries b_kk, beside which a pivot could be seen to be lost.
std::optional<Function> forward_dynamics_by_articulated_bodies(const Mechanism& mechanism, const Choices& choices) {
  if (!has_articulated_form(mechanism) || choices.guards_pivots) return std::nullopt;
  return derived(mechanism, choices, [](Workbench& bench) {
    const Motion motion{bench.joint_motion(InputKind::qd), bench.joint_drift(), bench.mechanism.gravity, true};
    const std::vector<Number> tau = bench.all(InputKind::tau);
    const ArticulatedSolution solution = articulated_accelerations(bench.frames, motion, tau);
    return finished_accelerations(bench, solution.qdd, {bench.nodes(solution.pivots), {}});
  });
}

// The bias is computed from the composite bodies that B is made from.
std::optional<Function> forward_dynamics_by_composite_bodies(const Mechanism& mechanism, const Choices& choices) {
  if (mechanism.has_prismatic_joint() || mechanism.has_loops()) return std::nullopt;
  return derived(mechanism, choices, [](Workbench& bench) {
    const Factorisation B(bench.frames, bench.inertia());
    const Motion motion{bench.joint_motion(InputKind::qd), bench.joint_drift(), bench.mechanism.gravity, true};
    const std::vector<Number> bias =
        bench.at_coordinates(composite_bias_torques(bench.frames, motion, composites(bench.frames)));
    return finished_accelerations(bench, accelerations(bench, B, bias), conditions_of(bench, B));
  });
}

void refuse_derivatives_of_loops(const Mechanism& mechanism, const std::string& name) {
  if (!mechanism.has_loops()) return;
  throw Failure(ExitCode::unsupported, name + ": derivatives of robots with closed loops are not supported yet",
                "leave this function out");
}

Function inverse_dynamics_derivatives(const Mechanism& mechanism, const Choices& choices) {
  refuse_derivatives_of_loops(mechanism, "inverse_dynamics_derivatives");
  return derived(mechanism, choices, torque_derivatives_function);
}

Function forward_dynamics_derivatives(const Mechanism& mechanism, const Choices& choices) {
  refuse_derivatives_of_loops(mechanism, "forward_dynamics_derivatives");
  return derived(mechanism, choices, acceleration_derivatives_function);
}

// Derives a function of closed loops, which depends on no choices.
template <Function (*derive)(Workbench&)>
Function of_loops(const Mechanism& mechanism, const Choices&) {
  Workbench bench(mechanism);
  return derive(bench);
}

template <Function (*derive)(Workbench&)>
Function at_the_tip(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, as_given(choices, mechanism.tip), derive);
}

Function kinetic_energy_function(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](Workbench& bench) {
    const NodeId T = bench.node(kinetic_energy(bench.frames));
    return finished(bench, {InputKind::q, InputKind::qd}, {scalar_output("T", T, "kinetic energy, J")});
  });
}

Function potential_energy_function(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](Workbench& bench) {
    const NodeId U = bench.node(potential_energy(bench.frames));
    return finished(bench, {InputKind::q},
                    {scalar_output("U", U, "potential energy, J; zero at the base frame's origin")});
  });
}

Function forward_kinematics_of(const Mechanism& mechanism, const LinkFrame& link) {
  Workbench bench(mechanism);
  const SymbolicPose result = pose(bench.frames, link);
  std::vector<NodeId> R, p;
  for (const Vec3& row : result.R) {
    for (const Number& entry : row) R.push_back(bench.node(entry));
  }
  for (const Number& entry : result.p) p.push_back(bench.node(entry));
  return finished(bench, {InputKind::q},
                  {matrix_output("R", 3, 3, R, "rotation matrix of the frame in the base frame"),
                   vector_output("p", p, "position of the frame's origin in the base frame, m")});
}

Function jacobian_of(const Mechanism& mechanism, const LinkFrame& link) {
  Workbench bench(mechanism);
  const std::vector<JacobianColumn> columns = at_coordinates(mechanism, bench.derivation, jacobian(bench.frames, link));
  std::vector<NodeId> entries;
  for (std::size_t row = 0; row < 6; ++row) {
    for (const JacobianColumn& column : columns) {
      entries.push_back(bench.node(row < 3 ? column.linear[row] : column.angular[row - 3]));
    }
  }
  return finished(
      bench, {InputKind::q},
      {matrix_output("J", 6, mechanism.size(), entries, "geometric Jacobian in base axes: linear rows, then angular")});
}

Function jacobian_dot_qd_of(const Mechanism& mechanism, const LinkFrame& link) {
  Workbench bench(mechanism);
  const JacobianColumn a = jacobian_dot_qd(bench.frames, link);
  std::vector<Number> entries(a.linear.begin(), a.linear.end());
  entries.insert(entries.end(), a.angular.begin(), a.angular.end());
  return finished(
      bench, {InputKind::q, InputKind::qd},
      {vector_output("a", bench.nodes(entries), "(dJ/dt) qd in base axes: linear m/s^2, then angular rad/s^2")});
}

Function forward_kinematics_tip(const Mechanism& m, const Choices&) { return forward_kinematics_of(m, m.tip); }
Function jacobian_tip(const Mechanism& m, const Choices&) { return jacobian_of(m, m.tip); }
Function jacobian_dot_qd_tip(const Mechanism& m, const Choices&) { return jacobian_dot_qd_of(m, m.tip); }

// Derives a regressor, which chooses its own parameters.
template <Function (*derive)(const Mechanism&)>
Function ungrouped(const Mechanism& mechanism, const Choices&) {
  return derive(mechanism);
}

constexpr const char* kRegressor =
    "Y(q, qd, qdd) with tau = Y pi, 13 parameters per joint, of its link with the rotors that it carries, in and about "
    "the frame that flatdyn inspect shows";

}  // namespace

const std::vector<FunctionEntry>& function_table() {
  using Kind = FunctionKind;
  static const std::vector<FunctionEntry> table = {
      {"inverse_dynamics", "tau = B(q) qdd + C(q, qd) qd + g(q) + friction", "(7.42)", Kind::dynamics,
       inverse_dynamics},
      {"inverse_dynamics_tip_force", "Inverse dynamics with a force h_e that the tip exerts on the environment",
       "(7.42)", Kind::dynamics, inverse_dynamics_tip_force},
      {"inertia_matrix", "Joint-space inertia matrix B(q)", "(7.32)", Kind::dynamics, inertia_matrix_function},
      {"christoffel", "Christoffel symbols of the first kind c_ijk(q)", "(7.45)", Kind::dynamics, christoffel},
      {"coriolis_matrix",
       "C(q, qd) from the Christoffel symbols",
       "(7.44)",
       Kind::dynamics,
       coriolis_from_christoffel,
       {coriolis_from_momenta}},
      {"gravity", "Gravity torques g(q)", "(7.39)", Kind::dynamics, gravity},
      {"bias", "C(q, qd) qd + g(q) + friction", "(7.116)", Kind::dynamics, bias},
      {"forward_dynamics",
       "qdd from B(q) qdd = tau - bias(q, qd)",
       "(7.115)",
       Kind::dynamics,
       forward_dynamics,
       {forward_dynamics_by_articulated_bodies, forward_dynamics_by_composite_bodies}},
      {"kinetic_energy", "Kinetic energy of links and rotors", "(7.31)", Kind::dynamics, kinetic_energy_function},
      {"potential_energy", "Potential energy of links and rotors", "(7.36)", Kind::dynamics, potential_energy_function},
      {"forward_kinematics", "Pose of the tip", "(2.50)", Kind::kinematics, forward_kinematics_tip},
      {"jacobian", "Geometric Jacobian of the tip", "(7.14), (7.15)", Kind::kinematics, jacobian_tip},
      {"jacobian_dot_qd", "(dJ/dt) qd of the tip", "", Kind::kinematics, jacobian_dot_qd_tip},
      {"loop_closure", "Phi(q): what lies between the points where the loops are closed", "", Kind::loops,
       of_loops<loop_closure_function>},
      {"loop_jacobian", "Phi_q, the derivative of loop_closure", "", Kind::loops, of_loops<loop_jacobian_function>},
      {"loop_step", "Newton's step of the dependent joints towards closed loops", "", Kind::loops,
       of_loops<loop_step_function>},
      {"loop_motion", "Rates and accelerations of all joints of q, from those of the independent ones", "", Kind::loops,
       of_loops<loop_motion_function>},
      {"inverse_dynamics_derivatives",
       "Derivatives of tau(q, qd, qdd) by q and by qd; Coulomb friction counts as constant", "", Kind::derivatives,
       inverse_dynamics_derivatives},
      {"forward_dynamics_derivatives",
       "Derivatives of qdd(q, qd, tau) by q, qd and tau; Coulomb friction counts as constant", "", Kind::derivatives,
       forward_dynamics_derivatives},
      {"operational_inertia", "B_A and the consistent inverse of J: the inertia that the tip moves with",
       "(7.130), (7.138)", Kind::operational, at_the_tip<operational_inertia_function>},
      {"operational_bias", "C_A times the tip's velocity, and g_A", "(7.131), (7.132)", Kind::operational,
       at_the_tip<operational_bias_function>},
      {"null_space_torque", "What of tau moves the arm and leaves the tip where it is", "(7.141)", Kind::operational,
       at_the_tip<null_space_torque_function>},
      {"regressor", kRegressor, "(7.81)", Kind::regressor, ungrouped<regressor_function>},
      {"base_regressor", "Y_b(q, qd, qdd) with tau = Y_b pi_b, pi_b the base parameters", "(7.81)", Kind::regressor,
       ungrouped<base_regressor_function>},
      {"base_parameters", "pi_b of this robot: Y_b pi_b = tau", "", Kind::regressor,
       ungrouped<base_parameters_function>},
      {"inverse_dynamics_base", "tau = B qdd + C qd + g + friction with the base parameters pi_b as an argument",
       "(7.42)", Kind::regressor, ungrouped<inverse_dynamics_base_function>},
      {"adaptive_regressor", "Y_b(q, qd, qd_r, qdd_r) with B qdd_r + C qd_r + g + friction at qd_r = Y_b pi_b",
       "(7.81)", Kind::regressor, ungrouped<adaptive_regressor_function>},
  };
  return table;
}

LinkDerivation link_derivation(const std::string& name) {
  if (name == "forward_kinematics") return forward_kinematics_of;
  if (name == "jacobian") return jacobian_of;
  if (name == "jacobian_dot_qd") return jacobian_dot_qd_of;
  return nullptr;
}

}  // namespace flatdyn
