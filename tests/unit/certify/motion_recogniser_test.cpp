// SPDX-License-Identifier: GPL-2.0-or-later
// Recognition of the operations of a text that are motions of links.
#include "proof/certify/motion_recogniser.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "code/languages/emit.hpp"
#include "code/languages/readers.hpp"
#include "code/readback/emitted_text.hpp"
#include "code/readback/straight_line_values.hpp"
#include "functions/load/load_robot.hpp"
#include "graph/passes/passes.hpp"
#include "proof/certify/error_terms.hpp"
#include "proof/certify/model_constants.hpp"
#include "support/fast_states.hpp"
#include "support/limited_robots.hpp"

namespace flatdyn {
namespace {

constexpr double kOfDoubles = 1e-9;

// The text of a function, its motions, and derivatives of one torque.
class ReadMotions {
 public:
  explicit ReadMotions(const Mechanism& mechanism)
      : mechanism_(mechanism),
        function_(run_passes(derive_function(mechanism, "inverse_dynamics"))),
        constants_(function_),
        text_(EmittedText(emit_header(mechanism, {function_}, {}), header_reader()).operations(0, function_)) {}

  std::unique_ptr<MotionRecogniser> motions() const {
    return std::make_unique<MotionRecogniser>(mechanism_, input_limits(mechanism_),
                                              [this](double literal) { return constants_.exact_size(literal); });
  }
  const StraightLine& text() const { return text_; }
  ErrorAnalysis analysis() const {
    const RoundingModel model{rounding_format("double"), 0x1p-53,
                              [this](double literal) { return constants_.error(literal, rounding_format("double")); }};
    return ErrorAnalysis(text_, model, input_limits(mechanism_), motions());
  }

