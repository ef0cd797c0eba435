// SPDX-License-Identifier: GPL-2.0-or-later
// Payloads on floating bases and behind spherical joints, from torques, the base's force and a sensor at the wrist.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "functions/load/load_robot.hpp"
#include "laboratory/identify/torque_equations.hpp"
#include "laboratory/identify/wrist.hpp"
#include "report/payload_report.hpp"
#include "support/floating_log.hpp"

namespace flatdyn {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using testing::BaseColumns;
using ::testing::Contains;
using testing::FloatingLogForm;
using testing::FloatingSample;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// 0.4 kg at (0.03, -0.02, 0.05) m: m, m l, Î about the frame's origin.
const VectorXd kPayload =
    (VectorXd(10) << 0.4, 0.012, -0.008, 0.02, 0.00216, 0.00034, -0.0006, 0.00256, 0.0004, 0.00142).finished();

constexpr const char* kCarried = R"(com = [0.03, -0.02, 0.05]
mass = 0.4
inertia = { xx = 0.001, yy = 0.0012, zz = 0.0009, xy = 0.0001 }
inertia_about = "com"
)";

// A robot, and the same with a payload on its tip.
struct Carrier {
  LoadedRobot plain, loaded;
};

class FloatingPayload : public ::testing::Test {
 protected:
  static void TearDownTestSuite() { std::filesystem::remove_all(folder()); }
  static std::filesystem::path folder() {
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / fmt::format("flatdyn-carried-{}", ::getpid());
    std::filesystem::create_directories(path);
    return path;
  }
  static Carrier carrier_of(const std::string& plain, const std::string& loaded) {
    std::ofstream(folder() / "plain.toml") << plain;
    std::ofstream(folder() / "loaded.toml") << loaded;
    return {load_robot(folder() / "plain.toml", {}), load_robot(folder() / "loaded.toml", {})};
  }
  static Carrier carrier(const std::string& robot, const std::string& tip, const std::string& settings = "") {
    const std::string text =
        fmt::format("robot = \"{}/{}\"\ntip = {{ link = \"{}\" }}\n{}", FLATDYN_SOURCE_DIR, robot, tip, settings);
    return carrier_of(text, text + fmt::format("[payload]\nlink = \"{}\"\n{}", tip, kCarried));
  }
  static Carrier free_arm(const std::string& tip) { return carrier("docs/examples/free_arm.toml", tip); }

  // A floating base with a hinge, a ball, whose link carries, a slide and a branch.
  static const Carrier& arm() {
    static const Carrier robots = free_arm("hand");
    return robots;
  }
  static const TorqueModel& model() {
    static Progress quiet(true);
    static const TorqueModel model(arm().plain, ParameterSet::given, quiet);
    return model;
  }
  static const TorqueEquations& equations() {
    static const TorqueEquations equations(model());
    return equations;
  }
  Measurement measured(const std::vector<FloatingSample>& samples, const FloatingLogForm& form) {
    return measured(equations(), arm().plain, samples, form);
  }
  FittedPayload found(std::vector<Measurement> measurements) const {
    return fitted_payload(model(), arm().plain, std::move(measurements));
  }

  Measurement measured(const EquationModel& equations, const LoadedRobot& robot,
                       const std::vector<FloatingSample>& samples, const FloatingLogForm& form,
                       const StreamOptions& options = {}) {
    const std::filesystem::path log = folder() / fmt::format("log{}.csv", ++logs_);
    testing::FloatingLogWriter(form, robot.mechanism).write(log, samples);
    Measurement measurement = measure(equations, robot.mechanism, {log}, options, progress_, found_);
    if (found_.has_errors()) throw Failure(FailureKind::input, found_.all().front().message);
    return measurement;
  }

  int logs_ = 0;
  Progress progress_{true};
  Diagnostics found_;
};

