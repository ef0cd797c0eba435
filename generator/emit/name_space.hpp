// SPDX-License-Identifier: GPL-2.0-or-later
// The C++ namespace of a header, and its include guard.
#pragma once

#include <string>
#include <vector>

namespace flatdyn {

// "a::b" → {"a", "b"}
std::vector<std::string> parts_of_namespace(const std::string& name);

// What is wanted, or a name made of the robot's. Throws Failure(usage) for what is no namespace.
std::string namespace_of(const std::string& robot, const std::string& wanted);

// "a::b", "HPP" → "FLATDYN_A_B_HPP_0C1D2E3F". The digits are a hash of the namespace, as a_b or A::B have the same
// letters, and of what the header is made from, so that two headers with one namespace meet and do not hide each other.
std::string guard_of(const std::string& name_space, const std::string& ending, const std::vector<std::string>& origin);

// ASCII only, whatever the locale.
std::string in_capitals(std::string text);

}  // namespace flatdyn
