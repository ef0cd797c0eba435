// SPDX-License-Identifier: GPL-2.0-or-later
// The worked examples of docs/identification.md.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"
#include "cli/torques_of_log.hpp"
#include "laboratory/identify/motion_limits.hpp"
#include "support/parallel_filter.hpp"
#include "support/robot_models.hpp"
#include "support/simulated_log.hpp"

namespace flatdyn::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

// Runs a script of docs/examples/ with a short search; more: further arguments; variables: such as "RATE=500".
Outcome run_example(const std::string& script, const std::string& folder, const std::string& more = "",
                    const std::string& variables = "") {
  const std::string command =
      fmt::format("cd {} && EVALUATIONS=60 FLATDYN={} {} docs/examples/{} {} {} > {}/out 2> {}/err", FLATDYN_SOURCE_DIR,
                  FLATDYN_PROGRAM, variables, script, folder, more, folder, folder);
  Outcome outcome;
  outcome.code = std::system(command.c_str());
  return outcome;
}

TEST(Examples, ThePlanarArmIsIdentifiedFromExample72sMotion) {
  const Scratch scratch;
  ASSERT_EQ(run_example("identify_planar_arm.sh", scratch.path()).code, 0) << scratch.read("err");
  EXPECT_THAT(scratch.read("out"), HasSubstr("2002 samples, 2002 used"));
  for (const char* row : {"m1lx  79.9961       0.0065   0.0082 %   79.9936", "I1zz  177.513       0.0059   0.0033 %",
                          "Im2   0.0100002     5.2e-07  0.0052 %"}) {
    EXPECT_THAT(scratch.read("out"), HasSubstr(row));
  }
  EXPECT_THAT(scratch.read("residuals.svg"), HasSubstr("one log behind the other"));
  EXPECT_EQ(run_flatdyn("verify -q --states 5 --functions inverse_dynamics " + scratch.path("identified.toml")).code,
            0);
}

// All masses of the given robot file are wrong; the result must be right nevertheless.
TEST(Examples, APandaIsIdentifiedFromAnExcitationWithNoise) {
  const Scratch scratch;
  ASSERT_EQ(run_example("identify_panda.sh", scratch.path()).code, 0) << scratch.read("err");
  EXPECT_THAT(scratch.read("residuals.svg"), HasSubstr("<svg"));
  EXPECT_EQ(scratch.read("out").find("did not converge"), std::string::npos) << scratch.read("out");
  EXPECT_THAT(scratch.read("out"), HasSubstr("divergence from the file's links: "));
  write_log(scratch.path("other.csv"), simulated(model_of("panda.urdf"), {.samples = 50, .seed = 9}));
  const auto truth = torques("robots/panda.urdf", scratch.path("other.csv"));
  const auto found = torques(scratch.path("identified.toml"), scratch.path("other.csv"));
  const auto wrong = torques(scratch.path("panda_unknown.urdf"), scratch.path("other.csv"));
  double largest = 0, largest_before = 0;
  for (std::size_t k = 0; k < truth.size(); ++k) {
    for (std::size_t i = truth[k].size() - 7; i < truth[k].size(); ++i) {
      largest = std::max(largest, std::abs(found[k][i] - truth[k][i]));
      largest_before = std::max(largest_before, std::abs(wrong[k][i] - truth[k][i]));
    }
  }
  EXPECT_LT(largest, 0.3);
  EXPECT_GT(largest_before, 5);
}

// Logs with all that a model lacks, judged by second ones.
struct PracticalCase {
  const char* robot;
  int rate;         // samples a second
  int evaluations;  // of the search for the motion
  // Searches that start elsewhere find motions that tell more of one parameter and less of another, so that a single
  // one says little about a joint.
  int motions;
};

// Squares of torque errors in validation logs, by joint, summed over rows in which the joint moves.
struct TorqueErrors {
  Eigen::ArrayXd own, other;  // of flatdyn's links, of the other program's parameters
  Eigen::ArrayXd put_in;      // of the torques that the arm's own parameters give: noise, ripple, friction near rest
  Eigen::ArrayXd rows;
};

class PracticalExample : public ::testing::TestWithParam<PracticalCase> {
 protected:
  static constexpr double kBound = 1.15;
  static constexpr std::size_t kEvery = 4;  // samples of the validation log
  Scratch scratch;

  void make_logs_and_identify(int seed) const {
    const auto& [robot, rate, evaluations, motions] = GetParam();
    const std::string variables = fmt::format("RATE={} EVALUATIONS={} SEED={}", rate, evaluations, seed);
    ASSERT_EQ(run_example("identify_practical.sh", scratch.path(), robot, variables).code, 0) << scratch.read("err");
  }

  SampledLog log(int joints) const {
    const auto rows = numbers_of(scratch.read("log.csv"));
    const auto count = static_cast<Eigen::Index>(rows.size());
    SampledLog result{1.0 / GetParam().rate, Eigen::MatrixXd(count, joints), Eigen::MatrixXd(count, joints)};
    for (Eigen::Index k = 0; k < count; ++k) {
      const Eigen::Map<const Eigen::RowVectorXd> row(rows[static_cast<std::size_t>(k)].data(), 2 * joints + 1);
      result.q.row(k) = row.segment(1, joints);
      result.tau.row(k) = row.tail(joints);
    }
    return result;
  }

