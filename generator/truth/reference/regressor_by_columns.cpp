// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/reference/regressor_by_columns.hpp"

#include <algorithm>

#include "derivation/parameters/base_parameters.hpp"
#include "truth/reference/magnitude.hpp"
#include "truth/reference/reference_point.hpp"

namespace flatdyn {
namespace {

template <class S>
reference::Robot<S> without_parameters(reference::Robot<S> robot) {
  for (reference::Link<S>& link : robot.links) link.inertials.clear();
  for (reference::Joint<S>& joint : robot.joints) {
    joint.viscous = joint.coulomb = joint.armature = joint.rotor.inertia = joint.stiffness = S(0);
  }
  robot.base_armature = robot.base_viscous = robot.base_coulomb = S(0);
  return robot;
}

// The frame of the written link that body i is named after, in the frame of the body.
const LinkFrame& written_frame(const Mechanism& mechanism, int i) {
  const std::string& link = mechanism.bodies[static_cast<std::size_t>(i)].link;
  return *std::find_if(mechanism.links.begin(), mechanism.links.end(),
                       [&link](const LinkFrame& frame) { return frame.link == link; });
}

// One parameter of body i, as bodies fixed to the written link that joint i moves.
template <class S>
class UnitInertials {
 public:
  UnitInertials(const LinkFrame& frame, const GiNaC::exmap& symbols) {
    for (int row = 0; row < 3; ++row) {
      const auto r = static_cast<std::size_t>(row);
      p_[row] = to_scalar<S>(frame.p[r], symbols);
      for (int col = 0; col < 3; ++col) R_(row, col) = to_scalar<S>(frame.R[r][static_cast<std::size_t>(col)], symbols);
    }
  }

  std::vector<reference::Inertial<S>> operator()(Parameter parameter) const {
    const InertialParameters unit = single_parameter(parameter);
    if (parameter == Parameter::m) return {mass_at(S(1), Vector::Zero())};
    const int first_moment = static_cast<int>(parameter) - static_cast<int>(Parameter::mlx);
    if (first_moment < 3) {
      const Vector arm = Vector::Unit(first_moment);
      return {mass_at(S(1) / S(2), arm), mass_at(S(-1) / S(2), -arm)};
    }
    Matrix I;
    for (int k = 0; k < 9; ++k) {
      I(k / 3, k % 3) =
          to_scalar<S>(unit.inertia[static_cast<std::size_t>(k / 3)][static_cast<std::size_t>(k % 3)], {});
    }
    return {{S(0), Vector::Zero(), R_.transpose() * I * R_}};
  }

 private:
  using Vector = reference::Vector3<S>;
  using Matrix = reference::Matrix3<S>;

  reference::Inertial<S> mass_at(const S& mass, const Vector& place) const {
    return {mass, R_.transpose() * (place - p_), Matrix::Zero()};
  }

