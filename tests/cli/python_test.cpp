// SPDX-License-Identifier: GPL-2.0-or-later
// `flatdyn generate --python`: Debian's Python imports the module with numpy, and it behaves as its text says.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <regex>
#include <utility>

#include "cli/python.hpp"

namespace flatdyn::testing {
namespace {

using ::testing::HasSubstr;

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

TEST(PythonUsage, IsALanguage) {
  const Scratch as_option, as_language;
  const std::string generate = "generate robots/scara.toml -q --functions gravity -o ";
  ASSERT_EQ(run_flatdyn(generate + as_option.path() + " --python").code, 0);
  ASSERT_EQ(run_flatdyn(generate + as_language.path() + " --language python").code, 0);
  for (const char* file : {"scara.py", "scara.h", "scara.c", "scara_batch.c"}) {
    EXPECT_EQ(as_language.read(file), as_option.read(file)) << file;
    EXPECT_FALSE(as_option.read(file).empty()) << file;
  }
}

// Errors name the argument; complex numbers and texts are no numbers.
TEST_F(Python, RefusesWrongArgumentsByName) {
  generate("robots/puma560.toml --functions inverse_dynamics");
  build("puma560");
  EXPECT_EQ(run(R"py(import numpy as np, puma560
def refused(error, words, *arguments):
    try:
        puma560.inverse_dynamics(*arguments)
    except error as failure:
        assert words in str(failure), failure
    else:
        raise SystemExit("not refused: " + words)
z, Z = np.zeros(6), np.zeros((3, 6))
refused(TypeError, "qd: real numbers are expected, not complex128", z, z + 1j, z)
refused(TypeError, "qdd: real numbers are expected", z, z, [0, 0, 0, 0, 0, 1j])
refused(TypeError, "q: real numbers are expected", ["1"] * 6, z, z)
refused(TypeError, "q: real numbers are expected", [None] * 6, z, z)
refused(ValueError, "qd: an array of shape (6,) or (N, 6) is expected, not (5,)", z, z[1:], z)
refused(ValueError, "qdd: this is no array", z, z, [[1, 2], [3]])
refused(ValueError, "here are q for 3, qdd for 2", Z, z, Z[1:])
assert puma560.inverse_dynamics([0] * 6, z, np.zeros(6, dtype=object)).shape == (6,)
)py"),
            0)
      << folder_.read("log");
}

TEST_F(Python, HasTheConstantsOfTheHeader) {
  generate("robots/ur5.urdf --functions base_regressor,inverse_dynamics");
  build("ur5");
  EXPECT_EQ(run(R"py(import numpy as np, ur5
assert ur5.joint_count == 6 and len(ur5.joint_names) == 6
assert ur5.position_upper.shape == (6,) and ur5.velocity_limit[0] == np.pi and not ur5.effort_limit.flags.writeable
n = ur5.base_parameter_count
assert n == len(ur5.base_parameter_names) == len(ur5.base_parameter_units) == len(ur5.base_parameter_values)
units = dict(zip(ur5.base_parameter_names, ur5.base_parameter_units))
assert units["m3lx"] == "kg m" and units["I1zz"] == "kg m^2", units
q, qd, qdd = np.random.default_rng(2).uniform(-1, 1, (3, 6))
assert np.allclose(ur5.base_regressor(q, qd, qdd) @ ur5.base_parameter_values, ur5.inverse_dynamics(q, qd, qdd))
)py"),
            0)
      << folder_.read("log");
}

TEST_F(Python, SaysHowToMakeABrokenLibraryAnew) {
  generate("robots/scara.toml --functions gravity");
  folder_.write("libscara.so", "no library");
  EXPECT_EQ(run(R"py(
try:
    import scara
except ImportError as error:
    assert "cannot be loaded" in str(error) and "cc -std=c99" in str(error), error
else:
    raise SystemExit("imported")
)py"),
            0)
      << folder_.read("log");
}

// The robot has free symbols, is in float, and its B is not positive definite.
TEST_F(Python, TakesParametersAndSaysWhereThereIsNoResult) {
  generate("robots/planar_2r.toml --scalar float --functions gravity,forward_dynamics --name arm --namespace arm");
  build("arm");
  EXPECT_EQ(run(R"py(import numpy as np, arm
level = arm.Parameters(g=9.81, m_l1=2, l_1=1, a_1=1, m_l2=1, l_2=1, **dict.fromkeys(("a_2", "I_l1", "m_m1", "I_m1", "k_r1", "I_l2", "m_m2", "I_m2", "k_r2"), 0))
g = arm.gravity(level, np.zeros(2))
assert g.dtype == np.float32 and np.allclose(g, [4 * 9.81, 9.81], rtol=1e-6)
assert np.isfinite(arm.forward_dynamics(level, [0, 1], np.zeros(2), g)).all()
none = arm.Parameters(**{name: 0 for name, _ in arm.Parameters._fields_})
assert np.isnan(arm.forward_dynamics(none, np.zeros((3, 2)), np.zeros(2), np.zeros(2))).all()
)py"),
            0)
      << folder_.read("log");
}

// The C form's own functions, with libm's sines, in the same library, for comparison with batches.
constexpr const char* kSingleCalls = R"py(import ctypes
import numpy as np

def library(module):
    return next(value for name, value in vars(module).items() if name.startswith("_library_"))

def single(module, name, shapes, *rows, parameters=None):
    function = getattr(library(module).c, module.__name__ + "_" + name)
    rows = [np.ascontiguousarray(row, module.number) for row in rows]
    results = [np.empty(shape, module.number) for shape in shapes]
    given = [] if parameters is None else [ctypes.byref(parameters)]
    function(*given, *(ctypes.c_void_p(array.ctypes.data) for array in rows + results))
    return results[0] if len(results) == 1 else results

def same_bits(a, b):
    return np.array_equal(a, b, equal_nan=True)
)py";

// Batches of sizes that fill the last block of lanes differently. If sines and cosines are exact, all bits agree.
TEST_F(Python, BatchesAreWhatSingleCallsAre) {
  for (const char* scalar : {"double", "float"}) {
    generate(fmt::format("robots/panda.urdf --functions inverse_dynamics,inertia_matrix,forward_dynamics --scalar {}",
                         scalar));
    build("panda");
    EXPECT_EQ(run(kSingleCalls + std::string(R"py(
import panda
rng = np.random.default_rng(1)
close = 1e3 * np.finfo(panda.number).eps
for n in (1, 7, 8, 9, 1000):
    q, qd, qdd = rng.uniform(-1, 1, (3, n, 7)).astype(panda.number)
    tau, B = panda.inverse_dynamics(q, qd, qdd), panda.inertia_matrix(q)
    alone = [panda.inverse_dynamics(q[k], qd[k], qdd[k]) for k in range(n)]
    assert same_bits(tau, alone) and same_bits(B, [panda.inertia_matrix(row) for row in q])
    in_c = [single(panda, "inverse_dynamics", [7], q[k], qd[k], qdd[k]) for k in range(n)]
    assert np.abs(tau - in_c).max() < close * np.abs(tau).max()
    assert np.abs(B - [single(panda, "inertia_matrix", [(7, 7)], row) for row in q]).max() < close * B.max()
    in_c = [single(panda, "forward_dynamics", [7], q[k], qd[k], tau[k]) for k in range(n)]
    assert np.abs(panda.forward_dynamics(q, qd, tau) - in_c).max() < 1e3 * close
    straight = panda.inverse_dynamics(np.zeros(7), qd, qdd)
    assert same_bits(straight, [single(panda, "inverse_dynamics", [7], np.zeros(7), *row) for row in zip(qd, qdd)])
)py")),
              0)
        << scalar << folder_.read("log");
  }
}

// A robot with prismatic joints, friction with its signs and free symbols; a function that returns a number.
TEST_F(Python, BatchesOfRobotsWithoutSinesHaveTheSameBits) {
  generate("robots/cartesian_2.toml --functions inverse_dynamics,inertia_matrix,kinetic_energy");
  build("cartesian_2");
  generate("robots/puma560.toml --functions inverse_dynamics");
  build("puma560");
  EXPECT_EQ(run(kSingleCalls + std::string(R"py(
import cartesian_2, puma560
rng = np.random.default_rng(1)
p = cartesian_2.Parameters(**{name: rng.uniform(1, 2) for name, _ in cartesian_2.Parameters._fields_})
q, qd, qdd = rng.uniform(-1, 1, (3, 21, 2))
tau = cartesian_2.inverse_dynamics(p, q, qd, qdd)
assert same_bits(tau, [single(cartesian_2, "inverse_dynamics", [2], *row, parameters=p) for row in zip(q, qd, qdd)])
B = single(cartesian_2, "inertia_matrix", [(2, 2)], q[0], parameters=p)
assert same_bits(cartesian_2.inertia_matrix(p, q), [B] * 21)
T = np.einsum("ni,ij,nj->n", qd, B, qd) / 2
assert np.allclose(cartesian_2.kinetic_energy(p, q, qd), T, rtol=1e-14)
qd = rng.choice([-1e-9, 0, 1e-9], (33, 6))
qd[::5, 5] = np.nan
tau = puma560.inverse_dynamics(np.zeros(6), qd, np.zeros(6))
assert same_bits(tau, [single(puma560, "inverse_dynamics", [6], np.zeros(6), row, np.zeros(6)) for row in qd])
assert np.nanmin(tau[qd[:, 0] > 0, 0]) > 1 and np.isnan(tau).any() and np.isfinite(tau).any()
)py")),
            0)
      << folder_.read("log");
}

// R of a pendulum consists of its sine and cosine. Beyond 1e5 rad, in float 6400 rad, the lanes that need it call the
// library.
TEST_F(Python, SinesOfBatchesAreRightToOneUlpAndLargeAnglesAreTheLibrarys) {
  for (const char* scalar : {"double", "float"}) {
    generate(fmt::format("robots/pendulum_motor.toml --functions forward_kinematics --scalar {}", scalar));
    build("pendulum_motor");
    EXPECT_EQ(run(kSingleCalls + std::string(R"py(
import pendulum_motor as arm
p = arm.Parameters(**dict.fromkeys((name for name, _ in arm.Parameters._fields_), 0))
rng = np.random.default_rng(1)
for size in (1e-8, 1, 4, 60, 1e3, 1e5):
    q = rng.uniform(-size, size, 100_000)
    q[1::2] = np.clip(np.rint(q[1::2] / (np.pi / 4)) * (np.pi / 4), -size, size)  # zeros, maxima, the seam
    q = q.astype(arm.number)
    R, _ = arm.forward_kinematics(p, q[:, None])
    for value, exact in ((R[:, 1, 0], np.sin(q.astype(np.longdouble))), (R[:, 0, 0], np.cos(q.astype(np.longdouble)))):
        ulp = np.spacing(np.abs(exact).astype(arm.number)).astype(np.longdouble)
        assert (np.abs(value - exact) / ulp).max() < 1, size
most = 1e5 if arm.number == np.float64 else 6400
q = np.array([0.5, most, np.nextafter(arm.number(most), np.inf), 1e5, 1e8, np.inf, -np.inf, np.nan, -1e30, 0.25, -1.1e5, 1, 2, 3, 4, -0.0, 0, 5, 6, 7, 8], arm.number)
R, _ = arm.forward_kinematics(p, q[:, None])
alone = np.array([single(arm, "forward_kinematics", [(3, 3), 3], [angle], parameters=p)[0] for angle in q])
for k, angle in enumerate(q):
    if not abs(angle) <= most:
        assert same_bits(R[k], alone[k]), angle
    else:
        assert np.abs(R[k] - alone[k]).max() <= 1.5 * np.finfo(arm.number).eps, angle
assert (np.isnan(R[:, 0, 0]) == ~np.isfinite(q)).all() and (R[q == 0, 1, 0] == 0).all() and (R[q == 0, 0, 0] == 1).all()
)py")),
              0)
        << scalar << folder_.read("log");
  }
}

// In float: every angle from 1 to 4 rad, every 101st from denormal ones to those of the library, and those around the
// limit.
TEST_F(Python, SinesOfFloatsAreRightToOneUlpAtAllAngles) {
  generate("robots/pendulum_motor.toml --functions forward_kinematics --scalar float");
  build("pendulum_motor");
  EXPECT_EQ(run(R"py(import numpy as np, pendulum_motor as arm
p = arm.Parameters(**dict.fromkeys((name for name, _ in arm.Parameters._fields_), 0))
def bits(x):
    return int(np.float32(x).view(np.uint32))

def units(value, exact):  # sines of doubles are exact enough to measure those of floats
    return np.abs(value - exact) / np.spacing(np.abs(exact).astype(np.float32)).astype(np.float64)

limit = bits(6400)
for first, last, step in (bits(1), bits(4), 1), (1, bits(1), 101), (bits(4), limit, 101), (limit - 999, limit + 999, 1):
    for begin in range(first, last + 1, step << 20):
        end = min(begin + (step << 20), last + 1)
        q = np.arange(begin, end, step, dtype=np.uint32).view(np.float32)
        q[1::2] *= -1
        R, _ = arm.forward_kinematics(p, q[:, None])
        angle = q.astype(np.float64)
        assert units(R[:, 1, 0], np.sin(angle)).max() < 1, (begin, end)
        assert units(R[:, 0, 0], np.cos(angle)).max() < 1, (begin, end)
)py"),
            0)
      << folder_.read("log");
}

// Rows of 2 to 36 entries, which do not all fill squares of 16 bytes, with full blocks and a partial one.
TEST_F(Python, RowsOfAllLengthsAreReadAndWrittenWhole) {
  for (const char* scalar : {"double", "float"}) {
    for (const std::string robot : {"prismatic_revolute.toml", "scara.toml", "ur5.urdf"}) {
      const std::string name = robot.substr(0, robot.find('.'));
      generate(fmt::format("robots/{} --functions inertia_matrix,gravity --scalar {}", robot, scalar));
      build(name);
      EXPECT_EQ(run(fmt::format(R"py(import numpy as np, {0} as arm
rng = np.random.default_rng(1)
p = [arm.Parameters(**{{name: 1.5 for name, _ in arm.Parameters._fields_}})] if hasattr(arm, "Parameters") else []
q = rng.uniform(-1, 1, (67, len(arm.joint_names))).astype(arm.number)
for function in (arm.inertia_matrix, arm.gravity):
    assert np.array_equal(function(*p, q), [function(*p, row) for row in q])
    assert np.array_equal(function(*p, np.tile(q[5], (67, 1))), [function(*p, q[5])] * 67)
)py",
                                name)),
                0)
          << robot << scalar << folder_.read("log");
    }
  }
}

// The statements of a function's definition without line breaks, types, or the spreading of numbers over lanes.
std::string statements(const std::string& source, const std::string& function, const std::string& prefix) {
  const std::size_t begin = source.find(" " + function + "(");
  if (begin == std::string::npos) return "";
  std::string text = source.substr(source.find('{', begin), source.find("\n}", begin) - source.find('{', begin));
  text = std::regex_replace(text, std::regex(prefix + "lanes_all\\(([^()]*)\\)"), "$1");
  text = std::regex_replace(text, std::regex(prefix + "lanes_mask"), "bool");
  text = std::regex_replace(text, std::regex(prefix + "lanes "), "double ");
  text = std::regex_replace(text, std::regex(prefix + "lanes_"), prefix);
  return std::regex_replace(text, std::regex("\\s+"), " ");
}

// The proof of the text for one state also holds for lanes.
TEST_F(Python, StatementsOfLanesAreThoseOfOneState) {
  generate("robots/panda.urdf --functions inverse_dynamics,forward_dynamics,base_regressor");
  generate("robots/planar_2r.toml --functions gravity,kinetic_energy,forward_dynamics");
  generate("robots/puma560.toml --functions inverse_dynamics");
  const std::pair<std::string, std::string> functions[] = {
      {"panda", "inverse_dynamics_given"},  {"panda", "forward_dynamics_given"},
      {"panda", "base_regressor_given"},    {"planar_2r", "kinetic_energy_given"},
      {"planar_2r", "gravity_given"},       {"planar_2r", "forward_dynamics_given"},
      {"puma560", "inverse_dynamics_given"}};
  for (const auto& [robot, function] : functions) {
    const std::string prefix = robot + "_";
    const std::string of_one = statements(folder_.read(robot + ".c"), prefix + function, prefix);
    EXPECT_GT(of_one.size(), 100u) << function;
    EXPECT_EQ(statements(folder_.read(robot + "_batch.c"), prefix + "lanes_" + function, prefix), of_one);
  }
}

// There are as many packed operations as in the text, and almost no others.
TEST_F(Python, BatchesAreInSimdRegisters) {
  const bool is_here = std::system("objdump --version > /dev/null 2>&1") == 0;
  if (!is_here || std::system("uname -m | grep -q x86_64") != 0) GTEST_SKIP() << "objdump of x86-64 counts";
  generate("robots/panda.urdf --functions inverse_dynamics");
  const char* const gcc = "cc -O3";
  const bool has_clang = std::system("clang --version > /dev/null 2>&1") == 0;
  for (const std::string command :
       {gcc, "cc -O3 -mavx2", "cc -O3 -mavx512f", "cc -O2", has_clang ? "clang -O2" : gcc}) {
    const std::string compile = " -std=c99 -ffp-contract=off -fPIC -Wall -Wextra -Werror -c panda_batch.c";
    ASSERT_EQ(std::system(fmt::format("cd '{}' && {}{} && objdump -d --no-show-raw-insn panda_batch.o > log",
                                      folder_.path(), command, compile)
                              .c_str()),
              0);
    const auto instructions = [&](const std::string& pattern) {
      const std::string count = fmt::format("cd '{}' && grep -cE '\\sv?({})\\s' log > count", folder_.path(), pattern);
      return std::system(count.c_str()) < 0 ? 0 : std::stoi(folder_.read("count"));
    };
    EXPECT_GE(instructions("(mul|add|sub)pd"), 529) << command;  // 273 products, 256 sums
    EXPECT_EQ(instructions("(mul|add|sub|div)sd"), 0) << command;
  }
}

TEST_F(Python, TheEntriesOfQuaternionsHaveNames) {
  generate("docs/examples/ball_wrist.toml --functions inverse_dynamics,forward_dynamics");
  build("ball_wrist");
  EXPECT_EQ(run(R"py(
import numpy as np
import ball_wrist as arm
assert arm.position_names == ("waist", "shoulder", "wrist.qw", "wrist.qx", "wrist.qy", "wrist.qz", "knuckle", "slide")
assert arm.joint_names[2:5] == ("wrist.wx", "wrist.wy", "wrist.wz")
rng = np.random.default_rng(1)
q, v, a = (rng.uniform(-1, 1, (5, n)) for n in (8, 7, 7))
q[:, 2:6] /= np.linalg.norm(q[:, 2:6], axis=1, keepdims=True)
tau = arm.inverse_dynamics(q, v, a)
assert np.abs(arm.forward_dynamics(q, v, tau) - a).max() < 1e-9
)py"),
            0)
      << folder_.read("log");
}

// 32 joints in one block of lanes; the compiler must stay fast.
TEST_F(Python, LargeRobotsCompile) {
  generate("robots/humanoid32.urdf --functions inverse_dynamics,inertia_matrix,forward_dynamics --max-lines 500");
  build("humanoid32");
  EXPECT_EQ(run(kSingleCalls + std::string(R"py(
import humanoid32 as robot
q, qd, qdd = np.random.default_rng(1).uniform(-1, 1, (3, 10, len(robot.joint_names)))
tau = robot.inverse_dynamics(q, qd, qdd)
assert np.allclose(tau, [single(robot, "inverse_dynamics", [32], *row) for row in zip(q, qd, qdd)], rtol=0, atol=1e-9)
assert np.abs(robot.forward_dynamics(q, qd, tau) - qdd).max() < 1e-7
)py")),
            0)
      << folder_.read("log");
}

// Square roots, and rows without a result beside rows with one.
TEST_F(Python, RowsWithoutAResultAreNotNumbersAndOthersAre) {
  folder_.write("angles.toml", "orientation = \"rpy\"\n");
  generate(fmt::format("robots/ur5.urdf --functions operational_bias --scene '{}'", folder_.path("angles.toml")));
  build("ur5");
  EXPECT_THAT(folder_.read("ur5_batch.c"), HasSubstr("ur5_lanes_sqrt("));
  EXPECT_EQ(run(kSingleCalls + std::string(R"py(
import ur5
rng = np.random.default_rng(1)
q, qd = rng.uniform(0.3, 1.2, (2, 21, 6))
q[3] = np.inf
q[4, 2] = np.nan
c, g = ur5.operational_bias(q, qd)
for k in range(21):
    c_k, g_k = single(ur5, "operational_bias", [6, 6], q[k], qd[k])
    if k in (3, 4):
        assert np.isnan(c[k]).all() and np.isnan(g[k]).all()
    else:
        assert np.allclose(c[k], c_k, rtol=1e-9) and np.allclose(g[k], g_k, rtol=1e-9), k
)py")),
            0)
      << folder_.read("log");
}

// Entries that a scene leaves out are 0, and no compiler warns about an array that is not filled.
TEST_F(Python, WhatASceneLeavesOutIsZero) {
  folder_.write("few.toml", "[outputs]\ninverse_dynamics = [\"tau[0]\", \"tau[2]\"]\n");
  generate(fmt::format("robots/panda.urdf --scene '{}' --name arm", folder_.path("few.toml")));
  build("arm");
  EXPECT_EQ(run(R"py(import numpy as np, arm
tau = arm.inverse_dynamics(*np.random.default_rng(1).uniform(-1, 1, (3, 19, 7)))
assert (tau[:, [1, 3, 4, 5, 6]] == 0).all() and (tau[:, [0, 2]] != 0).all()
)py"),
            0)
      << folder_.read("log");
}

// q has the positions of all joints, qd and tau have those of the crank.
TEST_F(Python, ClosesLoops) {
  generate("robots/slider_crank.toml");
  build("slider_crank");
  EXPECT_EQ(run(R"py(import numpy as np, slider_crank as arm
q = arm.close_loops([0.3, -0.4, 0.4])
assert np.abs(arm.loop_closure(q)).max() < 1e-12 and q[0] == 0.3 and q[1] < 0
rows = np.array([arm.close_loops([angle, -angle, 0.4]) for angle in np.linspace(0.1, 1.2, 20)])
tau = arm.inverse_dynamics(rows, np.full((20, 1), 2.0), np.zeros((20, 1)))
assert tau.shape == (20, 1) and np.abs(arm.forward_dynamics(rows, np.full((20, 1), 2.0), tau)).max() < 1e-10
for wrong in ([0.3, -0.4], [0.3, np.nan, 0.4]):
    try:
        arm.close_loops(wrong)
        raise SystemExit(1)
    except ValueError:
        pass
assert "singular" in arm.loop_step.__doc__ and "definite" not in arm.loop_step.__doc__
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
  EXPECT_EQ(run_flatdyn("generate robots/pendulum_motor.toml --python --name lambda -o /nowhere/at/all").code, 2);
  for (const std::string name : {"numpy", "ctypes", "random"}) {
    const Outcome outcome =
        run_flatdyn("generate robots/pendulum_motor.toml --python --name " + name + " -o /nowhere/at/all");
    EXPECT_EQ(outcome.code, 2) << name;
    EXPECT_THAT(outcome.err, HasSubstr("Python has a module \"" + name + "\", in whose place")) << name;
    EXPECT_THAT(outcome.err, HasSubstr("--name " + name + "_robot")) << name;
  }
}

}  // namespace
}  // namespace flatdyn::testing