 private:
  const Mechanism& mechanism_;
  Function function_;
  ModelConstants constants_;
  StraightLine text_;
};

int recognised(const MotionRecogniser& motions, const StraightLine& lines) {
  int count = 0;
  for (int k = 0; k < lines.size(); ++k) count += motions.group(k) >= 0 ? 1 : 0;
  return count;
}

class TextOfArm : public ::testing::TestWithParam<const char*> {
 protected:
  const Mechanism mechanism_ =
      testing::within_limits(load_robot(std::string(FLATDYN_SOURCE_DIR) + GetParam(), {}).mechanism);
  const ReadMotions read_{mechanism_};
};

TEST_P(TextOfArm, IsOfMotionsInPart) {
  const std::unique_ptr<MotionRecogniser> motions = read_.motions();
  motions->recognise(read_.text(), std::nullopt);
  EXPECT_GT(recognised(*motions, read_.text()), read_.text().size() / 4);
  EXPECT_EQ(motions->group(read_.text().outputs[0][0]), -1);  // all links contribute to it
  std::vector<double> seen(static_cast<std::size_t>(read_.text().size()), 0);
  for (const State& state : testing::fast_states(mechanism_, 300)) {
    const std::vector<double> values = values_of(read_.text(), state);
    for (std::size_t k = 0; k < values.size(); ++k) seen[k] = std::max(seen[k], std::abs(values[k]));
  }
  for (int k = 0; k < read_.text().size(); ++k) {
    EXPECT_LE(seen[static_cast<std::size_t>(k)], motions->largest(k) * (1 + kOfDoubles)) << "operation " << k;
  }
}

// Two results of one link together, with any factors and as a vector.
TEST_P(TextOfArm, HasVectorsOfOneMotion) {
  const std::unique_ptr<MotionRecogniser> motions = read_.motions();
  motions->recognise(read_.text(), std::nullopt);
  std::vector<int> pair;
  for (int k = read_.text().size() - 1; k >= 0 && pair.size() < 2; --k) {
    if (motions->group(k) >= 0 && (pair.empty() || motions->group(k) == motions->group(pair[0]))) pair.push_back(k);
  }
  ASSERT_EQ(pair.size(), 2u);
  Eigen::MatrixXd rows(2, 2);
  rows << 1, 0.3, -0.4, 2;
  const double bound = motions->largest_length(pair, rows);
  EXPECT_LE(bound, rows.col(0).norm() * motions->largest(pair[0]) + rows.col(1).norm() * motions->largest(pair[1]));
  for (const State& state : testing::fast_states(mechanism_, 300)) {
    const std::vector<double> values = values_of(read_.text(), state);
    const Eigen::Vector2d x(values[static_cast<std::size_t>(pair[0])], values[static_cast<std::size_t>(pair[1])]);
    EXPECT_LE((rows * x).norm(), bound * (1 + kOfDoubles));
  }
}

// Results, and derivatives of a torque by them, at random states.
TEST_P(TextOfArm, IsBoundedFromAboveWithMotions) {
  ErrorAnalysis analysis = read_.analysis();
  analysis.error_of(read_.text().outputs[0][1], 1);
  const StraightLine& all = analysis.text();
  ASSERT_GT(all.size(), analysis.executed());  // derivatives exist
  std::vector<double> seen(static_cast<std::size_t>(all.size()), 0);
  for (const State& state : testing::fast_states(mechanism_, 100)) {
    const std::vector<double> values = values_of(all, state);
    for (std::size_t k = 0; k < values.size(); ++k) seen[k] = std::max(seen[k], std::abs(values[k]));
  }
  constexpr double kLeast = 1e-12;  // slack for rounding of the values themselves
  double looseness = 0;
  for (int k = 0; k < all.size(); ++k) {
    const double largest = seen[static_cast<std::size_t>(k)], bound = analysis.norms().largest(k);
    EXPECT_LE(largest, bound + kLeast) << "operation " << k;
    looseness += std::log(std::max(bound, kLeast) / std::max(largest, kLeast));
  }
  EXPECT_LT(std::exp(looseness / all.size()), 8);  // geometric mean
}

INSTANTIATE_TEST_SUITE_P(Robots, TextOfArm, ::testing::Values("/robots/rx90.toml", "/docs/examples/general_7r.toml"),
                         [](const auto& test) {
                           return std::string(test.param).find("rx90") != std::string::npos ? "rx90" : "general_7r";
                         });

// With a base that floats: the same, of links that move with the base and of the torques of base and joints.
TEST(MotionRecogniser, KnowsTheMotionOfAFloatingBase) {
  const Mechanism mechanism = testing::limited_robot("floating planar_2r_example_7_2.toml");
  const ReadMotions read(mechanism);
  const std::unique_ptr<MotionRecogniser> motions = read.motions();
  motions->recognise(read.text(), std::nullopt);
  EXPECT_GT(recognised(*motions, read.text()), read.text().size() / 5);
  ErrorAnalysis analysis = read.analysis();
  for (const int torque : {1, 4, 7})
    analysis.error_of(read.text().outputs[0][static_cast<std::size_t>(torque)], torque);
  for (const State& state : testing::fast_states(mechanism, 200)) {
    const std::vector<double> values = values_of(analysis.text(), state);
    for (int k = 0; k < read.text().size(); ++k) {
      EXPECT_LE(std::abs(values[static_cast<std::size_t>(k)]), motions->largest(k) * (1 + kOfDoubles)) << k;
    }
    for (int k = 0; k < analysis.text().size(); ++k) {
      EXPECT_LE(std::abs(values[static_cast<std::size_t>(k)]), analysis.norms().largest(k) + 1e-12) << k;
    }
  }
}

TEST(MotionRecogniser, AreNoneOfPrismaticJoints) {
  const Mechanism mechanism = testing::limited_robot("scara.toml");
  ASSERT_TRUE(mechanism.has_prismatic_joint());
  const ReadMotions read(mechanism);
  const std::unique_ptr<MotionRecogniser> motions = read.motions();
  motions->recognise(read.text(), std::nullopt);
  EXPECT_EQ(recognised(*motions, read.text()), 0);
}

// 0.1 stands for two numbers, so its products cannot be recognised as those of a motion.
TEST(MotionRecogniser, NeedExactConstants) {
  const Mechanism mechanism = testing::limited_robot("rx90.toml");
  StraightLine lines;
  const int rate = lines.input({InputKind::qd, 0});
  const int known = lines.multiply(lines.constant(0.2), rate), unknown = lines.multiply(lines.constant(0.1), rate);
  MotionRecogniser motions(mechanism, input_limits(mechanism), [](double literal) {
    return literal == 0.1 ? std::nullopt : std::optional(Rational(literal));
  });
  motions.recognise(lines, std::nullopt);
  EXPECT_GE(motions.group(known), 0);
  EXPECT_NEAR(motions.largest(known), 0.2 * 2, 1e-6);
  EXPECT_EQ(motions.group(unknown), -1);
  EXPECT_EQ(motions.largest(unknown), INFINITY);
}

}  // namespace
}  // namespace flatdyn
