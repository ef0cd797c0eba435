// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/emit/name_space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "base/diagnostics/diagnostics.hpp"
#include "robot/input/common/content_hash.hpp"
#include "robot/model/identifiers.hpp"

namespace flatdyn {
namespace {

// Names that <cmath> may declare in the global namespace, where they would clash with a robot's namespace; the forms
// for float and long double are added.
constexpr auto kCMath = std::to_array<std::string_view>(
    {"abs",    "acos",     "acosh",   "asin",      "asinh",     "atan",       "atan2",       "atanh",   "cbrt",
     "ceil",   "copysign", "cos",     "cosh",      "div",       "double_t",   "drem",        "erf",     "erfc",
     "exp",    "exp10",    "exp2",    "expm1",     "fabs",      "fdim",       "finite",      "float_t", "floor",
     "fma",    "fmax",     "fmin",    "fmod",      "frexp",     "gamma",      "hypot",       "ilogb",   "isinf",
     "isnan",  "j0",       "j1",      "jn",        "labs",      "ldexp",      "ldiv",        "lgamma",  "llabs",
     "lldiv",  "llrint",   "llround", "log",       "log10",     "log1p",      "log2",        "logb",    "lrint",
     "lround", "modf",     "nan",     "nearbyint", "nextafter", "nexttoward", "pow",         "pow10",   "remainder",
     "remquo", "rint",     "round",   "scalb",     "scalbln",   "scalbn",     "significand", "sin",     "sincos",
     "sinh",   "sqrt",     "tan",     "tanh",      "tgamma",    "trunc",      "y0",          "y1",      "yn"});

bool is_in_cmath(std::string_view word) {
  const auto known = [](std::string_view name) {
    return std::find(kCMath.begin(), kCMath.end(), name) != kCMath.end();
  };
  const bool suffixed = word.size() > 1 && (word.back() == 'f' || word.back() == 'l');
  return known(word) || (suffixed && known(word.substr(0, word.size() - 1)));
}

}  // namespace

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
  if (wanted.empty()) {
    const std::string identifier = cpp_identifier(robot);
    return is_in_cmath(identifier) ? identifier + "_" : identifier;
  }
  const std::vector<std::string> parts = parts_of_namespace(wanted);
  if (is_in_cmath(parts.front())) {
    throw Failure(FailureKind::usage,
                  fmt::format("\"{}\" is no namespace: <cmath> has a function of that name", wanted),
                  fmt::format("\"{}_\", or put it into a namespace of yours", wanted));
  }
  for (const std::string& part : parts) {
    if (part.empty() || cpp_identifier(part) != part || part == "std") {
      throw Failure(FailureKind::usage, fmt::format("\"{}\" is no namespace for the generated code", wanted),
                    "use C++ identifiers joined by ::, such as \"arm\" or \"acme::arm\"");
    }
  }
  return wanted;
}

std::string guard_of(const std::string& name_space, const std::string& ending, const std::vector<std::string>& origin) {
  constexpr std::size_t kDigits = 8;
  std::string guard = "FLATDYN";
  for (const std::string& part : parts_of_namespace(name_space)) guard += "_" + part;
  std::vector<std::string> hashed = {name_space};
  for (const std::string& text : origin) hashed.push_back("\n" + text);
  const std::string hash = content_hash(hashed);  // "sha1:…"
  return in_capitals(guard + "_" + ending + "_" + hash.substr(hash.find(':') + 1, kDigits));
}

std::string in_capitals(std::string text) {
  for (char& c : text) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return text;
}

}  // namespace flatdyn
