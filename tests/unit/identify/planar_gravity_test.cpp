// SPDX-License-Identifier: GPL-2.0-or-later
// Arms whose axes are all parallel: gravity, masses and gains can be told less well there.
#include <gmock/gmock.h>
#include <unistd.h>

#include <numbers>

#include "laboratory/identify/gravity_search.hpp"
#include "laboratory/identify/identification.hpp"
#include "support/names.hpp"
#include "support/robot_models.hpp"
#include "support/simulated_log.hpp"

namespace flatdyn {
namespace {

using Eigen::Vector3d;
using ::testing::HasSubstr;
using testing::SimulatedSample;

constexpr const char* kScara = R"(dh = "standard"
gravity = [0, 0, "-9.81"]
[[link]]
joint = "shoulder"
a = 0.4
mass = 6
com = [-0.2, 0.01, 0]
inertia = { zz = 0.1 }
inertia_about = "com"
[[link]]
joint = "elbow"
a = 0.3
mass = 3
com = [-0.1, 0, 0]
inertia = { zz = 0.03 }
inertia_about = "com"
[[link]]
joint = "quill"
type = "prismatic"
mass = 2
inertia = { zz = 0.002 }
inertia_about = "com"
)";

LoadedRobot robot_of(const std::string& text) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / fmt::format("flatdyn-planar-{}.toml", ::getpid());
  std::ofstream(path) << text;
  LoadedRobot robot = load_robot(path, {});
  std::filesystem::remove(path);
  return robot;
}

// The quill is gone: no torque depends on gravity as the file has it.
std::string without_quill() {
  const std::string text = kScara;
  return text.substr(0, text.rfind("[[link]]"));
}

LoadedRobot under(LoadedRobot robot, const Vec3& gravity) {
  robot.robot.gravity = robot.mechanism.gravity = gravity;
  return robot;
}

// A robot as its file says, and the logs that are read with it.
struct Reader {
  explicit Reader(LoadedRobot of_file) : robot(std::move(of_file)) {}

  LoadedRobot robot;
  Progress quiet{true};
  TorqueModel model{robot, ParameterSet::given, quiet};
  TorqueEquations equations{model};

  Measurement measured(const std::vector<SimulatedSample>& samples) {
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / fmt::format("flatdyn-planar-{}.csv", ::getpid());
    testing::write_log(path, samples);
    Diagnostics found;
    Measurement measurement = measure(equations, robot.mechanism, {path}, {}, quiet, found);
    std::filesystem::remove(path);
    return measurement;
  }
  std::vector<JointFit> fits_of(const Measurement& measurement) const {
    return fit_quality(measurement.observations, measurement.logs, estimate_of(equations, measurement, {}).values,
                       equations.acceleration_rows());
  }
  std::optional<FitHypothesis> reason_of(const std::vector<SimulatedSample>& samples) {
    const Measurement measurement = measured(samples);
    return best_hypothesis(model, robot, measurement, fits_of(measurement));
  }
};

// Gravity and all masses turned around make the same torques.
TEST(PlanarGravity, HasThePlainSignWhereMassesCouldBeNegative) {
  const Vector3d tilts[] = {{1.2, 0, -9.736}, {-0.5, 1.9, -9.611}, {0, -3.4, -9.202}};
  Reader reader(robot_of(kScara));
  for (const Vector3d& tilt : tilts) {
    const auto exact = [](double value) { return exact_decimal(fmt::format("{:.6f}", value)); };
    const LoadedRobot real = under(reader.robot, {exact(tilt.x()), exact(tilt.y()), exact(tilt.z())});
    const Measurement measurement = reader.measured(testing::simulated(real, {.samples = 1500, .noise = 0.05}));
    const RowSample rows(reader.model, measurement, reader.fits_of(measurement));
    const GravityFit fit = gravity_direction(reader.robot, rows);
    EXPECT_LT((fit.gravity.normalized() - tilt.normalized()).norm(), 0.02) << tilt.transpose();
  }
}

TEST(PlanarGravity, ThatActsOnNoJointInTheFileIsFoundAndNamed) {
  Reader reader(robot_of(without_quill()));
  const LoadedRobot real = under(reader.robot, {exact_decimal("2.899"), 0, exact_decimal("-9.3719")});
  const std::vector<SimulatedSample> samples = testing::simulated(real, {.samples = 1500, .noise = 0.05});
  const Measurement measurement = reader.measured(samples);
  const RowSample rows(reader.model, measurement, reader.fits_of(measurement));
  const GravityFit fit = gravity_direction(reader.robot, rows);
  EXPECT_NEAR(fit.gravity.x(), 2.899, 0.05);
  EXPECT_NEAR(fit.gravity.z(), -9.3719, 0.02);
  const std::optional<FitHypothesis> reason = reader.reason_of(samples);
  ASSERT_TRUE(reason);
  EXPECT_THAT(reason->text, HasSubstr("gravity looks as if it came from another direction"));
}

// A spring below the quill would do the same, so that it is named, too.
TEST(PlanarGravity, ThatIsCompensatedIsNamed) {
  Reader reader(robot_of(kScara));
  const std::vector<SimulatedSample> weightless =
      testing::simulated(under(reader.robot, {0, 0, 0}), {.samples = 1500, .noise = 0.05});
  const std::optional<FitHypothesis> reason = reader.reason_of(weightless);
  ASSERT_TRUE(reason);
  EXPECT_THAT(reason->text, HasSubstr("gravity looks left out of the torques"));
  EXPECT_THAT(reason->text, HasSubstr("or joint \"quill\": its torques look as if -19.6 N were added"));
  EXPECT_FALSE(reader.reason_of(testing::simulated(reader.robot, {.samples = 1500, .noise = 0.05})));
}

// With all masses 1.2 times as large, the other joint's torques look too small instead.
TEST(PlanarGravity, GainsThatExplainAlikeAreAllNamed) {
  Reader reader(testing::model_of("planar_2r_example_7_2.toml"));
  std::vector<SimulatedSample> samples = testing::simulated(reader.robot, {.samples = 1500, .noise = 2});
  for (SimulatedSample& sample : samples) sample.tau(0) *= 1.2;
  const std::optional<FitHypothesis> reason = reader.reason_of(samples);
  ASSERT_TRUE(reason);
  EXPECT_THAT(reason->text,
              ::testing::ContainsRegex("joint \"[^\"]*1\": its torques look 1.2 times too large, or joint "
                                       "\"[^\"]*2\": its torques look 1.2 times too small"));
}

}  // namespace
}  // namespace flatdyn
