// SPDX-License-Identifier: GPL-2.0-or-later
// close_loops() as its users have it, in C++, C and JavaScript: Newton's method around the emitted functions finds the
// positions that the triangle says, and fails where there are none.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "base/system/temporary_folder.hpp"
#include "golden/golden.hpp"
#include "support/emitted_forms.hpp"
#include "support/robot_models.hpp"

namespace flatdyn::testing {
namespace {

namespace fs = std::filesystem;

// The checks in one language: 24 positions around the circle, the rod's other way round, and a crank that is held too
// far out.
constexpr const char* kChecks = R"(
  for (int k = 0; k < 24; ++k) {
    const double theta = 0.3 * k, height = 0.15 * sin(theta), root = sqrt(0.09 - height * height);
    for (int side = -1; side <= 1; side += 2) {
      double q[3] = {theta, side > 0 ? -theta : 3.0 - theta, side * 0.3}, qd[1] = {2.0}, qdd[1] = {0.0};
      double rates[3], accelerations[3];
      if (!CLOSE(q, 1e-12, 20)) return 1;
      if (fabs(q[0] - theta) > 0 || fabs(q[2] - (0.15 * cos(theta) + side * root)) > 1e-11) return 2;
      if (!MOTION(q, qd, qdd, rates, accelerations)) return 3;
      const double slope = -height * (1 + side * 0.15 * cos(theta) / root);
      if (fabs(rates[0] - 2.0) > 0 || fabs(rates[2] - 2.0 * slope) > 1e-11) return 4;
    }
  }
  double far[3] = {0.1, NAN, 0.2};
  if (CLOSE(far, 1e-12, 20)) return 5;
  double few[3] = {0.1, 1.0, 0.2};
  if (CLOSE(few, 1e-12, 1) || few[0] != 0.1 || few[1] != 1.0 || few[2] != 0.2) return 6;
  double closed[3] = {0, 0, 0.45};
  if (!CLOSE(closed, 0.0, 20) || CLOSE(closed, -1.0, 20)) return 7;
  return 0;
)";

class CloseLoops : public ::testing::Test {
 protected:
  void write(const std::string& file, const std::string& text) const { std::ofstream(folder_.path() / file) << text; }
  int run(const std::string& command) const {
    return std::system(fmt::format("cd '{}' && ({}) > log 2>&1", folder_.path().string(), command).c_str());
  }
  std::string log() const { return content_of(folder_.path() / "log"); }

  std::vector<Function> functions() const {
    PipelineOptions options;
    options.functions = {"loop_closure", "loop_step", "loop_motion"};
    Progress quiet(true);
    Diagnostics none;
    return functions_of(make_functions(model_, options, quiet, none));
  }

  const LoadedRobot model_ = model_of("slider_crank.toml");
  const TemporaryFolder folder_;
};

TEST_F(CloseLoops, InCpp) {
  write("robot.hpp", emit_header(model_.mechanism, functions(), {}, std::nullopt));
  write("main.cpp", std::string("#include \"robot.hpp\"\n#include <cmath>\nusing namespace std;\n"
                                "#define CLOSE slider_crank::close_loops\n#define MOTION slider_crank::loop_motion\n"
                                "int main() {") +
                        kChecks + "}\n");
  EXPECT_EQ(
      run("c++ -std=c++17 -Wall -Wextra -Wconversion -Wshadow -Werror -fno-exceptions main.cpp -o main && ./main"), 0)
      << log();
}

TEST_F(CloseLoops, InC) {
  EmitOptions options;
  options.language = "c";
  const HeaderAndSource text = emit_c(model_.mechanism, functions(), options);
  write("slider_crank.h", text.header);
  write("slider_crank.c", text.source);
  write("main.c", std::string("#include \"slider_crank.h\"\n#include <math.h>\n"
                              "#define CLOSE slider_crank_close_loops\n#define MOTION slider_crank_loop_motion\n"
                              "int main(void) {") +
                      kChecks + "}\n");
  EXPECT_EQ(run("cc -std=c99 -Wall -Wextra -pedantic -Wconversion -Wshadow -Wdouble-promotion -Werror main.c "
                "slider_crank.c -lm -o main && ./main"),
            0)
      << log();
}

TEST_F(CloseLoops, InJavascript) {
  if (std::system("node --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no node";
  write("robot.mjs", emit_javascript(model_.mechanism, functions()));
  write("main.mjs", R"(import {close_loops, loop_motion} from './robot.mjs';
for (let k = 0; k < 24; ++k) {
  const theta = 0.3 * k, height = 0.15 * Math.sin(theta), root = Math.sqrt(0.09 - height * height);
  const q = [theta, -theta, 0.3], rates = [0, 0, 0];
  if (!close_loops(q, 1e-12)) process.exit(1);
  if (Math.abs(q[2] - (0.15 * Math.cos(theta) + root)) > 1e-11) process.exit(2);
  if (!loop_motion(q, [2], [0], rates, [0, 0, 0])) process.exit(3);
  if (Math.abs(rates[2] + 2 * height * (1 + 0.15 * Math.cos(theta) / root)) > 1e-11) process.exit(4);
}
if (close_loops([0.1, NaN, 0.2], 1e-12)) process.exit(5);
if (!close_loops([0, 0, 0.45], 0) || close_loops([0, 0, 0.45], -1)) process.exit(6);
)");
  EXPECT_EQ(run("node main.mjs"), 0) << log();
}

}  // namespace
}  // namespace flatdyn::testing
