// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/name_list.hpp"

#include <fmt/format.h>

#include <sstream>
#include <stdexcept>

#include "base/diagnostics/characters.hpp"

namespace flatdyn {
std::vector<std::string> names_in(const std::string& list) {
  std::vector<std::string> names;
  std::istringstream parts(list + ",");
  for (std::string part; std::getline(parts, part, ',');) {
    names.emplace_back(trimmed(part));
    if (!names.back().empty()) continue;
    throw std::invalid_argument(
        fmt::format("\"{}\" has no name {}; write them as gravity,bias", list,
                    names.size() > 1 ? "behind \"" + names[names.size() - 2] + ",\"" : "at its beginning"));
  }
  return names;
}

}  // namespace flatdyn
