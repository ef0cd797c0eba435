// SPDX-License-Identifier: GPL-2.0-or-later
// flatdyn bench: its measurements, output and files. Speed depends on the machine and is not tested.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

using nlohmann::json;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

// An arm with two skew joints, the second one prismatic, without rotors and friction, which KDL does not have.
constexpr const char* kArmText = R"(<robot name="arm">
  <link name="base"/>
  <link name="upper"><inertial><origin xyz="0.1 0.2 0.3"/><mass value="2"/>
    <inertia ixx="0.2" iyy="0.3" izz="0.25" ixy="0.01" ixz="0.02" iyz="0.03"/></inertial></link>
  <link name="lower"><inertial><origin xyz="0.3 0.1 0.2" rpy="0.1 0.2 0.3"/><mass value="1"/>
    <inertia ixx="0.1" iyy="0.15" izz="0.2" ixy="0.01" ixz="0.02" iyz="0.03"/></inertial></link>
  <joint name="turn" type="revolute"><parent link="base"/><child link="upper"/>
    <origin xyz="0.1 0 0.5" rpy="0.3 0.2 0.1"/><axis xyz="0 1 1"/>
    <limit lower="-2" upper="2" velocity="3" effort="50"/></joint>
  <joint name="slide" type="prismatic"><parent link="upper"/><child link="lower"/>
    <origin xyz="0.2 0.3 0" rpy="0 0.7 0"/><axis xyz="1 0 0"/>
    <limit lower="0" upper="0.5" velocity="1" effort="50"/></joint>
</robot>)";

const std::set<std::string> kPeers = {"KDL", "MuJoCo", "DART"};

bool is_installed(const std::string& package) {
  return std::system(("pkg-config --exists " + package + " > /dev/null 2>&1").c_str()) == 0;
}

bool mujoco_has(const std::string& function) {
  const bool is_dynamics = function != "forward_kinematics" && function != "jacobian";
  return is_dynamics && std::filesystem::exists("/usr/include/mujoco/mujoco.h");
}

void expect_well_formed(const std::string& svg) {
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse(svg.c_str()), tinyxml2::XML_SUCCESS);
  EXPECT_STREQ(document.RootElement()->Name(), "svg");
}

std::map<std::string, json> by_variant(const json& function) {
  std::map<std::string, json> rows;
  for (const json& row : function["variants"]) rows[row["variant"]] = row;
  return rows;
}

void expect_ordered_times(const json& function) {
  double last = 0;
  for (const json& row : function["variants"]) {
    const json& ns = row["ns"];
    EXPECT_GT(ns["low"], 0.0);
    EXPECT_LE(ns["low"], ns["median"]);
    EXPECT_LE(ns["median"], ns["high"]);
    EXPECT_GE(ns["median"], last) << "sorted by time";
    last = ns["median"];
    EXPECT_GE(row["rounds"], 5);
  }
}

// The errors in units of the last place: a few in double and for peers, 2^29 times as many in float. MuJoCo's are
// relative to its inertia.
void expect_small_errors(const std::map<std::string, json>& rows) {
  for (const auto& [name, row] : rows) {
    const double error = row["scaled_error"]["max"];
    const double bound = name == "float" || name == "cuda-float" ? 16 * 536870912.0 : name == "MuJoCo" ? 1e9 : 16;
    EXPECT_LE(error, bound) << name;
    EXPECT_LE(row["scaled_error"]["p99"], error) << name;
  }
}

// The CUDA form, compiled for the processor, has the bits of the C++ form.
void expect_same_errors(const json& cpp, const json& cuda) {
  for (const char* key : {"operations", "scaled_error", "error"}) EXPECT_EQ(cuda[key], cpp[key]) << key;
  EXPECT_GT(cuda["bytes"], 0);
}

