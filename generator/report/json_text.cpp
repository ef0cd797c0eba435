// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/json_text.hpp"

namespace flatdyn {

std::string json_text(const nlohmann::ordered_json& object) {
  nlohmann::ordered_json versioned = {{"json_version", kJsonVersion}};
  versioned.update(object);
  return versioned.dump(2) + "\n";
}

}  // namespace flatdyn
