// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/utf8.hpp"

#include <array>
#include <cstdint>

namespace flatdyn {

namespace {

// The number of bytes that a first byte announces; 0 if it is none.
std::size_t length_of(unsigned char first) {
  if (first < 0x80U) return 1;
  if (first < 0xC2U) return 0;  // goes on with another byte, or says in two bytes what one can
  if (first < 0xE0U) return 2;
  if (first < 0xF0U) return 3;
  return first < 0xF5U ? 4 : 0;
}

// The code point of a character of `length` bytes; nothing lower may be written in so many.
bool is_character(std::string_view bytes) {
  constexpr std::array<std::uint32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};
  std::uint32_t code = static_cast<unsigned char>(bytes[0]);
  if (bytes.size() > 1) code &= 0x7FU >> bytes.size();
  for (const char c : bytes.substr(1)) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0U) != 0x80U) return false;
    code = (code << 6U) | (byte & 0x3FU);
  }
  const bool is_surrogate = code >= 0xD800 && code <= 0xDFFF;
  return code >= kLeast[bytes.size()] && code <= 0x10FFFF && !is_surrogate;
}

}  // namespace

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = length_of(static_cast<unsigned char>(text[0]));
    if (length == 0 || length > text.size() || !is_character(text.substr(0, length))) return false;
    text.remove_prefix(length);
  }
  return true;
}

}  // namespace flatdyn
