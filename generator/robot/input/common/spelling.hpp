// SPDX-License-Identifier: GPL-2.0-or-later
// Names of elements and attributes as people write them: in other letters, with a prefix, of several words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace flatdyn {

// Without a namespace prefix and in small letters: "x:Origin" is "origin".
std::string folded_name(std::string_view name);

// Whether the name is one of another program's: "drake:gear_ratio".
inline bool has_namespace(std::string_view name) { return name.find(':') != std::string_view::npos; }

// The words of a name, in small letters: "mechanicalReduction" and "mechanical_reduction" are "mechanical",
// "reduction".
std::vector<std::string> words_of_name(std::string_view name);

// The same without what separates words: "mimicjoint".
std::string joined_name(std::string_view name);

// The name among `known` that is this one but for case, prefix and what separates words; "" if there is none, or if it
// is that very name.
std::string known_spelling_of(std::string_view name, const std::vector<std::string>& known);

// Whether the name says that something changes how a robot moves: spring, joint_dynamics, rotor. Sensors and
// controllers of such things do not.
bool is_dynamics_name(std::string_view name);

// Whether elements of this name are forces or constraints in Drake's words: force_element,
// drake:linear_bushing_rpy, drake:joint.
bool is_force_or_constraint_name(std::string_view name);

// Whether it is about the inertia or the gear of a motor.
bool is_rotor_name(std::string_view name);

}  // namespace flatdyn
