// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/content_hash.hpp"

#include <fmt/format.h>

#include <boost/uuid/detail/sha1.hpp>

namespace flatdyn {

std::string content_hash(const std::vector<std::string>& texts) {
  boost::uuids::detail::sha1 sha;
  for (const std::string& text : texts) sha.process_bytes(text.data(), text.size());
  boost::uuids::detail::sha1::digest_type digest;
  sha.get_digest(digest);
  std::string result = "sha1:";
  for (const auto word : digest) result += fmt::format("{:08x}", word);
  return result;
}

}  // namespace flatdyn