// A log that has all derivatives, which is used as it is.
FloatingLogForm exact_form(bool has_force = true) {
  return {.base = BaseColumns::twist_with_derivatives,
          .has_force = has_force,
          .has_rates = true,
          .has_accelerations = true};
}

double error_of(const PayloadEstimate& payload) { return (payload.values - kPayload).cwiseAbs().maxCoeff(); }

// The hand behind a hinge and a ball carries; with and without the base's force.
TEST_F(FloatingPayload, IsFoundWhateverMeasuresTheBase) {
  const std::vector<FloatingSample> samples = testing::floating_motion(arm().loaded, {.samples = 2000});
  const std::vector<FloatingSample> some(samples.begin(), samples.begin() + 300);
  for (const bool has_force : {true, false}) {
    const auto payload = [&](const FloatingLogForm& form) { return found({measured(samples, form)}).payload; };
    EXPECT_LT(error_of(found({measured(some, exact_form(has_force))}).payload), 1e-12) << has_force;
    for (const BaseColumns base : {BaseColumns::imu, BaseColumns::pose, BaseColumns::pose_with_twist}) {
      EXPECT_LT(error_of(payload({.base = base, .has_force = has_force})), 2e-4) << static_cast<int>(base);
    }
    const Eigen::Quaterniond turned(Eigen::AngleAxisd(0.5, Eigen::Vector3d(1, 2, 3).normalized()));
    const FloatingLogForm of_other{.has_force = has_force, .imu_axes = turned, .imu_place = {0.1, -0.05, 0.2}};
    EXPECT_GT(error_of(payload(of_other)), 0.01);
  }
}

TEST_F(FloatingPayload, OfAFootOfAQuadruped) {
  const Carrier robots = carrier("robots/quadruped12.urdf", "FL_FOOT", "base = \"floating\"\n");
  const TorqueModel model(robots.plain, ParameterSet::given, progress_);
  const TorqueEquations equations(model);
  const std::vector<FloatingSample> samples = testing::floating_motion(robots.loaded, {.samples = 150, .rate = 20});
  for (const bool has_force : {true, false}) {
    const Measurement with = measured(equations, robots.plain, samples, exact_form(has_force));
    const FittedPayload payload = fitted_payload(model, robots.plain, {with});
    EXPECT_LT(error_of(payload.payload), 1e-12);
    EXPECT_EQ(payload.payload.untold.cols(), 0);
    EXPECT_THAT(plausibility_warnings(robots.plain, payload, ""), IsEmpty());
    const std::string text = describe_payload(robots.plain, payload);
    EXPECT_THAT(text, HasSubstr("on link FL_FOOT"));
    EXPECT_EQ(text.find("\nbase_nz ") != std::string::npos, has_force) << text;
    EXPECT_EQ(text.find("no log has the force on the base") == std::string::npos, has_force);
  }
}

// A robot with a fixed base whose tip is behind a ball.
TEST_F(FloatingPayload, BehindABallOnAFixedBase) {
  const Carrier robots = carrier("docs/examples/ball_wrist.toml", "finger");
  const TorqueModel model(robots.plain, ParameterSet::given, progress_);
  const TorqueEquations equations(model);
  const std::vector<FloatingSample> samples = testing::floating_motion(robots.loaded, {.samples = 2000});
  for (const bool has_rates : {true, false}) {
    const FloatingLogForm form{.has_rates = has_rates, .has_accelerations = has_rates};
    const FittedPayload payload =
        fitted_payload(model, robots.plain, {measured(equations, robots.plain, samples, form)});
    EXPECT_LT(error_of(payload.payload), has_rates ? 1e-12 : 2e-4);
    EXPECT_THAT(describe_payload(robots.plain, payload), HasSubstr("wrist.wy"));
  }
}

