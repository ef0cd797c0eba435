// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/emit/text_hash.hpp"

#include "code/emit/writer.hpp"
#include "robot/input/common/content_hash.hpp"

namespace flatdyn {

void fill_in_hash(const std::vector<std::string*>& texts) {
  constexpr std::size_t kShort = 8;
  std::vector<std::string> contents;
  for (const std::string* text : texts) contents.push_back(*text);
  const std::string named = content_hash(contents);  // "sha1:…"
  const std::string hash = named.substr(named.find(':') + 1);
  for (std::string* text : texts) {
    *text = with_replaced(with_replaced(*text, kHashPlaceholder, hash), kShortHashPlaceholder, hash.substr(0, kShort));
  }
}

}  // namespace flatdyn
