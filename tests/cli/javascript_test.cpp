// SPDX-License-Identifier: GPL-2.0-or-later
// `flatdyn generate --language javascript`: Node imports the module, which behaves as its text says.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

using ::testing::HasSubstr;

class Javascript : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system("node --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "Node is not installed: scripts/setup";
    folder_.write("package.json", R"({"type": "module"})");
  }

  void generate(const std::string& arguments) const {
    const Outcome outcome =
        run_flatdyn(fmt::format("generate {} --language javascript -o '{}'", arguments, folder_.path()));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("the text, read back, says the same"));
  }

  int run(const std::string& script) const {
    folder_.write("script.js", "import assert from 'node:assert';\n" + script);
    return std::system(fmt::format("cd '{}' && node script.js > log 2>&1", folder_.path()).c_str());
  }

  Scratch folder_;
};

TEST_F(Javascript, IsAModule) {
  generate("robots/panda.urdf --functions inverse_dynamics,forward_dynamics,inertia_matrix,kinetic_energy");
  EXPECT_EQ(run(R"js(import * as panda from './panda.js';
const q = [0.1, -0.2, 0.3, -1.5, 0.5, 1.2, 0.4], qd = [1, 2, -1, 0.5, 0.2, -0.3, 1], qdd = [1, 2, 3, 4, 5, 6, 7];
const tau = new Float64Array(panda.joint_count), back = [], B = new Float64Array(49);
panda.inverse_dynamics(q, qd, qdd, tau);
assert.equal(panda.forward_dynamics(q, qd, tau, back), true);
back.forEach((value, k) => assert(Math.abs(value - qdd[k]) < 1e-9));
const zero = new Float64Array(7), zeros = new Float64Array(7), apart = [], together = [];
panda.inverse_dynamics(q, zero, zeros, apart);
panda.inverse_dynamics(q, zero, zero, together);
assert.deepEqual(together, apart);
panda.inertia_matrix(q, B);
let T = 0;
for (let i = 0; i < 7; ++i) for (let j = 0; j < 7; ++j) T += qd[i] * B[7 * i + j] * qd[j] / 2;
assert(Math.abs(panda.kinetic_energy(q, qd) - T) < 1e-13);
assert.equal(panda.joint_names[0], 'panda_joint1');
assert.equal(panda.position_upper[0], 2.8973);
)js"),
            0)
      << folder_.read("log");
}

// Arrays of other lengths throw, in inputs and outputs; an output may be an empty Array, which grows.
TEST_F(Javascript, RefusesWrongLengths) {
  generate("robots/planar_2r.toml --functions gravity,forward_dynamics --name arm");
  EXPECT_EQ(run(R"js(import * as arm from './arm.js';
const one = Object.fromEntries(arm.parameter_names.map((name) => [name, 1]));
const g = new Float64Array(2), grown = [];
arm.gravity(one, [0, 0], grown);
arm.gravity(one, new Float64Array(2), g);
assert.equal(grown.length, 2);
assert.throws(() => arm.gravity(one, [0], g), new RangeError('gravity: q has 1 entries instead of 2'));
assert.throws(() => arm.gravity(one, [], g), RangeError);
assert.throws(() => arm.gravity(one, [0, 0], new Float64Array(0)), RangeError);
assert.throws(() => arm.gravity(one, [0, 0], [1, 2, 3]), new RangeError('gravity: g has 3 entries instead of 2'));
assert.throws(() => arm.forward_dynamics(one, [0, 0], [0, 0], [0, 0, 0], g),
    new RangeError('forward_dynamics: tau has 3 entries instead of 2'));
)js"),
            0)
      << folder_.read("log");
}

// Every export has a type of its name, and nothing else has.
TEST_F(Javascript, HasTypes) {
  generate("robots/planar_2r.toml --functions gravity,forward_dynamics,kinetic_energy,inertia_matrix --name arm");
  const std::string types = folder_.read("arm.d.ts");
  EXPECT_THAT(types, HasSubstr("export declare function gravity(parameters: Parameters, q: ArrayLike<number>, g: "
                               "Numbers): void;"));
  EXPECT_THAT(types, HasSubstr("tau: ArrayLike<number>, qdd: Numbers): boolean;"));
  EXPECT_THAT(types, HasSubstr("): number;"));
  EXPECT_THAT(types, HasSubstr("\n  g: number;"));
  EXPECT_EQ(run(R"js(import * as arm from './arm.js';
import fs from 'node:fs';
const text = fs.readFileSync('arm.d.ts', 'utf8');
const declared = [...text.matchAll(/export declare (?:const|function) (\w+)/g)].map((match) => match[1]);
assert.deepEqual(declared.sort(), Object.keys(arm).sort());
for (const [, name, type] of text.matchAll(/export declare const (\w+): (.*);/g)) {
  const value = arm[name];
  assert(type === 'number' ? typeof value === 'number'
      : Array.isArray(value) && value.every((entry) => `readonly ${typeof entry}[]` === type), name);
}
)js"),
            0)
      << folder_.read("log");
}

