// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

namespace flatdyn {

// A name or path as a TOML string, in quotes.
inline std::string toml_string(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

}  // namespace flatdyn
