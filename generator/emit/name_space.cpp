// SPDX-License-Identifier: GPL-2.0-or-later
#include "emit/name_space.hpp"

#include <fmt/format.h>

#include "diagnostics/diagnostics.hpp"
#include "emit/identifiers.hpp"

namespace flatdyn {

std::vector<std::string> parts_of_namespace(const std::string& name) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end; (end = name.find("::", begin)) != std::string::npos; begin = end + 2) {
    parts.push_back(name.substr(begin, end - begin));
  }
  parts.push_back(name.substr(begin));
  return parts;
}

std::string namespace_of(const std::string& robot, const std::string& wanted) {
  if (wanted.empty()) return cpp_identifier(robot);
  for (const std::string& part : parts_of_namespace(wanted)) {
    if (part.empty() || cpp_identifier(part) != part || part == "std") {
      throw Failure(ExitCode::usage, fmt::format("\"{}\" is no namespace for the generated code", wanted),
                    "use C++ identifiers joined by ::, such as \"arm\" or \"acme::arm\"");
    }
  }
  return wanted;
}

std::string guard_of(const std::string& name_space) {
  std::string guard = "FLATDYN";
  for (const std::string& part : parts_of_namespace(name_space)) guard += "_" + part;
  for (char& c : guard) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return guard + "_HPP";
}

}  // namespace flatdyn
