// SPDX-License-Identifier: GPL-2.0-or-later
// The emitted text, read back: everything printed is found again, and every slip of the printer would be noticed.
#include "readback/emitted_text.hpp"
#include "planning/make_functions.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "diagnostics/diagnostics.hpp"
#include "emit/languages/emit.hpp"
#include "emit/writer.hpp"
#include "support/robot_models.hpp"
#include "verify/proof.hpp"

namespace flatdyn {
namespace {

struct Printed {
  std::vector<OptimisedFunction> functions;
  std::optional<Stages> stages;
  std::string header;
  HeaderAndSource pair;
};

Printed printed(const char* robot, const std::vector<std::string>& names, int most_lines = 0) {
  const LoadedRobot model = testing::model_of(robot);
  PipelineOptions options;
  options.functions = names;
  Progress quiet(true);
  Diagnostics findings;
  Printed result;
  result.functions = make_functions(model, options, quiet, findings);
  result.stages = stages_of(make_fusion(model, {"inertia_matrix", "bias", "forward_dynamics"}, quiet).fusion);
  EmitOptions emit;
  emit.most_lines = most_lines;
  result.header = emit_cpp(model.mechanism, functions_of(result.functions), emit, result.stages);
  emit.more_scalars = {"float"};
  result.pair = emit_cpp_pair(model.mechanism, functions_of(result.functions), emit, result.stages);
  return result;
}

const std::vector<std::string> kNames = {"inverse_dynamics", "inertia_matrix", "forward_dynamics", "kinetic_energy",
                                         "forward_kinematics"};

TEST(EmittedText, IsWhatWasPrinted) {
  for (const char* robot :
       {"ur5.urdf", "scara.toml", "planar_2r.toml", "prismatic_revolute.toml", "pendulum_motor.toml", "finger.toml"}) {
    for (const int most_lines : {0, 40}) {
      const Printed all = printed(robot, kNames, most_lines);
      EXPECT_NO_THROW(prove_text(all.header, all.functions, all.stages)) << robot << ", lines: " << most_lines;
      EXPECT_NO_THROW(prove_text(all.pair.header + all.pair.source, all.functions, all.stages))
          << robot << " in header and source, lines: " << most_lines;
    }
  }
}

TEST(EmittedText, HasTheFunctionsInOrder) {
  const EmittedText text(printed("scara.toml", kNames, 40).header);
  std::vector<std::string> names;
  for (const ScannedFunction& function : text.functions()) names.push_back(function.member_of + ":" + function.name);
  EXPECT_THAT(names,
              ::testing::ElementsAre(":inverse_dynamics", ":inertia_matrix", ":forward_dynamics", ":kinetic_energy",
                                     ":forward_kinematics", ":at", "Configuration:inertia_matrix", "Configuration:with",
                                     "Motion:bias", "Motion:forward_dynamics"));
}

// The places of `text` in statements.
std::vector<std::size_t> places_of(const std::string& header, const std::string& text) {
  std::vector<std::size_t> places;
  for (std::size_t at = header.find(text); at != std::string::npos; at = header.find(text, at + 1)) {
    const std::size_t line = header.rfind('\n', at) + 1;
    const bool is_statement = header.compare(line, 2, "  ") == 0 && header.find(" = ", line) < header.find('\n', line);
    if (is_statement && header.find("bool", line) > header.find('\n', line)) places.push_back(at);
  }
  return places;
}

void expect_slips_refused(const Printed& all, const std::string& text) {
  const std::size_t code = text.find("sin_cos(q, Joints");
  const std::pair<const char*, const char*> slips[] = {
      {" + ", " - "},     {" - ", " + "},       {" * ", " + "},
      {" / ", " * "},     {"s_2", "c_2"},       {"qd_3", "qd_4"},
      {"q[1]", "q[2]"},   {"B[7]", "B[8]"},     {"Scalar(0.", "Scalar(1."},
      {"qdd_2", "qdd_1"}, {"tau[1]", "tau[0]"}, {"stage.x1 ", "stage.x2 "}};
  std::mt19937 engine(1);
  int mutants = 0;
  for (const auto& [slip, instead] : slips) {
    const std::vector<std::size_t> places = places_of(text, slip);
    for (int k = 0; k < 5 && !places.empty(); ++k) {
      const std::size_t place = places[engine() % places.size()];
      if (place < code) continue;
      std::string wrong = text;
      wrong.replace(place, std::string(slip).size(), instead);
      EXPECT_THROW(prove_text(wrong, all.functions, all.stages), Failure)
          << slip << " at " << wrong.substr(place - 40, 80);
      ++mutants;
    }
  }
  EXPECT_GE(mutants, 40);
}

TEST(EmittedText, WithASlipIsRefused) {
  const Printed all = printed("ur5.urdf", {"inverse_dynamics", "inertia_matrix", "forward_dynamics"});
  for (const std::string& text : {all.header, all.pair.header + all.pair.source}) expect_slips_refused(all, text);
}

TEST(EmittedText, WithAnotherAngleIsRefused) {
  const Printed all = printed("finger.toml", {"gravity"});
  const std::string right = "angle[3] = Scalar(0.6666666666666666) * q[2];";
  ASSERT_NE(all.header.find(right), std::string::npos);
  for (const char* wrong : {"angle[3] = Scalar(0.6666666666666667) * q[2];", "angle[3] = q[2];",
                            "angle[3] = Scalar(0.6666666666666666) * q[1];"}) {
    EXPECT_THROW(prove_text(with_replaced(all.header, right, wrong), all.functions, all.stages), Failure) << wrong;
  }
}

// Functions made once and printed in several ways.
class PrintedOnce {
 public:
  explicit PrintedOnce(const char* robot) : model_(testing::model_of(robot)) {
    PipelineOptions options;
    options.functions = kNames;
    Progress quiet(true);
    Diagnostics findings;
    functions_ = make_functions(model_, options, quiet, findings);
  }

