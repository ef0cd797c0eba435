// SPDX-License-Identifier: GPL-2.0-or-later
// The functions that acados asks for: docs/examples/acados as CasADi reads it, beside Pinocchio's dynamics.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "base/system/process.hpp"
#include "base/system/temporary_folder.hpp"

namespace flatdyn {
namespace {

namespace fs = std::filesystem;

TEST(Acados, FindsItsFunctionsWithPinocchiosValues) {
  const fs::path source = FLATDYN_SOURCE_DIR, python = source / "build" / "peers" / "bin" / "python",
                 example = source / "docs" / "examples" / "acados", robot = source / "robots" / "panda.urdf";
  if (!fs::exists(python)) GTEST_SKIP() << "CasADi and Pinocchio are not in build/peers: scripts/setup";
  const TemporaryFolder folder;
  const auto word = [](const fs::path& path) { return shell_word(path.string()); };
  const std::string generate = fmt::format(
      "{} generate {} -q --language c -o . --functions forward_dynamics,forward_dynamics_derivatives,"
      "vjp:forward_dynamics,inverse_dynamics,inverse_dynamics_derivatives,inertia_matrix,step:rk4,step_derivatives:rk4",
      shell_word(FLATDYN_PROGRAM), word(robot));
  const std::string compile = fmt::format(
      "cc -std=c99 -O0 -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion -Werror -shared -fPIC "
      "'-Dcasadi_int=long long' -I. panda.c {} -o libpanda_model.so -lm",
      word(example / "panda_model.c"));
  const std::string check =
      fmt::format("{} -B {} ./libpanda_model.so {}", word(python), word(example / "check.py"), word(robot));
  EXPECT_EQ(run_command(fmt::format("({} && {} && {}) > log 2>&1", generate, compile, check), folder.path()), 0)
      << content_of_file(folder.path() / "log");
}

}  // namespace
}  // namespace flatdyn
