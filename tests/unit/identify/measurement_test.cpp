// SPDX-License-Identifier: GPL-2.0-or-later
// From logs to observations: derivatives, gaps, and parts that make up the whole.
#include "laboratory/identify/measurement.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <set>

#include "laboratory/identify/least_squares.hpp"
#include "laboratory/identify/part_file.hpp"
#include "support/robot_models.hpp"
#include "support/simulated_log.hpp"

namespace flatdyn {
namespace {

using testing::LogDerivatives;
using testing::simulated;

const LoadedRobot& arm() {
  static const LoadedRobot model = testing::model_of("planar_2r_example_7_2.toml");
  return model;
}

const TorqueModel& torque_model() {
  static Progress quiet(true);
  static const TorqueModel model(arm(), ParameterSet::given, quiet);
  return model;
}

const TorqueEquations& equations() {
  static const TorqueEquations equations(torque_model());
  return equations;
}

class MeasurementTest : public ::testing::Test {
 protected:
  std::filesystem::path folder =
      std::filesystem::temp_directory_path() / fmt::format("flatdyn-measurement-{}", ::getpid());
  Diagnostics found;
  Progress progress{true};

  MeasurementTest() { std::filesystem::create_directories(folder); }
  ~MeasurementTest() override { std::filesystem::remove_all(folder); }

  std::filesystem::path log(const std::vector<testing::SimulatedSample>& samples,
                            LogDerivatives derivatives = LogDerivatives::both) {
    const std::filesystem::path path = folder / fmt::format("log{}.csv", ++logs_);
    write_log(path, samples, derivatives);
    return path;
  }
  Measurement measured(const std::vector<std::filesystem::path>& paths, const StreamOptions& options = {}) {
    return measure(equations(), arm().mechanism, paths, options, progress, found);
  }

