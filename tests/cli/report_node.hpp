// SPDX-License-Identifier: GPL-2.0-or-later
// Tests of the scripts of `flatdyn report`, run by Node with the page's functions; without Node they skip themselves.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "cli/program.hpp"

namespace flatdyn::testing {

// The text of a robot file of docs/examples.
inline std::string text_of_example(const std::string& file) {
  std::ifstream stream(std::filesystem::path(FLATDYN_SOURCE_DIR) / "docs/examples" / file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// `use(names)` gives what these names stand for in the page's scripts, those that need no document.
class ReportInNode : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system("node --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "Node is not installed: scripts/setup";
  }

  void expect_passes(const std::string& robot, const std::string& script) const {
    folder_.write("robot.toml", robot);
    const Outcome made =
        run_flatdyn(fmt::format("report '{}' -q -o '{}'", folder_.path("robot.toml"), folder_.path("page.html")));
    ASSERT_EQ(made.code, 0) << made.err;
    folder_.write("script.js", kPage + script);
    EXPECT_EQ(std::system(fmt::format("cd '{}' && node script.js > log 2>&1", folder_.path()).c_str()), 0)
        << folder_.read("log");
  }

  static constexpr const char* kPage = R"js('use strict';
const assert = require('node:assert'), fs = require('node:fs');
const page = fs.readFileSync('page.html', 'utf8');
const part = (begin, end) => { const from = page.indexOf(begin) + begin.length; return page.slice(from, page.indexOf(end, from)); };
const json = part('id="data">', '</script>');
const robot = new Function(part('const robot = (() => {', '\n})();\n</script>'))();
const scripts = part("(() => {\n'use strict';\n", '\n})();\n</script>').split('// SPDX-License-Identifier: BSD-3-Clause');
const withoutDocument = scripts.slice(1, scripts.findIndex((text) => text.includes('The robot as lines'))).join('');
const use = (names) => new Function('robot', 'document', `${withoutDocument} return {${names}};`)(robot, {getElementById: () => ({textContent: json})});
const distance = (a, b) => Math.hypot(...a.map((x, k) => x - b[k]));
)js";

  Scratch folder_;
};

}  // namespace flatdyn::testing