// The file's masses are wrong; logs without the payload take their place, whatever measures the base there.
TEST_F(FloatingPayload, IsFoundAgainstALogWithoutIt) {
  const Carrier& robots = arm();
  LoadedRobot wrong = robots.plain;
  for (Body& body : wrong.mechanism.bodies) body.inertia.mass = body.inertia.mass * 2;
  const TorqueModel model(wrong, ParameterSet::given, progress_);
  const TorqueEquations equations(model);
  const auto loaded = testing::floating_motion(robots.loaded, {.samples = 200, .rate = 50});
  const auto plain = testing::floating_motion(robots.plain, {.samples = 200, .rate = 50, .seed = 5});
  const auto against = [&](const FloatingLogForm& with, const FloatingLogForm& without) {
    return fitted_payload(model, wrong,
                          {measured(equations, wrong, loaded, with), measured(equations, wrong, plain, without)});
  };
  EXPECT_LT(error_of(against(exact_form(), exact_form()).payload), 1e-9);
  EXPECT_LT(error_of(against(exact_form(false), exact_form(false)).payload), 1e-9);
  const FittedPayload mixed = against(exact_form(), exact_form(false));
  EXPECT_LT(error_of(mixed.payload), 1e-9);
  EXPECT_THAT(describe_payload(wrong, mixed), HasSubstr("no log without the payload has the force on the base"));
  EXPECT_THAT(describe_payload(wrong, mixed), HasSubstr("base_fx "));
  EXPECT_THAT(describe_payload(wrong, mixed), Not(HasSubstr("base_fx, without payload")));
  EXPECT_GT(error_of(fitted_payload(model, wrong, {mixed.measurements.front()}).payload), 0.01);
}

// Without the base's force, what a hinge on the base carries is told but for a mass on its axis, and what the base
// carries is not told at all.
TEST_F(FloatingPayload, SaysWhatTheBasesForceAloneTells) {
  for (const char* link : {"link1", "base"}) {
    const Carrier robots = free_arm(link);
    const TorqueModel model(robots.plain, ParameterSet::given, progress_);
    const TorqueEquations equations(model);
    const auto samples = testing::floating_motion(robots.loaded, {.samples = 150, .rate = 50});
    const auto payload = [&](bool has_force) {
      return fitted_payload(model, robots.plain, {measured(equations, robots.plain, samples, exact_form(has_force))});
    };
    EXPECT_LT(error_of(payload(true).payload), 1e-12);
    const FittedPayload of_joints = payload(false);
    const std::vector<std::string> doubts = plausibility_warnings(robots.plain, of_joints, "");
    EXPECT_THAT(doubts, Contains(HasSubstr("the logs do not tell the payload's mass: no log has the force on the base, "
                                           "base_fx to base_nz, which tells it: zeros, if nothing touches the robot")));
    if (std::string(link) == "base") {
      EXPECT_TRUE(of_joints.payload.untold.isIdentity(1e-9));
      EXPECT_THROW(require_told(robots.plain, of_joints), Failure);
      continue;
    }
    MatrixXd expected = MatrixXd::Zero(10, 3);
    expected(0, 0) = expected(3, 1) = expected(4, 2) = expected(7, 2) = 1;  // m, m l_z, Ixx + Iyy
    EXPECT_TRUE(of_joints.payload.untold.isApprox(expected, 1e-9)) << of_joints.payload.untold;
    EXPECT_THAT(describe_payload(robots.plain, of_joints), HasSubstr("  m\n  m lz\n  Ixx + Iyy\n"));
    const PayloadEstimate& estimate = of_joints.payload;
    for (const Index k : {1, 2, 5, 6, 8, 9}) {
      EXPECT_NEAR(estimate.values[k], kPayload[k], 1e-12);
      EXPECT_NEAR(estimate.body[k], kPayload[k], 1e-6);
    }
    for (const Index k : {0, 3, 4, 7}) EXPECT_TRUE(std::isinf(estimate.standard_deviations[k])) << k;
    EXPECT_NEAR(estimate.body[4] - estimate.body[7], kPayload[4] - kPayload[7], 1e-6);
    require_told(robots.plain, of_joints);
  }
}

