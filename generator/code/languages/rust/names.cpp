// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/rust/names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "code/emit/writer.hpp"
#include "robot/model/identifiers.hpp"

namespace flatdyn {
namespace {

// The value of \uxxxx, whose backslash is at this place.
unsigned unit_at(const std::string& text, std::size_t at) {
  return static_cast<unsigned>(std::stoul(text.substr(at + 2, 4), nullptr, 16));
}

}  // namespace

std::vector<std::string> rust_keywords() {
  return {"abstract", "as",   "async", "await", "become", "box",    "crate",   "dyn", "final",    "fn",   "gen", "impl",
          "in",       "let",  "loop",  "macro", "match",  "mod",    "move",    "mut", "override", "priv", "pub", "ref",
          "self",     "Self", "super", "trait", "type",   "unsafe", "unsized", "use", "where",    "yield"};
}

std::string crate_name(const std::string& file_name) {
  std::string name = cpp_identifier(file_name);
  const std::vector<std::string> keywords = rust_keywords();
  const bool is_keyword = std::find(keywords.begin(), keywords.end(), name) != keywords.end();
  const bool is_known = name == "core" || name == "std" || name == "alloc" || name == "test" || name == "proc_macro";
  return is_keyword || is_known ? name + "_" : name;
}

// JSON's escapes are those of Rust, but for characters by their number.
std::string rust_string(const std::string& text) {
  const std::string json = javascript_string(text);
  std::string result;
  for (std::size_t at = 0; at < json.size(); ++at) {
    if (json[at] != '\\') {
      result += json[at];
      continue;
    }
    const char kind = json[at + 1];
    if (kind == 'b' || kind == 'f') {
      result += fmt::format("\\u{{{:x}}}", kind == 'b' ? 8 : 12);
      ++at;
    } else if (kind == 'u') {
      unsigned code = unit_at(json, at);
      at += 5;
      const bool is_first_of_two = code >= 0xD800 && code < 0xDC00;
      if (is_first_of_two) {
        code = 0x10000 + ((code - 0xD800) << 10U) + (unit_at(json, at + 1) - 0xDC00);
        at += 6;
      }
      result += fmt::format("\\u{{{:x}}}", code);
    } else {
      result += {'\\', kind};
      ++at;
    }
  }
  return result;
}

}  // namespace flatdyn
