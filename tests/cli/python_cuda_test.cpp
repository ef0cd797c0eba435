// SPDX-License-Identifier: GPL-2.0-or-later
// The module for Python over the CUDA form, on the host: its library is made by a compiler without CUDA, and arrays of
// the host pretend to be on the device.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

constexpr const char* kModuleScript = R"(
import ctypes


class Array:
    def __init__(self, shape, values=(), typestr="<f8"):
        count = 1
        for axis in shape:
            count *= axis
        self.data = ((ctypes.c_bool if typestr == "|b1" else ctypes.c_double) * count)(*values)
        self.__cuda_array_interface__ = {"shape": shape, "typestr": typestr, "version": 3, "strides": None,
                                         "data": (ctypes.addressof(self.data), False)}


import panda

n = 3
numbers = [((k * 37) % 19) / 9 - 1 for k in range(7 * n)]
by_column = [numbers[k * 7 + i] for i in range(7) for k in range(n)]
q, tau = Array((n, 7), numbers), Array((n, 7))
panda.inverse_dynamics(q, q, q, tau)
expected = [tau.data[k * 7 + i] for i in range(7) for k in range(n)]
q_columns, tau_columns = Array((7, n), by_column), Array((7, n))
panda.inverse_dynamics(q_columns, q_columns, q_columns, tau_columns, layout="columns")
assert list(tau_columns.data) == expected
q_tiles, tau_tiles = Array((1, 7, 32)), Array((1, 7, 32))
for i in range(7):
    for k in range(n):
        q_tiles.data[i * 32 + k] = by_column[i * n + k]
panda.inverse_dynamics(q_tiles, q_tiles, q_tiles, tau_tiles, layout="tiles", states=n)
assert [tau_tiles.data[i * 32 + k] for i in range(7) for k in range(n)] == expected
qdd, valid, energy = Array((n, 7)), Array((n,), typestr="|b1"), Array((n,))
panda.forward_dynamics(q, q, tau, qdd, valid=valid)
assert all(valid.data) and max(abs(a - b) for a, b in zip(qdd.data, numbers)) < 1e-11
panda.kinetic_energy(q, q, energy)
assert all(each > 0 for each in energy.data)
for wrong in (lambda: panda.inverse_dynamics(q, q, q, energy), lambda: panda.inverse_dynamics(q, q, q, [0.0] * 21),
              lambda: panda.inverse_dynamics(q, q, q, tau, layout="diagonals"),
              lambda: panda.inverse_dynamics(q, q, q, tau, states=4),
              lambda: panda.inverse_dynamics([0.0] * 21, q, q, tau), lambda: panda.inverse_dynamics(q, q, q, tau, layout=[]),
              lambda: panda.inverse_dynamics(q, q, q, tau_columns),
              lambda: panda.inverse_dynamics(q, q_columns, q, tau),
              lambda: panda.inverse_dynamics(q, q, q, Array((21,))),
              lambda: panda.inverse_dynamics(q_columns, q, q_columns, tau_columns, layout="columns"),
              lambda: panda.inverse_dynamics(q_tiles, q_tiles, q_tiles, Array((1, 32, 7)), layout="tiles"),
              lambda: panda.inverse_dynamics(q, q, q, tau, stream=object()),
              lambda: panda.inverse_dynamics(q, q, tau, tau), lambda: panda.inverse_dynamics(q, q, q, q),
              lambda: panda.inverse_dynamics(q, q, q, tau, states="3"),
              lambda: panda.forward_dynamics(q, q, q, qdd, valid=()),
              lambda: panda.forward_dynamics(q, q, q, qdd, valid=tau)):
    try:
        wrong()
    except (TypeError, ValueError):
        pass
    else:
        raise SystemExit("no error")
print("all hold")
)";

TEST(PythonCuda, ModuleComputesInEveryLayout) {
  const Scratch scratch;
  ASSERT_EQ(run_flatdyn("generate -q robots/panda.urdf --language cuda --python --functions "
                        "inverse_dynamics,forward_dynamics,kinetic_energy -o " +
                        scratch.path("."))
                .code,
            0);
  std::ofstream(scratch.path("check.py")) << kModuleScript;
  const std::string command = "cd " + scratch.path(".") +
                              " && c++ -x c++ -std=c++17 -O1 -Wall -Wextra -Wpedantic -Werror -shared -fPIC "
                              "-I " FLATDYN_SOURCE_DIR
                              "/runtime/include panda_python.cu -o libpanda.so && python3 check.py > out 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << scratch.read("out");
  EXPECT_THAT(scratch.read("out"), EndsWith("all hold\n"));
}

// A body without joints has a q without entries, which is left out.
TEST(PythonCuda, IsForBodiesWithoutJoints) {
  const Scratch scratch;
  std::ofstream(scratch.path("drone.urdf"))
      << R"(<robot name="drone"><link name="body"><inertial><origin xyz="0 0 0.1"/><mass value="2"/>
            <inertia ixx="1" ixy="0" ixz="0" iyy="2" iyz="0" izz="2"/></inertial></link></robot>)";
  ASSERT_EQ(
      run_flatdyn("generate -q " + scratch.path("drone.urdf") +
                  " --base floating --language cuda --python --functions inverse_dynamics -o " + scratch.path("."))
          .code,
      0);
  EXPECT_THAT(scratch.read("drone.py"), HasSubstr("def inverse_dynamics(g_b, v, a, tau, layout="));
  const std::string command = "cd " + scratch.path(".") +
                              " && c++ -x c++ -std=c++17 -Wall -Wextra -Wpedantic -Werror -fsyntax-only "
                              "-I " FLATDYN_SOURCE_DIR "/runtime/include drone_python.cu";
  EXPECT_EQ(std::system(command.c_str()), 0);
}

TEST(PythonCuda, IsSeveralFiles) {
  EXPECT_EQ(run_flatdyn("generate -q robots/scara.toml --language cuda --python -o -").code, 2);
}

TEST(PythonCuda, IsNotForFreeSymbols) {
  const Scratch scratch;
  const Outcome outcome =
      run_flatdyn("generate -q robots/planar_2r.toml --language cuda --python -o " + scratch.path("out"));
  EXPECT_EQ(outcome.code, 2);
}

}  // namespace
}  // namespace flatdyn::testing
