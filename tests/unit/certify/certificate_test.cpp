// SPDX-License-Identifier: GPL-2.0-or-later
// No observed error is larger than its bound, and the bound is about what the text executes.
#include "proof/certify/certificate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/diagnostics/diagnostics.hpp"
#include "code/languages/emit.hpp"
#include "code/languages/readers.hpp"
#include "code/readback/emitted_text.hpp"
#include "code/readback/straight_line_values.hpp"
#include "functions/load/load_robot.hpp"
#include "graph/passes/passes.hpp"
#include "proof/verify/compiled.hpp"
#include "support/floating_robots.hpp"
#include "support/limited_robots.hpp"
#include "support/written_model.hpp"

namespace flatdyn {
namespace {

std::vector<Function> functions_to_certify(const Mechanism& mechanism, const std::vector<std::string>& names) {
  std::vector<Function> functions;
  for (const std::string& name : names) functions.push_back(run_passes(derive_function(mechanism, name)));
  return functions;
}

// The certificate without Gappa, which is not needed for what is tested here.
Certificate certificate_of(const Mechanism& mechanism, const std::string& scalar, const std::vector<std::string>& names,
                           CertifyOptions options = {}) {
  options.scalar = scalar;
  options.observed.states = 5'000;
  options.time_limit = 0;
  Progress quiet(true);
  const std::vector<Function> functions = functions_to_certify(mechanism, names);
  return certify(mechanism, functions, emit_header(mechanism, functions, {}), options, quiet);
}

class Certificates : public ::testing::TestWithParam<std::tuple<const char*, const char*>> {};

TEST_P(Certificates, AreAboveEveryErrorThatIsSeen) {
  const auto& [robot, scalar] = GetParam();
  const Certificate certificate =
      certificate_of(testing::limited_robot(robot), scalar, {"inverse_dynamics", "inertia_matrix", "gravity"});
  int seen = 0;
  for (const CertifiedFunction& function : certificate.functions) {
    for (const CertifiedOutput& output : function.outputs) {
      EXPECT_LE(output.observed, output.bound + output.reference_error) << function.name << " " << output.name;
      EXPECT_LE(output.bound, 1000 * output.observed + 1e-30) << function.name << " " << output.name;
      seen += output.observed > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(seen, 4);
}

INSTANTIATE_TEST_SUITE_P(Robots, Certificates,
                         ::testing::Combine(::testing::Values("planar_2r_example_7_2.toml", "puma560.toml", "rx90.toml",
                                                              "ur5.urdf", "finger.toml",
                                                              "floating planar_2r_example_7_2.toml"),
                                            ::testing::Values("double", "float")),
                         [](const auto& test) {
                           std::string name = std::string(std::get<0>(test.param)) + "_" + std::get<1>(test.param);
                           for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
                           return name;
                         });

// Axes neither parallel nor at right angles: rotations by constant angles are recognised, too.
TEST(Certificate, OfAxesAtAnyAngle) {
  std::string text = testing::text_of_robot("rx90.toml");
  for (const auto& [right_angle, other] : {std::pair("\"pi/2\"", "1.1"), std::pair("\"-pi/2\"", "-0.8")}) {
    for (std::size_t at = 0; (at = text.find(right_angle, at)) != std::string::npos;) {
      text.replace(at, std::string(right_angle).size(), other);
    }
  }
  const Mechanism mechanism = testing::within_limits(testing::model_of_toml(text).mechanism);
  const Certificate certificate = certificate_of(mechanism, "double", {"inverse_dynamics", "inertia_matrix"});
  for (const CertifiedFunction& function : certificate.functions) {
    for (const CertifiedOutput& output : function.outputs) {
      EXPECT_LE(output.observed, output.bound + output.reference_error) << function.name << " " << output.name;
      EXPECT_LE(output.bound, 500 * output.observed) << function.name << " " << output.name;
    }
  }
}

// A slide and rotors on a base that floats: nothing is recognised as a motion of turns alone.
TEST(Certificate, OfAFloatingBaseWithASlide) {
  const Mechanism mechanism = testing::within_limits(testing::model_of_toml(testing::kSatellite).mechanism);
  const Certificate certificate =
      certificate_of(mechanism, "double", {"inverse_dynamics", "inertia_matrix", "coriolis_matrix"});
  for (const CertifiedFunction& function : certificate.functions) {
    for (const CertifiedOutput& output : function.outputs) {
      EXPECT_LE(output.observed, output.bound + output.reference_error) << function.name << " " << output.name;
      EXPECT_LE(output.bound, 100 * output.observed + 1e-30) << function.name << " " << output.name;
    }
  }
}

// Quaternions are inputs within 1; nothing is recognised as a motion of turns alone.
TEST(Certificate, OfASphericalJoint) {
  LoadOptions options;
  options.read.scene_file = FLATDYN_SOURCE_DIR "/docs/examples/ball_wrist_limits.toml";
  const LoadedRobot model = load_robot(FLATDYN_SOURCE_DIR "/docs/examples/ball_wrist.toml", options);
  const Certificate certificate = certificate_of(model.mechanism, "double", {"inverse_dynamics", "gravity"});
  for (const CertifiedFunction& function : certificate.functions) {
    for (const CertifiedOutput& output : function.outputs) {
      EXPECT_LE(output.observed, output.bound + output.reference_error) << function.name << " " << output.name;
      EXPECT_LE(output.bound, 2000 * output.observed + 1e-30) << function.name << " " << output.name;
    }
  }
}

// A ceiling, as for operation counts; without recognising motions the bound is 2.9e-11.
TEST(Certificate, OfRandomTwistsStaysAsGoodAsItIs) {
  const LoadedRobot model = load_robot(FLATDYN_SOURCE_DIR "/docs/examples/general_7r.toml", {});
  const Certificate certificate = certificate_of(model.mechanism, "double", {"inverse_dynamics"});
  const CertifiedOutput& first = certificate.functions.at(0).outputs.at(0);
  EXPECT_LE(first.observed, first.bound + first.reference_error);
  EXPECT_LE(first.bound, 1.68e-11);
}

// Little effort also finds proven bounds, and not much larger ones.
TEST(Certificate, IsSmallerAfterMoreEffort) {
  const Mechanism mechanism = testing::limited_robot("puma560.toml");
  const auto sum_of_bounds = [&mechanism](int effort) {
    CertifyOptions options;
    options.effort = effort;
    double sum = 0;
    for (const CertifiedOutput& output :
         certificate_of(mechanism, "double", {"inverse_dynamics"}, options).functions.at(0).outputs) {
      EXPECT_LE(output.observed, output.bound + output.reference_error) << output.name << " " << effort;
      sum += output.bound;
    }
    return sum;
  };
  const double little = sum_of_bounds(kLittleEffort), usual = sum_of_bounds(kUsualEffort), much = sum_of_bounds(16);
  EXPECT_LT(usual, little);
  EXPECT_LT(much, usual);
  EXPECT_LT(little, 1.15 * much);
}

// Sines from a table: errors are above the bound for accurate sines, and below the bound for the table's.
TEST_P(Certificates, KnowWhatSinesMayBeOff) {
  const auto& [robot, scalar] = GetParam();
  const Mechanism mechanism = testing::limited_robot(robot);
  const Certificate good = certificate_of(mechanism, scalar, {"gravity"});
  CertifyOptions of_table;
  of_table.trigonometry_ulp = 10'000;
  const Certificate off = certificate_of(mechanism, scalar, {"gravity"}, of_table);
  int above = 0;
  for (std::size_t k = 0; k < good.functions[0].outputs.size(); ++k) {
    const CertifiedOutput& output = off.functions[0].outputs[k];
    EXPECT_LE(output.observed, output.bound + output.reference_error) << output.name;
    EXPECT_LE(output.bound, 100 * output.observed + 1e-30) << output.name;
    above += output.observed > good.functions[0].outputs[k].bound ? 1 : 0;
  }
  EXPECT_GT(above, 0);
}

// The values agree bit for bit, at any state, with the same sines.
TEST(StraightLine, IsWhatTheCompiledTextDoes) {
  const Mechanism mechanism = testing::limited_robot("puma560.toml");
  const std::vector<Function> functions = functions_to_certify(mechanism, {"inverse_dynamics", "forward_dynamics"});
  const CompiledFunctions compiled(mechanism, functions, Sines::library);
  const EmittedText text(emit_header(mechanism, functions, {}), header_reader());
  for (std::size_t f = 0; f < functions.size(); ++f) {
    const StraightLine lines = text.operations(f, functions[f]);
    for (const State& state : random_states(mechanism, 50, 1)) {
      const std::vector<double> values = values_of(lines, state), expected = compiled.call(f, state);
      for (std::size_t e = 0; e < expected.size(); ++e) {
        EXPECT_EQ(values[static_cast<std::size_t>(lines.outputs[0][e])], expected[e]);
      }
    }
  }
}

// The norms that Gappa takes for granted: results and derivatives of all operations, at random states.
TEST(Norms, AreAboveResultsAndDerivatives) {
  const Mechanism mechanism = testing::limited_robot("rx90.toml");
  const std::vector<Function> functions = functions_to_certify(mechanism, {"inverse_dynamics"});
  const StraightLine text =
      EmittedText(emit_header(mechanism, functions, {}), header_reader()).operations(0, functions[0]);
  const RoundingModel model{rounding_format("double"), 0x1p-53, [](double) { return 1e-16; }};
  ErrorAnalysis analysis(text, model, input_limits(mechanism));
  analysis.error_of(text.outputs[0][1]);
  ASSERT_GT(analysis.text().size(), analysis.executed());  // derivatives exist
  std::vector<double> largest(static_cast<std::size_t>(analysis.text().size()), 0);
  for (const State& state : random_states(mechanism, 300, 1)) {
    const std::vector<double> values = values_of(analysis.text(), state);
    for (std::size_t k = 0; k < values.size(); ++k) largest[k] = std::max(largest[k], std::abs(values[k]));
  }
  constexpr double kRoundings = 1e-12;  // share of the values, for their own rounding
  double looseness = 0;
  for (int k = 0; k < analysis.text().size(); ++k) {
    const double seen = largest[static_cast<std::size_t>(k)], bound = analysis.norms().largest(k);
    EXPECT_LE(seen, bound + kRoundings) << "operation " << k;
    looseness += std::log(std::max(bound, kRoundings) / std::max(seen, kRoundings));
  }
  EXPECT_LT(std::exp(looseness / analysis.text().size()), 20);  // geometric mean
}

// All entries of the function are zero, so there is nothing to bound.
TEST(Certify, OfAFunctionThatIsZero) {
  Mechanism mechanism = testing::limited_robot("panda.urdf");
  mechanism.gravity = zero_vector();
  const Certificate certificate = certificate_of(mechanism, "double", {"gravity", "inertia_matrix"});
  EXPECT_TRUE(certificate.functions.at(0).outputs.empty());
  EXPECT_FALSE(certificate.functions.at(1).outputs.empty());
}

TEST(Certify, NeedsLimits) {
  Mechanism mechanism = testing::limited_robot("ur5.urdf");
  mechanism.bodies[3].limits.acceleration = std::nullopt;
  try {
    certificate_of(mechanism, "double", {"inverse_dynamics"});
    FAIL() << "a limit is missing";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.kind(), FailureKind::unsupported);
    EXPECT_THAT(failure.what(), ::testing::HasSubstr("\"wrist_1_joint\""));
  }
  EXPECT_NO_THROW(certificate_of(mechanism, "double", {"gravity"}));
}

TEST(Certify, RefusesWhatItCannotBound) {
  const Mechanism mechanism = testing::limited_robot("ur5.urdf");
  for (const char* name : {"forward_dynamics", "inverse_dynamics_tip_force"}) {
    EXPECT_THROW(certificate_of(mechanism, "double", {name}), Failure) << name;
  }
  EXPECT_THROW(certificate_of(testing::limited_robot("planar_2r.toml"), "double", {"gravity"}), Failure);
}

// There are more base parameters than joints, so their indices are not those of joints.
TEST(Certify, RefusesInputsWithoutLimits) {
  const Mechanism mechanism = testing::limited_robot("planar_2r_example_7_2.toml");
  for (const char* name : {"inverse_dynamics_base", "inverse_dynamics_tip_force", "adaptive_regressor"}) {
    EXPECT_THROW(certificate_of(mechanism, "double", {name}), Failure) << name;
  }
}

// Two numbers of the model with the same text have separate errors.
TEST(StraightLine, KeepsConstantsApart) {
  StraightLine lines;
  const int x = lines.input({InputKind::qd, 0}), c = lines.constant(0.5), d = lines.constant(0.25);
  lines.outputs = {{lines.add(lines.multiply(c, x), lines.multiply(d, lines.add(c, d)))}};
  const StraightLine apart = with_constants_unshared(lines, [](double value) { return value == 0.5; });
  int halves = 0, quarters = 0;
  for (int k = 0; k < apart.size(); ++k) {
    if (apart[k].step != Step::constant) continue;
    halves += apart[k].value == 0.5 ? 1 : 0;
    quarters += apart[k].value == 0.25 ? 1 : 0;
  }
  EXPECT_EQ(halves, 3);  // one that nothing reads any more, and two others
  EXPECT_EQ(quarters, 1);
  EXPECT_EQ(apart[apart.outputs[0][0]].step, Step::add);
}

}  // namespace
}  // namespace flatdyn
