// SPDX-License-Identifier: GPL-2.0-or-later
// The JavaScript of every robot, run by Node, against its graph in 50 digits: rounding errors are as small as in the
// C++ form. It is tested whole, and with bodies in parts.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "code/lower/arguments.hpp"
#include "functions/deviation/expected.hpp"
#include "functions/planning/make_functions.hpp"
#include "golden/golden.hpp"
#include "support/emitted_forms.hpp"
#include "support/robot_models.hpp"
#include "truth/reference/graph_evaluator.hpp"

namespace flatdyn::testing {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kStates = 5;
constexpr double kBound = 16;  // units, as in verify

// Results by function and state; NaN for an entry that is not written, or if the function returns false.
constexpr const char* kScript = R"js(import * as robot from './robot.mjs';
import {readFileSync, writeFileSync} from 'node:fs';
const {functions, states} = JSON.parse(readFileSync('states.json'));
const call = (of, state) => {
  const outputs = of.lengths.map((length) => new Float64Array(length).fill(NaN));
  const inputs = of.inputs.map((name) => state[name]);
  const names = robot.parameter_names ?? [];
  if (names.length > 0) inputs.unshift(Object.fromEntries(names.map((name, k) => [name, state.parameters[k]])));
  const result = robot[of.name](...inputs, ...outputs);
  if (of.lengths.length === 0) return [result];
  return outputs.flatMap((output) => result === false ? [...output].fill(NaN) : [...output]);
};
writeFileSync('results.json', JSON.stringify(functions.map((of) => states.map((state) => call(of, state)))));
)js";

bool has_node() { return std::system("node --version > /dev/null 2>&1") == 0; }

std::vector<Function> functions_to_run(const LoadedRobot& model) {
  PipelineOptions options;
  // The humanoid is tested in part: its 16896 Christoffel symbols take long in 50 digits.
  if (model.mechanism.size() > 20) {
    options.functions = {"inverse_dynamics", "inertia_matrix", "gravity", "forward_dynamics", "jacobian"};
  }
  Progress quiet(true);
  Diagnostics left_out;
  return functions_of(make_functions(model, options, quiet, left_out));
}

json calls_of(const std::vector<Function>& functions) {
  json calls = json::array();
  for (const Function& function : functions) {
    json call = {{"name", function.name}, {"inputs", json::array()}, {"lengths", json::array()}};
    for (const InputKind kind : function.inputs) call["inputs"].push_back(input_argument(kind, 0).name);
    for (const Output& output : function.outputs) {
      if (!returns_value(function)) call["lengths"].push_back(output.entries.size());
    }
    calls.push_back(std::move(call));
  }
  return calls;
}

json states_as_json(const std::vector<State>& states) {
  json list = json::array();
  for (const State& state : states) {
    list.push_back({{"q", state.q},
                    {"qd", state.qd},
                    {"qdd", state.qdd},
                    {"tau", state.tau},
                    {"h_e", state.h_e},
                    {"parameters", state.parameters}});
  }
  return list;
}

std::vector<double> numbers(const json& list) {
  std::vector<double> values;
  for (const json& entry : list) values.push_back(entry.is_null() ? std::nan("") : entry.get<double>());
  return values;
}

// The largest scaled error of each function is small.
void expect_small_errors(const std::string& robot, int most_lines) {
  const LoadedRobot model = model_of(robot);
  const std::vector<Function> functions = functions_to_run(model);
  const ExpectedValues expected(model.robot, model.mechanism, 1);
  const std::vector<State> states = with_parameters(random_states(model.mechanism, kStates, 1), expected.symbols());
  EmitOptions options;
  options.most_lines = most_lines;
  const TemporaryFolder folder;
  write(folder.path() / "robot.mjs", emit_javascript(model.mechanism, functions, options));
  write(folder.path() / "run.mjs", kScript);
  write(folder.path() / "states.json",
        json({{"functions", calls_of(functions)}, {"states", states_as_json(states)}}).dump());
  const std::string command = fmt::format("cd '{}' && node run.mjs > log 2>&1", folder.path().string());
  ASSERT_EQ(std::system(command.c_str()), 0) << content_of(folder.path() / "log");
  const json results = json::parse(content_of(folder.path() / "results.json"));
  ASSERT_EQ(results.size(), functions.size());
  for (std::size_t f = 0; f < functions.size(); ++f) {
    GraphEvaluator<Real50> graph(functions[f]);
    const Expected of_function = expected.of(functions[f]);
    for (std::size_t k = 0; k < states.size(); ++k) {
      const auto truth = graph(widened<Real50>(states[k]));
      ASSERT_TRUE(truth) << functions[f].name;
      const std::vector<double> values = numbers(results[f][k]);
      ASSERT_EQ(values.size(), truth->size()) << functions[f].name;
      EXPECT_LE(scaled_error(values, *truth, of_function.scale(states[k])), kBound)
          << robot << " " << functions[f].name;
    }
  }
}

class JavascriptForm : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (!has_node()) GTEST_SKIP() << "Node is not installed: scripts/setup";
  }
};

TEST_P(JavascriptForm, HasTheErrorsOfDouble) { expect_small_errors(GetParam(), 0); }

INSTANTIATE_TEST_SUITE_P(Robots, JavascriptForm, ::testing::ValuesIn(robot_files()),
                         [](const auto& test) { return test.param.substr(0, test.param.find('.')); });

class JavascriptFormInParts : public JavascriptForm {};

TEST_P(JavascriptFormInParts, HasTheErrorsOfDouble) { expect_small_errors(GetParam(), 40); }

INSTANTIATE_TEST_SUITE_P(Robots, JavascriptFormInParts, ::testing::Values("scara.toml", "planar_2r.toml", "ur5.urdf"),
                         [](const auto& test) { return test.param.substr(0, test.param.find('.')); });

}  // namespace
}  // namespace flatdyn::testing
