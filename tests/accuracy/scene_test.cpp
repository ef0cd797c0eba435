// SPDX-License-Identifier: GPL-2.0-or-later
// The terms that a scene removes cost nothing, and the rest has the values of the general function.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "base/system/temporary_folder.hpp"
#include "functions/planning/make_functions.hpp"
#include "graph/count.hpp"
#include "truth/reference/graph_evaluator.hpp"

namespace flatdyn {
namespace {

using Values = std::vector<Real50>;
using State50 = StateOf<Real50>;

// Constants are rationals within 1e-40 of the written ones.
const Real50 kTolerance("1e-34");

struct Case {
  const char* robot;
  const char* joint;  // the joint that is held
  std::size_t index;  // its index
  const char* position;
};

std::string name_of(const ::testing::TestParamInfo<Case>& info) {
  std::string name = info.param.robot;
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
}

class InAScene : public ::testing::TestWithParam<Case> {
 protected:
  // The fixture has the robot with friction in every joint.
  InAScene() {
    const std::string robot = std::string(FLATDYN_SOURCE_DIR "/robots/") + GetParam().robot;
    std::ofstream file(path());
    file << "robot = \"" << robot << "\"\n";
    for (const Body& body : load_robot(robot, {}).mechanism.bodies) {
      file << "[[joint]]\nname = \"" << body.joint << "\"\nviscous = 0.3\ncoulomb = 0.2\n";
    }
  }

  std::filesystem::path path() const { return folder_.path() / "with_friction.toml"; }

  Function make(const std::string& function, const Scene& scene = {}) {
    PipelineOptions options;
    options.functions = {function};
    options.read.scene = scene;
    model_ = load_robot(path(), options);
    Progress quiet(true);
    Diagnostics findings;
    return make_functions(*model_, options, quiet, findings).at(0).function;
  }

  const Mechanism& mechanism() const { return model_->mechanism; }

  std::vector<State50> states() const {
    std::vector<State50> wide;
    for (const State& state : random_states(mechanism(), 3, 7)) {
      wide.push_back(widened<Real50>(state));
      for (std::size_t k = 0; k < mechanism().symbols.size(); ++k) wide.back().parameters.push_back(Real50(k + 2) / 8);
    }
    return wide;
  }

  static Values values(const Function& function, const State50& state) {
    return GraphEvaluator<Real50>(function)(state).value();
  }

  static void expect_equal(const Values& a, const Values& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) EXPECT_LT(abs(a[k] - b[k]), kTolerance * (1 + abs(b[k]))) << k;
  }

  static void expect_fewer_operations(const Function& scene, const Function& general) {
    const OperationCount fewer = count_operations(scene), all = count_operations(general);
    EXPECT_LT(fewer.arithmetic(), all.arithmetic());
    EXPECT_LE(fewer.trigonometric, all.trigonometric);
  }

