// SPDX-License-Identifier: GPL-2.0-or-later
// The C++ namespace of a header, and its include guard.
#pragma once

#include <string>
#include <vector>

namespace flatdyn {

// The parts of a namespace: "a::b" → {"a", "b"}.
std::vector<std::string> parts_of_namespace(const std::string& name);

// The wanted namespace, or one made from the robot's name. Throws Failure(usage) if `wanted` is not a namespace.
std::string namespace_of(const std::string& robot, const std::string& wanted);

// The include guard: "a::b", "HPP" → "FLATDYN_A_B_HPP_0C1D2E3F". The digits are a hash of the namespace, as a_b or A::B
// have the same letters, and of the sources of the header, so that two different headers with one namespace collide at
// compile time instead of hiding each other.
std::string guard_of(const std::string& name_space, const std::string& ending, const std::vector<std::string>& origin);

// The text in capital letters, ASCII only, in any locale.
std::string in_capitals(std::string text);

}  // namespace flatdyn
