// SPDX-License-Identifier: GPL-2.0-or-later
// Parameters of robots with a floating base, from what measures its motion: an inertial measurement unit, motion
// capture, or estimates of its twist; with and without the force on the base.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "functions/load/load_robot.hpp"
#include "laboratory/identify/base_coordinates.hpp"
#include "laboratory/identify/excitation.hpp"
#include "laboratory/identify/excitation_objective.hpp"
#include "laboratory/identify/fit_quality.hpp"
#include "laboratory/identify/identification.hpp"
#include "laboratory/identify/part_file.hpp"
#include "report/excitation_report.hpp"
#include "report/identification_report.hpp"
#include "support/floating_log.hpp"
#include "support/gradient.hpp"

namespace flatdyn {
namespace {

using testing::BaseColumns;

// A body with an arm of two joints, one of which has friction, and a link for the measurement unit.
constexpr const char* kText = R"(
name = "carried"

[base]
name = "body"
motion = "floating"
mass = 12
com = [0.03, -0.02, 0.05]
inertia = { xx = 0.3, yy = 0.4, zz = 0.35, xy = 0.02 }
inertia_about = "com"

[[link]]
name = "upper"
joint = "shoulder"
xyz = [0.2, 0, 0.1]
rpy = [0, "pi/2", 0]
mass = 2
com = [0, 0.15, 0.02]
inertia = { xx = 0.02, yy = 0.01, zz = 0.03 }
inertia_about = "com"
viscous = 0.4
coulomb = 0.3

[[link]]
name = "lower"
joint = "elbow"
xyz = [0, 0.3, 0]
axis = [1, 0, 0]
mass = 1.5
com = [0.01, 0.2, 0]
inertia = { xx = 0.015, yy = 0.005, zz = 0.015 }
inertia_about = "com"
viscous = 0.2

[[link]]
name = "imu"
parent = "body"
type = "fixed"
xyz = [0.1, -0.05, 0.2]
rpy = [0, 0, "pi/2"]
)";

class FloatingIdentification : public ::testing::Test {
 protected:
  static const LoadedRobot& robot() {
    static const LoadedRobot model = [] {
      const std::filesystem::path file = folder() / "carried.toml";
      std::ofstream(file) << kText;
      return load_robot(file, {});
    }();
    return model;
  }
  static const TorqueModel& model() {
    static Progress quiet(true);
    static const TorqueModel model(robot(), ParameterSet::given, quiet);
    return model;
  }
  static const TorqueEquations& equations() {
    static const TorqueEquations equations(model());
    return equations;
  }
  static const std::vector<testing::FloatingSample>& motion() {
    static const std::vector<testing::FloatingSample> samples = testing::floating_motion(robot(), {});
    return samples;
  }
  static std::filesystem::path folder() {
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / fmt::format("flatdyn-floating-{}", ::getpid());
    std::filesystem::create_directories(path);
    return path;
  }
  static void TearDownTestSuite() { std::filesystem::remove_all(folder()); }

  Measurement measured(const testing::FloatingLogForm& form, const StreamOptions& options = {}) {
    const std::filesystem::path log = folder() / "log.csv";
    testing::FloatingLogWriter(form, robot().mechanism).write(log, motion());
    return measure(equations(), robot().mechanism, {log}, options, progress, found);
  }
  static Eigen::VectorXd truth() { return equations().file_values(); }

