// SPDX-License-Identifier: GPL-2.0-or-later
// Small robot files of others that were once read wrongly, and real ones that were refused. They lie beside the
// checkout, in ../shared, and the tests are skipped where they are not. Each file of ../shared/cases has one row here.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "flatdyn/reference/newton_euler.hpp"
#include "robot/input/reader.hpp"
#include "robot/model/coupling.hpp"
#include "robot/model/mechanism.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {
namespace {

namespace fs = std::filesystem;

const fs::path kShared = fs::path(FLATDYN_SOURCE_DIR) / ".." / "shared";

std::string all_of(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics.all()) text += to_string(diagnostic) + "\n";
  return text;
}

// A file with one joint, and its torques at q = 0 in the states of ../shared/cases/states.csv.
struct Torques {
  const char* file;
  double moving;        // N m, at q̇ = 1 rad/s, q̈ = 0
  double accelerating;  // N m, at q̇ = 0, q̈ = 1 rad/s²
};

const Torques kTorques[] = {
    {"plain.urdf", -1.962, -1.912},
    {"axis_children.urdf", -1.962, -1.912},
    {"axis_text.urdf", -1.962, -1.912},
    {"nine.urdf", -1.962, -1.912},
    {"dynamics_children.urdf", 18.038, -1.912},
    {"joint_properties.urdf", 18.038, -1.912},
    {"motorInertia1.urdf", -1.962, -1.892},
    {"motorInertia100.urdf", -1.962, 0.088},
    {"dust.urdf", -1.962, -1.912},
    {"gear.urdf", 0, 0.0536},
    {"fourbar.urdf", 5.886, 5.994},  // at 60° half of it: UrdfLoops.AParallelogramHasOneCoordinate
};

// A file that is refused: in which line, and what the message says among others.
struct Refusal {
  const char* file;
  int line;
  const char* says;
};

const Refusal kRefusals[] = {
    {"loop_constraint.urdf", 10, "along its axes it takes 4 coordinates, and has 2 joints for them"},
    {"loop_independent.urdf", 8, "joint \"j2\" is marked independent=\"false\""},
    {"loop_urdfplus_coupling.urdf", 10, "coupling \"cp\": there is no joint between its predecessor"},
    {"ratio0.urdf", 1, "the gear ratio of its rotor is zero"},
    {"reduction0.urdf", 1, "the gear ratio of its rotor is zero"},
    {"twomotors.urdf", 1, "two actuators with a rotor each"},
    {"xacro.urdf", 2, "this is a xacro template"},
    {"limits/a.toml", 5, "the lower limit (130 deg) is above the upper one (-100 deg)"},
    {"limits/b.toml", 4, "the lower limit (1.5708) is above the upper one (-1.5708)"},
    {"limits/c.toml", 5, "velocity limit is negative (-180 deg/s)"},
    {"limits/s1.toml", 3, "mass is negative (-1.41421)"},
    {"limits/s2.toml", 4, "viscous friction (damping) is negative (-1.41421)"},
    {"files/lfs.urdf", 1, "this is a pointer of Git LFS"},
};

// A file that is read, and what is noted or warned of: "" for nothing at all.
struct Reading {
  const char* file;
  const char* says;
};

const Reading kReadings[] = {
    {"limits/s7.toml", "no body has this inertia: a principal moment is negative"},
    {"files/B_limit.xml", ""},
    {"files/B_limit_dblmax.sdf", ""},
    {"files/B_limit_dblmax.urdf", ""},
    {"files/E_velocity_decay_twice.sdf", ""},
    {"files/G_gravity1.urdf", ""},
    {"files/H_bullet_lower_above_upper.urdf", "no limit in Bullet and ODE"},
    {"files/torque_constant.urdf", ""},
};

// A file with several joints, and its coordinates. Their dynamics are tested where loops and dust are.
struct Coordinates {
  const char* file;
  int count;
};

const Coordinates kCoordinates[] = {
    {"loop_gz_mimic_plugin.urdf", 2},
    {"ax_a.urdf", 6},
    {"iner_a.urdf", 6},
};

std::string name_of(const std::string& file) {
  std::string name = fs::path(file).replace_extension().string();
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '-' || c == '.' || c == '/'; }, '_');
  return name;
}

template <class Case>
std::string name_of_case(const ::testing::TestParamInfo<Case>& info) {
  return name_of(info.param.file);
}

class SharedTorques : public ::testing::TestWithParam<Torques> {};

