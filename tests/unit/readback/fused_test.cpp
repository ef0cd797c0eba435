// SPDX-License-Identifier: GPL-2.0-or-later
// Text with fused multiply-adds: it is proven, it is executed with one rounding, and no change of it holds.
#include <gtest/gtest.h>

#include "base/diagnostics/diagnostics.hpp"
#include "code/readback/straight_line_values.hpp"
#include "graph/passes/fuse_products.hpp"
#include "support/printed_code.hpp"
#include "support/robot_models.hpp"

namespace flatdyn::testing {
namespace {

EmitOptions fused_options(const std::string& language, Form form = Form::header, int most_lines = 0) {
  EmitOptions options;
  options.language = language;
  options.form = form;
  options.fuses = true;
  options.most_lines = most_lines;
  return options;
}

const PrintedCode& two_joints() {
  static const PrintedCode code(model_of("planar_2r.toml"), {"inverse_dynamics", "forward_dynamics"},
                                {"inverse_dynamics", "inertia_matrix"});
  return code;
}

TEST(FusedText, IsProvenInEveryForm) {
  for (const EmitOptions& options : {fused_options("c++"), fused_options("c++", Form::pair), fused_options("c"),
                                     fused_options("c++", Form::header, 30)}) {
    const std::string text = two_joints().text(options);
    EXPECT_NE(text.find("fma("), std::string::npos);
    EXPECT_NO_THROW(two_joints().prove(text, options));
  }
}

TEST(FusedText, HasHelpersOnlyWhereTheyAreUsed) {
  const PrintedCode gravity(model_of("planar_2r.toml"), {"potential_energy"});
  EmitOptions options;
  EXPECT_EQ(gravity.text(options).find("fma"), std::string::npos);
}

// Without them there are 529.
TEST(FusedText, OfThePandaHasThreeFifthsOfTheOperations) {
  const PrintedCode panda(model_of("panda.urdf"), {"inverse_dynamics"});
  EXPECT_LE(operations_as_written(panda.functions().front(), true).arithmetic(), 319);
}

// a b + c for a = b = 1 + 2^-52 and c = -1 is 2^-51 + 2^-104, of which two roundings leave 2^-51.
TEST(FusedText, IsRoundedOnce) {
  StraightLine lines;
  const int a = lines.constant(1 + 0x1p-52), c = lines.constant(-1);
  lines.outputs = {{lines.fused(a, a, c), lines.add(lines.multiply(a, a), c)}};
  const std::vector<double> values = outputs_of(lines, State{});
  EXPECT_EQ(values[0], 0x1p-51 + 0x1p-104);
  EXPECT_EQ(values[1], 0x1p-51);
}

struct Change {
  std::string language;
  const char *from, *to;
};

TEST(FusedText, ChangesAreRefused) {
  const Change changes[] = {
      {"c++", "fma(-", "fma("},
      {"c++", "constexpr detail::MultiplyAdd<Scalar> fma{};", ""},
      {"c++", "constexpr detail::MultiplyAdd<Scalar> fma{};", "constexpr detail::Multiply<Scalar> fma{};"},
      {"c++", "return std::fma(a, b, c);", "return std::fma(a, c, b);"},
      {"c++", "return a * b + c;", "return a * b - c;"},
      {"c++", "void fma();", ""},
      {"c++", "defined(__FMA__) || ", ""},
      {"c++", "__ARM_FP & 8", "__ARM_FP & 4"},
      {"c++", "struct MultiplyAdd<double>", "struct MultiplyAdd<int>"},
      {"c", "planar_2r_fma(-", "planar_2r_fma("},
      {"c", "return fma(a, b, c);", "return fma(a, c, b);"},
      {"c", "return a * b + c;", "return a * c + b;"},
      {"c", "__riscv_flen >= 64", "__riscv_flen >= 32"},
      {"c", "= planar_2r_fma(", "= fma("},
  };
  for (const Change& change : changes) {
    const EmitOptions options = fused_options(change.language);
    std::string text = two_joints().text(options);
    const std::size_t place = text.find(change.from);
    ASSERT_NE(place, std::string::npos) << change.from;
    text.replace(place, std::string(change.from).size(), change.to);
    EXPECT_THROW(two_joints().prove(text, options), Failure) << change.from << " -> " << change.to;
  }
}

}  // namespace
}  // namespace flatdyn::testing