  Progress progress{true};
  Diagnostics found;
};

// The largest difference of an estimate from the truth, as a share of the largest parameter.
double error_of(const Estimate& found, const Eigen::VectorXd& truth) {
  return (found.values - truth).cwiseAbs().maxCoeff() / truth.cwiseAbs().maxCoeff();
}

double worst_residual(const Measurement& measurement, const Eigen::VectorXd& truth) {
  double worst = 0;
  for (const JointObservations& joint : measurement.observations.joints) {
    if (joint.rows > 0) worst = std::max(worst, joint.rms_residual(truth) / joint.rms_torque());
  }
  return worst;
}

TEST_F(FloatingIdentification, WithAllDerivativesTheRowsAreExact) {
  const Measurement measurement =
      measured({.base = BaseColumns::twist_with_derivatives, .has_rates = true, .has_accelerations = true});
  ASSERT_THAT(found.all(), ::testing::IsEmpty());
  EXPECT_EQ(measurement.logs.at(0).filter.band, 0);
  EXPECT_LT(worst_residual(measurement, truth()), 1e-13);
  const Estimate estimate = estimate_of(equations(), measurement, {});
  EXPECT_THAT(estimate.damped, ::testing::IsEmpty());
  EXPECT_LT(error_of(estimate, truth()), 1e-12);
}

// The first half of the log has quaternions of the other sign, which is the same turn.
TEST_F(FloatingIdentification, ComesFromWhateverMeasuresTheBase) {
  for (const BaseColumns base :
       {BaseColumns::imu, BaseColumns::pose, BaseColumns::pose_with_twist, BaseColumns::twist_with_derivatives}) {
    const Measurement measurement = measured({.base = base});
    ASSERT_FALSE(found.has_errors()) << found.all().front().message;
    EXPECT_LT(worst_residual(measurement, truth()), 3e-4) << static_cast<int>(base);
    const Estimate estimate = estimate_of(equations(), measurement, {});
    EXPECT_THAT(estimate.damped, ::testing::IsEmpty());
    EXPECT_LT(error_of(estimate, truth()), 1e-4) << static_cast<int>(base);
  }
}

// A position without an orientation tells nothing more, and is passed over.
TEST_F(FloatingIdentification, NeedsNoPositionBesideATwist) {
  const std::filesystem::path log = folder() / "log.csv";
  for (const char* left_out : {"base_x,base_y,base_z,", "base_qw,base_qx,base_qy,base_qz,"}) {
    const bool has_quaternion = left_out[5] != 'q';
    std::string heading =
        "t,q1,q2,tau7,tau8,base_x,base_y,base_z,base_qw,base_qx,base_qy,base_qz,base_gx,base_gy,base_gz,base_vx,base_"
        "vy,"
        "base_vz,base_wx,base_wy,base_wz";
    heading.replace(heading.find(left_out), std::string(left_out).size(), "");
    std::ofstream text(log);
    text << heading << "\n";
    for (const testing::FloatingSample& each : motion()) {
      text << fmt::format("{},{},{},{},{}", each.time, each.q[0], each.q[1], each.tau[6], each.tau[7]);
      const Eigen::Quaterniond& turn = each.turn;
      if (has_quaternion) text << fmt::format(",{},{},{},{}", turn.w(), turn.x(), turn.y(), turn.z());
      if (!has_quaternion) text << fmt::format(",{},{},{}", each.place[0], each.place[1], each.place[2]);
      for (const double value : each.g_b) text << "," << fmt::format("{}", value);
      for (const double value : each.v.head(6)) text << "," << fmt::format("{}", value);
      text << "\n";
    }
    text.close();
    found = {};
    const Measurement measurement = measure(equations(), robot().mechanism, {log}, {}, progress, found);
    ASSERT_FALSE(found.has_errors()) << found.all().front().message;
    EXPECT_LT(worst_residual(measurement, truth()), 1e-3) << left_out;
  }
}

TEST_F(FloatingIdentification, AMeasurementUnitMayBeOnAnyLinkOfTheBase) {
  const Eigen::Quaterniond axes(Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitZ()));
  const testing::FloatingLogForm form{.imu_axes = axes, .imu_place = {0.1, -0.05, 0.2}};
  const Estimate estimate = estimate_of(equations(), measured(form, {.imu = "imu"}), {});
  ASSERT_FALSE(found.has_errors()) << found.all().front().message;
  EXPECT_LT(error_of(estimate, truth()), 1e-4);
  EXPECT_GT(worst_residual(measured(form), truth()), 0.1);
  EXPECT_THROW(measured(form, {.imu = "lower"}), Failure);
  EXPECT_THROW(measured(form, {.imu = "nothing"}), Failure);
}

// The joints' torques tell nothing of the ten parameters that the base has for all that it carries.
TEST_F(FloatingIdentification, WithoutTheBasesForceItsOwnParametersStayTheFiles) {
  const Measurement measurement = measured({.has_force = false});
  EXPECT_EQ(first_equation(model(), measurement.observations), 6);
  Eigen::VectorXd prior = truth();
  prior.head(10).setConstant(1.25);
  const Estimate estimate = flatdyn::estimate(measurement.observations, prior, {});
  EXPECT_EQ(estimate.values.head(10), prior.head(10));
  for (Eigen::Index k = 0; k < prior.size(); ++k) EXPECT_EQ(std::isfinite(estimate.standard_deviations[k]), k >= 10);
  const Eigen::VectorXd of_joints = estimate.values.tail(prior.size() - 10) - truth().tail(prior.size() - 10);
  EXPECT_LT(of_joints.cwiseAbs().maxCoeff(), 1e-4 * truth().maxCoeff());
}

