// SPDX-License-Identifier: GPL-2.0-or-later
// C++ in header and source beside the header alone, for the same robots, in one program: the same bits in double and in
// float, with the library's and the caller's sines and cosines, in stages and in parts. Neither compiler warns.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "code/emit/writer.hpp"
#include "code/lower/arguments.hpp"
#include "functions/planning/make_functions.hpp"
#include "golden/golden.hpp"
#include "robot/model/identifiers.hpp"
#include "support/emitted_forms.hpp"
#include "support/given_sines.hpp"
#include "support/robot_models.hpp"

namespace flatdyn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr const char* kFlags =
    "-std=c++17 -O1 -ffp-contract=off -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wdouble-promotion "
    "-Wold-style-cast "
    "-Werror -fno-exceptions -fno-rtti";

const std::vector<std::string> kFunctions = {"inverse_dynamics", "inertia_matrix", "forward_dynamics",
                                             "potential_energy", "forward_kinematics"};
const std::vector<std::string> kStaged = {"gravity", "inverse_dynamics"};

struct Forms {
  LoadedRobot model;
  std::vector<Function> functions;
  std::string header;  // the header alone, in namespace whole
  HeaderAndSource pair;
};

Forms forms_of(const std::string& robot, int most_lines) {
  Forms forms{model_of(robot), {}, "", {}};
  PipelineOptions pipeline;
  pipeline.functions = kFunctions;
  Progress quiet(true);
  Diagnostics left_out;
  forms.functions = functions_of(make_functions(forms.model, pipeline, quiet, left_out));
  const Stages stages = stages_of(make_fusion(forms.model, kStaged, quiet).fusion);
  EmitOptions options;
  options.most_lines = most_lines;
  options.name_space = "whole";
  forms.header = emit_header(forms.model.mechanism, forms.functions, options, stages);
  options.name_space = options.file_name = "apart";
  options.more_scalars = {"float"};
  forms.pair = emit_pair(forms.model.mechanism, forms.functions, options, stages);
  return forms;
}

// Calls both forms and compares what they write. FORM stands for a form's namespace.
std::string comparison(const std::string& call, const std::string& inputs, const Function& function,
                       const std::string& last) {
  std::size_t length = 0;
  std::vector<std::string> arguments;
  if (!inputs.empty()) arguments.push_back(inputs);
  for (const Output& output : function.outputs) {
    if (!returns_value(function)) arguments.push_back(fmt::format("out + {}", length));
    length += output.entries.size();
  }
  if (!last.empty()) arguments.push_back(last);
  std::string text = fmt::format("  {{\n    Scalar all[2][{}] = {{}};\n", length);
  for (int form = 0; form < 2; ++form) {
    const std::string name = form == 0 ? "whole" : "apart";
    const std::string line =
        fmt::format("    {{ Scalar* const out = all[{}]; {}FORM::{}({}); }}\n", form,
                    returns_value(function) ? "out[0] = " : "(void)", call, fmt::join(arguments, ", "));
    text += with_replaced(line, "FORM", name);
  }
  return text + "    compare(all);\n  }\n";
}

bool asks_for_sines(const Forms& forms, const std::string& name) {
  const std::size_t at = forms.pair.header.find(" " + name + "(const");
  return forms.pair.header.substr(at, forms.pair.header.find(';', at) - at).find("SinCos") != std::string::npos;
}

