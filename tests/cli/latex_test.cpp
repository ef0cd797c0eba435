// SPDX-License-Identifier: GPL-2.0-or-later
// The output of `flatdyn derive --latex` in a document: it compiles, and no line is wider than the page.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class Latex : public ::testing::TestWithParam<const char*> {};

TEST_P(Latex, CompilesAndFitsThePage) {
  if (std::system("command -v pdflatex > /dev/null") != 0) GTEST_SKIP() << "pdflatex is not installed: scripts/setup";
  const Scratch scratch;
  const Outcome derived = run_flatdyn(fmt::format("derive {} --latex -q", GetParam()));
  ASSERT_EQ(derived.code, 0) << derived.err;
  scratch.write("model.tex", derived.out);
  scratch.write("document.tex",
                "\\documentclass[a4paper]{article}\n\\usepackage{amsmath}\n\\usepackage[margin=2cm]{geometry}\n"
                "\\allowdisplaybreaks\n\\begin{document}\n\\input{model.tex}\n\\end{document}\n");
  const std::string command = fmt::format(
      "cd '{}' && pdflatex -interaction=nonstopmode -halt-on-error document.tex > out 2>&1", scratch.path());
  EXPECT_EQ(std::system(command.c_str()), 0) << scratch.read("out");
  EXPECT_THAT(scratch.read("document.log"), HasSubstr("Output written on document.pdf"));
  EXPECT_THAT(scratch.read("document.log"), Not(HasSubstr("Overfull")));
}

INSTANTIATE_TEST_SUITE_P(Derive, Latex,
                         ::testing::Values("robots/cartesian_2.toml", "robots/planar_2r.toml",
                                           "robots/pendulum_motor.toml", "robots/planar_2r_example_7_2.toml",
                                           "robots/prismatic_revolute.toml", "robots/scara.toml",
                                           "robots/planar_2r.toml --base floating", "docs/examples/floating_body.toml",
                                           "docs/examples/spherical_pendulum.toml",
                                           "docs/examples/ball_wrist.toml --digits 4 --max-terms 40"),
                         [](const auto& test) {
                           std::string name = test.param;
                           name.erase(0, name.rfind('/') + 1);
                           const bool floats = name.find("floating") != std::string::npos;
                           return name.substr(0, name.find('.')) + (floats ? "_floats" : "");
                         });

}  // namespace
}  // namespace flatdyn::testing
