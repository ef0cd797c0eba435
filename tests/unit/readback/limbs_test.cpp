// SPDX-License-Identifier: GPL-2.0-or-later
// Text that computes limbs together: it is proven, each limb has the bits of its own text, and no change of it holds.
#include <gtest/gtest.h>

#include <random>

#include "base/diagnostics/diagnostics.hpp"
#include "code/languages/readers.hpp"
#include "code/readback/straight_line_values.hpp"
#include "support/printed_code.hpp"
#include "support/robot_models.hpp"

namespace flatdyn::testing {
namespace {

EmitOptions in_lanes(Form form = Form::header) {
  EmitOptions options;
  options.form = form;
  options.limbs_in_lanes = true;
  return options;
}

const PrintedCode& quadruped() {
  static const PrintedCode code(model_of("quadruped12.urdf"), {"inverse_dynamics"});
  return code;
}

TEST(TextOfLimbs, IsProvenInEveryForm) {
  for (const Form form : {Form::header, Form::pair}) {
    const std::string text = quadruped().text(in_lanes(form));
    EXPECT_NE(text.find("using Limbs4 = detail::Limbs<Scalar, 4>;"), std::string::npos);
    EXPECT_NO_THROW(quadruped().prove(text, in_lanes(form)));
  }
}

TEST(TextOfLimbs, IsProvenForFunctionsWithATrunkBetweenTheLimbs) {
  const PrintedCode code(model_of("quadruped12.urdf"), {"forward_dynamics", "kinetic_energy"}, {"gravity", "bias"});
  const std::string text = code.text(in_lanes());
  EXPECT_NE(text.find("Limbs4"), std::string::npos);
  EXPECT_NO_THROW(code.prove(text, in_lanes()));
}

State some_state(int joints, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  State state;
  for (std::vector<double>* list : {&state.q, &state.qd, &state.qdd, &state.tau}) {
    for (int k = 0; k < joints; ++k) list->push_back(number(generator));
  }
  return state;
}

std::vector<double> executed(const PrintedCode& code, const EmitOptions& options, const State& state) {
  const EmittedText text(code.text(options), header_reader());
  return outputs_of(text.operations(0, code.functions().front()), state);
}

// The arms and the legs of humanoid32, two by two, beside a trunk of two joints and a head.
TEST(TextOfLimbs, HasTheBitsOfEachLimbByItself) {
  const PrintedCode code(model_of("humanoid32.urdf"), {"gravity"});
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const State state = some_state(code.model().mechanism.size(), seed);
    EXPECT_EQ(executed(code, in_lanes(), state), executed(code, EmitOptions(), state));
  }
}

// Products that are written out in one leg and variables in another round differently.
TEST(TextOfLimbs, DiffersByRoundingAtMost) {
  const State state = some_state(12, 1);
  const std::vector<double> lanes = executed(quadruped(), in_lanes(), state);
  const std::vector<double> apart = executed(quadruped(), EmitOptions(), state);
  ASSERT_EQ(lanes.size(), 12U);
  for (std::size_t k = 0; k < lanes.size(); ++k) EXPECT_NEAR(lanes[k], apart[k], 1e-15);
}

struct LaneChange {
  const char *from, *to;
};

TEST(TextOfLimbs, ChangesAreRefused) {
  const std::string text = quadruped().text(in_lanes());
  const LaneChange changes[] = {
      {"Scalar(163.07990445503535), Scalar(-163.07990445503535)",
       "Scalar(163.07990445503535), Scalar(-163.07990445503537)"},
      {"Scalar(61.3125), Scalar(-61.3125)", "Scalar(-61.3125), Scalar(61.3125)"},
      {"{qd[0], qd[3], qd[6], qd[9]}", "{qd[0], qd[3], qd[9], qd[6]}"},
      {"{qd[0], qd[3], qd[6], qd[9]}", "{qd[0], qd[3], qd[6]}"},
      {"{qd[0], qd[3], qd[6], qd[9]}", "{qd[0], qd[3], qd[6], qd[9], qd[9]}"},
      {"{qd[0], qd[3], qd[6], qd[9]}", "{qd[0], qd[3], qd[6], qd[12]}"},
      {"{cosine[1], -cosine[4]", "{cosine[1], cosine[4]"},
      {"c_2 * c_3 - s_2 * s_3", "c_2 * c_3 + s_2 * s_3"},
      {"c_2 * c_3 - s_2 * s_3", "c_2 * c_3 - s_2[1] * s_3"},
      {"c_2 * c_3 - s_2 * s_3", "c_2 * c_3 - s_2 * detail::sqrt(s_3)"},
      {"= qd_1 * qd_1;", "= Scalar(1.0) * Scalar(2.0);"},
      {"tau[9] = mu_1_z[3];", "tau[9] = mu_1_z[2];"},
      {"tau[9] = mu_1_z[3];", "tau[9] = -mu_1_z[3];"},
      {"tau[9] = mu_1_z[3];", "tau[9] = mu_1_z[4];"},
      {"tau[9] = mu_1_z[3];", "tau[9] = mu_1_z;"},
      {"tau[9] = mu_1_z[3];", "const Scalar x = mu_1_z; tau[9] = mu_1_z[3];"},
      {"tau[9] = mu_1_z[3];", "const Limbs2 x = {mu_1_z[0], mu_1_z[1]}; tau[9] = mu_1_z[3];"},
      {"using Limbs4 = detail::Limbs<Scalar, 4>;", "using Limbs4 = detail::Limbs<Scalar, 8>;"},
      {"using Limbs4 = detail::Limbs<Scalar, 4>;", "using Limbs4 = detail::Limbs<float, 4>;"},
      {"using Limbs4 = detail::Limbs<Scalar, 4>;", ""},
      {"return of(a.low - b.low, a.high - b.high);", "return of(a.low - b.low, b.high - a.high);"},
      {"return of(-a.low, -a.high);", "return of(-a.low, a.high);"},
      {"low{a, b}, high{c, d}", "low{a, b}, high{d, c}"},
      {"k < lanes / 2 ? low[k]", "k <= lanes / 2 ? low[k]"},
      {"vector_size(32)", "vector_size(64)"},
      {"struct LimbLanes<double, 2>", "struct LimbLanes<int, 2>"},
  };
  for (const LaneChange& change : changes) {
    std::string wrong = text;
    const std::size_t place = wrong.find(change.from);
    ASSERT_NE(place, std::string::npos) << change.from;
    wrong.replace(place, std::string(change.from).size(), change.to);
    EXPECT_THROW(quadruped().prove(wrong, in_lanes()), Failure) << change.from << " -> " << change.to;
  }
}

// A change that would hold if vectors of other lengths could be mixed.
TEST(TextOfLimbs, VectorsOfOtherLengthsAreNotMixed) {
  const PrintedCode code(model_of("quadruped12.urdf"), {"gravity"});
  std::string text = code.text(in_lanes());
  const std::string type = "  using Limbs4 = detail::Limbs<Scalar, 4>;\n";
  text.replace(text.find(type), type.size(), type + "  using Limbs2 = detail::Limbs<Scalar, 2>;\n");
  EXPECT_NO_THROW(code.prove(text, in_lanes()));
  const std::size_t place = text.find("const Limbs4 ", text.find("};", text.find("const Limbs4 s_1")));
  ASSERT_NE(place, std::string::npos);
  const std::size_t computed = text.find("const Limbs4 t", place);
  ASSERT_NE(computed, std::string::npos);
  text.replace(computed, 13, "const Limbs2 ");
  EXPECT_THROW(code.prove(text, in_lanes()), Failure);
}

}  // namespace
}  // namespace flatdyn::testing