// Noise of encoders, torques, forces and of what measures the base is told apart, and 95 % intervals hold the truth.
TEST_F(FloatingIdentification, HasHonestIntervals) {
  constexpr unsigned kRuns = 24;
  constexpr double kTwoSided95 = 1.959964;
  const testing::FloatingLogNoise noise{2e-5, 0.2, 1, 0.05, 0.005, 1e-4, 1e-4};
  for (const BaseColumns base : {BaseColumns::imu, BaseColumns::pose}) {
    long inside = 0, all = 0;
    for (unsigned run = 1; run <= kRuns; ++run) {
      testing::FloatingLogForm form{.base = base, .noise = noise};
      form.noise.seed = run;
      const Measurement measurement = measured(form);
      const Estimate estimate = estimate_of(equations(), measurement, {});
      const Eigen::ArrayXd error = (estimate.values - truth()).cwiseAbs();
      inside += (error <= kTwoSided95 * estimate.standard_deviations.array()).count();
      all += error.size();
      if (run > 1) continue;
      for (const JointFit& fit :
           fit_quality(measurement.observations, measurement.logs, estimate.values, equations().acceleration_rows())) {
        EXPECT_GT(fit.ratio, 0.75);
        EXPECT_LT(fit.ratio, 1.35);
      }
    }
    const double share = static_cast<double>(inside) / static_cast<double>(all);
    EXPECT_GE(share, 0.92) << static_cast<int>(base);
    EXPECT_LE(share, 0.985) << static_cast<int>(base);
  }
}