  HeaderAndSource text(const std::string& scalar, int most_lines = 0) const {
    EmitOptions emit;
    emit.language = Language::c;
    emit.scalar = scalar;
    emit.most_lines = most_lines;
    return emit_c(model_.mechanism, functions_of(functions_), emit);
  }

  std::string javascript(int most_lines = 0) const {
    EmitOptions emit;
    emit.most_lines = most_lines;
    return emit_javascript(model_.mechanism, functions_of(functions_), emit);
  }

  void prove_javascript(const std::string& module) const {
    prove_text(EmittedText(module, "number"), functions_, std::nullopt);
  }

  void prove(const HeaderAndSource& text, const std::string& source, const std::string& scalar) const {
    prove_text(EmittedText(text.header + source, scalar), functions_, std::nullopt);
  }

 private:
  LoadedRobot model_;
  std::vector<OptimisedFunction> functions_;
};

TEST(EmittedText, InCIsWhatWasPrinted) {
  for (const char* robot : {"scara.toml", "planar_2r.toml", "prismatic_revolute.toml", "pendulum_motor.toml"}) {
    const PrintedOnce all(robot);
    for (const char* scalar : {"double", "float"}) {
      for (const int most_lines : {0, 40}) {
        const HeaderAndSource text = all.text(scalar, most_lines);
        EXPECT_NO_THROW(all.prove(text, text.source, scalar)) << robot << " " << scalar << ", lines: " << most_lines;
      }
    }
  }
}

// Each of these changes alters what the text computes, wherever it is made.
TEST(EmittedText, InCWithASlipIsRefused) {
  const PrintedOnce all("scara.toml");
  const HeaderAndSource printed = all.text("float");
  const std::string& source = printed.source;
  const std::pair<const char*, const char*> slips[] = {{" + ", " - "},
                                                       {" - ", " + "},
                                                       {" * ", " + "},
                                                       {" / ", " * "},
                                                       {"= sine[1]", "= cosine[1]"},
                                                       {"qd[1]", "qd[2]"},
                                                       {"B[5]", "B[6]"},
                                                       {"0.5f * ", "0.25f * "},
                                                       {"tau[1] =", "tau[0] ="},
                                                       {"(q, 0, 1,", "(q, 0, 0,"},
                                                       {"sine, cosine, qd, qdd", "sine, cosine, qdd, qd"},
                                                       {"(sine, cosine, ", "(cosine, sine, "},
                                                       {"f * ", " * "}};
  std::mt19937 engine(1);
  int mutants = 0;
  for (const auto& [text, instead] : slips) {
    std::vector<std::size_t> places;
    const std::size_t code = source.find("scara_inverse_dynamics_given(");
    for (std::size_t at = source.find(text, code); at < source.find("scara_is_zero"); at = source.find(text, at + 1)) {
      const std::size_t line = source.rfind('\n', at) + 1;
      if (source.compare(line, 2, "  ") == 0) places.push_back(at);
    }
    for (int k = 0; k < 5 && !places.empty(); ++k) {
      const std::size_t place = places[engine() % places.size()];
      std::string wrong = source;
      wrong.replace(place, std::string(text).size(), instead);
      EXPECT_THROW(all.prove(printed, wrong, "float"), Failure) << text << " at " << wrong.substr(place - 40, 80);
      ++mutants;
    }
  }
  EXPECT_GE(mutants, 45);
}

TEST(EmittedText, InCThatIsNoneIsRefused) {
  const PrintedOnce all("scara.toml");
  const HeaderAndSource text = all.text("double");
  EXPECT_THROW(all.prove(text, "", "double"), Failure);
  EXPECT_THROW(all.prove(text, text.source.substr(0, text.source.size() / 2), "double"), Failure);
  EXPECT_THROW(all.prove(text, text.source + "}", "double"), Failure);
}

TEST(EmittedText, ThatIsNoneIsRefused) {
  const Printed all = printed("scara.toml", {"gravity"});
  EXPECT_THROW(prove_text("", all.functions, all.stages), Failure);
  EXPECT_THROW(prove_text(all.header.substr(0, all.header.size() / 2), all.functions, all.stages), Failure);
  EXPECT_THROW(prove_text(all.header + "}", all.functions, all.stages), Failure);
}

TEST(EmittedText, InJavascriptIsWhatWasPrinted) {
  for (const char* robot : {"scara.toml", "planar_2r.toml", "prismatic_revolute.toml", "pendulum_motor.toml"}) {
    const PrintedOnce all(robot);
    for (const int most_lines : {0, 40}) {
      EXPECT_NO_THROW(all.prove_javascript(all.javascript(most_lines))) << robot << ", lines: " << most_lines;
    }
  }
}

TEST(EmittedText, InJavascriptWithASlipIsRefused) {
  const PrintedOnce all("scara.toml");
  for (const int most_lines : {0, 40}) {
    const std::string module = all.javascript(most_lines);
    const std::pair<const char*, const char*> slips[] = {{" + ", " - "},
                                                         {" * ", " + "},
                                                         {"Math.sin(q[1])", "Math.sin(q[0])"},
                                                         {"Math.cos(", "Math.sin("},
                                                         {"qd[1]", "qd[2]"},
                                                         {"= qdd[0]", "= qd[0]"},
                                                         {"tau[1] =", "tau[0] ="},
                                                         {"B[5]", "B[6]"},
                                                         {"0.5 * ", "0.25 * "}};
    for (const auto& [text, instead] : slips) {
      const std::size_t code = module.find("\nfunction inverse_dynamics(");
      const std::size_t place = module.find(text, module.find("\n  const ", code));
      ASSERT_NE(place, std::string::npos) << text;
      std::string wrong = module;
      wrong.replace(place, std::string(text).size(), instead);
      EXPECT_THROW(all.prove_javascript(wrong), Failure) << text << " at " << wrong.substr(place - 40, 80);
    }
  }
}

TEST(EmittedText, InJavascriptThatIsNoneIsRefused) {
  const PrintedOnce all("scara.toml");
  const std::string module = all.javascript();
  EXPECT_THROW(all.prove_javascript(""), Failure);
  EXPECT_THROW(all.prove_javascript(module.substr(0, module.size() / 2)), Failure);
  EXPECT_THROW(all.prove_javascript(module + "}"), Failure);
}

// Reads the body of a function of one output, g.
void read_body(const std::string& body, const std::string& before = "") {
  const std::string function = "template <class Scalar>\nvoid f(const Scalar* q, Scalar* g) {\n" + body + "}\n";
  Function like;
  like.outputs.emplace_back().entries = {like.graph.constant(0)};
  EmittedText(before + "namespace r {\n" + function + "}\n").read(0, like);
}

std::string squares(const std::string& of) {
  std::string text = "const Scalar a0 = " + of + ";\n";
  for (int k = 0; k < 40; ++k) text += fmt::format("const Scalar a{0} = a{1} * a{1};\n", k + 1, k);
  return text + "g[0] = a40;\n";
}

TEST(EmittedText, ThatAsksForTooMuchIsRefused) {
  EXPECT_NO_THROW(read_body("g[0] = (q[0]);\n"));
  EXPECT_THROW(read_body("g[0] = " + std::string(100'000, '(')), Failure);
  EXPECT_THROW(read_body(squares("q[0]")), Failure);
  EXPECT_THROW(read_body(squares("Scalar(1e300)")), Failure);
  EXPECT_THROW(read_body(squares("q[0] + q[0]")), Failure);
  const std::string part = "namespace detail {\ntemplate <class Scalar>\nvoid p(Scalar* g) {\ndetail::p(g);\n}\n}\n";
  EXPECT_THROW(read_body("detail::p(g);\n", part), Failure);
}

TEST(EmittedText, WithoutAMeaningIsRefused) {
  for (const char* body : {"g[0] = g[0];\n", "g[0] = q[0] / Scalar(0.0);\n", "g[0] = Scalar(inf);\n",
                           "g[0] = Scalar(1e999);\n", "g[1] = q[0];\n", "g[0] = q[0]"}) {
    EXPECT_THROW(read_body(body), Failure) << body;
  }
}

}  // namespace
}  // namespace flatdyn
