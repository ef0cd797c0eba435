// SPDX-License-Identifier: GPL-2.0-or-later
// The CUDA form: what is printed is proven, and one change anywhere is refused.
#include <gtest/gtest.h>

#include "base/diagnostics/diagnostics.hpp"
#include "code/lower/kernel_parts.hpp"
#include "code/readback/tokens.hpp"
#include "functions/planning/kernel_columns.hpp"
#include "support/printed_code.hpp"
#include "support/robot_models.hpp"
#include "support/written_model.hpp"

namespace flatdyn::testing {
namespace {

// The functions and, behind them, their parts for kernels with so few registers that it pays to divide them.
struct DividedCode {
  PrintedCode code;
  EmitOptions options = form_of("cuda");
};

constexpr int kFewValues = 30;

DividedCode divided(const char* robot, const std::vector<std::string>& names) {
  const PrintedCode whole(model_of(robot), names);
  ReadingParts reading;
  for (const Function& each : whole.functions()) reading.push_back(reading_own_outputs(whole.model(), each));
  KernelParts parts = kernel_parts(whole.functions(), kFewValues, reading);
  std::vector<Function> functions = whole.functions();
  functions.insert(functions.end(), parts.functions.begin(), parts.functions.end());
  DividedCode result{{model_of(robot), std::move(functions)}};
  result.options.kernel_parts = std::move(parts.counts);
  return result;
}

TEST(CudaText, IsWhatWasPrinted) {
  for (const char* robot : {"scara.toml", "planar_2r_example_7_2.toml", "pendulum_motor.toml", "finger.toml"}) {
    const PrintedCode all(model_of(robot),
                          {"inverse_dynamics", "inertia_matrix", "forward_dynamics", "kinetic_energy"});
    EXPECT_NO_THROW(all.prove(all.text(form_of("cuda")), form_of("cuda"))) << robot;
  }
  const PrintedCode loops(model_of("four_bar.toml"), {"loop_closure", "loop_step", "gravity"});
  EXPECT_NO_THROW(loops.prove(loops.text(form_of("cuda")), form_of("cuda")));
  EmitOptions library = form_of("cuda"), fused = library;
  library.sines = Sines::library;
  fused.fuses = true;
  const PrintedCode arm(model_of("scara.toml"), {"forward_dynamics"});
  EXPECT_NO_THROW(arm.prove(arm.text(library), library));
  EXPECT_NO_THROW(arm.prove(arm.text(fused), fused));
}

TEST(CudaText, OfKernelPartsIsWhatWasPrinted) {
  const DividedCode arm = divided("puma560.toml", {"inertia_matrix", "inverse_dynamics_derivatives"});
  ASSERT_GT(arm.options.kernel_parts.at(1), 1);
  const std::string text = arm.code.text(arm.options);
  EXPECT_NO_THROW(arm.code.prove(text, arm.options));
  for (const auto& [from, to] :
       {std::pair("part == 1", "part == 2"), std::pair("derivatives_part_2<", "derivatives_part_1<"),
        std::pair("constexpr int parts = ", "constexpr int parts = 1"),
        std::pair("int places[] = {\n          0,", "int places[] = {\n          1,"),
        std::pair("place(int entry)", "place(int entries)")}) {
    const std::size_t place = text.find(from, text.find("namespace functions"));
    ASSERT_NE(place, std::string::npos) << from;
    std::string wrong = text;
    wrong.replace(place, std::string(from).size(), to);
    EXPECT_THROW(arm.code.prove(wrong, arm.options), Failure) << to;
  }
}

TEST(CudaText, OfPartsThatReadIsWhatWasPrinted) {
  const DividedCode arm = divided("puma560.toml", {"forward_dynamics_derivatives"});
  const std::string text = arm.code.text(arm.options), read = "detail::stored(dqdd_dtau, 0)";
  const std::size_t place = text.find(read);
  ASSERT_NE(place, std::string::npos);
  EXPECT_NO_THROW(arm.code.prove(text, arm.options));
  for (const char* other : {"detail::stored(dqdd_dtau, 1)", "detail::stored(dqdd_dq, 0)", "detail::stored(qd, 0)",
                            "detail::stored(dqdd_dtau, 36)", "dqdd_dtau[0]", "detail::sign(dqdd_dtau[0])"}) {
    std::string wrong = text;
    wrong.replace(place, read.size(), other);
    EXPECT_THROW(arm.code.prove(wrong, arm.options), Failure) << other;
  }
}

// A free symbol may be called like something that the text has, in every language.
TEST(CudaText, FreeSymbolsMayHaveAnyName) {
  for (const char* name : {"sin_cos", "sine", "cosine", "valid", "fma"}) {
    std::string robot = text_of_robot("planar_2r.toml");
    for (std::size_t at = robot.find("I_m1"); at != std::string::npos; at = robot.find("I_m1", at)) {
      robot.replace(at, 4, name);
    }
    const std::vector<std::string> functions = {"base_parameters", "kinetic_energy"};
    const PrintedCode code(model_of_toml(robot), functions);
    for (const char* form : {"c++", "cuda", "c", "javascript"}) {
      EXPECT_NO_THROW(code.prove(code.text(form_of(form)), form_of(form))) << name << " in " << form;
    }
  }
}

// Names that CUDA's runtime or the header's macros have are no namespaces.
TEST(CudaText, NamespacesAreNotThoseOfTheRuntime) {
  const PrintedCode code(model_of("pendulum_motor.toml"), {"gravity"});
  EmitOptions options = form_of("cuda");
  for (const char* name : {"threadIdx", "cudaSuccess", "dim3", "ulonglong2", "max", "atomicAdd", "make_float4", "tex2D",
                           "rsqrtf", "FLATDYN_MEMBER", "acme::FLATDYN_MEMBER"}) {
    options.name_space = name;
    EXPECT_THROW(code.text(options), Failure) << name;
  }
  for (const char* name :
       {"acme::threadIdx", "cuda_arm", "float5", "maximum", "texas", "atomic", "make_robot", "time_arm"}) {
    options.name_space = name;
    EXPECT_NO_THROW(code.text(options)) << name;
  }
}

// Without one of its tokens, or with one twice, no text holds.
TEST(CudaText, EveryTokenCounts) {
  const DividedCode arm = divided("scara.toml", {"inverse_dynamics", "forward_dynamics"});
  const auto is_proven = [&arm](const std::vector<Token>& tokens) {
    std::string text;
    for (const Token& token : tokens) text += token.is_directive() ? "\n" + token.text + "\n" : token.text + " ";
    try {
      arm.code.prove(text, arm.options);
    } catch (const Failure&) {
      return false;
    }
    return true;
  };
  const std::vector<Token> tokens = tokens_of(arm.code.text(arm.options));
  ASSERT_TRUE(is_proven(tokens));
  constexpr std::size_t kStride = 29;  // a prime number: any kind of token is among them
  for (std::size_t k = 0; k < tokens.size(); k += kStride) {
    std::vector<Token> wrong = tokens;
    wrong.erase(wrong.begin() + static_cast<std::ptrdiff_t>(k));
    EXPECT_FALSE(is_proven(wrong)) << "without \"" << tokens[k].text << "\" in line " << tokens[k].line;
    wrong = tokens;
    wrong.insert(wrong.begin() + static_cast<std::ptrdiff_t>(k), tokens[k]);
    EXPECT_FALSE(is_proven(wrong)) << "twice \"" << tokens[k].text << "\" in line " << tokens[k].line;
  }
}

}  // namespace
}  // namespace flatdyn::testing