 private:
  int logs_ = 0;
};

Eigen::VectorXd truth() {
  const std::vector<double>& values = torque_model().file_values();
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

double relative_residual(const Measurement& measurement) {
  double worst = 0;
  for (const JointObservations& joint : measurement.observations.joints) {
    worst = std::max(worst, joint.rms_residual(truth()) / joint.rms_torque());
  }
  return worst;
}

TEST_F(MeasurementTest, WithAllDerivativesTheRowsAreExact) {
  const Measurement measurement = measured({log(simulated(arm(), {.samples = 3000}))});
  EXPECT_TRUE(found.all().empty());
  EXPECT_EQ(measurement.count.used, 3000);
  EXPECT_EQ(measurement.logs.at(0).filter.band, 0);
  EXPECT_LT(relative_residual(measurement), 1e-14);
}

TEST_F(MeasurementTest, DerivativesThatAreMissingComeFromTheFilter) {
  const auto samples = simulated(arm(), {.samples = 5000, .rate = 500, .fundamental = 0.3});
  for (const LogDerivatives derivatives : {LogDerivatives::none, LogDerivatives::rates}) {
    const Measurement measurement = measured({log(samples, derivatives)});
    const SampleFilter& filter = measurement.logs.at(0).filter;
    EXPECT_EQ(filter.band, 10);
    EXPECT_EQ(filter.decimate, 16);
    EXPECT_EQ(measurement.count.lines, 5000);
    EXPECT_NEAR(static_cast<double>(measurement.count.used), (5000 - 2 * filter.half_window()) / 16, 1);
    EXPECT_LT(relative_residual(measurement), 3e-4);
  }
}

// Filtered white noise is not quite white at the samples used, and less so the more samples are used.
TEST_F(MeasurementTest, IntervalsAreHonestWhereDerivativesComeFromTheFilter) {
  constexpr int kRuns = 120;
  constexpr double kTwoSided95 = 1.959964;
  for (const std::optional<int> decimate : {std::optional<int>(), std::optional<int>(2)}) {
    int inside = 0;
    for (unsigned run = 1; run <= kRuns; ++run) {
      const auto samples =
          simulated(arm(), {.samples = 4000, .rate = 200, .fundamental = 0.3, .noise = 200, .seed = run});
      const Measurement measurement = measured({log(samples, LogDerivatives::none)}, {.decimate = decimate});
      EXPECT_GT(measurement.observations.joints.front().correlation, decimate ? 3 : 1.1);
      const Estimate estimated = estimate(measurement.observations, truth());
      const Eigen::VectorXd error = (estimated.values - truth()).cwiseAbs();
      inside += static_cast<int>((error.array() <= kTwoSided95 * estimated.standard_deviations.array()).count());
    }
    const double part = static_cast<double>(inside) / static_cast<double>(kRuns * truth().size());
    EXPECT_GE(part, 0.93);
    EXPECT_LE(part, 0.97);
  }
}

TEST_F(MeasurementTest, AGapInTimeStartsTheFilterAnew) {
  auto samples = simulated(arm(), {.samples = 4000, .rate = 500, .fundamental = 0.3});
  samples.erase(samples.begin() + 2000, samples.begin() + 2100);
  const Measurement measurement = measured({log(samples, LogDerivatives::none)});
  EXPECT_EQ(measurement.count.gaps, 1);
  EXPECT_LT(relative_residual(measurement), 3e-4);
}

TEST_F(MeasurementTest, ABandThatTheSamplingCannotHoldIsAnError) {
  measured({log(simulated(arm(), {.samples = 100}))}, {.band = 40});
  ASSERT_TRUE(found.has_errors());
  EXPECT_THAT(found.all().at(0).message, ::testing::HasSubstr("too wide for 100 samples a second"));
}

TEST_F(MeasurementTest, ATipForceIsTakenOffTheTorques) {
  const Mechanism& mechanism = arm().mechanism;
  const double q[] = {0.3, -0.8}, h_e[] = {2, -3, 0, 0, 0, 0.5};
  double tau[2];
  torque_model().tip_torque(q, h_e, tau);
  // Both links are 1 m long: moments about the joints, in the plane.
  const double x2 = std::cos(0.3 - 0.8), y2 = std::sin(0.3 - 0.8);
  const double x1 = std::cos(0.3) + x2, y1 = std::sin(0.3) + y2;
  ASSERT_EQ(mechanism.size(), 2);
  EXPECT_NEAR(tau[0], x1 * -3 - y1 * 2 + 0.5, 1e-14);
  EXPECT_NEAR(tau[1], x2 * -3 - y2 * 2 + 0.5, 1e-14);
}

double largest_difference(const Observations& a, const Observations& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.joints.size(); ++i) {
    const Eigen::MatrixXd x = a.joints[i].R.transpose() * a.joints[i].R;
    const Eigen::MatrixXd y = b.joints[i].R.transpose() * b.joints[i].R;
    worst = std::max(worst, (x - y).norm() / x.norm());
  }
  return worst;
}

// More logs than there are runs of instants to keep.
TEST_F(MeasurementTest, KeepsInstantsOfManyLogs) {
  std::vector<std::filesystem::path> logs;
  for (unsigned k = 1; k <= 60; ++k) {
    logs.push_back(log(simulated(arm(), {.samples = 1200, .rate = 250, .seed = k}), LogDerivatives::none));
  }
  const std::vector<EquationInstant> instants = measured(logs).observations.instants;
  EXPECT_LE(instants.size(), InstantSample::kMost);
  EXPECT_GT(instants.size(), InstantSample::kMost / 8);
  std::set<int> kept;
  for (const EquationInstant& each : instants) kept.insert(each.log);
  EXPECT_GT(kept.size(), 5U);
}

class PartsTest : public MeasurementTest {
 protected:
  static constexpr int kParts = 3;
  std::filesystem::path whole_log = log(simulated(arm(), {.samples = 150000, .rate = 1000}), LogDerivatives::none);

