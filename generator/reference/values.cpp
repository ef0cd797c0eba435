// SPDX-License-Identifier: GPL-2.0-or-later
#include "reference/values.hpp"

#include <map>

#include "flatdyn/reference/derivatives.hpp"
#include "graph/arithmetic.hpp"
#include "reference/magnitude.hpp"
#include "reference/operational_values.hpp"

namespace flatdyn {
namespace {

// The name without a link: "jacobian" for "jacobian:hand".
std::string stem_of(const Function& function) { return function.name.substr(0, function.name.find(':')); }

// RealArithmetic that converts each constant of a graph only once, looked up by its node.
template <class S>
class CachedArithmetic : public RealArithmetic<S> {
 public:
  CachedArithmetic(const StateOf<S>& state, std::unordered_map<const Rational*, S>& constants)
      : RealArithmetic<S>(
            [&state](const Input& input) { return state.of(input.kind)[static_cast<std::size_t>(input.index)]; }),
        constants_(constants) {}

  S constant(const Rational& value) const {
    const auto found = constants_.find(&value);
    return found != constants_.end() ? found->second : constants_.emplace(&value, to_real<S>(value)).first->second;
  }

 private:
  std::unordered_map<const Rational*, S>& constants_;
};

// A state in the reference's types.
template <class S>
struct Arguments {
  Arguments(const StateOf<S>& state, const Function& function)
      : task(function.task),
        q(vector_of<S>(state.q)),
        qd(vector_of<S>(state.qd)),
        qdd(vector_of<S>(state.qdd)),
        tau(vector_of<S>(state.tau)) {
    const reference::VectorX<S> h = vector_of<S>(state.h_e);
    h_e.f_e = h.template head<3>();
    h_e.mu_e = h.template tail<3>();
  }
  const Task& task;  // the function's task
  reference::VectorX<S> q, qd, qdd, tau;
  reference::Environment<S> h_e;
};

template <class S>
using Evaluation = std::vector<S> (*)(const reference::Robot<S>&, const Arguments<S>&);

template <class S>
std::vector<S> pose_entries(const reference::Robot<S>& robot, const Arguments<S>& a) {
  const reference::Pose<S> pose = reference::tip_pose(robot, a.q);
  std::vector<S> entries = row_by_row(pose.R);
  entries.insert(entries.end(), pose.p.data(), pose.p.data() + 3);
  return entries;
}

template <class S>
std::vector<S> one_after_the_other(const std::vector<reference::MatrixX<S>>& matrices) {
  std::vector<S> entries;
  for (const reference::MatrixX<S>& m : matrices) {
    const std::vector<S> more = row_by_row(m);
    entries.insert(entries.end(), more.begin(), more.end());
  }
  return entries;
}

template <class S>
std::vector<S> loop_motion_entries(const reference::Robot<S>& robot, const Arguments<S>& a) {
  const reference::MatrixX<S> G = reference::loop_motion(robot, a.q);
  return one_after_the_other<S>({G * a.qd, G * a.qdd + reference::loop_drift(robot, a.q, a.qd)});
}

template <class S>
std::vector<S> torque_derivative_entries(const reference::Robot<S>& robot, const Arguments<S>& a) {
  const auto d = reference::inverse_dynamics_derivatives(robot, a.q, a.qd, a.qdd);
  return one_after_the_other<S>({d.dq, d.dqd});
}

template <class S>
std::vector<S> acceleration_derivative_entries(const reference::Robot<S>& robot, const Arguments<S>& a) {
  const auto d = reference::forward_dynamics_derivatives(robot, a.q, a.qd, a.tau);
  return one_after_the_other<S>({d.dq, d.dqd, d.dtau});
}

template <class S>
const std::map<std::string, Evaluation<S>>& reference_table() {
  using R = reference::Robot<S>;
  using A = Arguments<S>;
  namespace ref = reference;
  static const std::map<std::string, Evaluation<S>> table = {
      {"inverse_dynamics",
       [](const R& r, const A& a) { return row_by_row(ref::inverse_dynamics(r, a.q, a.qd, a.qdd)); }},
      {"inverse_dynamics_tip_force",
       [](const R& r, const A& a) { return row_by_row(ref::inverse_dynamics(r, a.q, a.qd, a.qdd, a.h_e)); }},
      {"inertia_matrix", [](const R& r, const A& a) { return row_by_row(ref::inertia_matrix(r, a.q)); }},
      {"christoffel", [](const R& r, const A& a) { return row_by_row(ref::christoffel(r, a.q)); }},
      {"coriolis_matrix", [](const R& r, const A& a) { return row_by_row(ref::coriolis_matrix(r, a.q, a.qd)); }},
      {"gravity", [](const R& r, const A& a) { return row_by_row(ref::gravity(r, a.q)); }},
      {"bias", [](const R& r, const A& a) { return row_by_row(ref::bias(r, a.q, a.qd)); }},
      {"forward_dynamics",
       [](const R& r, const A& a) { return row_by_row(ref::forward_dynamics(r, a.q, a.qd, a.tau)); }},
      {"inverse_dynamics_derivatives", torque_derivative_entries<S>},
      {"forward_dynamics_derivatives", acceleration_derivative_entries<S>},
      {"operational_inertia", [](const R& r, const A& a) { return operational_inertia_entries<S>(r, a.q, a.task); }},
      {"operational_bias", [](const R& r, const A& a) { return operational_bias_entries<S>(r, a.q, a.qd, a.task); }},
      {"null_space_torque",
       [](const R& r, const A& a) {
         return row_by_row(ref::null_space_torque(r, a.q, a.tau, reference_task<S>(a.task)));
       }},
      {"kinetic_energy", [](const R& r, const A& a) { return std::vector<S>{ref::kinetic_energy(r, a.q, a.qd)}; }},
      {"potential_energy", [](const R& r, const A& a) { return std::vector<S>{ref::potential_energy(r, a.q)}; }},
      {"forward_kinematics", pose_entries<S>},
      {"jacobian", [](const R& r, const A& a) { return row_by_row(ref::jacobian(r, a.q)); }},
      {"jacobian_dot_qd", [](const R& r, const A& a) { return row_by_row(ref::jacobian_dot_qd(r, a.q, a.qd)); }},
      {"loop_closure", [](const R& r, const A& a) { return row_by_row(ref::loop_closure(r, a.q)); }},
      {"loop_jacobian", [](const R& r, const A& a) { return row_by_row(ref::loop_jacobian(r, a.q)); }},
      {"loop_step", [](const R& r, const A& a) { return row_by_row(ref::loop_step(r, a.q)); }},
      {"loop_motion", loop_motion_entries<S>},
  };
  return table;
}

using MagnitudeRobot = reference::Robot<double>;
using MagnitudeArguments = Arguments<double>;

std::vector<double> absolute(std::vector<double> values) {
  for (double& v : values) v = std::abs(v);
  return values;
}

reference::MatrixX<double> absolute_inverse(const MagnitudeRobot& r, const MagnitudeArguments& a) {
  return reference::inertia_matrix(r, a.q).inverse().cwiseAbs();
}

// The magnitude for q̈ = B⁻¹ (τ - n): the effect of an error as large as the terms of B q̈ + n - τ.
reference::VectorX<double> acceleration_magnitude(const MagnitudeRobot& r, const MagnitudeArguments& a) {
  const auto zero = reference::VectorX<double>::Zero(r.size());
  const reference::VectorX<double> qdd = reference::forward_dynamics(r, a.q, a.qd, a.tau).cwiseAbs();
  const reference::VectorX<double> terms =
      reference::torque_magnitude(r, a.q, a.qd, zero) + a.tau.cwiseAbs() + reference::inertia_magnitude(r, a.q) * qdd;
  return absolute_inverse(r, a) * terms;
}

std::vector<double> torque_derivative_magnitude(const MagnitudeRobot& r, const MagnitudeArguments& a) {
  return one_after_the_other<double>({reference::position_derivative_magnitude(r, a.q, a.qd, a.qdd),
                                      reference::rate_derivative_magnitude(r, a.q, a.qd)});
}

// The magnitude for ∂q̈ = -B⁻¹ ∂(B q̈ + n): the effect of an error as large as the terms of B ∂q̈ + ∂(B q̈ + n),
// including that of q̈ itself.
std::vector<double> acceleration_derivative_magnitude(const MagnitudeRobot& r, const MagnitudeArguments& a) {
  using Matrix = reference::MatrixX<double>;
  const Matrix inverse = absolute_inverse(r, a), inertia = reference::inertia_magnitude(r, a.q);
  const auto d = reference::forward_dynamics_derivatives(r, a.q, a.qd, a.tau);
  const Matrix by_q = reference::position_derivative_magnitude(r, a.q, a.qd, acceleration_magnitude(r, a));
  const Matrix by_qd = reference::rate_derivative_magnitude(r, a.q, a.qd);
  return one_after_the_other<double>({inverse * (by_q + inertia * d.dq.cwiseAbs()),
                                      inverse * (by_qd + inertia * d.dqd.cwiseAbs()),
                                      inverse * inertia * d.dtau.cwiseAbs()});
}

// T = ½ q̇ᵀ B q̇ with magnitudes.
std::vector<double> kinetic_magnitude(const MagnitudeRobot& r, const MagnitudeArguments& a) {
  const reference::VectorX<double> rate = a.qd.cwiseAbs();
  return {0.5 * rate.dot(reference::inertia_magnitude(r, a.q) * rate)};
}

// Entries of rotations have magnitude 1; positions and moment arms have that of the path to the tip.
std::vector<double> pose_magnitude(const MagnitudeRobot& r, const MagnitudeArguments& a) {
  std::vector<double> entries(9, 1.0);
  entries.insert(entries.end(), 3, reference::reach(r, a.q));
  return entries;
}

std::vector<double> jacobian_magnitude(const MagnitudeRobot& r, const MagnitudeArguments& a) {
  return row_by_row(reference::jacobian_magnitude(r, a.q));
}

std::vector<double> tip_acceleration(const MagnitudeRobot& r, const MagnitudeArguments& a) {
  const Eigen::Vector2d m = reference::tip_acceleration_magnitude(r, a.q, a.qd);
  return {m[0], m[0], m[0], m[1], m[1], m[1]};
}

std::vector<double> loop_motion_magnitude(const MagnitudeRobot& r, const MagnitudeArguments& a) {
  return one_after_the_other<double>(
      {reference::loop_motion_magnitude(r, a.q) * a.qd.cwiseAbs(),
       reference::loop_motion_magnitude(r, a.q) * a.qdd.cwiseAbs() + reference::loop_drift_magnitude(r, a.q, a.qd)});
}

const std::map<std::string, Evaluation<double>>& magnitude_table() {
  using R = MagnitudeRobot;
  using A = MagnitudeArguments;
  namespace ref = reference;
  static const std::map<std::string, Evaluation<double>> table = {
      {"inverse_dynamics",
       [](const R& r, const A& a) { return row_by_row(ref::torque_magnitude(r, a.q, a.qd, a.qdd)); }},
      {"inverse_dynamics_tip_force",
       [](const R& r, const A& a) {
         const ref::MagnitudeOptions tip{.f_e = a.h_e.f_e.norm(), .mu_e = a.h_e.mu_e.norm()};
         return row_by_row(ref::torque_magnitude(r, a.q, a.qd, a.qdd, tip));
       }},
      {"inertia_matrix", [](const R& r, const A& a) { return row_by_row(ref::inertia_magnitude(r, a.q)); }},
      {"christoffel", [](const R& r, const A& a) { return row_by_row(ref::christoffel_magnitude(r, a.q)); }},
      {"coriolis_matrix", [](const R& r, const A& a) { return row_by_row(ref::coriolis_magnitude(r, a.q, a.qd)); }},
      {"gravity",
       [](const R& r, const A& a) {
         const ref::VectorX<double> zero = ref::VectorX<double>::Zero(r.size());
         return row_by_row(ref::torque_magnitude(r, a.q, zero, zero));
       }},
      {"bias",
       [](const R& r, const A& a) {
         const ref::VectorX<double> zero = ref::VectorX<double>::Zero(r.size());
         return row_by_row(ref::torque_magnitude(r, a.q, a.qd, zero));
       }},
      {"forward_dynamics", [](const R& r, const A& a) { return row_by_row(acceleration_magnitude(r, a)); }},
      {"inverse_dynamics_derivatives", torque_derivative_magnitude},
      {"forward_dynamics_derivatives", acceleration_derivative_magnitude},
      {"operational_inertia", [](const R& r, const A& a) { return OperationalMagnitude(r, a.q, a.task).inertia(); }},
      {"operational_bias", [](const R& r, const A& a) { return OperationalMagnitude(r, a.q, a.task).bias(a.qd); }},
      {"null_space_torque",
       [](const R& r, const A& a) { return OperationalMagnitude(r, a.q, a.task).null_space(a.tau); }},
      {"kinetic_energy", kinetic_magnitude},
      {"potential_energy",
       [](const R& r, const A& a) { return std::vector<double>{ref::potential_magnitude(r, a.q)}; }},
      {"forward_kinematics", pose_magnitude},
      {"jacobian", jacobian_magnitude},
      {"jacobian_dot_qd", tip_acceleration},
      {"loop_closure", [](const R& r, const A& a) { return row_by_row(ref::loop_closure_magnitude(r, a.q)); }},
      {"loop_jacobian", [](const R& r, const A& a) { return row_by_row(ref::loop_jacobian_magnitude(r, a.q)); }},
      {"loop_step", [](const R& r, const A& a) { return row_by_row(ref::loop_step_magnitude(r, a.q)); }},
      {"loop_motion", loop_motion_magnitude},
  };
  return table;
}

}  // namespace

template <class S>
std::optional<std::vector<S>> GraphEvaluator<S>::operator()(const StateOf<S>& state) {
  CachedArithmetic<S> arithmetic(state, constants_);
  const std::vector<S> all = evaluate(function_, arithmetic);
  const auto value = [&all](NodeId id) { return all[static_cast<std::size_t>(id)]; };
  for (const NodeId id : function_.validity_conditions) {
    if (!(value(id) > 0)) return std::nullopt;
  }
  std::vector<S> result;
  for (const Output& output : function_.outputs) {
    for (const NodeId id : output.entries) result.push_back(value(id));
  }
  return result;
}

template <class S>
std::vector<S> reference_values(const Function& function, const reference::Robot<S>& robot, const StateOf<S>& state) {
  return reference_table<S>().at(stem_of(function))(robot, Arguments<S>(state, function));
}

std::vector<double> magnitudes(const Function& function, const reference::Robot<double>& robot, const State& state) {
  return absolute(magnitude_table().at(stem_of(function))(robot, Arguments<double>(state, function)));
}

template class GraphEvaluator<double>;
template class GraphEvaluator<Real50>;
template std::vector<float> reference_values(const Function&, const reference::Robot<float>&, const StateOf<float>&);
template std::vector<double> reference_values(const Function&, const reference::Robot<double>&, const StateOf<double>&);
template std::vector<Real50> reference_values(const Function&, const reference::Robot<Real50>&, const StateOf<Real50>&);

}  // namespace flatdyn
