// SPDX-License-Identifier: GPL-2.0-or-later
// Parameters of robots with spherical joints, whose quaternions a log has.
#include <gtest/gtest.h>
#include <unistd.h>

#include "flatdyn/reference/newton_euler.hpp"
#include "functions/load/load_robot.hpp"
#include "laboratory/identify/excitation.hpp"
#include "laboratory/identify/identification.hpp"
#include "report/excitation_report.hpp"
#include "report/identified_robot.hpp"
#include "robot/model/spherical_joint.hpp"
#include "support/floating_log.hpp"

namespace flatdyn {
namespace {

class SphericalIdentification : public ::testing::Test {
 protected:
  static const LoadedRobot& robot() {
    static const LoadedRobot model = load_robot(FLATDYN_SOURCE_DIR "/docs/examples/ball_wrist.toml", {});
    return model;
  }
  static const TorqueEquations& equations() {
    static Progress quiet(true);
    static const TorqueModel model(robot(), ParameterSet::given, quiet);
    static const TorqueEquations equations(model);
    return equations;
  }
  SphericalIdentification() { std::filesystem::create_directories(folder_); }
  ~SphericalIdentification() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / fmt::format("flatdyn-spherical-{}", ::getpid());
  Progress progress_{true};
  Diagnostics found_;
};

struct Sample {
  double time = 0;
  Eigen::VectorXd q, v, a, tau;
};

// Joints 1, 2, 6 and 7 swing, and the wrist turns by roll, pitch and yaw.
std::vector<Sample> swinging_wrist(const LoadedRobot& model, int count, double rate) {
  testing::Uniform draw(3);
  std::vector<testing::SumOfSines> sums;
  for (int k = 0; k < 7; ++k) sums.emplace_back(draw, k == 6 ? 0.02 : 0.5, 0.3);
  std::vector<Sample> samples;
  for (int k = 0; k < count; ++k) {
    Sample sample{k / rate, Eigen::VectorXd(8), Eigen::VectorXd(7), Eigen::VectorXd(7), {}};
    Eigen::Matrix3d angles;
    for (int i = 0; i < 3; ++i) angles.row(i) = sums[static_cast<std::size_t>(2 + i)].at(sample.time).transpose();
    const testing::Turning wrist = testing::turning(angles);
    sample.q.segment(2, 4) << wrist.turn.w(), wrist.turn.x(), wrist.turn.y(), wrist.turn.z();
    sample.v.segment(2, 3) = wrist.velocity;
    sample.a.segment(2, 3) = wrist.acceleration;
    for (const auto& [joint, position] : {std::pair(0, 0), {1, 1}, {5, 6}, {6, 7}}) {
      const Eigen::Vector3d moved = sums[static_cast<std::size_t>(joint)].at(sample.time);
      sample.q[position] = moved[0];
      sample.v[joint] = moved[1];
      sample.a[joint] = moved[2];
    }
    reference::Robot<double> robot = reference_robot<double>(model.robot, {});
    Eigen::VectorXd positions = sample.q;
    reference::take_orientations(robot, positions);
    sample.tau = reference::inverse_dynamics<double>(robot, positions, sample.v, sample.a);
    samples.push_back(std::move(sample));
  }
  return samples;
}

void write(const std::filesystem::path& path, const std::vector<Sample>& samples, bool has_rates) {
  std::ofstream file(path);
  file << "t,q1,q2,q3,q4,q5,q6,q7,q8";
  for (const char* stem : {"tau", "qd", "qdd"}) {
    for (int i = 1; i <= 7 && (has_rates || stem[0] == 't'); ++i) file << "," << stem << i;
  }
  file << "\n";
  for (const Sample& each : samples) {
    file << fmt::format("{}", each.time);
    for (const double value : each.q) file << fmt::format(",{}", value);
    for (const double value : each.tau) file << fmt::format(",{}", value);
    for (const double value : each.v) file << (has_rates ? fmt::format(",{}", value) : "");
    for (const double value : each.a) file << (has_rates ? fmt::format(",{}", value) : "");
    file << "\n";
  }
}

TEST_F(SphericalIdentification, ComesFromQuaternionsAloneOrWithRates) {
  const std::vector<Sample> samples = swinging_wrist(robot(), 4000, 500);
  const Eigen::VectorXd truth = equations().file_values();
  for (const bool has_rates : {true, false}) {
    write(folder_ / "log.csv", samples, has_rates);
    const Measurement measurement =
        measure(equations(), robot().mechanism, {folder_ / "log.csv"}, {}, progress_, found_);
    ASSERT_FALSE(found_.has_errors()) << found_.all().front().message;
    const Estimate estimate = estimate_of(equations(), measurement, {});
    const double error = (estimate.values - truth).cwiseAbs().maxCoeff() / truth.cwiseAbs().maxCoeff();
    EXPECT_LT(error, has_rates ? 1e-10 : 3e-4);
    if (!has_rates) continue;
    // The bodies inside the joint are none, and the file has one coefficient of friction for all axes.
    const Identification result = identification(robot(), equations(), measurement, {}, progress_);
    const std::string text =
        identified_robot_text(robot(), ParameterSet::given, result.physical, {folder_ / "x.toml", {}, {}, {}});
    EXPECT_EQ(result.physical.pi[2 * kParametersPerJoint], 0);
    EXPECT_NE(text.find("[[joint]]\nname = \"wrist\"\nviscous = 0.0"), std::string::npos) << text;
    EXPECT_EQ(text.find("wrist.w"), std::string::npos);
    std::ofstream(folder_ / "x.toml") << text;
    const Mechanism again = load_robot(folder_ / "x.toml", {}).mechanism;
    EXPECT_NEAR(nearest_double(again.bodies[4].inertia.mass), nearest_double(robot().mechanism.bodies[4].inertia.mass),
                1e-6);
  }
}

// The planned motion keeps the limits of the wrist's angular velocity, and identifies the robot.
TEST_F(SphericalIdentification, IsPlannedByExcite) {
  const MotionEquations planned_for(equations().model());
  const Excitation planned = make_excitation(planned_for, {.rate = 20, .evaluations = 100, .time = {}}, progress_);
  EXPECT_LT(planned.motion.cost, planned.start.cost);
  const std::vector<JointLimits> limits = motion_limits(robot().mechanism);
  for (const FourierMotion& sample : planned.motion.samples) {
    const PlannedState state = planned_for.state(sample.q.data(), sample.qd.data(), sample.qdd.data());
    for (std::size_t i = 2; i < 5; ++i) {
      EXPECT_LE(std::abs(state.v[static_cast<Eigen::Index>(i)]), limits[i].speed);
      EXPECT_LE(std::abs(state.a[static_cast<Eigen::Index>(i)]), limits[i].acceleration);
    }
  }
  std::ofstream(folder_ / "planned.csv") << excitation_csv(planned_for, planned.motion);
  const Measurement measurement =
      measure(equations(), robot().mechanism, {folder_ / "planned.csv"}, {}, progress_, found_);
  ASSERT_FALSE(found_.has_errors()) << found_.all().front().message;
  const Eigen::VectorXd truth = equations().file_values();
  EXPECT_LT((estimate_of(equations(), measurement, {}).values - truth).cwiseAbs().maxCoeff(), 1e-9);
}

}  // namespace
}  // namespace flatdyn
