// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/scene/entries.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "base/diagnostics/diagnostics.hpp"

namespace flatdyn {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class Entries : public ::testing::Test {
 protected:
  Entries() {
    mechanism.bodies.resize(3);
    const char* names[] = {"base", "elbow", "hand"};
    for (std::size_t i = 0; i < 3; ++i) mechanism.bodies[i].joint = names[i];
    const auto add = [this](const char* name, Output output) {
      output.entries.assign(static_cast<std::size_t>(output.rows * output.cols), 0);
      Function function;
      function.name = name;
      function.outputs = {output};
      functions[output.name] = function;
    };
    add("inverse_dynamics", {"tau", Layout::vector, 3, 1, {}, ""});
    add("inertia_matrix", {"B", Layout::matrix, 3, 3, {}, ""});
    add("christoffel", {"c", Layout::christoffel, 3, 6, {}, ""});
    add("jacobian:hand", {"J", Layout::matrix, 6, 3, {}, ""});
    add("forward_kinematics", {"p", Layout::vector, 3, 1, {}, ""});
    add("kinetic_energy", {"T", Layout::scalar, 1, 1, {}, ""});
    add("operational_bias", {"g_A", Layout::vector, 2, 1, {}, ""});
    add("operational_inertia", {"J_bar", Layout::matrix, 3, 2, {}, ""});
  }

  // The function with the output that the text names; else inverse dynamics.
  const Function& function_of(const std::string& text) const {
    const auto found = functions.find(text.substr(0, text.find('[')));
    return found == functions.end() ? functions.at("tau") : found->second;
  }
  std::vector<std::size_t> of(const std::string& text) const {
    return selected_entries(function_of(text), mechanism, text).entries;
  }
  std::string refusal(const std::string& text) const {
    try {
      selected_entries(function_of(text), mechanism, text);
    } catch (const Failure& failure) {
      return std::string(failure.what()) + "; " + failure.hint();
    }
    return "";
  }

  Mechanism mechanism;
  std::map<std::string, Function> functions;  // by their only output
};

TEST_F(Entries, AreNumbersRangesAndJoints) {
  EXPECT_THAT(of("tau"), ElementsAre(0, 1, 2));
  EXPECT_THAT(of("tau[1]"), ElementsAre(1));
  EXPECT_THAT(of("tau[1..2]"), ElementsAre(1, 2));
  EXPECT_THAT(of("tau[elbow]"), ElementsAre(1));
  EXPECT_THAT(of("tau[base..elbow]"), ElementsAre(0, 1));
  EXPECT_THAT(of("B[1]"), ElementsAre(3, 4, 5));
  EXPECT_THAT(of("B[elbow][0..1]"), ElementsAre(3, 4));
  EXPECT_THAT(of("J[5][hand]"), ElementsAre(17));
  EXPECT_THAT(of("J_bar[hand][0]"), ElementsAre(4));
  EXPECT_THAT(of("T"), ElementsAre(0));
}

// c_ijk = c_ikj is one entry: (i, k (k + 1) / 2 + j) with j <= k.
TEST_F(Entries, OfChristoffelSymbolsAreSymmetric) {
  EXPECT_THAT(of("c[1][0][2]"), ElementsAre(9));
  EXPECT_THAT(of("c[1][2][0]"), ElementsAre(9));
  EXPECT_THAT(of("c[2][1][1]"), ElementsAre(14));
}

TEST_F(Entries, ThatAreWrongAreRefusedWithAHint) {
  EXPECT_THAT(refusal("tua[0]"), HasSubstr("did you mean \"tau\"?"));
  EXPECT_THAT(refusal("force[0]"), HasSubstr("known outputs: tau"));
  EXPECT_THAT(refusal("tau[3]"), HasSubstr("indices here go from 0 to 2"));
  EXPECT_THAT(refusal("tau[2..1]"), HasSubstr("is empty"));
  EXPECT_THAT(refusal("tau[0][0]"), HasSubstr("has 1 and not 2 indices"));
  EXPECT_THAT(refusal("tau[elbw]"), HasSubstr("did you mean \"elbow\"?"));
  EXPECT_THAT(refusal("tau[0"), HasSubstr("is no entry"));
  EXPECT_THAT(refusal("tau 0"), HasSubstr("there is no output \"tau 0\""));
  EXPECT_THAT(refusal("p[elbow]"), HasSubstr("\"elbow\" is no index of p"));
  EXPECT_THAT(refusal("J[elbow]"), HasSubstr("write 0 to 5"));
  EXPECT_THAT(refusal("g_A[hand]"), HasSubstr("\"hand\" is no index of g_A"));
  EXPECT_THAT(refusal("J_bar[0][hand]"), HasSubstr("write 0 to 1"));
  EXPECT_THAT(refusal("tau[-1]"), HasSubstr("there is no index -1"));
}

TEST_F(Entries, ThatAreWrittenAreNamedInRuns) {
  Output tau = functions.at("tau").outputs[0], B = functions.at("B").outputs[0];
  tau.left_out = {false, true, false};
  EXPECT_EQ(written_entries(tau), "tau[0], tau[2]");
  B.left_out = {true, true, true, true, false, false, false, false, false};
  EXPECT_EQ(written_entries(B), "B[1][1..2], B[2][0..2]");
}

}  // namespace
}  // namespace flatdyn
