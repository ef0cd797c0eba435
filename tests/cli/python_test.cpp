// SPDX-License-Identifier: GPL-2.0-or-later
// `flatdyn generate --python`: the module is imported by Debian's Python with numpy, and does what its text says.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

using ::testing::HasSubstr;

constexpr const char* kPython = "/usr/bin/python3";  // Debian's, which has Debian's numpy

class Python : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system(fmt::format("{} -c 'import numpy' 2> /dev/null", kPython).c_str()) != 0) {
      GTEST_SKIP() << "numpy is not installed: scripts/setup";
    }
  }

  void generate(const std::string& arguments) const {
    const Outcome outcome = run_flatdyn(fmt::format("generate {} -q --python -o '{}'", arguments, folder_.path()));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
  }

  // With the command that the module's own text names.
  void build(const std::string& name) const {
    const std::string text = folder_.read(name + ".py");
    const std::size_t begin = text.find("cc -std=c99");
    const std::string command = text.substr(begin, text.find('\n', begin) - begin);
    ASSERT_EQ(std::system(fmt::format("cd '{}' && {} -Wall -Wextra -Werror", folder_.path(), command).c_str()), 0);
  }

  int run(const std::string& script) const {
    folder_.write("script.py", script);
    return std::system(
        fmt::format("cd '{}' && {} script.py > '{}' 2>&1", folder_.path(), kPython, folder_.path("log")).c_str());
  }

  Scratch folder_;
};

TEST_F(Python, ComputesOneStateAndBatches) {
  generate(
      "robots/panda.urdf --functions "
      "inverse_dynamics,forward_dynamics,inertia_matrix,forward_kinematics,kinetic_energy");
  build("panda");
  EXPECT_EQ(run(R"py(import numpy as np, panda
rng = np.random.default_rng(1)
q, qd, qdd = (rng.uniform(-1, 1, (50, 7)) for _ in range(3))
tau = panda.inverse_dynamics(q, qd, qdd)
assert tau.shape == (50, 7) and tau.dtype == np.float64
assert (panda.inverse_dynamics(q[3], qd[3], qdd[3]) == tau[3]).all()
assert np.abs(panda.forward_dynamics(q, qd, tau) - qdd).max() < 1e-11
B = panda.inertia_matrix(q)
assert B.shape == (50, 7, 7) and (B == B.transpose(0, 2, 1)).all()
T = panda.kinetic_energy(q, qd)
assert T.shape == (50,) and np.allclose(T, 0.5 * np.einsum('ni,nij,nj->n', qd, B, qd), rtol=1e-13)
assert np.shape(panda.kinetic_energy(q[0], qd[0])) == ()
R, p = panda.forward_kinematics(q[0])
assert R.shape == (3, 3) and p.shape == (3,) and np.allclose(R @ R.T, np.eye(3), atol=1e-15)
# One state holds for all; lists, other strides and other types are taken.
assert (panda.inverse_dynamics(q, np.zeros(7), qdd) == panda.inverse_dynamics(q, np.zeros((50, 7)), qdd)).all()
assert (panda.inertia_matrix(q[::2]) == B[::2]).all() and panda.inertia_matrix([0] * 7).shape == (7, 7)
assert panda.inertia_matrix(np.empty((0, 7))).shape == (0, 7, 7)
assert panda.joint_names[0] == "panda_joint1" and panda.rounding_is_as_written()
assert "joint positions, rad or m" in panda.inertia_matrix.__doc__ and "(7, 7)" in panda.inertia_matrix.__doc__
for wrong in (lambda: panda.inertia_matrix(np.zeros(6)), lambda: panda.inverse_dynamics(q, qd[:2], qdd)):
    try:
        wrong()
        raise AssertionError("not refused")
    except ValueError:
        pass
)py"),
            0)
      << folder_.read("log");
}

// Free symbols of the robot, float, and a B that is not positive definite.
TEST_F(Python, TakesParametersAndSaysWhereThereIsNoResult) {
  generate("robots/planar_2r.toml --scalar float --functions gravity,forward_dynamics --name arm --namespace arm");
  build("arm");
  EXPECT_EQ(run(R"py(import numpy as np, arm
level = arm.Parameters(g=9.81, m_l1=2, l_1=1, a_1=1, m_l2=1, l_2=1)
g = arm.gravity(level, np.zeros(2))
assert g.dtype == np.float32 and np.allclose(g, [4 * 9.81, 9.81], rtol=1e-6)
assert np.isfinite(arm.forward_dynamics(level, [0, 1], np.zeros(2), g)).all()
assert np.isnan(arm.forward_dynamics(arm.Parameters(), np.zeros((3, 2)), np.zeros(2), np.zeros(2))).all()
)py"),
            0)
      << folder_.read("log");
}

TEST_F(Python, SaysHowTheLibraryIsMade) {
  generate("robots/pendulum_motor.toml --functions gravity");
  EXPECT_NE(run("import pendulum_motor\n"), 0);
  EXPECT_THAT(folder_.read("log"), HasSubstr("pendulum_motor_batch.c -o libpendulum_motor.so -lm"));
}

TEST_F(Python, RefusesWhatItCannotImport) {
  EXPECT_EQ(run_flatdyn("generate robots/pendulum_motor.toml --python --name a-b -o /nowhere/at/all").code, 2);
  EXPECT_EQ(run_flatdyn("generate robots/pendulum_motor.toml --python --language c++ -o /nowhere/at/all").code, 2);
}

}  // namespace
}  // namespace flatdyn::testing
