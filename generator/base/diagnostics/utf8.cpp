// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/diagnostics/utf8.hpp"

#include <array>
#include <boost/locale/encoding_utf.hpp>
#include <cstdint>

namespace flatdyn {

namespace {

// The number of bytes that a first byte announces; 0 if it is not a first byte.
std::size_t length_of(unsigned char first) {
  if (first < 0x80U) return 1;
  if (first < 0xC2U) return 0;  // continuation bytes and overlong forms
  if (first < 0xE0U) return 2;
  if (first < 0xF0U) return 3;
  return first < 0xF5U ? 4 : 0;
}

// The code point of a character of `length` bytes; none for overlong forms.
std::optional<char32_t> code_of(std::string_view bytes) {
  constexpr std::array<std::uint32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};
  std::uint32_t code = static_cast<unsigned char>(bytes[0]);
  if (bytes.size() > 1) code &= 0x7FU >> bytes.size();
  for (const char c : bytes.substr(1)) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0U) != 0x80U) return std::nullopt;
    code = (code << 6U) | (byte & 0x3FU);
  }
  const bool is_surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < kLeast[bytes.size()] || code > 0x10FFFF || is_surrogate) return std::nullopt;
  return code;
}

unsigned byte_at(std::string_view bytes, std::size_t k) { return static_cast<unsigned char>(bytes[k]); }

bool has_mark(std::string_view bytes) {
  const unsigned both = byte_at(bytes, 0) << 8U | byte_at(bytes, 1);
  return both == 0xFEFFU || both == 0xFFFEU;
}

bool is_big_endian(std::string_view bytes) { return byte_at(bytes, 0) == 0xFEU || bytes[0] == '\0'; }

}  // namespace

Utf8Character first_character(std::string_view text) {
  const std::size_t length = length_of(static_cast<unsigned char>(text[0]));
  if (length == 0 || length > text.size()) return {};
  const std::optional<char32_t> code = code_of(text.substr(0, length));
  return {code, code ? length : 1};
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const Utf8Character first = first_character(text);
    if (!first.code) return false;
    text.remove_prefix(first.length);
  }
  return true;
}

bool is_utf16(std::string_view bytes) {
  return bytes.size() >= 2 && (has_mark(bytes) || (bytes[0] == '\0') != (bytes[1] == '\0'));
}

std::optional<std::string> utf8_of_utf16(std::string_view bytes) {
  if (bytes.size() % 2 != 0) return std::nullopt;
  const std::size_t high = is_big_endian(bytes) ? 0 : 1;
  std::u16string text;
  for (std::size_t k = has_mark(bytes) ? 2 : 0; k < bytes.size(); k += 2) {
    text += static_cast<char16_t>(byte_at(bytes, k + high) << 8U | byte_at(bytes, k + 1 - high));
  }
  try {
    return boost::locale::conv::utf_to_utf<char>(text, boost::locale::conv::stop);
  } catch (const boost::locale::conv::conversion_error&) {
    return std::nullopt;
  }
}

std::string utf8_of_latin1(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x80U) {
      text += c;
    } else {
      text += {static_cast<char>(0xC0U | code >> 6U), static_cast<char>(0x80U | (code & 0x3FU))};
    }
  }
  return text;
}

}  // namespace flatdyn