 private:
  TemporaryFolder folder_;
  std::optional<LoadedRobot> model_;
};

TEST_P(InAScene, AJointIsHeld) {
  Scene scene;
  scene.locked = {{GetParam().joint, exact_decimal(GetParam().position), GetParam().position}};
  const Function general = make("inverse_dynamics");
  std::vector<State50> full = states();
  const Function held = make("inverse_dynamics", scene);
  expect_fewer_operations(held, general);
  for (State50& state : full) {
    const auto i = static_cast<std::ptrdiff_t>(GetParam().index);
    state.q[GetParam().index] = Real50(GetParam().position);
    state.qd[GetParam().index] = state.qdd[GetParam().index] = 0;
    Values expected = values(general, state);
    for (Values* each : {&expected, &state.q, &state.qd, &state.qdd}) each->erase(each->begin() + i);
    expect_equal(values(held, state), expected);
  }
}

TEST_P(InAScene, GravityIsOff) {
  Scene scene;
  scene.gravity = zero_vector();
  const Function general = make("inverse_dynamics"), gravity = make("gravity");
  const Function without = make("inverse_dynamics", scene);
  expect_fewer_operations(without, general);
  for (const State50& state : states()) {
    Values expected = values(general, state);
    const Values g = values(gravity, state);
    for (std::size_t k = 0; k < g.size(); ++k) expected[k] -= g[k];
    expect_equal(values(without, state), expected);
  }
}

TEST_P(InAScene, TheRobotIsAtRest) {
  Scene scene;
  scene.at_rest = true;
  const Function general = make("inverse_dynamics");
  const Function still = make("inverse_dynamics", scene);
  expect_fewer_operations(still, general);
  for (const Input& input : inputs_read(still)) EXPECT_NE(input.kind, InputKind::qd);
  for (const State50& state : states()) {
    State50 rest = state;
    rest.qd.assign(rest.qd.size(), 0);
    expect_equal(values(still, state), values(general, rest));
  }
  for (const char* name : {"coriolis_matrix", "kinetic_energy", "jacobian_dot_qd"}) {
    EXPECT_EQ(count_operations(make(name, scene)), OperationCount{}) << name;
  }
}

TEST_P(InAScene, SomeEntriesAreDropped) {
  Scene scene;
  scene.outputs = {{{"inverse_dynamics", {}}, {{"tau[1]", {}}}}, {{"inertia_matrix", {}}, {{"B[1][1]", {}}}}};
  for (const char* name : {"inverse_dynamics", "inertia_matrix"}) {
    const Function general = make(name), part = make(name, scene);
    expect_fewer_operations(part, general);
    for (const State50& state : states()) {
      const Values expected = values(general, state);
      const std::size_t n = state.q.size(), entry = expected.size() == n ? 1 : n + 1;
      expect_equal(kept_values(part, values(part, state)), {expected[entry]});
    }
  }
}

TEST_P(InAScene, FrictionIsLeftOut) {
  Scene scene;
  scene.friction = false;
  const Function general = make("inverse_dynamics"), smooth = make("inverse_dynamics", scene);
  expect_fewer_operations(smooth, general);
  for (const State50& state : states()) {
    Values expected = values(general, state);
    for (std::size_t k = 0; k < expected.size(); ++k) {
      const Real50& rate = state.qd[k];
      expected[k] -= Real50("0.3") * rate + Real50("0.2") * (rate > 0 ? 1 : -1);
    }
    expect_equal(values(smooth, state), expected);
  }
}

// A body that moves with the tip adds its own kinetic energy: m v^2 / 2 of its centre of mass if it has no inertia.
TEST_P(InAScene, APayloadIsCarried) {
  Scene scene;
  ScenePayload payload;
  payload.inertial.mass.number = 2;
  payload.inertial.place = {"scene.toml", 1};
  scene.payload = payload;
  const Function before = make("kinetic_energy"), jacobian = make("jacobian:" + mechanism().tip.link);
  const Function after = make("kinetic_energy", scene);
  for (const State50& state : states()) {
    const Values J = values(jacobian, state);
    const std::size_t n = state.q.size();
    Real50 expected = values(before, state)[0];
    for (std::size_t row = 0; row < 3; ++row) {
      Real50 v = 0;
      for (std::size_t k = 0; k < n; ++k) v += J[row * n + k] * state.qd[k];
      expected += v * v;
    }
    expect_equal(values(after, state), {expected});
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, InAScene,
                         ::testing::Values(Case{"panda.urdf", "panda_joint4", 3, "-1.5"},
                                           Case{"ur5.urdf", "elbow_joint", 2, "1.25"},
                                           Case{"puma560.toml", "shoulder", 1, "-0.4"},
                                           Case{"planar_2r_example_7_2.toml", "theta_2", 1, "0.7"},
                                           Case{"scara.toml", "d_3", 2, "0.05"}),
                         name_of);

// README.md promises these counts for the example.
TEST(ExampleScene, TakesNoMoreOperations) {
  const std::string folder = FLATDYN_SOURCE_DIR;
  PipelineOptions options;
  options.read.scene_file = folder + "/docs/examples/panda_scene.toml";
  const LoadedRobot model = load_robot(folder + "/robots/panda.urdf", options);
  Progress quiet(true);
  Diagnostics findings;
  const std::vector<Function> functions = functions_of(make_functions(model, options, quiet, findings));
  ASSERT_EQ(functions.size(), 3U);
  const OperationCount torques = count_operations(functions[0]), inertia = count_operations(functions[1]);
  EXPECT_LE(torques.multiplications, 98);
  EXPECT_LE(torques.additions, 83);
  EXPECT_LE(inertia.multiplications, 45);
  EXPECT_LE(inertia.additions, 50);
}

}  // namespace
}  // namespace flatdyn
