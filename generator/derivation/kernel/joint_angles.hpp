// SPDX-License-Identifier: GPL-2.0-or-later
// The positions of the joints, and cosines and sines of their angles, from the coordinates q: q_joint = A q.
#pragma once

#include <string>
#include <vector>

#include "derivation/kernel/derivation.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// The label of body i in names, counted from 1 as in the emitted code: "3" for body 2. Bodies that are the motion of a
// floating base come before those: the base link is "b".
std::string label(int i, int base_bodies = 0);

// The inputs of one kind (q, q̇, q̈, ...) as a vector of `size` entries.
std::vector<Number> inputs(Derivation& derivation, InputKind kind, int size);

// Σ factors[k] values[k].
Number sum_of(const std::vector<Number>& factors, const std::vector<Number>& values);

// The rotation with its entries named c_name, s_name.
PlanarRotation named(Derivation& derivation, const PlanarRotation& rotation, const std::string& name);

// The cosine and sine of a sum of whole multiples of the mechanism's angles (angle_factors), by the addition theorems.
// So only the cosines and sines of these angles, most of them coordinates, have to be evaluated or given.
PlanarRotation rotation_by(const Mechanism& mechanism, Derivation& derivation, const std::vector<Number>& multiples);

// The position of body i's joint, rad or m; 0 for coordinates around the present pose.
Number joint_position(const Mechanism& mechanism, Derivation& derivation, int i);

}  // namespace flatdyn
