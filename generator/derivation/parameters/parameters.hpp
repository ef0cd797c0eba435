// SPDX-License-Identifier: GPL-2.0-or-later
// The dynamic parameters in which the model is linear, (7.77): thirteen per joint, joint after joint in the order of q;
// before them, ten of the link of a floating base. The vector π has thirteen places for every body of the mechanism, of
// which those of a floating base's motion are not used.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robot/model/mechanism.hpp"

namespace flatdyn {

// The first ten are those of body i, the augmented link i (including the rotors that it carries), in its canonical
// frame, about that frame's origin; then I_m of the rotor that drives joint i, whichever body carries it, and the
// friction of joint i. If the file gives an armature instead of a motor, I_m is the armature, a rotor with k_r = 1
// whose spin does not couple with its carrier.
enum class Parameter : std::uint8_t { m, mlx, mly, mlz, Ixx, Ixy, Ixz, Iyy, Iyz, Izz, Im, Fv, Fs };
inline constexpr int kInertialPerBody = 10;
inline constexpr int kParametersPerJoint = 13;

// The index in π of a parameter of joint i.
constexpr int index_of(int i, Parameter parameter) { return kParametersPerJoint * i + static_cast<int>(parameter); }
constexpr int joint_of(int index) { return index / kParametersPerJoint; }
constexpr Parameter parameter_of(int index) { return static_cast<Parameter>(index % kParametersPerJoint); }

// The name of a parameter by its index in π: "m2", "m2lx", "I2xy", "Im2", "Fv2", "Fs2"; joints are counted from 1, and
// a floating base is 0.
std::string parameter_name(int index, int base_bodies = 0);

// The indices in π of the parameters that the mechanism has, in order: ten of a floating base's link, 13 per joint. The
// last three of a spherical joint are F_v of its three bodies: viscous friction about its x, y and z.
std::vector<int> parameter_indices(const Mechanism& mechanism);

// A body with one parameter equal to `value` and the others 0; `parameter` is one of the first ten.
InertialParameters single_parameter(Parameter parameter, const Number& value = 1);
// The first ten of (7.77).
std::vector<Number> entries_of(const InertialParameters& body);

// π of the mechanism, 13 numbers per body. Throws Failure(unsupported) for a joint with both a motor and an armature:
// their effects differ, and π has one place for them.
std::vector<Number> dynamic_parameters(const Mechanism& mechanism);

// The subset of its parameters that the model has.
enum class ParameterSet : std::uint8_t {
  inertial,  // ten of every link
  given,     // these, and I_m, F_v, F_s of the joints for which the file gives them
  full,      // all
  nonzero,   // those that are not zero in the file
};
// By index in π: whether the parameter is in the set.
std::vector<bool> parameters_in(const Mechanism& mechanism, ParameterSet set);

// The same mechanism with a rotor, viscous and Coulomb friction at exactly the joints where `set` has them; missing
// ones are set to 1. Its regressor with the given parameters is that of `mechanism` with the parameters of `set`.
Mechanism with_parameter_set(const Mechanism& mechanism, ParameterSet set);

}  // namespace flatdyn