// The sensor needs the motion of base and joints, and no masses; its offsets are found, too.
TEST_F(FloatingPayload, IsFoundByASensorAtTheWrist) {
  for (const auto& [robot, tip] :
       {std::pair("docs/examples/free_arm.toml", "hand"), std::pair("docs/examples/ball_wrist.toml", "finger")}) {
    const Carrier robots = carrier(robot, tip);
    Robot only_payload = robots.loaded.robot;
    for (Link& link : only_payload.links) {
      const bool is_tip = link.name == tip;
      link.inertials.erase(link.inertials.begin(), is_tip ? link.inertials.end() - 1 : link.inertials.end());
    }
    const reference::Robot<double> file = reference_robot<double>(only_payload, {});
    const auto wrench = [&](const FloatingSample& sample) -> VectorXd {
      reference::Robot<double> turned = file;
      VectorXd positions = sample.q;
      if (turned.floating_base) turned.gravity = sample.g_b;
      reference::take_orientations(turned, positions);
      const auto motion = reference::link_motions<double>(turned, positions, sample.v, sample.a, true);
      Eigen::Vector3d f(1, -2, 3), mu(0.1, 0.2, -0.3);  // the sensor's offsets
      const auto at = static_cast<std::size_t>(turned.tip);
      reference::detail::add_inertial_wrench(turned.links[at], motion[at], f, mu);
      return (VectorXd(6) << f, mu).finished();
    };
    const WristEquations equations(robots.plain);
    const auto samples = testing::floating_motion(robots.loaded, {.samples = 2000});
    FloatingLogForm exact = exact_form(false), unit{.has_force = false};
    exact.wrench = unit.wrench = wrench;
    for (const FloatingLogForm& form : {exact, unit}) {
      const Measurement measurement = measured(equations, robots.plain, samples, form, {.torques = false});
      const PayloadEstimate payload = estimate_payload_at_wrist(measurement.observations);
      EXPECT_LT(error_of(payload), form.has_rates ? 1e-12 : 2e-4) << robot;
      EXPECT_THAT(plausibility_warnings(robots.plain, {payload, {}, {}, {measurement}}, ""), IsEmpty());
    }
  }
}

// Noise of encoders, torques, forces and of what measures the base; 95 % intervals hold the truth.
TEST_F(FloatingPayload, HasHonestIntervals) {
  constexpr unsigned kRuns = 9;
  constexpr double kTwoSided95 = 1.959964;
  const auto loaded = testing::floating_motion(arm().loaded, {});
  const auto plain = testing::floating_motion(arm().plain, {.seed = 5});
  long inside = 0, all = 0;
  for (unsigned run = 1; run <= kRuns; ++run) {
    FloatingLogForm form{.base = run % 2 == 0 ? BaseColumns::imu : BaseColumns::pose,
                         .has_force = run % 3 != 0,
                         .noise = {2e-5, 0.2, 1, 0.05, 0.005, 1e-4, 1e-4}};
    form.noise.seed = run;
    const Measurement with = measured(loaded, form);
    form.noise.seed += kRuns;
    const Measurement without = measured(plain, form);
    for (const FittedPayload& payload : {found({with}), found({with, without})}) {
      const Eigen::ArrayXd error = (payload.payload.values - kPayload).cwiseAbs();
      inside += (error <= kTwoSided95 * payload.payload.standard_deviations.array()).count();
      all += error.size();
      EXPECT_LT(payload.payload.standard_deviations[0], 0.1);
      for (const JointFit& fit : payload.fits) EXPECT_TRUE(fit.is_sound());
    }
  }
  const double share = static_cast<double>(inside) / static_cast<double>(all);
  EXPECT_GE(share, 0.91);
  EXPECT_LE(share, 0.99);
}

