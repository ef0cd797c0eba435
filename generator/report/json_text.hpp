// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace flatdyn {

// The version of the JSON outputs. It rises when a key of any output is renamed, removed or changes its meaning; new
// keys do not change it. docs/json.md lists the keys.
inline constexpr int kJsonVersion = 1;

// The object as text for printing and writing: with its version first, indented, the last line ended.
std::string json_text(const nlohmann::ordered_json& object);

}  // namespace flatdyn
