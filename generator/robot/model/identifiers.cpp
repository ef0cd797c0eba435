// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/identifiers.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "base/diagnostics/characters.hpp"
#include "base/diagnostics/utf8.hpp"
#include "robot/model/transliteration.hpp"

namespace flatdyn {

namespace {

// Keywords and alternative tokens up to C++20; then names that cannot be a namespace, are predefined macros, or have a
// meaning in all generated code; then the macros of <cmath>. Each group is sorted for the reader and searched linearly.
constexpr auto kReserved = std::to_array<std::string_view>({
    "alignas",
    "alignof",
    "and",
    "and_eq",
    "asm",
    "auto",
    "bitand",
    "bitor",
    "bool",
    "break",
    "case",
    "catch",
    "char",
    "char16_t",
    "char32_t",
    "char8_t",
    "class",
    "co_await",
    "co_return",
    "co_yield",
    "compl",
    "concept",
    "const",
    "const_cast",
    "consteval",
    "constexpr",
    "constinit",
    "continue",
    "decltype",
    "default",
    "delete",
    "do",
    "double",
    "dynamic_cast",
    "else",
    "enum",
    "explicit",
    "export",
    "extern",
    "false",
    "float",
    "for",
    "friend",
    "goto",
    "if",
    "inline",
    "int",
    "long",
    "mutable",
    "namespace",
    "new",
    "noexcept",
    "not",
    "not_eq",
    "nullptr",
    "operator",
    "or",
    "or_eq",
    "private",
    "protected",
    "public",
    "register",
    "reinterpret_cast",
    "requires",
    "return",
    "short",
    "signed",
    "sizeof",
    "static",
    "static_assert",
    "static_cast",
    "struct",
    "switch",
    "template",
    "this",
    "thread_local",
    "throw",
    "true",
    "try",
    "typedef",
    "typeid",
    "typename",
    "union",
    "unsigned",
    "using",
    "virtual",
    "void",
    "volatile",
    "wchar_t",
    "while",
    "xor",
    "xor_eq",
    //
    "NULL",
    "detail",
    "errno",
    "i386",
    "linux",
    "main",
    "posix",
    "std",
    "unix",
    //
    "DOMAIN",
    "FP_FAST_FMA",
    "FP_FAST_FMAF",
    "FP_FAST_FMAL",
    "FP_ILOGB0",
    "FP_ILOGBNAN",
    "FP_INFINITE",
    "FP_NAN",
    "FP_NORMAL",
    "FP_SUBNORMAL",
    "FP_ZERO",
    "HUGE_VAL",
    "HUGE_VALF",
    "HUGE_VALL",
    "INFINITY",
    "MATH_ERREXCEPT",
    "MATH_ERRNO",
    "MAXFLOAT",
    "M_1_PI",
    "M_2_PI",
    "M_2_SQRTPI",
    "M_E",
    "M_LN10",
    "M_LN2",
    "M_LOG10E",
    "M_LOG2E",
    "M_PI",
    "M_PI_2",
    "M_PI_4",
    "M_SQRT1_2",
    "M_SQRT2",
    "NAN",
    "OVERFLOW",
    "PLOSS",
    "SING",
    "SNAN",
    "TLOSS",
    "UNDERFLOW",
    "X_TLOSS",
    "math_errhandling",
    "signgam",
});

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// A name in ASCII. Robot files are UTF-8; a byte that belongs to no character separates words.
std::string in_ascii(std::string_view name) {
  std::string ascii;
  bool is_last_apart = false;  // the last word needs a separator before whatever follows
  while (!name.empty()) {
    const Utf8Character first = first_character(name);
    const bool is_ascii = first.code && *first.code < 0x80;
    ascii += is_ascii ? std::string(1, name.front()) : first.code ? transliterated(*first.code) : "-";
    is_last_apart = !is_ascii;
    name.remove_prefix(first.length);
  }
  while (is_last_apart && ascii.ends_with('-')) ascii.pop_back();
  return ascii;
}

}  // namespace

bool is_reserved_in_cpp(std::string_view word) {
  return std::find(kReserved.begin(), kReserved.end(), word) != kReserved.end();
}

std::string cpp_identifier(std::string_view name) {
  std::string identifier;
  for (const char c : in_ascii(name)) {
    if (is_letter(c) || is_digit(c)) {
      identifier += c;
    } else if (!identifier.empty() && identifier.back() != '_') {
      identifier += '_';
    }
  }
  if (identifier.empty()) return "unnamed";
  if (is_digit(identifier.front())) identifier.insert(0, "x");
  if (is_reserved_in_cpp(identifier)) identifier += '_';
  return identifier;
}

}  // namespace flatdyn
