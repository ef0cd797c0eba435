// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace flatdyn {

// Raised when a key of any output is renamed, goes away, or means something else; new keys leave it. docs/json.md has
// the keys.
inline constexpr int kJsonVersion = 1;

// The object as it is printed and written: its version first, indented, the last line ended.
inline std::string json_text(const nlohmann::ordered_json& object) {
  nlohmann::ordered_json versioned = {{"json_version", kJsonVersion}};
  versioned.update(object);
  return versioned.dump(2) + "\n";
}

}  // namespace flatdyn
