// SPDX-License-Identifier: GPL-2.0-or-later
// The headers that sources reach decide what a build costs. A header that takes seconds to compile may be reached from
// the folders named here alone: a folder that joins a list makes every build longer.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>

#include "unit/layout/source_files.hpp"

namespace flatdyn::testing {
namespace {

struct HeavyHeader {
  std::string path;               // how its name begins
  std::set<std::string> folders;  // the generator's folders whose sources may reach it
};

const std::vector<HeavyHeader>& heavy_headers() {
  static const std::vector<HeavyHeader> all = {
      {"boost/multiprecision/", {}},
      {"boost/", {"base/diagnostics", "laboratory/simulate", "robot/input"}},
      {"CLI/", {"cli"}},
      {"ceres/", {"laboratory/identify"}},
      {"nlohmann/json.hpp",
       {"cli", "code/emit", "delivery/python", "functions/planning", "laboratory/identify", "proof/verify", "report",
        "report/html"}},
      {"regex", {"robot/input"}},
      {"toml++/", {"laboratory/simulate", "laboratory/trajectory", "robot/input"}},
      {"Eigen/",
       {"base/numeric",
        "cli",
        "code/conventions",
        "code/emit",
        "delivery/convert",
        "delivery/firmware",
        "derivation/parameters",
        "functions",
        "functions/deviation",
        "functions/load",
        "functions/planning",
        "functions/scene",
        "laboratory/bench",
        "laboratory/identify",
        "laboratory/manipulability",
        "laboratory/simulate",
        "laboratory/stress",
        "laboratory/trajectory",
        "proof/certify",
        "proof/verify",
        "report",
        "report/html",
        "report/plot",
        "robot/model",
        "truth/reference"}},
  };
  return all;
}

// The folders that see numbers and the standard library alone.
const std::set<std::string>& folders_without_symbols() {
  static const std::set<std::string> all = {"base/diagnostics", "base/numeric", "base/system", "code", "graph",
                                            "graph/passes"};
  return all;
}

// Headers by the names that #include gives them, "robot/model/robot.hpp" or "flatdyn/reference/robot.hpp".
using Headers = std::map<std::string, std::vector<std::string>>;

Headers own_headers() {
  Headers headers;
  for (const std::string top : {"generator", "runtime/include"}) {
    for (const SourceFile& file : source_files(top)) headers.emplace(file.name, file.lines);
  }
  return headers;
}

// All headers of others that a file reaches, each with the chain of names that leads to it.
std::map<std::string, std::string> reached_from(const std::string& name, const Headers& headers) {
  static const std::regex kInclude("^#include [\"<](.*)[\">]$");
  std::map<std::string, std::string> reached;
  std::set<std::string> seen = {name};
  std::vector<std::pair<std::string, std::string>> waiting = {{name, name}};
  while (!waiting.empty()) {
    const auto [next, chain] = waiting.back();
    waiting.pop_back();
    for (const std::string& line : headers.at(next)) {
      std::smatch match;
      if (!line.starts_with("#include") || !std::regex_match(line, match, kInclude)) continue;
      const std::string header = match[1];
      if (!seen.insert(header).second) continue;
      if (headers.count(header) > 0) {
        waiting.emplace_back(header, chain + " > " + header);
      } else {
        reached.emplace(header, chain + " > " + header);
      }
    }
  }
  return reached;
}

// The wing and the folder in it: "robot/input" for robot/input/urdf/reader.cpp, "graph" for graph/graph.cpp.
std::string folder_in_wing(const std::string& name) {
  const std::string folders = name.substr(0, name.rfind('/'));
  return folders.substr(0, folders.find('/', folders.find('/') + 1));
}

std::vector<std::string> broken_rules(const Headers& headers) {
  std::vector<std::string> broken;
  for (const auto& [name, lines] : headers) {
    if (!name.ends_with(".cpp")) continue;
    const std::string folder = folder_in_wing(name);
    for (const auto& [header, chain] : reached_from(name, headers)) {
      for (const HeavyHeader& heavy : heavy_headers()) {
        if (!header.starts_with(heavy.path)) continue;
        if (heavy.folders.count(folder) == 0)
          broken.push_back(fmt::format("{}/ reaches <{}>: {}", folder, header, chain));
        break;
      }
      if (header.starts_with("ginac/") && folders_without_symbols().count(folder) > 0) {
        broken.push_back(fmt::format("{}/ reaches <{}>: {}", folder, header, chain));
      }
    }
  }
  return broken;
}

TEST(BuildWeight, HeavyHeadersAreReachedFromFewFolders) {
  for (const std::string& rule : broken_rules(own_headers())) ADD_FAILURE() << rule;
}

TEST(BuildWeight, EveryFolderOfAListReachesItsHeader) {
  const Headers headers = own_headers();
  std::map<std::string, std::set<std::string>> found;
  for (const auto& [name, lines] : headers) {
    for (const auto& [header, chain] : reached_from(name, headers)) {
      for (const HeavyHeader& heavy : heavy_headers()) {
        if (header.starts_with(heavy.path)) found[heavy.path].insert(folder_in_wing(name));
      }
    }
  }
  for (const HeavyHeader& heavy : heavy_headers()) {
    for (const std::string& folder : heavy.folders) {
      EXPECT_EQ(found[heavy.path].count(folder), 1u) << folder << "/ may leave the list of <" << heavy.path << ">";
    }
  }
}

TEST(BuildWeight, AHeaderBehindAnotherIsFound) {
  const Headers headers = {{"graph/a.cpp", {"#include \"graph/b.hpp\""}},
                           {"graph/b.hpp", {"#include <vector>", "#include <CLI/CLI.hpp>", "#include <ginac/ginac.h>"}},
                           {"cli/c.cpp", {"#include <CLI/CLI.hpp>"}}};
  EXPECT_EQ(broken_rules(headers),
            (std::vector<std::string>{"graph/ reaches <CLI/CLI.hpp>: graph/a.cpp > graph/b.hpp > CLI/CLI.hpp",
                                      "graph/ reaches <ginac/ginac.h>: graph/a.cpp > graph/b.hpp > ginac/ginac.h"}));
}

}  // namespace
}  // namespace flatdyn::testing