TEST_P(SharedTorques, AreThoseOfTheRobotThatIsMeant) {
  const fs::path path = kShared / "cases" / GetParam().file;
  if (!fs::exists(path)) GTEST_SKIP() << "there is no ../shared/cases";
  Diagnostics diagnostics;
  const std::optional<Robot> robot = read_robot(path, {}, diagnostics);
  ASSERT_TRUE(robot.has_value()) << all_of(diagnostics);
  const reference::Robot<double> numbers = reference_robot<double>(*robot, {});
  using Vector = Eigen::VectorXd;
  const Vector zero = Vector::Zero(1), one = Vector::Ones(1);
  EXPECT_NEAR(reference::inverse_dynamics<double>(numbers, zero, one, zero)(0), GetParam().moving, 1e-12);
  EXPECT_NEAR(reference::inverse_dynamics<double>(numbers, zero, zero, one)(0), GetParam().accelerating, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Cases, SharedTorques, ::testing::ValuesIn(kTorques), name_of_case<Torques>);

class SharedRefusals : public ::testing::TestWithParam<Refusal> {};

TEST_P(SharedRefusals, NameTheLine) {
  const fs::path path = kShared / "cases" / GetParam().file;
  if (!fs::exists(path)) GTEST_SKIP() << "there is no ../shared/cases";
  Diagnostics diagnostics;
  EXPECT_FALSE(read_robot(path, {}, diagnostics).has_value());
  const std::vector<Diagnostic>& all = diagnostics.all();
  EXPECT_TRUE(std::any_of(all.begin(), all.end(), [](const Diagnostic& found) {
    return found.severity == Severity::error && found.place.line == GetParam().line &&
           found.message.find(GetParam().says) != std::string::npos;
  })) << all_of(diagnostics);
}

INSTANTIATE_TEST_SUITE_P(Cases, SharedRefusals, ::testing::ValuesIn(kRefusals), name_of_case<Refusal>);

class SharedReadings : public ::testing::TestWithParam<Reading> {};

TEST_P(SharedReadings, SayNothingElse) {
  const fs::path path = kShared / "cases" / GetParam().file;
  if (!fs::exists(path)) GTEST_SKIP() << "there is no ../shared/cases";
  Diagnostics diagnostics;
  const std::optional<Robot> robot = read_robot(path, {}, diagnostics);
  ASSERT_TRUE(robot.has_value()) << all_of(diagnostics);
  const std::string says = GetParam().says;
  EXPECT_EQ(diagnostics.all().size(), says.empty() ? 0U : 1U) << all_of(diagnostics);
  EXPECT_NE(all_of(diagnostics).find(says), std::string::npos) << all_of(diagnostics);
}

// With the extension, as one name is that of several formats.
std::string name_of_reading(const ::testing::TestParamInfo<Reading>& info) {
  return name_of(info.param.file) + name_of(fs::path(info.param.file).extension().string());
}

INSTANTIATE_TEST_SUITE_P(Cases, SharedReadings, ::testing::ValuesIn(kReadings), name_of_reading);

TEST(SharedCases, AMimicPluginLetsTheMimicJointFollow) {
  const fs::path path = kShared / "cases" / "loop_gz_mimic_plugin.urdf";
  if (!fs::exists(path)) GTEST_SKIP() << "there is no ../shared/cases";
  Diagnostics diagnostics;
  const std::optional<Robot> robot = read_robot(path, {}, diagnostics);
  ASSERT_TRUE(robot.has_value()) << all_of(diagnostics);
  EXPECT_EQ(joint_positions(*robot)[2].factors, (std::map<int, Number>{{1, -1}}));  // j3 = -j2
}

class SharedCoordinates : public ::testing::TestWithParam<Coordinates> {};

TEST_P(SharedCoordinates, AreAsMany) {
  const fs::path path = kShared / "cases" / GetParam().file;
  if (!fs::exists(path)) GTEST_SKIP() << "there is no ../shared/cases";
  Diagnostics diagnostics;
  const std::optional<Robot> robot = read_robot(path, {}, diagnostics);
  ASSERT_TRUE(robot.has_value()) << all_of(diagnostics);
  EXPECT_EQ(make_mechanism(*robot).size(), GetParam().count);
}

INSTANTIATE_TEST_SUITE_P(Cases, SharedCoordinates, ::testing::ValuesIn(kCoordinates), name_of_case<Coordinates>);

TEST(SharedCases, EachHasARow) {
  if (!fs::is_directory(kShared / "cases")) GTEST_SKIP() << "there is no ../shared/cases";
  std::set<std::string> rows;
  for (const Torques& row : kTorques) rows.insert(row.file);
  for (const Refusal& row : kRefusals) rows.insert(row.file);
  for (const Coordinates& row : kCoordinates) rows.insert(row.file);
  for (const fs::directory_entry& entry : fs::directory_iterator(kShared / "cases")) {
    if (entry.path().extension() != ".urdf") continue;
    EXPECT_TRUE(rows.contains(entry.path().filename().string())) << entry;
  }
}

std::vector<std::string> urdf_files() {
  std::vector<std::string> files;
  for (const fs::path folder : {"robots", "robots/strict"}) {
    if (!fs::is_directory(kShared / folder)) continue;
    for (const fs::directory_entry& entry : fs::directory_iterator(kShared / folder)) {
      if (entry.path().extension() == ".urdf") files.push_back((folder / entry.path().filename()).string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

class SharedRobots : public ::testing::TestWithParam<std::string> {};

TEST_P(SharedRobots, AreRead) {
  Diagnostics diagnostics;
  EXPECT_TRUE(read_robot(kShared / GetParam(), {}, diagnostics).has_value()) << all_of(diagnostics);
}

std::string name_of_robot(const ::testing::TestParamInfo<std::string>& info) { return name_of(info.param); }

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(SharedRobots);  // where the files are not there
INSTANTIATE_TEST_SUITE_P(Files, SharedRobots, ::testing::ValuesIn(urdf_files()), name_of_robot);

}  // namespace
}  // namespace flatdyn
