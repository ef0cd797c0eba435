// SPDX-License-Identifier: GPL-2.0-or-later
// A module, its library and its Parameters after a change of the robot: parts that no longer fit are refused.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "cli/python.hpp"

namespace flatdyn::testing {
namespace {

// Compiles with the command that the module names, as a reader of it would.
constexpr const char* kMakesAnew = R"py(import os, subprocess, sys
sys.dont_write_bytecode = True  # what has the same second and size is the same to Python
def generate(robot):
    subprocess.run([os.environ["FLATDYN"], "generate", robot, "-q", "--python", "-o", ".", "--name", "arm",
                    "--namespace", "arm", "--functions", "gravity,inertia_matrix"], check=True, stdout=subprocess.DEVNULL)

def compile():
    text = open("arm.py").read()
    command = text[text.index("cc -std=c99"):]
    subprocess.run(command[:command.index("\n")], shell=True, check=True)

def refused(call, error, *words):
    try:
        call()
    except error as failure:
        assert all(word in str(failure) for word in words), failure
    else:
        raise SystemExit("not refused: " + str(words))
)py";

class PythonAnew : public Python {
 protected:
  void SetUp() override {
    Python::SetUp();
    ::setenv("FLATDYN", FLATDYN_PROGRAM, 1);
    write_pendulum("light", 1, 1), write_pendulum("heavy", 2, 1), write_pendulum("double", 1, 2);
  }

  // Writes a pendulum with masses of `mass` kg at the ends of horizontal links of 1 m each.
  void write_pendulum(const std::string& name, int mass, int links) const {
    std::string text = "name = \"arm\"\ngravity = [0, -10, 0]\ndh = \"standard\"\n";
    for (int k = 0; k < links; ++k) {
      text += fmt::format(
          "[[link]]\njoint = \"j{}\"\na = 1\nmass = {}\ninertia = {{ zz = 1 }}\n"
          "inertia_about = \"com\"\n",
          k, mass);
    }
    folder_.write(name + ".toml", text);
  }
};

TEST_F(PythonAnew, AStaleLibraryIsRefusedAndReloadGivesTheNewRobot) {
  EXPECT_EQ(run(kMakesAnew + std::string(R"py(import importlib
generate("light.toml")
compile()
import arm
assert arm.gravity([0.0]) == [10.0]
old = arm.gravity

generate("heavy.toml")
refused(lambda: importlib.reload(arm), ImportError, "libarm.so was compiled from another text", "cc -std=c99")
assert arm.gravity([0.0]) == [10.0]  # nothing has changed
compile()
importlib.reload(arm)
assert arm.gravity([0.0]) == [20.0] and old([0.0]) == [10.0]

generate("double.toml")
refused(lambda: importlib.reload(arm), ImportError, "cc -std=c99")
compile()
importlib.reload(arm)
assert len(arm.joint_names) == 2 and list(arm.gravity([0.0, 0.0])) == [30.0, 10.0]
assert old([0.0]) == [10.0]  # a function that was kept computes what it did
refused(lambda: arm.gravity([0.0]), ValueError, "(2,)")
)py")),
            0)
      << folder_.read("log");
}

// Another process has nothing to reload; a library from before hashes existed is refused, too.
TEST_F(PythonAnew, AStaleLibraryIsRefusedOnImport) {
  EXPECT_EQ(run(kMakesAnew + std::string(R"py(import sys
def python(code):
    return subprocess.run([sys.executable, "-B", "-c", code], stderr=subprocess.PIPE, text=True).stderr

generate("light.toml")
compile()
assert python("import arm") == ""
generate("double.toml")
assert "ImportError" in python("import arm") and "make it in" in python("import arm")
compile()
assert python("import arm; assert len(arm.joint_names) == 2") == ""
subprocess.run("cc -shared -fPIC arm.c -o libarm.so -lm", shell=True, check=True)
assert "ImportError" in python("import arm")
)py")),
            0)
      << folder_.read("log");
}

TEST_F(PythonAnew, ParametersAreAllThereAndNoOthers) {
  folder_.write("open.toml",
                "name = \"arm\"\ngravity = [0, \"-g\", 0]\ndh = \"standard\"\n[[link]]\njoint = \"j\"\na = \"self\"\n"
                "mass = \"m_1\"\ninertia = { zz = \"2*c*m_0\" }\ninertia_about = \"com\"\n");
  EXPECT_EQ(run(kMakesAnew + std::string(R"py(
generate("open.toml")
compile()
import arm
given = arm.Parameters(g=10, self=1, m_1=2, c=0, m_0=0)
assert arm.gravity(given, [0.0]) == [20.0]
assert repr(given) == "Parameters(g=10.0 m/s^2, self=1.0 m, m_1=2.0 kg, c=0.0, m_0=0.0)", repr(given)
refused(lambda: arm.Parameters(g=10, self=1, m_11=2, c=0, m_0=0), TypeError, "unknown: m_11", "missing: m_1")
refused(lambda: arm.Parameters(), TypeError, "missing: g, self, m_1, c, m_0")
refused(lambda: arm.Parameters(10, 1, 2, 0, 0), TypeError)
refused(lambda: setattr(given, "m_11", 2), AttributeError)
refused(lambda: arm.Parameters(g="10", self=1, m_1=2, c=0, m_0=0), TypeError)
class Others(arm.ctypes.Structure):
    _fields_ = [("x", arm.ctypes.c_double)]
for wrong in (Others(), {"g": 10}, [0.0], None):
    refused(lambda: arm.gravity(wrong, [0.0]), TypeError, "Parameters of this module")
)py")),
            0)
      << folder_.read("log");
}

}  // namespace
}  // namespace flatdyn::testing
