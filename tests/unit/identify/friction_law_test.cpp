// SPDX-License-Identifier: GPL-2.0-or-later
// Friction that is more than F_v q̇ + F_s sgn q̇, in noisy logs.
#include <gtest/gtest.h>

#include "laboratory/identify/friction_search.hpp"
#include "laboratory/identify/identification.hpp"
#include "laboratory/identify/rest_search.hpp"
#include "laboratory/identify/temperature_survey.hpp"
#include "report/identification_report.hpp"
#include "support/practical_bench.hpp"

namespace flatdyn {
namespace {

using testing::kEncoderStep;
using testing::SimulatedSample;
using Bench = testing::PracticalBench;

class FrictionLaws : public ::testing::Test {
 protected:
  Bench& bench = testing::ur5();

  // The motion with friction that a law adds to the arm's, given by joint, F_s and speed.
  template <class More>
  std::vector<SimulatedSample> motion(const More& more) const {
    std::vector<SimulatedSample> samples = bench.motion({});
    for (SimulatedSample& sample : samples) {
      for (int i = 0; i < 6; ++i) sample.tau(i) += more(coulomb(i), sample.qd(i));
    }
    return samples;
  }
  double coulomb(int joint) const { return bench.arm().coulomb[static_cast<std::size_t>(joint)]; }

  // The equations of a law, its speeds found from the log where it has some.
  TorqueEquations equations_of(FrictionLaw law, const std::vector<SimulatedSample>& samples) {
    FurtherParameters further{law};
    if (has_speed(law)) {
      const Measurement linear = bench.measured(samples, kEncoderStep, 1);
      const TorqueEquations dictionary(bench.model(), {law, {}, false, friction_dictionary(bench.equations(), linear)});
      FrictionSpeeds speeds = friction_speeds(dictionary, bench.measured(samples, kEncoderStep, 1, 1, {}, &dictionary));
      further.speeds = std::move(speeds.speeds);
      are_told = std::move(speeds.are_told);
    }
    return TorqueEquations(bench.model(), further);
  }

  // Expects a fit that leaves nothing but noise, and parameters named `stem` that are `share` of each joint's F_s.
  void expect_found(const std::vector<SimulatedSample>& samples, FrictionLaw law, const std::string& stem,
                    double share) {
    const TorqueEquations equations = equations_of(law, samples);
    const Measurement measurement = bench.measured(samples, kEncoderStep, 1, 1, {}, &equations);
    const Estimate found = estimate_of(equations, measurement, {});
    for (const JointFit& fit :
         fit_quality(measurement.observations, measurement.logs, found.values, equations.acceleration_rows())) {
      EXPECT_LT(fit.ratio, 1.3);
    }
    int checked = 0;
    for (int k = 0; k < equations.parameters(); ++k) {
      const std::string& name = equations.names()[static_cast<std::size_t>(k)];
      if (name.substr(0, 2) != stem) continue;
      const double truth = share * coulomb(name[2] - '1');
      EXPECT_NEAR(found.values(k), truth, std::max(0.03 * truth, 4 * found.standard_deviations(k))) << name;
      ++checked;
    }
    EXPECT_EQ(checked, 6);
    for (const double speed : equations.further().speeds) EXPECT_NEAR(speed, kSpeed, 0.05 * kSpeed);
  }