void expect_stages_of(const json& stages, std::size_t functions) {
  EXPECT_EQ(stages["functions"].size(), functions);
  std::vector<std::string> names;
  for (const json& step : stages["steps"]) {
    names.push_back(step["name"]);
    EXPECT_GT(step["ns"]["median"], 0.0);
  }
  EXPECT_THAT(names, ElementsAre("at(q)", "with(qd)", "all in stages", "one by one"));
  EXPECT_LT(stages["steps"][2]["operations"]["mul"], stages["steps"][3]["operations"]["mul"]);
}

TEST(Bench, MeasuresVariantsAndPeersThatAgree) {
  const Scratch scratch;
  scratch.write("arm.urdf", kArmText);
  const Outcome outcome = run_flatdyn(fmt::format(
      "bench {} -q --json --time 0.02 --states 20 --variants "
      "double,double-given,double-staged,float,"
      "batch-double-given,cuda-double,cuda-float,KDL,MuJoCo,DART "
      "--functions inverse_dynamics,inertia_matrix,gravity,bias,forward_dynamics,forward_kinematics,jacobian "
      "-o {}",
      scratch.path("arm.urdf"), scratch.path("out")));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json result = json::parse(outcome.out);
  EXPECT_EQ(json::parse(scratch.read("out/bench.json")), result);
  expect_well_formed(scratch.read("out/bench.svg"));
  ASSERT_EQ(result["robots"].size(), 1u);
  const json& functions = result["robots"][0]["functions"];
  ASSERT_EQ(functions.size(), 7u);
  for (const json& function : functions) {
    const std::map<std::string, json> rows = by_variant(function);
    const bool has_angles = function["operations"]["sincos"] > 0;
    const bool has_dart = is_installed("dart");
    EXPECT_EQ(rows.size(), 5u + 2 * has_angles + is_installed("orocos-kdl") + mujoco_has(function["name"]) + has_dart)
        << function["name"];
    expect_ordered_times(function);
    expect_small_errors(rows);
    EXPECT_EQ(rows.at("double")["ratio"], 1.0);
    EXPECT_GT(rows.at("double")["bytes"], 0);
    expect_same_errors(rows.at("double"), rows.at("cuda-double"));
    expect_same_errors(rows.at("float"), rows.at("cuda-float"));
    EXPECT_FALSE(rows.at("double-staged")["front"]) << "it leaves out part of the work";
    EXPECT_LE(rows.at("double-staged")["operations"]["mul"], rows.at("double")["operations"]["mul"]);
    if (has_angles) {
      EXPECT_FALSE(rows.at("double-given")["front"]) << "it leaves out part of the work";
      const double bytes = rows.at("double-given")["bytes"], estimated = function["estimated_bytes"];
      EXPECT_NEAR(estimated, bytes, 0.3 * bytes + 100) << function["name"];
    }
    for (const auto& [name, row] : rows) EXPECT_EQ(row["peer"], kPeers.count(name) > 0);
  }
  EXPECT_GT(functions[0]["operations"]["mul"], 0);
  expect_stages_of(result["robots"][0]["stages"], functions.size());
}

// MuJoCo has the base in the world's axes and other accelerations of it; the base's own gravity turns.
TEST(Bench, ComparesRobotsWithAFloatingBase) {
  const Outcome outcome = run_flatdyn(
      "bench docs/examples/free_arm.toml -q --json --time 0.01 --states 20 --functions "
      "inverse_dynamics,bias,forward_dynamics "
      "--variants double,double-staged,batch-double,cuda-double,reference,MuJoCo");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json robot = json::parse(outcome.out)["robots"][0];
  for (const json& function : robot["functions"]) {
    const std::map<std::string, json> rows = by_variant(function);
    EXPECT_EQ(rows.size(), 5u + mujoco_has(function["name"])) << function["name"];
    expect_small_errors(rows);
  }
  EXPECT_EQ(robot["stages"]["steps"][1]["name"], "with(v)");
}

