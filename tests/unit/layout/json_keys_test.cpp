// SPDX-License-Identifier: GPL-2.0-or-later
// docs/json.md names every key that reports put into JSON.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include "unit/layout/source_files.hpp"

namespace flatdyn::testing {
namespace {

// The words of json["key"] = …, of {"key", value} and of a ReportField, {"heading", "object.key", getter}.
std::set<std::string> keys_in(const std::vector<std::string>& lines) {
  static const std::regex kKeys[] = {std::regex(R"re((?:json|\))\["([a-z_0-9]+)"\])re"),
                                     std::regex(R"re(\{"([a-z_0-9]+)", (?!["&]))re"),
                                     std::regex(R"re(\{"[^"]*", "([a-z_0-9.]+)", [&\[])re")};
  static const std::regex kWord("[a-z_0-9]+");
  std::set<std::string> words;
  for (const std::string& line : lines) {
    for (const std::regex& kKey : kKeys) {
      for (std::sregex_iterator found(line.begin(), line.end(), kKey), end; found != end; ++found) {
        const std::string key = (*found)[1];
        words.insert(std::sregex_token_iterator(key.begin(), key.end(), kWord), std::sregex_token_iterator());
      }
    }
  }
  return words;
}

std::set<std::string> words_of_page() {
  static const std::regex kWord("[a-z_0-9]+");
  std::set<std::string> words;
  for (const std::string& line : lines_of(std::filesystem::path(FLATDYN_SOURCE_DIR) / "docs/json.md")) {
    words.insert(std::sregex_token_iterator(line.begin(), line.end(), kWord), std::sregex_token_iterator());
  }
  return words;
}

TEST(JsonPage, NamesEveryKeyOfReports) {
  const std::set<std::string> named = words_of_page();
  std::size_t keys = 0;
  for (const SourceFile& file : source_files("generator/report")) {
    if (!file.folder.empty()) continue;  // the page's data are its own
    for (const std::string& key : keys_in(file.lines)) {
      ++keys;
      EXPECT_EQ(named.count(key), 1u) << "docs/json.md lacks the key " << key << " of generator/report/" << file.name;
    }
  }
  EXPECT_GT(keys, 300u);
}

TEST(JsonPage, FindsKeysHoweverTheyAreWritten) {
  EXPECT_EQ(keys_in({R"(json["a"] = 1; json["b"].push_back({{"c", 2}, {"d", x}});)",
                     R"({"heading", "ns.low", [](auto& row) { return row.time.low; }},)",
                     R"({"column", &Row::column}, {"", "", nothing})"}),
            (std::set<std::string>{"a", "b", "c", "d", "low", "ns"}));
}

}  // namespace
}  // namespace flatdyn::testing