  std::vector<bool> are_told;             // FrictionSpeeds::are_told
  static constexpr double kSpeed = 0.08;  // rad/s
};

TEST_F(FrictionLaws, AsymmetricFrictionIsFound) {
  const auto samples = motion([](double F_s, double qd) { return qd == 0 ? 0 : 0.15 * F_s; });
  expect_found(samples, FrictionLaw::asymmetric, "Fa", 0.15);
}

TEST_F(FrictionLaws, FrictionThatIsLargerNearRestIsFoundWithItsSpeed) {
  const auto samples = motion([](double F_s, double qd) {
    return 0.4 * F_s * std::exp(-(qd / kSpeed) * (qd / kSpeed)) * ((qd > 0) - (qd < 0));
  });
  expect_found(samples, FrictionLaw::stribeck, "Fb", 0.4);
}

TEST_F(FrictionLaws, SmoothFrictionIsFoundWithItsSpeed) {
  const auto samples =
      motion([](double F_s, double qd) { return F_s * (std::tanh(qd / kSpeed) - ((qd > 0) - (qd < 0))); });
  expect_found(samples, FrictionLaw::smooth, "Fs", 1);
}

// Logs with a column of temperatures for each joint.
class WarmLogs : public FrictionLaws {
 protected:
  // Writes a log at the temperatures, with friction at 40 °C that falls by 1 % (viscous) and 0.5 % (Coulomb) for each
  // kelvin.
  void write(double (*temperature)(double time, int joint)) const {
    std::vector<SimulatedSample> samples = bench.motion({});
    for (SimulatedSample& sample : samples) {
      for (int i = 0; i < 6; ++i) {
        const double qd = sample.qd(i),
                     per_kelvin = kViscous * viscous(i) * qd + kCoulomb * std::copysign(coulomb(i), qd);
        sample.tau(i) += (temperature(sample.time, i) - kAt) * per_kelvin;
      }
    }
    write_with_temperatures(samples, temperature);
  }
  Estimate estimated_by(const TorqueEquations& by) {
    Progress quiet{true};
    Diagnostics said;
    measurement = measure(by, bench.plain().mechanism, {path}, {.temperatures = true}, quiet, said);
    EXPECT_TRUE(said.all().empty());
    return estimate_of(by, measurement, {});
  }
  Estimate estimated(double (*temperature)(double time, int joint)) {
    write(temperature);
    return estimated_by(equations);
  }
  double viscous(int joint) const { return bench.arm().viscous[static_cast<std::size_t>(joint)]; }
  Eigen::Index place_of(const std::string& stem, int joint) const {
    const std::string name = fmt::format("{}{}", stem, joint + 1);
    return std::ranges::find(equations.names(), name) - equations.names().begin();
  }
  ~WarmLogs() override {
    std::filesystem::remove(plain);
    std::filesystem::remove(path);
  }

  static constexpr double kViscous = -0.01, kCoulomb = -0.005, kAt = 40;
  TorqueEquations equations{bench.model(), {.temperature = kAt}};
  Measurement measurement;

  void write_with_temperatures(const std::vector<SimulatedSample>& samples, double (*temperature)(double, int)) const {
    write_practical_log(plain, bench.arm(), samples, kEncoderStep, 1, 1);
    std::ifstream in(plain);
    std::ofstream out(path);
    std::string line;
    for (std::size_t row = 0; std::getline(in, line); ++row) {
      out << line;
      for (int i = 0; i < 6; ++i) {
        out << (row == 0 ? fmt::format(",temperature{} [degC]", i + 1)
                         : fmt::format(",{:.1f}", temperature(samples[row - 1].time, i)));
      }
      out << "\n";
    }
  }

