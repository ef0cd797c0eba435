// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/parameters/parameters.hpp"

#include "base/diagnostics/diagnostics.hpp"
#include "robot/model/spherical_joint.hpp"

namespace flatdyn {
namespace {

// The row and column of a moment of inertia, by its place in (7.77).
struct InertiaPlace {
  std::size_t row, col;
};
constexpr InertiaPlace kInertiaPlaces[] = {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}};
constexpr int kFirstInertia = static_cast<int>(Parameter::Ixx);

Number driving_inertia(const Body& body) {
  if (!body.rotor) return body.armature;
  if (!vanishes(body.armature)) {
    throw Failure(FailureKind::unsupported, "joint \"" + body.joint + "\" has both a motor and an armature",
                  "give its rotor's inertia once: a regressor has one column for it");
  }
  return body.rotor->inertia;
}

}  // namespace

std::string parameter_name(int index, int base_bodies) {
  static const char* const kNames[] = {"m#",   "m#lx", "m#ly", "m#lz", "I#xx", "I#xy", "I#xz",
                                       "I#yy", "I#yz", "I#zz", "Im#",  "Fv#",  "Fs#"};
  std::string name = kNames[static_cast<std::size_t>(parameter_of(index))];
  return name.replace(name.find('#'), 1, std::to_string(joint_of(index) + 1 - base_bodies));
}

std::vector<int> parameter_indices(const Mechanism& mechanism) {
  std::vector<int> indices;
  const int joints = mechanism.base_bodies();
  for (int k = 0; joints > 0 && k < kInertialPerBody; ++k) {
    indices.push_back(index_of(joints - 1, static_cast<Parameter>(k)));
  }
  for (int i = joints; i < mechanism.body_count(); ++i) {
    const bool is_spherical = mechanism.is_of_spherical(i);
    if (is_spherical && is_inside_joint(mechanism.bodies[static_cast<std::size_t>(i)])) continue;
    const bool is_tendon = mechanism.bodies[static_cast<std::size_t>(i)].is_tendon;
    for (int k = is_tendon ? kInertialPerBody : 0; k < (is_spherical ? kInertialPerBody : kParametersPerJoint); ++k) {
      indices.push_back(index_of(i, static_cast<Parameter>(k)));
    }
    for (int j = first_body_of_joint(mechanism, i); is_spherical && j <= i; ++j) {
      indices.push_back(index_of(j, Parameter::Fv));
    }
  }
  return indices;
}

InertialParameters single_parameter(Parameter parameter, const Number& value) {
  InertialParameters body;
  const int k = static_cast<int>(parameter);
  if (k == 0) {
    body.mass = value;
  } else if (k < kFirstInertia) {
    body.first_moment[static_cast<std::size_t>(k - 1)] = value;
  } else {
    const auto [row, col] = kInertiaPlaces[k - kFirstInertia];
    body.inertia[row][col] = body.inertia[col][row] = value;
  }
  return body;
}

std::vector<Number> entries_of(const InertialParameters& body) {
  std::vector<Number> entries = {body.mass, body.first_moment[0], body.first_moment[1], body.first_moment[2]};
  for (const auto& [row, col] : kInertiaPlaces) entries.push_back(body.inertia[row][col]);
  return entries;
}

std::vector<Number> dynamic_parameters(const Mechanism& mechanism) {
  std::vector<Number> parameters;
  for (int i = 0; i < mechanism.body_count(); ++i) {
    const Body& body = mechanism.bodies[static_cast<std::size_t>(i)];
    const bool is_of_joint = !mechanism.is_of_base(i);
    for (const Number& entry : entries_of(body.inertia)) parameters.push_back(entry);
    parameters.push_back(is_of_joint ? driving_inertia(body) : Number(0));
    parameters.push_back(is_of_joint ? body.viscous : Number(0));
    parameters.push_back(is_of_joint ? body.coulomb : Number(0));
  }
  return parameters;
}

std::vector<bool> parameters_in(const Mechanism& mechanism, ParameterSet set) {
  const std::vector<Number> values = dynamic_parameters(mechanism);
  std::vector<bool> present(values.size(), false);
  for (const int k : parameter_indices(mechanism)) {
    const Body& body = mechanism.bodies[static_cast<std::size_t>(joint_of(k))];
    const bool inertial = static_cast<int>(parameter_of(k)) < kInertialPerBody;
    const bool nonzero = !vanishes(values[static_cast<std::size_t>(k)]);
    const bool given = nonzero || (parameter_of(k) == Parameter::Im && body.rotor);
    present[static_cast<std::size_t>(k)] = set == ParameterSet::full ||
                                           (set == ParameterSet::nonzero ? nonzero : inertial) ||
                                           (set == ParameterSet::given && given);
  }
  return present;
}

Mechanism with_parameter_set(const Mechanism& mechanism, ParameterSet set) {
  const std::vector<bool> present = parameters_in(mechanism, set);
  const std::vector<Number> values = dynamic_parameters(mechanism);
  Mechanism changed = mechanism;
  for (int i = 0; i < mechanism.body_count(); ++i) {
    Body& body = changed.bodies[static_cast<std::size_t>(i)];
    const auto has = [&](Parameter parameter) { return present[static_cast<std::size_t>(index_of(i, parameter))]; };
    const auto is_zero = [&](Parameter parameter) {
      return vanishes(values[static_cast<std::size_t>(index_of(i, parameter))]);
    };
    if (!has(Parameter::Im)) {
      body.rotor.reset();
      body.armature = 0;
    } else if (!body.rotor && is_zero(Parameter::Im)) {
      body.armature = 1;
    }
    if (!has(Parameter::Fv) || is_zero(Parameter::Fv)) body.viscous = has(Parameter::Fv) ? 1 : 0;
    if (!has(Parameter::Fs) || is_zero(Parameter::Fs)) body.coulomb = has(Parameter::Fs) ? 1 : 0;
  }
  return changed;
}

}  // namespace flatdyn
