// SPDX-License-Identifier: GPL-2.0-or-later
// The emitted text, read back: everything printed is found again, and every slip of the printer would be noticed.
#include "code/readback/emitted_text.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "base/diagnostics/diagnostics.hpp"
#include "code/emit/writer.hpp"
#include "code/languages/readers.hpp"
#include "support/printed_code.hpp"
#include "support/robot_models.hpp"

namespace flatdyn {
namespace {

using testing::form_of;
using testing::PrintedCode;

// A robot's functions with stages, as C++.
struct Printed {
  PrintedCode code;
  std::string header, pair;
};

Printed printed(const char* robot, const std::vector<std::string>& names, int most_lines = 0) {
  PrintedCode code(testing::model_of(robot), names, {"inertia_matrix", "bias", "forward_dynamics"});
  std::string header = code.text(form_of("c++", most_lines)), pair = code.text(form_of("pair", most_lines));
  return {std::move(code), std::move(header), std::move(pair)};
}

const std::vector<std::string> kNames = {"inverse_dynamics", "inertia_matrix", "forward_dynamics", "kinetic_energy",
                                         "forward_kinematics"};

TEST(EmittedText, IsWhatWasPrinted) {
  for (const char* robot :
       {"ur5.urdf", "scara.toml", "planar_2r.toml", "prismatic_revolute.toml", "pendulum_motor.toml", "finger.toml"}) {
    for (const int most_lines : {0, 40}) {
      const Printed all = printed(robot, kNames, most_lines);
      EXPECT_NO_THROW(all.code.prove(all.header, form_of("c++"))) << robot << ", lines: " << most_lines;
      EXPECT_NO_THROW(all.code.prove(all.pair, form_of("pair")))
          << robot << " in header and source, lines: " << most_lines;
    }
  }
}

TEST(EmittedText, HasTheFunctionsInOrder) {
  const EmittedText text(printed("scara.toml", kNames, 40).header, header_reader());
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

void expect_slips_refused(const Printed& all, const std::string& text, const char* form) {
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
      EXPECT_THROW(all.code.prove(wrong, form_of(form)), Failure) << slip << " at " << wrong.substr(place - 40, 80);
      ++mutants;
    }
  }
  EXPECT_GE(mutants, 40);
}

TEST(EmittedText, WithASlipIsRefused) {
  const Printed all = printed("ur5.urdf", {"inverse_dynamics", "inertia_matrix", "forward_dynamics"});
  expect_slips_refused(all, all.header, "c++");
  expect_slips_refused(all, all.pair, "pair");
}

TEST(EmittedText, WithAnotherAngleIsRefused) {
  const Printed all = printed("finger.toml", {"gravity"});
  const std::string right = "angle[3] = Scalar(0.6666666666666666) * q[2];";
  ASSERT_NE(all.header.find(right), std::string::npos);
  for (const char* wrong : {"angle[3] = Scalar(0.6666666666666667) * q[2];", "angle[3] = q[2];",
                            "angle[3] = Scalar(0.6666666666666666) * q[1];"}) {
    EXPECT_THROW(all.code.prove(with_replaced(all.header, right, wrong), form_of("c++")), Failure) << wrong;
  }
}

PrintedCode code_of(const char* robot) { return {testing::model_of(robot), kNames}; }

TEST(EmittedText, InCIsWhatWasPrinted) {
  for (const char* robot : {"scara.toml", "planar_2r.toml", "prismatic_revolute.toml", "pendulum_motor.toml"}) {
    const PrintedCode all = code_of(robot);
    for (const char* form : {"c", "float"}) {
      for (const int most_lines : {0, 40}) {
        EXPECT_NO_THROW(all.prove(all.text(form_of(form, most_lines)), form_of(form)))
            << robot << " " << form << ", lines: " << most_lines;
      }
    }
  }
}

// Each of these changes alters what the text computes, wherever it is made.
TEST(EmittedText, InCWithASlipIsRefused) {
  const PrintedCode all = code_of("scara.toml");
  const std::string text = all.text(form_of("float"));
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
  for (const auto& [slip, instead] : slips) {
    std::vector<std::size_t> places;
    const std::size_t code = text.find("void scara_inverse_dynamics_given(", text.find("#include \"scara.h\""));
    for (std::size_t at = text.find(slip, code); at < text.find("scara_is_zero"); at = text.find(slip, at + 1)) {
      const std::size_t line = text.rfind('\n', at) + 1;
      if (text.compare(line, 2, "  ") == 0) places.push_back(at);
    }
    for (int k = 0; k < 5 && !places.empty(); ++k) {
      const std::size_t place = places[engine() % places.size()];
      std::string wrong = text;
      wrong.replace(place, std::string(slip).size(), instead);
      EXPECT_THROW(all.prove(wrong, form_of("float")), Failure) << slip << " at " << wrong.substr(place - 40, 80);
      ++mutants;
    }
  }
  EXPECT_GE(mutants, 45);
}

TEST(EmittedText, InCThatIsNoneIsRefused) {
  const PrintedCode all = code_of("scara.toml");
  const std::string text = all.text(form_of("c"));
  for (const std::string& wrong : {std::string(), text.substr(0, text.size() / 2), text + "}"}) {
    EXPECT_THROW(all.prove(wrong, form_of("c")), Failure);
  }
}

TEST(EmittedText, ThatIsNoneIsRefused) {
  const Printed all = printed("scara.toml", {"gravity"});
  for (const std::string& wrong : {std::string(), all.header.substr(0, all.header.size() / 2), all.header + "}"}) {
    EXPECT_THROW(all.code.prove(wrong, form_of("c++")), Failure);
  }
}

TEST(EmittedText, InJavascriptIsWhatWasPrinted) {
  for (const char* robot : {"scara.toml", "planar_2r.toml", "prismatic_revolute.toml", "pendulum_motor.toml"}) {
    const PrintedCode all = code_of(robot);
    for (const int most_lines : {0, 40}) {
      EXPECT_NO_THROW(all.prove(all.text(form_of("javascript", most_lines)), form_of("javascript")))
          << robot << ", lines: " << most_lines;
    }
  }
}

TEST(EmittedText, InRustIsWhatWasPrinted) {
  for (const char* robot : {"scara.toml", "planar_2r.toml", "prismatic_revolute.toml", "pendulum_motor.toml"}) {
    const PrintedCode all = code_of(robot);
    for (const char* scalar : {"double", "float"}) {
      for (const int most_lines : {0, 40}) {
        EmitOptions options = form_of("rust", most_lines);
        options.scalar = scalar;
        EXPECT_NO_THROW(all.prove(all.text(options), options)) << robot << ", lines: " << most_lines;
      }
    }
  }
}

TEST(EmittedText, InJavascriptWithASlipIsRefused) {
  const PrintedCode all = code_of("scara.toml");
  for (const int most_lines : {0, 40}) {
    const std::string module = all.text(form_of("javascript", most_lines));
    const std::pair<const char*, const char*> slips[] = {
        {" + ", " - "},           {" * ", " + "},     {"sin(q[1])", "sin(q[0])"},
        {"= cos(", "= sin("},     {"qd[1]", "qd[2]"}, {"= qdd[0]", "= qd[0]"},
        {"tau[1] =", "tau[0] ="}, {"B[5]", "B[6]"},   {"0.5 * ", "0.25 * "}};
    for (const auto& [text, instead] : slips) {
      const std::size_t code = module.find("\nfunction inverse_dynamics(");
      const std::size_t place = module.find(text, module.find("\n  const ", code));
      ASSERT_NE(place, std::string::npos) << text;
      std::string wrong = module;
      wrong.replace(place, std::string(text).size(), instead);
      EXPECT_THROW(all.prove(wrong, form_of("javascript")), Failure) << text << " at " << wrong.substr(place - 40, 80);
    }
  }
}

TEST(EmittedText, InJavascriptThatIsNoneIsRefused) {
  const PrintedCode all = code_of("scara.toml");
  const std::string module = all.text(form_of("javascript"));
  for (const std::string& wrong : {std::string(), module.substr(0, module.size() / 2), module + "}"}) {
    EXPECT_THROW(all.prove(wrong, form_of("javascript")), Failure);
  }
}

// Reads the body of a function of one output, g.
void read_body(const std::string& body, const std::string& before = "") {
  const std::string function = "template <class Scalar>\nvoid f(const Scalar* q, Scalar* g) {\n" + body + "}\n";
  Function like;
  like.outputs.emplace_back().entries = {like.graph.constant(0)};
  EmittedText(before + "namespace r {\n" + function + "}\n", header_reader()).read(0, like);
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

// The graph has one zero, so that a sign of it would be lost without a word.
TEST(EmittedText, WithASignOfZeroIsRefused) {
  EXPECT_NO_THROW(read_body("g[0] = Scalar(0.0);\n"));
  for (const char* body : {"g[0] = Scalar(-0.0);\n", "g[0] = -Scalar(0.0);\n", "g[0] = q[0] * Scalar(-0.0);\n"}) {
    EXPECT_THROW(read_body(body), Failure) << body;
  }
}

}  // namespace
}  // namespace flatdyn
