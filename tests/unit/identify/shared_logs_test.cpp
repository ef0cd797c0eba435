// SPDX-License-Identifier: GPL-2.0-or-later
// Logs of known truth with the stamps of a real controller, with gaps, and with a real misfit at another time. They lie
// beside the checkout, in ../shared/cases/logs; the tests are skipped where they do not.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "laboratory/identify/identification.hpp"
#include "support/robot_models.hpp"

namespace flatdyn {
namespace {

namespace fs = std::filesystem;

const fs::path& folder_of_logs() {
  static const fs::path folder = fs::path(FLATDYN_SOURCE_DIR) / "../shared/cases/logs";
  return folder;
}

class SharedLogs : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(folder_of_logs())) GTEST_SKIP() << "there is no ../shared/cases/logs";
  }

  // Measures a log, and estimates all parameters of a robot.
  void identify(const fs::path& robot, const std::string& log, const FurtherParameters& further = {}) {
    const fs::path unpacked = fs::temp_directory_path() / fmt::format("flatdyn-shared-log-{}.csv", ::getpid());
    const std::string command = fmt::format("gunzip -c {} > {}", (folder_of_logs() / log).string(), unpacked.string());
    ASSERT_EQ(std::system(command.c_str()), 0);
    Progress quiet(true);
    const LoadedRobot loaded = load_robot(robot, {});
    const TorqueModel model(loaded, ParameterSet::full, quiet);
    const TorqueEquations equations(model, further);
    Diagnostics found;
    measurement = measure(equations, loaded.mechanism, {unpacked}, {}, quiet, found);
    fs::remove(unpacked);
    ASSERT_FALSE(found.has_errors());
    estimate = estimate_of(equations, measurement, {});
  }

  long parameters_not_told() const { return (!estimate.standard_deviations.array().isFinite()).count(); }

  Measurement measurement;
  Estimate estimate;
};

// The noise of the torques is 0.05 N m; plain least squares on the log interpolated to 1 kHz leaves 0.015 N m.
TEST_F(SharedLogs, WithTheStampsOfARealControllerAreReadAtTheirStamps) {
  identify(fs::path(FLATDYN_SOURCE_DIR) / "robots/panda.urdf", "jit_real_times.csv.gz");
  EXPECT_EQ(parameters_not_told(), 0);
  EXPECT_EQ(measurement.count.gaps, 0);
  for (const JointObservations& joint : measurement.observations.joints) {
    EXPECT_LT(joint.rms_residual(estimate.values), 0.018);
  }
}

TEST_F(SharedLogs, WithGapsThatAreShortBesideTheBandAreUsedWhole) {
  identify(fs::path(FLATDYN_SOURCE_DIR) / "robots/panda.urdf", "jit_gaps6.csv.gz");
  EXPECT_EQ(parameters_not_told(), 0);
  EXPECT_EQ(measurement.count.gaps, 0);
  EXPECT_EQ(measurement.count.interpolated, 78);
}

TEST_F(SharedLogs, WithAMisfitTellAllParameters) {
  FurtherParameters further;
  further.offsets = true;
  identify(folder_of_logs() / "xmate.toml", "perm1_g.csv.gz", further);
  EXPECT_EQ(parameters_not_told(), 0);
}

}  // namespace
}  // namespace flatdyn
