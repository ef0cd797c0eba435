// SPDX-License-Identifier: GPL-2.0-or-later
// The vectors of a self test on a target: the bounds are those of the certificate, and the search finds worse states
// than the random ones.
#include "delivery/firmware/test_vectors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "code/languages/emit.hpp"
#include "code/languages/readers.hpp"
#include "code/readback/emitted_text.hpp"
#include "code/readback/straight_line_values.hpp"
#include "functions/deviation/expected.hpp"
#include "functions/planning/make_functions.hpp"
#include "proof/certify/certificate.hpp"
#include "support/robot_models.hpp"

namespace flatdyn {
namespace {

using ::testing::Each;
using ::testing::Field;

constexpr std::size_t kDrawn = 12;  // states before those that the search finds

struct Made {
  LoadedRobot model;
  std::vector<Function> functions;
  std::string header;
  TestVectors vectors;
};

Made made(const char* robot, const std::vector<std::string>& names, const std::string& scalar, bool fuses = false) {
  PipelineOptions options;
  options.functions = names;
  Made result{testing::model_of(robot), {}, "", {}};
  Progress quiet(true);
  Diagnostics findings;
  result.functions = functions_of(make_functions(result.model, options, quiet, findings));
  EmitOptions emit;
  emit.scalar = scalar;
  emit.fuses = fuses;
  result.header = emit_header(result.model.mechanism, result.functions, emit);
  result.vectors = test_vectors(result.model.robot, result.model.mechanism, result.functions, emit, quiet);
  return result;
}

// Gravity of the UR5 reads angles only, so its bounds hold everywhere; functions of speeds have no proof at 1000 rad/s.
class TestVectorsOf : public ::testing::TestWithParam<bool> {};  // whether the text has fused multiply-adds

TEST_P(TestVectorsOf, TheTextHaveTheBoundsOfItsCertificate) {
  const Made ur5 = made("ur5.urdf", {"gravity", "bias"}, "float", GetParam());
  CertifyOptions options;
  options.scalar = "float";
  options.effort = kLittleEffort;
  options.time_limit = 0;
  options.observed.states = 1;
  Progress quiet(true);
  const Certificate certificate = certify(ur5.model.mechanism, ur5.functions, ur5.header, options, quiet);
  for (std::size_t f = 0; f < ur5.functions.size(); ++f) {
    for (const CertifiedOutput& output : certificate.functions[f].outputs) {
      const auto entry = static_cast<std::size_t>(output.name[2] - '0');  // "g[1]", "n[0]"
      EXPECT_EQ(ur5.vectors.expected[f].at(entry).proven, output.bound) << output.name;
      EXPECT_GT(output.bound, 0) << output.name;
    }
  }
  ASSERT_GT(ur5.vectors.states.size(), kDrawn);
  const auto proven_in_all = [&ur5](std::size_t f) {
    const std::vector<ExpectedEntry>& all = ur5.vectors.expected[f];
    return std::all_of(all.begin(), all.end(), [](const ExpectedEntry& entry) { return entry.proven >= 0; });
  };
  EXPECT_TRUE(proven_in_all(0));
  EXPECT_FALSE(proven_in_all(1));
}

INSTANTIATE_TEST_SUITE_P(Fused, TestVectorsOf, ::testing::Bool());

TEST(TestVectors, ProveNothingWhereThereIsNoCertificate) {
  const auto is_unproven = Field(&ExpectedEntry::proven, -1);
  EXPECT_THAT(made("ur5.urdf", {"forward_dynamics"}, "double").vectors.expected[0], Each(is_unproven));
  EXPECT_THAT(made("planar_2r.toml", {"gravity"}, "double").vectors.expected[0], Each(is_unproven));
}

// The largest scaled error at these states when the text is executed.
double largest_error(const Made& of, std::size_t begin, std::size_t end) {
  const ExpectedValues values(of.model.robot, of.model.mechanism, 1);
  const Function& function = of.functions.front();
  const Expected expected = values.of(function);
  const StraightLine lines = EmittedText(of.header, header_reader()).operations(0, function);
  double largest = 0;
  for (std::size_t k = begin; k < end; ++k) {
    const State& state = of.vectors.states[k];
    const std::vector<double> computed = outputs_of<float>(lines, state, library_sines(state));
    largest = std::max(largest, scaled_error(computed, expected.exact(state), expected.scale(state)));
  }
  return largest;
}

TEST(TestVectors, IncludeAWorseStateThanAreDrawn) {
  const Made ur5 = made("ur5.urdf", {"inverse_dynamics"}, "float");
  ASSERT_EQ(ur5.vectors.states.size(), kDrawn + 1);
  constexpr std::size_t kRandom = 8;
  EXPECT_GT(largest_error(ur5, kDrawn, kDrawn + 1), 1.2 * largest_error(ur5, 0, kRandom));
  for (const State& state : ur5.vectors.states) EXPECT_EQ(state.qd, in_float(state).qd);
}

TEST(TestVectors, AreTheSameEveryTime) {
  const TestVectors a = made("ur5.urdf", {"gravity"}, "float").vectors,
                    b = made("ur5.urdf", {"gravity"}, "float").vectors;
  ASSERT_EQ(a.states.size(), b.states.size());
  EXPECT_EQ(a.states.back().q, b.states.back().q);
}

}  // namespace
}  // namespace flatdyn