  std::filesystem::path plain = std::filesystem::temp_directory_path() / fmt::format("warm-{}", ::getpid()),
                        path = plain.string() + ".csv";
};

// The drives warm up by 15 K. No joint reaches 40 °C, at which friction is found.
TEST_F(WarmLogs, TellHowFrictionChanges) {
  const Estimate found = estimated([](double time, int joint) { return 20 + joint + 15 * (1 - std::exp(-time / 8)); });
  for (const JointFit& fit :
       fit_quality(measurement.observations, measurement.logs, found.values, equations.acceleration_rows())) {
    EXPECT_LT(fit.ratio, 1.3);
  }
  for (int i = 0; i < 6; ++i) {
    for (const auto& [stem, truth] :
         {std::pair{"Fv", viscous(i)}, std::pair{"Fs", coulomb(i)}, std::pair{"FvT", kViscous * viscous(i)},
          std::pair{"FsT", kCoulomb * coulomb(i)}}) {
      const Eigen::Index k = place_of(stem, i);
      EXPECT_NEAR(found.values(k), truth, 3.5 * found.standard_deviations(k)) << stem << i;
      EXPECT_LT(found.standard_deviations(k), 0.2 * std::abs(truth)) << stem << i;
    }
  }
  EXPECT_TRUE(temperature_warnings(equations, found).empty());
}

// All at 30 °C: friction at 40 °C is anything.
TEST_F(WarmLogs, OfOneTemperatureTellNoOther) {
  const Estimate found = estimated([](double, int) { return 30.0; });
  for (int i = 0; i < 6; ++i) {
    for (const char* stem : {"Fv", "Fs", "FvT", "FsT"}) {
      EXPECT_FALSE(std::isfinite(found.standard_deviations(place_of(stem, i)))) << stem << i;
    }
  }
  const std::vector<std::string> warnings = temperature_warnings(equations, found);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("no friction at --temperature 40"), std::string::npos) << warnings[0];
}

// Friction is found at the temperature of the log then.
TEST_F(WarmLogs, ThatAreEvenHaveFrictionAtTheirTemperature) {
  write([](double time, int joint) { return joint == 2 ? 25 + 10 * std::sin(time) : 30.0; });
  std::vector<bool> even = even_temperatures({path}, bench.plain().mechanism, {.temperatures = true}, kAt);
  EXPECT_EQ(even, std::vector<bool>({true, true, false, true, true, true}));
  const TorqueEquations by(bench.model(), {.temperature = kAt, .even_temperatures = std::move(even)});
  const Estimate found = estimated_by(by);
  for (int i = 0; i < 6; ++i) {
    const double kelvins = i == 2 ? 0 : 30 - kAt;
    for (const auto& [stem, truth] : {std::pair{"Fv", viscous(i) * (1 + kelvins * kViscous)},
                                      std::pair{"Fs", coulomb(i) * (1 + kelvins * kCoulomb)}}) {
      const auto k = std::ranges::find(by.names(), fmt::format("{}{}", stem, i + 1)) - by.names().begin();
      EXPECT_NEAR(found.values(k), truth, 3.5 * found.standard_deviations(k)) << stem << i;
    }
  }
  const std::vector<std::string> warnings = temperature_warnings(by, found);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("the temperatures hardly change"), std::string::npos) << warnings[0];
}

// All speeds of a joint that moves slowly are below v: F_s tanh(q̇/v) is as viscous as F_v q̇, and F_b as constant as
// F_s.
TEST_F(FrictionLaws, AreNotToldByAJointThatIsSlowerThanTheirSpeed) {
  constexpr int kSlow = 1;
  for (const auto law : {FrictionLaw::stribeck, FrictionLaw::smooth}) {
    std::vector<SimulatedSample> samples = bench.motion({.seconds = 12, .scale = {1, 0.02, 1, 1, 1, 1}});
    for (SimulatedSample& sample : samples) {
      for (int i = 0; i < 6; ++i) {
        const double qd = sample.qd(i), part = qd / kSpeed, sign = (qd > 0) - (qd < 0);
        sample.tau(i) +=
            coulomb(i) * (law == FrictionLaw::smooth ? std::tanh(part) - sign : 0.4 * std::exp(-part * part) * sign);
      }
    }
    equations_of(law, samples);
    for (int i = 0; i < 6; ++i) EXPECT_EQ(are_told[static_cast<std::size_t>(i)], i != kSlow) << i;
  }
}

// A dictionary's columns and offsets together are where the names say.
TEST_F(FrictionLaws, EveryEntryHasTheValueOfItsLaw) {
  const TorqueEquations equations(bench.model(), {FrictionLaw::asymmetric, {}, true});
  EXPECT_EQ(equations.parameters(), bench.model().parameters() + 12);
  ASSERT_EQ(equations.friction().size(), 18u);
  int entry = 0;
  for (int i = 0; i < 6; ++i) {
    for (const int column : equations.columns()[static_cast<std::size_t>(i)]) {
      const std::string& name = equations.names()[static_cast<std::size_t>(column)];
      const auto law = std::find_if(equations.friction().begin(), equations.friction().end(),
                                    [&](const FrictionEntry& each) { return each.entry == entry; });
      EXPECT_EQ(law != equations.friction().end(), name.front() == 'F') << name;
      if (law != equations.friction().end()) {
        EXPECT_EQ(law->joint, i) << name;
      }
      ++entry;
    }
  }
  EXPECT_EQ(entry, equations.entries());
}

