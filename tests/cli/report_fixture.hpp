// SPDX-License-Identifier: GPL-2.0-or-later
// Tests of pages of `flatdyn report` in a browser, which skip themselves where Chromium is not installed.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/program.hpp"
#include "cli/report_scripts.hpp"

namespace flatdyn::testing {

using nlohmann::json;

inline std::string from_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0, count = 0;
  for (const char c : text) {
    const std::size_t digit = digits.find(c);
    if (digit == std::string::npos) continue;
    bits = (bits << 6 | static_cast<unsigned>(digit)) & 0xffffff;
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xff);
  }
  return bytes;
}

class Report : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system("chromium --version > /dev/null 2>&1") != 0) {
      GTEST_SKIP() << "Chromium is not installed: scripts/setup";
    }
  }

  std::string page(const std::string& robot) const {
    const Outcome outcome = run_flatdyn(fmt::format("report {} -q -o '{}'", robot, folder_.path("page.html")));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return folder_.read("page.html");
  }

  // The page's report of itself, with scripts added to it.
  json told_by(std::string page, const std::string& scripts, const std::string& frame = "") const {
    const std::size_t head = page.find("<head>") + 6;
    page.insert(head, kBefore);
    folder_.write("watched.html", page + scripts + kTell);
    folder_.write("frame.html", frame);
    const std::string command = fmt::format(
        "chromium --headless=new --no-sandbox --disable-gpu --user-data-dir='{0}' --virtual-time-budget=4000 "
        "--dump-dom 'file://{1}' > '{2}' 2> '{3}'",
        folder_.path("profile"), folder_.path(frame.empty() ? "watched.html" : "frame.html"), folder_.path("dom"),
        folder_.path("log"));
    EXPECT_EQ(std::system(command.c_str()), 0) << folder_.read("log");
    const std::string dom = folder_.read("dom"), mark = "<pre id=\"told\">";
    const std::size_t begin = dom.rfind(mark);
    if (begin == std::string::npos) {
      ADD_FAILURE() << "the page says nothing: " << folder_.read("log");
      return json::object();
    }
    return json::parse(from_base64(dom.substr(begin + mark.size(), dom.find("</pre>", begin) - begin - mark.size())));
  }

  // The results of `flatdyn eval` at the one state of a CSV, without the state's own columns.
  std::vector<double> evaluated(const std::string& robot, const std::string& function, const std::string& csv) const {
    folder_.write("state.csv", csv);
    const Outcome outcome =
        run_flatdyn(fmt::format("eval {} -q --function {} --states '{}'", robot, function, folder_.path("state.csv")));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    std::istringstream lines(outcome.out);
    std::string names, row, cell;
    std::getline(lines, names);
    std::getline(lines, row);
    std::vector<double> values;
    for (std::istringstream cells(row); std::getline(cells, cell, ',');) values.push_back(std::stod(cell));
    const auto given = std::count(csv.begin(), csv.begin() + static_cast<std::ptrdiff_t>(csv.find('\n')), ',') + 1;
    values.erase(values.begin(), values.begin() + given);
    return values;
  }

  Scratch folder_;
};

inline void expect_near(const std::vector<double>& shown, const std::vector<double>& expected,
                        const std::string& what) {
  constexpr double kRelative = 1e-9;
  ASSERT_EQ(shown.size(), expected.size()) << what;
  double size = 0;
  for (const double x : expected) size = std::max(size, std::abs(x));
  for (std::size_t k = 0; k < shown.size(); ++k) {
    EXPECT_NEAR(shown[k], expected[k], kRelative * std::max(std::abs(expected[k]), 1e-3 * size)) << what << " " << k;
  }
}

}  // namespace flatdyn::testing