// The angles of the tip need a square root. Torques in the null space exert nothing along them, (7.140).
TEST_F(Javascript, TakesSquareRoots) {
  folder_.write("scene.toml", "orientation = \"rpy\"\ntask = [\"theta\", \"psi\"]\n");
  generate("robots/ur5.urdf --functions operational_inertia,null_space_torque --scene '" + folder_.path("scene.toml") +
           "'");
  EXPECT_THAT(folder_.read("ur5.js"), HasSubstr("Math.sqrt("));
  EXPECT_EQ(run(R"js(import * as ur5 from './ur5.js';
const q = [0.3, -1, 0.7, 1.1, -0.4, 2], B_A = [], J_bar = [], condition = [], rest = [], again = [];
assert.equal(ur5.operational_inertia(q, B_A, J_bar, condition), true);
assert(Math.abs(B_A[1] - B_A[2]) === 0 && B_A[0] > 0 && condition[0] > 0 && condition[0] < 1);
assert.equal(ur5.null_space_torque(q, [1, 2, 3, 4, 5, 6], rest), true);
for (let j = 0; j < 2; ++j) {
  let force = 0;
  for (let k = 0; k < 6; ++k) force += J_bar[2 * k + j] * rest[k];
  assert(Math.abs(force) < 1e-12, String(force));
}
)js"),
            0)
      << folder_.read("log");
}

// The robot has free symbols, and a B that is not positive definite.
TEST_F(Javascript, TakesParametersAndSaysWhereThereIsNoResult) {
  generate("robots/planar_2r.toml --functions gravity,forward_dynamics --name arm --max-lines 40");
  EXPECT_EQ(run(R"js(import * as arm from './arm.js';
const none = Object.fromEntries(arm.parameter_names.map((name) => [name, 0]));
const level = {...none, g: 9.81, m_l1: 2, l_1: 1, a_1: 1, m_l2: 1, l_2: 1}, g = [];
arm.gravity(level, [0, 0], g);
assert.deepEqual(g, [4 * 9.81, 9.81]);
assert.equal(arm.forward_dynamics(level, [0, 1], [0, 0], g, []), true);
assert.equal(arm.forward_dynamics(none, [0, 1], [0, 0], g, []), false);
assert.equal(arm.forward_dynamics({}, [0, 1], [0, 0], g, []), false);
)js"),
            0)
      << folder_.read("log");
}

TEST_F(Javascript, KeepsNamesThatWouldEndStrings) {
  folder_.write("arm.toml", R"toml(name = "*/ </script>"
dh = "standard"
[[link]]
joint = '"`é</script>\'
a = "Math"
mass = "let"
inertia = { zz = "yield" }
inertia_about = "com"
)toml");
  const Outcome outcome =
      run_flatdyn(fmt::format("generate '{0}/arm.toml' -q --language javascript --name arm -o '{0}'", folder_.path()));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(run(R"js(import * as arm from './arm.js';
assert.deepEqual(arm.joint_names, ['"`\u00e9<' + '/script>\\']);
assert.deepEqual(arm.parameter_names, ['Math', 'let', 'yield']);
)js"),
            0)
      << folder_.read("log");
}

// Unicode's line separators end a comment in JavaScript.
TEST(JavascriptUsage, CommentsEndWhereTheyShould) {
  const Scratch scratch;
  scratch.write("arm.toml",
                "name = \"arm\"\n[[link]]\njoint = \"j\\u2028globalThis.escaped = 1; //\"\nmass = 1\n"
                "com = [1, 0, 0]\ninertia = { xx = 1, yy = 1, zz = 1 }\ninertia_about = \"com\"\n");
  const Outcome outcome =
      run_flatdyn(fmt::format("generate {} --language javascript -q -o {}", scratch.path("arm.toml"), scratch.path()));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(scratch.read("arm.js"), HasSubstr("globalThis.escaped"));
  EXPECT_THAT(scratch.read("arm.js"), Not(HasSubstr("\u2028globalThis")));
}

TEST(JavascriptUsage, WhatItHasNotIsRefused) {
  for (const char* option : {"--scalar float", "--namespace a", "--stages gravity,bias", "--python"}) {
    const Outcome outcome = run_flatdyn(
        fmt::format("generate robots/pendulum_motor.toml --language javascript {} -o /nowhere/at/all", option));
    EXPECT_EQ(outcome.code, 2) << option;
    EXPECT_THAT(outcome.err, HasSubstr("hint: ")) << option;
  }
}

}  // namespace
}  // namespace flatdyn::testing