std::string program(const Forms& forms) {
  const Mechanism& mechanism = forms.model.mechanism;
  const std::string n = "apart::joint_count", robot = mechanism.symbols.empty() ? "" : "FORM_parameters, ";
  std::string text =
      "#include <cmath>\n#include <cstdio>\n#include <cstring>\n#include <initializer_list>\n#include "
      "\"apart.hpp\"\n#include \"whole.hpp\"\n"
      "static unsigned state = 1;\n"
      "static double drawn() {\n  state = state * 1664525u + 1013904223u;\n  return state / 1073741824.0 - 2;\n}\n"
      "static int differ = 0, changed = 0;\n"
      "template <class S, int n> void compare(const S (&all)[2][n]) {\n"
      "  differ += std::memcmp(all[0], all[1], sizeof all[0]) != 0;\n"
      "  for (const S& x : all[1]) changed += x < S(0) || x > S(0);\n}\n"
      "template <class Scalar> void compare_all() {\n"
      "  Scalar q[" +
      n + "], qd[" + n + "], qdd[" + n + "], tau[" + n +
      "];\n"
      "  for (Scalar* x : {q, qd, qdd, tau}) for (int k = 0; k < " +
      n + "; ++k) x[k] = Scalar(2 * drawn());\n" + testing::given_sines(mechanism, "Scalar", "whole");
  if (!mechanism.symbols.empty()) {
    std::vector<std::string> values;
    for (std::size_t k = 0; k < mechanism.symbols.size(); ++k) {
      values.push_back(fmt::format("Scalar({})", 0.3 + 0.07 * static_cast<double>(k)));
    }
    for (const char* form : {"whole", "apart"}) {
      text += fmt::format("  const {0}::Parameters<Scalar> {0}_parameters = {{{1}}};\n", form, fmt::join(values, ", "));
    }
  }
  for (const Function& function : forms.functions) {
    std::vector<std::string> inputs;
    for (const InputKind kind : function.inputs) inputs.push_back(input_argument(kind, 0).name);
    const std::string name = cpp_identifier(function.name);
    const std::string arguments = robot + fmt::format("{}", fmt::join(inputs, ", "));
    text += comparison(name, arguments, function, "");
    if (!asks_for_sines(forms, name)) continue;
    text += comparison(name, arguments, function, "FORM::GivenSinCos<Scalar>{sine, cosine}");
  }
  const std::string at = "at(" + robot + "q)";
  text += comparison(at + ".gravity", "", forms.functions.front(), "");
  text += comparison(at + ".with(qd).inverse_dynamics", "qdd", forms.functions.front(), "");
  return text +
         "}\nint main() {\n  for (int k = 0; k < 20; ++k) compare_all<double>(), compare_all<float>();\n"
         "  std::printf(\"%d differ\\n\", differ);\n  return changed > 0 ? 0 : 1;\n}\n";
}

void write_files(const fs::path& folder, const Forms& forms) {
  write(folder / "whole.hpp", forms.header);
  write(folder / "apart.hpp", forms.pair.header);
  write(folder / "apart.cpp", forms.pair.source);
}

struct PairCase {
  const char* robot;
  int most_lines;
};

void PrintTo(const PairCase& of, std::ostream* out) { *out << of.robot << ", lines: " << of.most_lines; }

class PairForm : public ::testing::TestWithParam<PairCase> {};

TEST_P(PairForm, HasTheBitsOfTheHeader) {
  const Forms forms = forms_of(GetParam().robot, GetParam().most_lines);
  const TemporaryFolder folder;
  write_files(folder.path(), forms);
  write(folder.path() / "main.cpp", program(forms));
  // clang++ warns if a template with its definition elsewhere is not declared as instantiated there.
  for (const char* compiler : {"g++", "clang++ -Wundefined-func-template"}) {
    EXPECT_EQ(output_of(folder.path(), fmt::format("{0} {1} -c apart.cpp && {0} {1} -Wno-unused-variable "
                                                   "-Wno-unused-but-set-variable main.cpp apart.o -o main && ./main",
                                                   compiler, kFlags)),
              "0 differ\n")
        << compiler;
  }
}

// Robots with free symbols, with friction's sign, with an entry that is always zero, and in parts.
INSTANTIATE_TEST_SUITE_P(Robots, PairForm,
                         ::testing::Values(PairCase{"scara.toml", 0}, PairCase{"pendulum_motor.toml", 0},
                                           PairCase{"puma560.toml", 0}, PairCase{"cartesian_2.toml", 0},
                                           PairCase{"ur5.urdf", 40}),
                         [](const auto& test) {
                           const std::string robot = test.param.robot;
                           return robot.substr(0, robot.find('.'));
                         });

// A user's flags do not matter for code that the user does not compile; code that is not compiled does not link.
TEST(SourceOfAPair, SaysWhetherItRoundsAsWritten) {
  const Forms forms = forms_of("ur5.urdf", 0);
  const TemporaryFolder folder;
  write_files(folder.path(), forms);
  const auto build = [&folder](const char* flags_of_source, const char* flags_of_user) {
    return output_of(folder.path(),
                     fmt::format("g++ -std=c++17 -O2 {} -c apart.cpp && g++ -std=c++17 -O2 {} -c main.cpp "
                                 "&& g++ main.o apart.o -o main && ./main",
                                 flags_of_source, flags_of_user));
  };
  write(folder.path() / "main.cpp",
        "#include \"apart.hpp\"\nint main() { return apart::rounding_is_as_written<float>() ? 0 : 1; }\n");
  EXPECT_EQ(build("-ffp-contract=off", "-ffast-math"), "");
  EXPECT_THAT(build("-ffast-math", "-ffp-contract=off"), HasSubstr("add -fno-finite-math-only"));
  write(folder.path() / "main.cpp",
        "#include \"apart.hpp\"\nint main() {\n  long double q[6] = {}, g[6];\n  apart::at(q).gravity(g);\n}\n");
  EXPECT_THAT(build("", ""), HasSubstr("undefined reference"));
}

}  // namespace
}  // namespace flatdyn::testing