  std::vector<std::filesystem::path> parts() {
    std::vector<std::filesystem::path> files;
    for (int k = 1; k <= kParts; ++k) files.push_back(part_of({whole_log}, k));
    return files;
  }
  std::filesystem::path part_of(const std::vector<std::filesystem::path>& logs, int k,
                                std::optional<int> decimate = std::nullopt) {
    const StreamOptions options{.decimate = decimate, .part = k, .parts = kParts};
    const std::filesystem::path file = folder / fmt::format("part{}.json", k);
    std::ofstream(file) << part_text(measured(logs, options), equations(), options);
    return file;
  }
};

// The parts also agree at the edges of blocks, where the filter needs the neighbours' samples.
TEST_F(PartsTest, MakeUpTheWhole) {
  const Measurement whole = measured({whole_log});
  const Measurement merged = merge_parts(parts(), equations(), found);
  ASSERT_FALSE(found.has_errors());
  EXPECT_EQ(merged.count.used, whole.count.used);
  EXPECT_EQ(merged.count.lines, whole.count.lines);
  EXPECT_LT(largest_difference(merged.observations, whole.observations), 1e-13);
  EXPECT_LE(merged.observations.instants.size(), InstantSample::kMost);
}

// The last samples of a log, which are held back until it is read, belong to the part that has the lines before them.
TEST_F(PartsTest, HaveTheLastRowsOfALog) {
  const std::filesystem::path brief = log(simulated(arm(), {.samples = 3000, .rate = 250}), LogDerivatives::none);
  const Measurement whole = measured({brief}, {.decimate = 1});
  std::vector<std::filesystem::path> files;
  for (int k = 1; k <= kParts; ++k) files.push_back(part_of({brief}, k, 1));
  const Measurement merged = merge_parts(files, equations(), found);
  ASSERT_FALSE(found.has_errors());
  EXPECT_EQ(merged.count.used, whole.count.used);
  EXPECT_LT(largest_difference(merged.observations, whole.observations), 1e-13);
}

// Filtered samples have correlated noise, in whichever order the logs come and whichever part has them.
TEST_F(PartsTest, OfLogsThatAreFilteredAndThatAreNotMakeUpTheWhole) {
  const std::vector<std::filesystem::path> logs = {
      log(simulated(arm(), {.samples = 3000, .rate = 1000, .noise = 1})),
      log(simulated(arm(), {.samples = 5000, .rate = 1000, .noise = 1, .seed = 2}), LogDerivatives::none)};
  const Measurement whole = measured(logs);
  std::vector<std::filesystem::path> files;
  for (int k = 1; k <= kParts; ++k) files.push_back(part_of(logs, k));
  const Measurement merged = merge_parts(files, equations(), found);
  ASSERT_FALSE(found.has_errors());
  EXPECT_GT(whole.observations.joints.back().correlation, 1);
  EXPECT_EQ(merged.observations.joints.back().correlation, whole.observations.joints.back().correlation);
  EXPECT_EQ(merged.filters().size(), 2u);
  EXPECT_EQ(merged.logs, whole.logs);
  const Estimate a = estimate(merged.observations, truth()), b = estimate(whole.observations, truth());
  EXPECT_LT((a.standard_deviations - b.standard_deviations).norm(), 1e-9 * b.standard_deviations.norm());
}

// Several logs may have the same times: both are drawn, each by itself.
TEST_F(PartsTest, HaveSamplesOfAllLogs) {
  std::vector<std::filesystem::path> logs, files;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    logs.push_back(log(simulated(arm(), {.samples = 600, .rate = 1000, .seed = seed})));
  }
  for (int k = 1; k <= kParts; ++k) files.push_back(part_of(logs, k));
  const Measurement merged = merge_parts(files, equations(), found);
  ASSERT_FALSE(found.has_errors());
  std::vector<int> of_log(logs.size(), 0);
  for (const EquationInstant& sample : merged.observations.instants) ++of_log.at(static_cast<std::size_t>(sample.log));
  for (const int count : of_log) EXPECT_GT(count, 20);
  EXPECT_TRUE(std::is_sorted(merged.observations.instants.begin(), merged.observations.instants.end(),
                             [](const EquationInstant& a, const EquationInstant& b) { return a.log < b.log; }));
}

TEST_F(MeasurementTest, TheSameLogTwiceIsRefused) {
  const auto path = log(simulated(arm(), {.samples = 50}));
  std::filesystem::create_directories(folder / "copy");
  std::filesystem::copy(path, folder / "copy");
  measured({path, folder / "copy" / path.filename()});
  ASSERT_EQ(found.all().size(), 1u);
  EXPECT_THAT(found.all()[0].message, ::testing::HasSubstr("the same log as"));
}

// Processes may get the logs in different orders.
TEST_F(PartsTest, OfManyShortLogsHaveTheirShareEach) {
  std::vector<std::filesystem::path> logs;
  for (int k = 0; k < 30; ++k) {
    const unsigned seed = static_cast<unsigned>(k) + 1;
    logs.push_back(log(simulated(arm(), {.samples = 200 + 10 * k, .rate = 1000, .seed = seed})));
  }
  const Measurement whole = measured(logs);
  std::vector<std::filesystem::path> files;
  for (int k = 1; k <= kParts; ++k) {
    std::rotate(logs.begin(), logs.begin() + 7, logs.end());
    files.push_back(part_of(logs, k));
    const Measurement part = measured(logs, {.part = k, .parts = kParts});
    EXPECT_NEAR(static_cast<double>(part.count.used) * kParts, static_cast<double>(whole.count.used), 1000) << k;
  }
  const Measurement merged = merge_parts(files, equations(), found);
  ASSERT_FALSE(found.has_errors());
  EXPECT_EQ(merged.count.used, whole.count.used);
  EXPECT_LT(largest_difference(merged.observations, whole.observations), 1e-13);
}

// Every line belongs to exactly one part, and parts differ by one block at most.
TEST(BlockSharesTest, AreEqual) {
  constexpr int kParts = 4;
  const long lengths[] = {10, 3 * kBlock + 5, 0, kBlock, 2 * kBlock - 1, 77, 1, 40000};
  std::vector<long> lines(kParts, 0);
  std::vector<BlockPartition> shares;
  for (int k = 1; k <= kParts; ++k) shares.emplace_back(k, kParts);
  for (const long length : lengths) {
    for (long line = 0; line < length; ++line) {
      int owners = 0;
      for (int k = 0; k < kParts; ++k) {
        if (!shares[static_cast<std::size_t>(k)].owns(line)) continue;
        ++owners;
        ++lines[static_cast<std::size_t>(k)];
      }
      ASSERT_EQ(owners, 1) << line << " of " << length;
    }
    shares[1].owns(length + 2 * kBlock);  // lines beyond the end have no effect
    for (BlockPartition& share : shares) share.end_log(length);
    const auto [least, most] = std::minmax_element(lines.begin(), lines.end());
    EXPECT_LE(*most - *least, kBlock);
  }
}

TEST_F(PartsTest, AreMissedCountedTwiceAndToldApart) {
  const std::vector<std::filesystem::path> files = parts();
  merge_parts({files[0], files[2]}, equations(), found);
  ASSERT_EQ(found.all().size(), 1u);
  EXPECT_EQ(found.all()[0].message, "missing: part 2 of 3");
  found = {};
  merge_parts({files[0], files[1], files[2], files[1]}, equations(), found);
  ASSERT_EQ(found.all().size(), 1u);
  EXPECT_THAT(found.all()[0].message, ::testing::HasSubstr("part 2 is there twice"));
  found = {};
  const TorqueModel other(arm(), ParameterSet::full, progress);
  merge_parts(files, TorqueEquations(other), found);
  EXPECT_EQ(found.all().size(), 3u);
  EXPECT_THAT(found.all()[0].message, ::testing::HasSubstr("another robot"));
  found = {};
  std::filesystem::resize_file(files[1], 1000);
  merge_parts(files, equations(), found);
  EXPECT_THAT(found.all().at(0).message, ::testing::HasSubstr("not whole"));
}

TEST_F(PartsTest, OfOtherLogsAreRefused) {
  const std::vector<std::filesystem::path> files = parts();
  const StreamOptions options{.part = 2, .parts = kParts};
  const auto other = log(simulated(arm(), {.samples = 150000, .rate = 1000, .seed = 2}), LogDerivatives::none);
  std::ofstream(files[1]) << part_text(measured({other}, options), equations(), options);
  merge_parts(files, equations(), found);
  ASSERT_EQ(found.all().size(), 1u);
  EXPECT_EQ(found.all()[0].place.file, files[1].string());
  EXPECT_THAT(found.all()[0].message, ::testing::HasSubstr("made from other logs than"));
  EXPECT_THAT(found.all()[0].message, ::testing::HasSubstr(other.filename().string()));
}

TEST_F(PartsTest, OfAnotherVersionAreRefused) {
  const std::string text = part_text(measured({log(simulated(arm(), {.samples = 50}))}), equations(), {});
  const std::string version = "\"version\":7,";
  ASSERT_NE(text.find(version), std::string::npos);
  for (const std::string other : {"", "\"version\":6,", "\"version\":\"7\","}) {
    found = {};
    std::ofstream(folder / "part.json") << std::string(text).replace(text.find(version), version.size(), other);
    merge_parts({folder / "part.json"}, equations(), found);
    ASSERT_EQ(found.all().size(), 1u);
    EXPECT_THAT(found.all()[0].message, ::testing::HasSubstr("another version of flatdyn"));
    EXPECT_THAT(found.all()[0].hint, ::testing::HasSubstr("make all parts again by this version"));
  }
}

TEST_F(PartsTest, OfOtherEquationsAreRefused) {
  std::ofstream(folder / "part.json") << part_text(measured({log(simulated(arm(), {.samples = 50}))}), equations(), {});
  for (const FurtherParameters& other : {FurtherParameters{.offsets = true}, FurtherParameters{.temperature = 30}}) {
    found = {};
    merge_parts({folder / "part.json"}, TorqueEquations(equations().model(), other), found);
    ASSERT_EQ(found.all().size(), 1u);
    EXPECT_THAT(found.all()[0].message, ::testing::HasSubstr("other parameters than these"));
  }
}

// Numbers of parts that no part file can have.
TEST_F(PartsTest, OfWhichThereAreTooManyAreNoParts) {
  const auto short_log = log(simulated(arm(), {.samples = 50}));
  for (const StreamOptions& options : {StreamOptions{.parts = 1000000000}, StreamOptions{.part = 5, .parts = 4}}) {
    found = {};
    std::ofstream(folder / "part.json") << part_text(measured({short_log}), equations(), options);
    merge_parts({folder / "part.json"}, equations(), found);
    ASSERT_EQ(found.all().size(), 1u);
    EXPECT_THAT(found.all()[0].message, ::testing::HasSubstr("no part of an identification"));
  }
}

}  // namespace
}  // namespace flatdyn