// DART has the base's angular entries before the linear ones, in everything.
TEST(Bench, ComparesRobotsWithAFloatingBaseWithDart) {
  if (!is_installed("dart")) GTEST_SKIP() << "DART is not installed: scripts/setup all";
  const Outcome outcome = run_flatdyn(
      "bench docs/examples/free_arm.toml -q --json --time 0.01 --states 20 --variants double,DART --functions "
      "inverse_dynamics,"
      "inertia_matrix,gravity,bias,forward_dynamics,kinetic_energy,forward_kinematics,jacobian");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const json& function : json::parse(outcome.out)["robots"][0]["functions"]) {
    const std::map<std::string, json> rows = by_variant(function);
    EXPECT_EQ(rows.count("DART"), 1u) << function["name"];
    expect_small_errors(rows);
  }
}

// Errors of an abbreviated function are measured against the whole model's values.
TEST(Bench, ShowsWhatErrorBudgetsBuyAndCost) {
  const Outcome outcome = run_flatdyn(
      "bench robots/panda.urdf -q --json --time 0.02 --states 20 --functions inverse_dynamics,jacobian "
      "--variants double,double-0.01%,double-1%");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json result = json::parse(outcome.out)["robots"][0];
  const std::map<std::string, json> rows = by_variant(result["functions"][0]);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_LT(rows.at("double-1%")["operations"]["mul"], rows.at("double")["operations"]["mul"]);
  EXPECT_GT(rows.at("double-1%")["error"]["max"], 1e-6);
  EXPECT_LE(rows.at("double-1%")["error"]["max"], 0.87) << "N m, 1 % of the largest effort limit";
  EXPECT_EQ(by_variant(result["functions"][1]).size(), 1u) << "a budget changes no Jacobian";
  EXPECT_THAT(result["left_out"], Contains("error budget 0.01%: it saves no operation"));
  EXPECT_FALSE(result.contains("stages"));
}

TEST(Bench, MakesNoBudgetsOfItsOwnForAnAbbreviatedModel) {
  const Outcome outcome = run_flatdyn(
      "bench robots/panda.urdf -q --json --time 0.02 --states 5 --functions gravity --error-budget 1% "
      "--variants double,double-0.1%");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json result = json::parse(outcome.out)["robots"][0];
  EXPECT_EQ(result["functions"][0]["variants"].size(), 1u);
  EXPECT_THAT(result["left_out"], Contains("error budget 0.1%: the model has one already"));
}

// A robot with free symbols and rotors (which the reference supports), in all variants with SIMD lanes.
TEST(Bench, MeasuresLanesOfARobotWithSymbols) {
  const Outcome outcome = run_flatdyn(
      "bench robots/planar_2r.toml -q --time 0.02 --states 10 --functions kinetic_energy "
      "--variants "
      "double,double-together,double-1%,float-staged,batch-double,batch-float-given,cuda-float,reference,KDL");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const char* text :
       {"planar_2r: ", "kinetic_energy: 20 mul, 11 add", "batch-double ", "double-together ", "batch-float-given ",
        "cuda-float ", "reference ", "J: p99", "float-staged ", "stages of kinetic_energy", "one by one",
        "left out: KDL: it knows no rotors", "left out: error budget: the robot has free symbols"}) {
    EXPECT_THAT(outcome.out, HasSubstr(text));
  }
}

// Packed results are filled up again before they are compared with 50 digits.
TEST(Bench, PacksMatricesThatHaveZerosOrAreSymmetric) {
  const Outcome outcome = run_flatdyn(
      "bench robots/planar_2r.toml -q --json --time 0.02 --states 10 --variants double,batch-double-packed "
      "--functions inertia_matrix,gravity,jacobian");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json functions = json::parse(outcome.out)["robots"][0]["functions"];
  ASSERT_EQ(functions.size(), 3u);
  EXPECT_LT(by_variant(functions[0]).at("batch-double-packed")["error"]["max"], 1e-12);
  EXPECT_EQ(by_variant(functions[1]).size(), 1u) << "a vector is not packed";
  EXPECT_LT(by_variant(functions[2]).at("batch-double-packed")["error"]["max"], 1e-12);
}