  Matrix R_;
  Vector p_;
};

template <class S>
reference::Joint<S>& joint_of_body(reference::Robot<S>& robot, int i) {
  return *std::find_if(robot.joints.begin(), robot.joints.end(), [i](const reference::Joint<S>& each) {
    return each.index <= i && i < each.index + each.size();
  });
}

// A matrix with two columns for each unit.
template <class S, class Columns>
reference::MatrixX<S> two_by_two(const std::vector<std::array<reference::Robot<S>, 2>>& units, const Columns& columns) {
  reference::MatrixX<S> result;
  for (std::size_t k = 0; k < units.size(); ++k) {
    const std::array<reference::VectorX<S>, 2> pair = columns(units[k]);
    if (k == 0) result.resize(pair[0].size(), static_cast<Eigen::Index>(2 * units.size()));
    for (std::size_t j = 0; j < 2; ++j) result.col(static_cast<Eigen::Index>(2 * k + j)) = pair[j];
  }
  return result;
}

template <class S>
reference::Robot<S> unit_robot(const Mechanism& mechanism, reference::Robot<S> robot, const GiNaC::exmap& symbols,
                               int index) {
  const int i = joint_of(index);
  if (mechanism.is_of_base(i)) {
    robot.links[static_cast<std::size_t>(robot.root)].inertials =
        UnitInertials<S>(written_frame(mechanism, i), symbols)(parameter_of(index));
    return robot;
  }
  reference::Joint<S>& joint = joint_of_body(robot, i);
  switch (parameter_of(index)) {
    case Parameter::Im:
      (mechanism.bodies[static_cast<std::size_t>(i)].rotor ? joint.rotor.inertia : joint.armature) = S(1);
      break;
    case Parameter::Fv:
      joint.viscous = S(1);
      break;
    case Parameter::Fs:
      joint.coulomb = S(1);
      break;
    default:
      robot.links[static_cast<std::size_t>(joint.child)].inertials =
          UnitInertials<S>(written_frame(mechanism, i), symbols)(parameter_of(index));
  }
  return robot;
}

// The bracket of two motions of rigid bodies: (ω × v_r - ω_r × v, ω × ω_r) of a floating base, ω × ω_r of a spherical
// joint, 0 else. C(v) v_r - C(v_r) v is B times it. `sign` 1: the sum of the terms' magnitudes for magnitudes.
template <class S>
reference::VectorX<S> bracket(const reference::Robot<S>& robot, const reference::VectorX<S>& v,
                              const reference::VectorX<S>& v_r, int sign) {
  reference::VectorX<S> result = reference::VectorX<S>::Zero(v.size());
  const auto product = [sign](const auto& a, const auto& b) {
    const reference::Vector3<S> less(a[2] * b[1], a[0] * b[2], a[1] * b[0]);
    return reference::Vector3<S>(reference::Vector3<S>(a[1] * b[2], a[2] * b[0], a[0] * b[1]) + S(sign) * less);
  };
  const auto add_turn = [&](Eigen::Index first) {
    result.template segment<3>(first) = product(v.template segment<3>(first), v_r.template segment<3>(first));
  };
  if (robot.floating_base) {
    result.template head<3>() = product(v.template segment<3>(3), v_r.template head<3>()) +
                                S(sign) * product(v_r.template segment<3>(3), v.template head<3>());
    add_turn(3);
  }
  for (const reference::Joint<S>& joint : robot.joints) {
    if (joint.size() == 3) add_turn(joint.index);
  }
  return result;
}

// B q̈_r + C(q, q̇) q̇_r + g + F_v q̇_r + F_s sgn(q̇_r) from inverse dynamics, by polarisation of the part that is
// quadratic in the rates, which makes C symmetric in them, and half of their bracket. `torque(qd, qdd, gravity,
// friction)`.
template <class S, class Torque>
reference::VectorX<S> adaptive(const Torque& torque, const reference::VectorX<S>& qd, const reference::VectorX<S>& qd_r,
                               const reference::VectorX<S>& qdd_r, const reference::VectorX<S>& bracket) {
  const reference::VectorX<S> zero = reference::VectorX<S>::Zero(qd.size());
  const auto velocity_torque = [&](const reference::VectorX<S>& rates) { return torque(rates, zero, false, false); };
  const reference::VectorX<S> mixed = velocity_torque(qd + qd_r) - velocity_torque(qd) - velocity_torque(qd_r);
  const reference::VectorX<S> friction = torque(qd_r, zero, false, true) - velocity_torque(qd_r);
  return torque(zero, qdd_r + bracket / S(2), true, false) + mixed / S(2) + friction;
}

template <class S>
reference::VectorX<S> adaptive_column(const reference::Robot<S>& robot, const StateOf<S>& state) {
  using Vector = reference::VectorX<S>;
  const Vector q = vector_of(state.q);
  const auto torque = [&](const Vector& qd, const Vector& qdd, bool gravity, bool friction) -> Vector {
    return reference::inverse_dynamics(robot, q, qd, qdd, {.gravity = gravity, .friction = friction});
  };
  const Vector qd = vector_of(state.qd), qd_r = vector_of(state.qd_r);
  return adaptive<S>(torque, qd, qd_r, vector_of(state.qdd_r), bracket<S>(robot, qd, qd_r, -1));
}

GiNaC::exmap values_of(const std::vector<FreeSymbol>& symbols, const SymbolValues& values) {
  GiNaC::exmap map;
  for (std::size_t k = 0; k < symbols.size(); ++k) map[symbols[k].symbol] = values[k];
  return map;
}

// column(robot, state) with gravity and spherical joints as at the state.
template <class S, class Column>
reference::VectorX<S> column_at(const reference::Robot<S>& robot, const StateOf<S>& state, const Column& column) {
  if (!has_base_gravity(robot) && !reference::has_spherical_joints(robot)) return column(robot, state);
  reference::Robot<S> turned = has_base_gravity(robot) ? with_base_gravity(robot, state) : robot;
  if (!reference::has_spherical_joints(robot)) return column(turned, state);
  const StateOf<S> rest = without_quaternions(turned, state);
  return column(turned, rest);
}

// A matrix with a column for each robot, with gravity and spherical joints as at the state.
template <class S, class Column>
reference::MatrixX<S> by_columns(const std::vector<reference::Robot<S>>& robots, const StateOf<S>& state,
                                 const Column& column) {
  reference::MatrixX<S> result;
  for (std::size_t k = 0; k < robots.size(); ++k) {
    const reference::VectorX<S> entries = column_at(robots[k], state, column);
    if (k == 0) result.resize(entries.size(), static_cast<Eigen::Index>(robots.size()));
    result.col(static_cast<Eigen::Index>(k)) = entries;
  }
  return result;
}

reference::VectorX<double> adaptive_magnitude(const reference::Robot<double>& robot, const State& state) {
  using Vector = reference::VectorX<double>;
  const Vector q = vector_of(state.q);
  const auto torque = [&](const Vector& qd, const Vector& qdd, bool gravity, bool friction) -> Vector {
    return reference::torque_magnitude(robot, q, qd, qdd, {.gravity = gravity, .friction = friction});
  };
  const auto size = [](const std::vector<double>& v) { return Vector(vector_of(v).cwiseAbs()); };
  const Vector qd = size(state.qd), qd_r = size(state.qd_r);
  return adaptive<double>(torque, qd, qd_r, size(state.qdd_r), bracket<double>(robot, qd, qd_r, 1)).cwiseAbs();
}

}  // namespace

template <class S>
BaseValues<S> base_values_of(const Mechanism& mechanism, const SymbolValues& symbols) {
  using std::abs;
  const GiNaC::exmap values = values_of(mechanism.symbols, symbols);
  const std::vector<Number> pi = dynamic_parameters(mechanism);
  BaseValues<S> result;
  for (const ParameterForm& form : base_parameters(mechanism).combination) {
    S sum(0), size(0);
    for (const auto& [index, coefficient] : form) {
      const S term = to_scalar<S>(coefficient, values) * to_scalar<S>(pi[static_cast<std::size_t>(index)], values);
      sum += term;
      size += abs(term);
    }
    result.values.push_back(sum);
    result.magnitudes.push_back(size);
  }
  return result;
}

template <class S>
RegressorReference<S>::RegressorReference(const Mechanism& mechanism, const reference::Robot<S>& robot,
                                          const SymbolValues& symbols, RegressorColumns columns) {
  const GiNaC::exmap values = values_of(mechanism.symbols, symbols);
  indices_ = columns == RegressorColumns::base ? base_parameters(mechanism).columns : parameter_indices(mechanism);
  const reference::Robot<S> empty = without_parameters(robot);
  for (const int index : indices_) {
    units_.push_back(unit_robot(mechanism, empty, values, index));
    const bool has_one_row = parameter_of(index) == Parameter::Fv && mechanism.is_of_spherical(joint_of(index));
    only_rows_.push_back(has_one_row ? joint_of(index) : -1);
  }
}

template <class S>
reference::MatrixX<S> RegressorReference<S>::with_own_friction(reference::MatrixX<S> Y) const {
  for (Eigen::Index k = 0; k < Y.cols(); ++k) {
    const int row = only_rows_[static_cast<std::size_t>(k)];
    if (row < 0) continue;
    const S entry = Y(row, k);
    Y.col(k).setZero();
    Y(row, k) = entry;
  }
  return Y;
}

template <class S>
reference::MatrixX<S> RegressorReference<S>::matrix(const StateOf<S>& state) const {
  const reference::VectorX<S> qd = vector_of(state.qd), qdd = vector_of(state.qdd);
  return with_own_friction(by_columns(units_, state, [&](const auto& unit, const auto& at) -> reference::VectorX<S> {
    return reference::inverse_dynamics(unit, vector_of(at.q), qd, qdd);
  }));
}

template <class S>
reference::MatrixX<S> RegressorReference<S>::adaptive_matrix(const StateOf<S>& state) const {
  return with_own_friction(
      by_columns(units_, state, [](const auto& unit, const auto& at) { return adaptive_column(unit, at); }));
}

template <class S>
SpringRegressorReference<S>::SpringRegressorReference(const Mechanism& mechanism, const reference::Robot<S>& robot) {
  for (const int i : mechanism.bodies_on_one_axis()) {
    std::array<reference::Robot<S>, 2> unit = {without_parameters(robot), without_parameters(robot)};
    for (std::size_t k = 0; k < 2; ++k) {
      reference::Joint<S>& joint = joint_of_body(unit[k], i);
      joint.stiffness = S(1);
      joint.spring_q_0 = S(static_cast<int>(k));
    }
    units_.push_back(unit);
  }
}

template <class S>
reference::MatrixX<S> SpringRegressorReference<S>::matrix(const StateOf<S>& state) const {
  const auto still = [](const auto& unit, const auto& at) -> reference::VectorX<S> {
    const reference::VectorX<S> zero = reference::VectorX<S>::Zero(unit.size());
    return reference::inverse_dynamics(unit, vector_of(at.q), zero, zero);
  };
  return two_by_two<S>(units_, [&](const auto& relaxed_at) -> std::array<reference::VectorX<S>, 2> {
    const reference::VectorX<S> at_0 = column_at(relaxed_at[0], state, still);
    return {at_0, column_at(relaxed_at[1], state, still) - at_0};
  });
}

reference::MatrixX<double> magnitudes(const SpringRegressorReference<double>& of, const State& state) {
  const auto still = [](const auto& unit, const auto& at) -> reference::VectorX<double> {
    const reference::VectorX<double> zero = reference::VectorX<double>::Zero(unit.size());
    return reference::torque_magnitude(unit, vector_of(at.q), zero, zero);
  };
  return two_by_two<double>(of.units(), [&](const auto& relaxed_at) -> std::array<reference::VectorX<double>, 2> {
    return {column_at(relaxed_at[0], state, still), column_at(relaxed_at[1], state, still)};
  });
}

reference::MatrixX<double> magnitudes(const RegressorReference<double>& of, const State& state) {
  const auto qd = vector_of(state.qd), qdd = vector_of(state.qdd);
  return of.with_own_friction(by_columns(of.units(), state, [&](const auto& unit, const auto& at) {
    return reference::torque_magnitude(unit, vector_of(at.q), qd, qdd);
  }));
}

reference::MatrixX<double> adaptive_magnitudes(const RegressorReference<double>& of, const State& state) {
  return of.with_own_friction(
      by_columns(of.units(), state, [](const auto& unit, const auto& at) { return adaptive_magnitude(unit, at); }));
}

template class RegressorReference<double>;
template class RegressorReference<Real50>;
template class SpringRegressorReference<double>;
template class SpringRegressorReference<Real50>;
template BaseValues<double> base_values_of(const Mechanism&, const SymbolValues&);
template BaseValues<Real50> base_values_of(const Mechanism&, const SymbolValues&);

}  // namespace flatdyn
