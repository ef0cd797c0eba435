// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/content_hash.hpp"

#include <fmt/format.h>

#include <boost/uuid/detail/sha1.hpp>
#include <fstream>
#include <sstream>

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

std::string file_hash(const std::vector<std::string>& paths) {
  std::vector<std::string> contents;
  for (const std::string& path : paths) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream content;
    content << file.rdbuf();
    contents.push_back(content.str());
  }
  return content_hash(contents);
}

}  // namespace flatdyn