  // A motion faster than the arm's limits would judge an extrapolation of friction.
  void expect_validation_within_limits(const Mechanism& mechanism) const {
    const std::vector<JointLimits> limits = motion_limits(mechanism);
    const std::size_t n = limits.size();
    std::vector<LimitUse> use(n);
    for (const auto& row : numbers_of(scratch.read("validation_exact.csv"))) {
      for (std::size_t i = 0; i < n; ++i) {
        const auto entry = [&](std::size_t k) { return row.at(1 + k * n + i); };
        update_use(use[i], limits[i], entry(0), entry(1), entry(2), entry(3));
      }
    }
    constexpr double kWithin = 1 + 1e-9;  // a wrist of the UR5 turns at its limit, pi rad/s
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_LE(use[i].position, kWithin);
      EXPECT_LE(use[i].speed, kWithin);
      EXPECT_LE(use[i].torque, kWithin);
      if (!mechanism.joints()[i].limits.acceleration) continue;
      EXPECT_LE(use[i].acceleration, kWithin);
    }
  }

  void add_errors(const LoadedRobot& arm, TorqueErrors& sum) const {
    const int n = arm.mechanism.size();
    const ParallelFilter judge(arm, {});
    const Eigen::VectorXd pi = judge.identified(log(n));
    if (sum.rows.size() == 0) sum.own = sum.other = sum.put_in = sum.rows = Eigen::ArrayXd::Zero(n);
    const auto exact = numbers_of(scratch.read("validation_exact.csv")),
               measured = numbers_of(scratch.read("validation.csv")),
               found = torques(scratch.path("identified.toml"), scratch.path("validation_motion.csv"));
    ASSERT_EQ(found.size(), exact.size());
    for (std::size_t k = 0; k < found.size(); k += kEvery) {
      const auto part = [n](const std::vector<double>& row, int first) {
        return Eigen::Map<const Eigen::VectorXd>(row.data() + 1 + first * n, n);
      };
      const auto qd = part(exact[k], 1), tau = part(measured[k], 1);
      const Eigen::ArrayXd moves = (qd.array() != 0).cast<double>();
      if (moves.maxCoeff() == 0) continue;
      sum.own += moves * (part(found[k], 3) - tau).array().square();
      sum.other += moves * (judge.matrix(part(exact[k], 0), qd, part(exact[k], 2)) * pi - tau).array().square();
      sum.put_in += moves * (part(exact[k], 3) - tau).array().square();
      sum.rows += moves;
    }
  }
};

// The other program has other filters and another regressor (support/parallel_filter.hpp).
TEST_P(PracticalExample, IsIdentifiedAsWellAsByAnotherProgram) {
  const auto& [robot, rate, evaluations, motions] = GetParam();
  TorqueErrors sum;
  for (int seed = 1; seed <= motions; ++seed) {
    ASSERT_NO_FATAL_FAILURE(make_logs_and_identify(seed));
    const LoadedRobot arm = load_robot(scratch.path("truth.toml"), {});
    expect_validation_within_limits(arm.mechanism);
    ASSERT_NO_FATAL_FAILURE(add_errors(arm, sum));
  }
  EXPECT_GT(sum.rows.minCoeff() * kEvery, 4.5 * rate * motions);  // 5 s for the joint that is held, else 10
  EXPECT_GT(sum.rows.maxCoeff() * kEvery, 9 * rate * motions);
  // Both leave what was put in, but for the part of friction near rest that F_s takes.
  const Eigen::ArrayXd own = (sum.own / sum.put_in).sqrt(), other = (sum.other / sum.put_in).sqrt();
  EXPECT_GT(own.minCoeff(), 0.8);
  EXPECT_GT(other.minCoeff(), 0.8);
  EXPECT_LT(own.maxCoeff(), 1.3);
  EXPECT_LT(other.maxCoeff(), 1.3);
  const Eigen::ArrayXd ratios = (sum.own / sum.other).sqrt();
  const double ratio = std::sqrt(sum.own.sum() / sum.other.sum());
  EXPECT_LT(ratio, kBound);
  EXPECT_LT(ratios.maxCoeff(), kBound);
  RecordProperty("ratio", fmt::format("{:.3f}", ratio));
  fmt::print("torque error to the other program's: {:.2f}, by joint {:.2f} to {:.2f}\n", ratio, ratios.minCoeff(),
             ratios.maxCoeff());
}

INSTANTIATE_TEST_SUITE_P(Robots, PracticalExample,
                         ::testing::Values(PracticalCase{"ur5", 500, 60, 1}, PracticalCase{"panda", 1000, 1000, 3}),
                         [](const auto& test) { return std::string(test.param.robot); });

}  // namespace
}  // namespace flatdyn::testing