TEST_F(FloatingIdentification, SaysWhatIsWrongWithTheBasesColumns) {
  const std::filesystem::path log = folder() / "log.csv";
  const auto text_of = [&](const testing::FloatingLogForm& form) {
    testing::FloatingLogWriter(form, robot().mechanism).write(log, motion());
    std::ifstream file(log);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  const auto message_of = [&](const std::string& text) {
    std::ofstream(log) << text;
    Diagnostics problems;
    measure(equations(), robot().mechanism, {log}, {}, progress, problems);
    return problems.all().empty() ? std::string() : problems.all().front().message + problems.all().front().hint;
  };
  const auto without = [](std::string text, const std::string& name) {
    return text.replace(text.find(name), 4, "oldz");
  };
  const std::string unit = text_of({}), pose = text_of({.base = BaseColumns::pose});
  EXPECT_THAT(message_of(without(unit, "imu_az")), ::testing::HasSubstr("no column for imu_az"));
  EXPECT_THAT(message_of(without(pose, "base_qy")), ::testing::HasSubstr("no column for base_qy"));
  EXPECT_THAT(message_of(without(pose, "base_nz")), ::testing::HasSubstr("no column for base_nz"));
  EXPECT_THAT(message_of("t,q1,q2,tau_shoulder,tau_elbow\n0,0,0,0,0\n"),
              ::testing::HasSubstr("no columns that tell the motion of the floating base"));
  EXPECT_THAT(message_of("t,q1,q2,tau1,tau2\n0,0,0,0,0\n"), ::testing::HasSubstr("tau7 is of the first joint"));
  EXPECT_THAT(message_of("t,q1,q2,tau7,tau8,base_x,base_y,base_z,base_qw,base_qx,base_qy,base_qz\n"
                         "0,0,0,0,0,0,0,0,1,1,0,0\n"),
              ::testing::HasSubstr("\"base_qw\" has the length 1.414"));
}

TEST_F(FloatingIdentification, AsksWhatTheBasesMotionCannotBe) {
  const auto warnings_of = [&](const std::function<void(testing::FloatingSample&)>& fault,
                               const testing::FloatingLogForm& form) {
    std::vector<testing::FloatingSample> wrong = motion();
    for (testing::FloatingSample& each : wrong) fault(each);
    const std::filesystem::path log = folder() / "odd.csv";
    testing::FloatingLogWriter(form, robot().mechanism).write(log, wrong);
    found = {};
    const Measurement measurement = measure(equations(), robot().mechanism, {log}, {}, progress, found);
    std::vector<std::string> texts;
    for (const Diagnostic& each : found.all()) texts.push_back(each.message);
    const Identification result = identification(robot(), equations(), measurement, {}, progress);
    for (std::string& each : plausibility_warnings(model(), result)) texts.push_back(std::move(each));
    return texts;
  };
  const auto nothing = [](testing::FloatingSample&) {};
  const testing::FloatingLogForm twists{.base = BaseColumns::pose_with_twist, .noise = {.tau = 0.02, .force = 0.1}};
  EXPECT_THAT(warnings_of(nothing, twists), ::testing::IsEmpty());
  EXPECT_THAT(warnings_of([](testing::FloatingSample& each) { each.g_b *= 0.1; }, {}),
              ::testing::Contains(::testing::HasSubstr("the base's specific force is 2.32 m/s^2 on average")));
  EXPECT_THAT(warnings_of([](testing::FloatingSample& each) { each.tau.head(6).setZero(); }, {}),
              ::testing::Contains(::testing::HasSubstr("something carries the robot")));
  EXPECT_THAT(warnings_of([](testing::FloatingSample& each) { each.v.head(3) = each.turn * each.v.head(3); }, twists),
              ::testing::Contains("base_vx to base_vz look like the velocity in the world's axes"));
  EXPECT_THAT(
      warnings_of([](testing::FloatingSample& each) { each.v.segment(3, 3) = each.turn * each.v.segment(3, 3); },
                  twists),
      ::testing::Contains("base_wx to base_wz look like the angular velocity in the world's axes"));
}

// The base's six equations are solved as one, before which the textbook's procedure has only the joints'.
TEST_F(FloatingIdentification, TheSequentialProcedureTakesTheBasesEquationsTogether) {
  const Measurement measurement =
      measured({.base = BaseColumns::twist_with_derivatives, .has_rates = true, .has_accelerations = true});
  Eigen::VectorXd prior = truth();
  for (Eigen::Index k = 0; k < prior.size(); ++k) prior[k] += 0.1 * std::sin(static_cast<double>(k));
  const Eigen::VectorXd values = estimate_joint_by_joint(measurement.observations, prior, model().first_of_joint());
  EXPECT_LT((values - truth()).cwiseAbs().maxCoeff(), 1e-9);
}

// Each log has one fault, and the reason that is named is this fault.
TEST_F(FloatingIdentification, NamesTheFaultOfALog) {
  const auto reason = [&](const std::function<void(testing::FloatingSample&)>& fault,
                          BaseColumns base = BaseColumns::twist_with_derivatives) {
    std::vector<testing::FloatingSample> wrong = motion();
    for (testing::FloatingSample& each : wrong) fault(each);
    const std::filesystem::path log = folder() / "wrong.csv";
    testing::FloatingLogWriter({.base = base, .noise = {.q = 1e-5, .tau = 0.02, .force = 0.1}}, robot().mechanism)
        .write(log, wrong);
    const Measurement measurement = measure(equations(), robot().mechanism, {log}, {}, progress, found);
    const Identification result = identification(robot(), equations(), measurement, {}, progress);
    return result.hypothesis ? result.hypothesis->text : "none";
  };
  EXPECT_EQ(reason([](testing::FloatingSample&) {}), "none");
  EXPECT_THAT(reason([](testing::FloatingSample& each) { each.tau[6] *= -1; }),
              ::testing::HasSubstr("joint \"shoulder\": its torques look as if their sign were reversed"));
  EXPECT_THAT(reason([](testing::FloatingSample& each) { each.q[1] *= -1; }),
              ::testing::HasSubstr("joint \"elbow\": its positions look as if their sign were reversed"));
  EXPECT_THAT(
      reason([](testing::FloatingSample& each) { each.tau[2] += 8; }),
      ::testing::HasSubstr("the base's force along z: its readings look as if 7.99 N were added to all of them"));
  // A gyroscope alone: the accelerometer beside it still shows the same.
  EXPECT_THAT(reason(
                  [](testing::FloatingSample& each) {
                    const Eigen::Vector3d v = each.v.head(3), w = each.v.segment(3, 3);
                    each.a.head(3) += 2 * w.cross(v);
                    each.v.segment(3, 3) *= -1;
                  },
                  BaseColumns::imu),
              ::testing::HasSubstr("the base's angular velocity looks as if its sign were reversed"));
}

TEST_F(FloatingIdentification, PartsMakeUpTheWhole) {
  const std::filesystem::path log = folder() / "parts.csv";
  testing::FloatingLogWriter({}, robot().mechanism).write(log, testing::floating_motion(robot(), {.samples = 140000}));
  std::vector<std::filesystem::path> files;
  for (int part = 1; part <= 2; ++part) {
    const StreamOptions options{.part = part, .parts = 2};
    files.push_back(folder() / fmt::format("part{}.json", part));
    std::ofstream(files.back()) << part_text(measure(equations(), robot().mechanism, {log}, options, progress, found),
                                             equations(), options);
  }
  const Measurement merged = merge_parts(files, equations(), found);
  ASSERT_FALSE(found.has_errors()) << found.all().front().message;
  const Measurement whole = measure(equations(), robot().mechanism, {log}, {}, progress, found);
  const Estimate of_parts = estimate_of(equations(), merged, {}), of_whole = estimate_of(equations(), whole, {});
  EXPECT_TRUE(of_parts.values.isApprox(of_whole.values, 1e-9));
  EXPECT_TRUE(of_parts.standard_deviations.isApprox(of_whole.standard_deviations, 1e-6));
}

// A robot that nothing touches: what the log has for the base's force are zeros, and yet all parameters are told, as
// torques that are not zero give the scale.
TEST_F(FloatingIdentification, OfARobotThatNothingTouches) {
  const reference::Robot<double> file = reference_robot<double>(robot().robot, {});
  std::vector<testing::FloatingSample> free = motion();
  for (testing::FloatingSample& each : free) {
    reference::Robot<double> turned = file;
    turned.gravity = each.g_b;
    each.a.head(6).setZero();
    const Eigen::MatrixXd B = reference::inertia_matrix<double>(turned, each.q);
    const Eigen::VectorXd left = reference::inverse_dynamics<double>(turned, each.q, each.v, each.a);
    each.a.head(6) = -B.topLeftCorner(6, 6).llt().solve(left.head(6));
    each.tau = reference::inverse_dynamics<double>(turned, each.q, each.v, each.a);
    each.tau.head(6).setZero();
  }
  const std::filesystem::path log = folder() / "free.csv";
  testing::FloatingLogWriter(
      {.base = BaseColumns::twist_with_derivatives, .has_rates = true, .has_accelerations = true}, robot().mechanism)
      .write(log, free);
  const Measurement measurement = measure(equations(), robot().mechanism, {log}, {}, progress, found);
  const Estimate estimate = estimate_of(equations(), measurement, {});
  EXPECT_THAT(estimate.damped, ::testing::IsEmpty());
  EXPECT_LT(error_of(estimate, truth()), 1e-9);
}

// The motion that is planned keeps the limits of the base's twist, and tells all parameters; without the base's force,
// those that the joints tell.
TEST_F(FloatingIdentification, IsPlannedByExcite) {
  for (const bool has_force : {true, false}) {
    const MotionEquations planned_for(model(), has_force);
    EXPECT_EQ(planned_for.parameters(), model().parameters() - (has_force ? 0 : 10));
    ExcitationOptions options{.rate = 20, .evaluations = 120, .time = {}};
    const Excitation planned = make_excitation(planned_for, options, progress);
    EXPECT_LT(planned.motion.cost, planned.start.cost);
    const std::vector<JointLimits> limits = motion_limits(robot().mechanism);
    for (const FourierMotion& sample : planned.motion.samples) {
      const BaseState state = base_state(sample.q.data(), sample.qd.data(), sample.qdd.data());
      for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_LE(std::abs(sample.q[i]), limits[i].upper);
        EXPECT_LE(std::abs(state.twist[static_cast<Eigen::Index>(i)]), limits[i].speed);
        EXPECT_LE(std::abs(state.twist_rates[static_cast<Eigen::Index>(i)]), limits[i].acceleration);
      }
    }
    if (!has_force) continue;
    const std::filesystem::path log = folder() / "planned.csv";
    std::ofstream(log) << excitation_csv(planned_for, planned.motion);
    const Measurement measurement = measure(equations(), robot().mechanism, {log}, {}, progress, found);
    ASSERT_FALSE(found.has_errors()) << found.all().front().message;
    EXPECT_LT(error_of(estimate_of(equations(), measurement, {}), truth()), 1e-12);
  }
}

TEST_F(FloatingIdentification, TheGradientOfAPlannedMotionIsTheDerivative) {
  const MotionEquations planned_for(model());
  const ExcitationObjective objective(planned_for, within_margin(motion_limits(robot().mechanism), 0.9), 10, 2);
  std::vector<double> x(static_cast<std::size_t>(objective.size()));
  for (std::size_t k = 0; k < x.size(); ++k) x[k] = 0.5 * std::sin(static_cast<double>(3 * k + 1));
  testing::expect_gradient(objective, x);
}

}  // namespace
}  // namespace flatdyn