// Poses in which robot and base are held tell mass and centre of mass, and no inertia.
TEST_F(FloatingPayload, OfPoses) {
  std::vector<FloatingSample> poses = testing::floating_motion(arm().loaded, {.samples = 200, .rate = 20});
  const reference::Robot<double> truth = reference_robot<double>(arm().loaded.robot, {});
  for (FloatingSample& each : poses) {
    each.v.setZero();
    each.a.setZero();
    each.tau = testing::torques_of(truth, each);
  }
  FloatingLogForm form = exact_form();
  form.noise.tau = form.noise.force = 1e-3;
  for (const bool has_force : {true, false}) {
    form.has_force = has_force;
    const FittedPayload payload = found({measured(poses, form)});
    for (Index k = 0; k < 4; ++k) {
      EXPECT_NEAR(payload.payload.values[k], kPayload[k], 5 * payload.payload.standard_deviations[k]);
      EXPECT_LT(payload.payload.standard_deviations[k], 0.003);
    }
    for (Index k = 4; k < 10; ++k) EXPECT_TRUE(std::isinf(payload.payload.standard_deviations[k]));
    EXPECT_TRUE(payload.payload.untold.isApprox(MatrixXd::Identity(10, 10).rightCols(6), 1e-9));
    EXPECT_THAT(plausibility_warnings(arm().plain, payload, ""), IsEmpty());
  }
}

// Doubts about the base's motion are those of identify, of each set of logs.
TEST_F(FloatingPayload, AsksWhatTheBasesMotionCannotBe) {
  const auto loaded = testing::floating_motion(arm().loaded, {.samples = 1500});
  auto in_g = testing::floating_motion(arm().plain, {.samples = 1500, .seed = 5});
  for (FloatingSample& each : in_g) each.g_b /= 9.81;
  const Measurement with = measured(loaded, {.noise = {.tau = 0.02, .force = 0.1}});
  const Measurement without = measured(in_g, {.noise = {.tau = 0.02, .force = 0.1}});
  const std::vector<std::string> doubts = plausibility_warnings(arm().plain, found({with, without}), "");
  EXPECT_THAT(doubts, Contains(HasSubstr("without payload: the base's specific force is 2.")));
  EXPECT_THAT(doubts, Contains(HasSubstr("(--imu LINK says which)?")));
  auto untouched = loaded;
  for (FloatingSample& each : untouched) each.tau.head(6).setZero();
  const Measurement carried = measured(untouched, {.noise = {.tau = 0.02}});
  EXPECT_THAT(plausibility_warnings(arm().plain, found({carried}), ""),
              Contains(HasSubstr("something carries the robot")));
}

// A joint's spring is behind a ball, whose quaternion has an entry more than its rates.
TEST_F(FloatingPayload, BehindABallWithASpring) {
  const std::string arm = R"(name = "sprung"
[[link]]
name = "upper"
joint = "ball"
type = "spherical"
mass = 2
com = [0.2, 0, 0]
inertia = { xx = 0.01, yy = 0.02, zz = 0.03 }
inertia_about = "com"
[[link]]
name = "lower"
joint = "elbow"
xyz = [0.4, 0, 0]
axis = [0, 1, 0]
mass = 1
com = [0.1, 0.02, 0]
inertia = { xx = 0.001, yy = 0.002, zz = 0.003 }
inertia_about = "com"
stiffness = 8
spring_reference = 0.3
)";
  const Carrier robots = carrier_of(arm, arm + "[payload]\nlink = \"lower\"\n" + kCarried);
  const TorqueModel model(robots.plain, ParameterSet::given, progress_);
  const TorqueEquations equations(model);
  const auto samples = testing::floating_motion(robots.loaded, {.samples = 500});
  const FloatingLogForm form{.has_rates = true, .has_accelerations = true};
  EXPECT_LT(error_of(fitted_payload(model, robots.plain, {measured(equations, robots.plain, samples, form)}).payload),
            1e-12);
}

}  // namespace
}  // namespace flatdyn