// The elbow sticks and slips: below 2 % of its largest speed, its friction is anything.
TEST_F(FrictionLaws, RowsOfAJointThatCreepsAreLeftOut) {
  constexpr int kElbow = 2;
  std::vector<SimulatedSample> samples = bench.motion({});
  EXPECT_TRUE(better_rest_speeds(bench.equations(), bench.measured(samples, kEncoderStep, 1),
                                 bench.estimated(bench.measured(samples, kEncoderStep, 1)).values)
                  .empty());
  double fastest = 0;
  for (const SimulatedSample& sample : samples) fastest = std::max(fastest, std::abs(sample.qd(kElbow)));
  for (SimulatedSample& sample : samples) {
    const double qd = sample.qd(kElbow);
    if (std::abs(qd) < 0.02 * fastest) sample.tau(kElbow) -= 2 * coulomb(kElbow) * ((qd > 0) - (qd < 0));
  }
  const Measurement before = bench.measured(samples, kEncoderStep, 1);
  const std::vector<double> speeds = better_rest_speeds(bench.equations(), before, bench.estimated(before).values);
  ASSERT_EQ(speeds.size(), 6u);
  for (int i = 0; i < 6; ++i) {
    const double speed = speeds[static_cast<std::size_t>(i)],
                 earlier = before.rest_speeds()[static_cast<std::size_t>(i)];
    EXPECT_EQ(speed > earlier, i == kElbow) << i;
  }
  EXPECT_NEAR(speeds[kElbow], 0.03 * fastest, 0.005 * fastest);
  const Measurement after = bench.measured(samples, kEncoderStep, 1, 1, {.rest_speed = speeds});
  const Estimate found = bench.estimated(after), early = bench.estimated(before);
  const int k = bench.place_of("Fs3");
  EXPECT_GT(std::abs(early.values(k) - bench.truth(k)), 4 * std::abs(found.values(k) - bench.truth(k)));
}

TEST(FrictionEntry, SlopesAreDerivativesByTheSpeed) {
  constexpr double kStep = 1e-6;
  using Law = FrictionEntry::Law;
  for (const auto& [law, slope] : {std::pair{Law::stribeck, Law::stribeck_slope}, {Law::smooth, Law::smooth_slope}}) {
    for (const double rate : {-0.3, -0.02, 0.05, 0.4}) {
      const auto at = [&, law = law](double speed) { return FrictionEntry{0, 0, law, speed, 2}.value(rate); };
      const double derivative = (at(0.1 + kStep) - at(0.1 - kStep)) / (2 * kStep);
      EXPECT_NEAR((FrictionEntry{0, 0, slope, 0.1, 2}.value(rate)), derivative, 1e-6) << rate;
    }
  }
}

TEST_F(FrictionLaws, HuberWeightsKeepOutliersFromFriction) {
  std::vector<SimulatedSample> samples = bench.motion({});
  for (std::size_t k = 3000; k < samples.size(); k += 3000) samples[k].tau(1) += 400;
  const Measurement plain = bench.measured(samples, kEncoderStep, 1);
  const Estimate before = bench.estimated(plain);
  const Estimate after = bench.robustly_estimated(samples, kEncoderStep, 1);
  const int k = bench.place_of("Fs2");
  EXPECT_LT(after.standard_deviations(k), 0.6 * before.standard_deviations(k));
  EXPECT_NEAR(after.values(k), bench.truth(k), 4 * after.standard_deviations(k));
}

}  // namespace
}  // namespace flatdyn