TEST(Bench, ShowsGrowth) {
  const Scratch scratch;
  const Outcome outcome =
      run_flatdyn("bench --growth --joints 4 -q --json --time 0.02 --functions gravity -o " + scratch.path());
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  expect_well_formed(scratch.read("growth.svg"));
  const json curves = json::parse(outcome.out)["growth"];
  ASSERT_EQ(curves.size(), 2u);
  for (const json& curve : curves) {
    ASSERT_EQ(curve["sizes"].size(), 2u);
    for (const json& row : curve["sizes"]) {
      EXPECT_LE(row["scaled_error"], 16.0);
      EXPECT_GT(row["ns"]["median"], 0.0);
      EXPECT_GT(row["compilation_s"], 0.0);
      EXPECT_GT(row["compiler_kilobytes"], 1000);
    }
    EXPECT_LT(curve["sizes"][0]["mul"], curve["sizes"][1]["mul"]);
    EXPECT_EQ(curve["fitted_from"], 2);
    EXPECT_GT(curve["operation_exponent"], 1.0);
    EXPECT_TRUE(curve["time_exponent"].is_number());
  }
}

// Every stage is measured once, and the functions' shares make up the stages that they are derived and optimised in.
TEST(Bench, ShowsWhatGenerationCosts) {
  const std::string command = "bench --generator robots/planar_2r.toml -q --functions gravity,inertia_matrix ";
  const Outcome outcome = run_flatdyn(command + "--json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json cost = json::parse(outcome.out);
  const std::vector<std::string> expected = {"reading", "derivation", "passes", "emitting and reading back", "proving"};
  ASSERT_EQ(cost["stages"].size(), expected.size());
  double stages = 0, functions = 0;
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_EQ(cost["stages"][k]["stage"], expected[k]);
    EXPECT_GE(cost["stages"][k]["peak_kilobytes"], 1000);
    stages += cost["stages"][k]["processor_s"].get<double>();
  }
  EXPECT_NEAR(stages, cost["processor_s"].get<double>(), 1e-6);
  ASSERT_EQ(cost["functions"].size(), 2u);
  for (const json& each : cost["functions"]) {
    EXPECT_GT(each["mul"], 0);
    functions += each["derivation_s"].get<double>() + each["passes_s"].get<double>();
  }
  const double derived = cost["stages"][1]["processor_s"], optimised = cost["stages"][2]["processor_s"];
  EXPECT_NEAR(functions, derived + optimised, 1e-6);
  const Outcome table = run_flatdyn(command);
  for (const char* text : {"planar_2r: ", "s of the processor", "peak MB so far", "passes s", "inertia_matrix"}) {
    EXPECT_THAT(table.out, HasSubstr(text));
  }
}

TEST(Bench, RefusesWhatItCannotDo) {
  const std::string robot = "robots/planar_2r.toml";
  for (const std::string& arguments : std::vector<std::string>{
           std::string(), robot + " --growth", robot + " --joints 4", std::string("--growth --joints 1"),
           std::string("--growth --joints 65"), robot + " --time 0", robot + " --time nan", robot + " --states 0",
           robot + " --generator " + robot, std::string("--generator"), robot + " --generator --growth",
           robot + " --variants quadruple", robot + " --functions nothing", robot + " -o ''"}) {
    EXPECT_EQ(run_flatdyn("bench -q " + arguments).code, 2) << arguments;
  }
  EXPECT_THAT(run_flatdyn("bench -q " + robot + " --variants doubel").err, HasSubstr("double"));
  EXPECT_EQ(run_flatdyn("bench -q no_such.urdf").code, 6);
}

}  // namespace
}  // namespace flatdyn::testing
