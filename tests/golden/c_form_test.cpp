// SPDX-License-Identifier: GPL-2.0-or-later
// The C form of every robot beside its C++ form, in one program: the same bits in double and in float. It compiles
// without a warning as C99; two robots link together; C++ includes its headers. Robots with more than four joints are
// compared in a few functions; FLATDYN_ALL_FUNCTIONS=1 compares all functions of robots with up to twenty, which takes
// some minutes.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <cstdlib>

#include "code/lower/arguments.hpp"
#include "functions/planning/make_functions.hpp"
#include "golden/golden.hpp"
#include "robot/model/identifiers.hpp"
#include "support/emitted_forms.hpp"
#include "support/given_sines.hpp"
#include "support/robot_models.hpp"

namespace flatdyn::testing {
namespace {

constexpr const char* kScalars[] = {"double", "float"};
constexpr const char* kFlagsOfC =
    "-std=c99 -O1 -ffp-contract=off -Wall -Wextra -pedantic -Wconversion -Wshadow -Wfloat-equal -Wdouble-promotion "
    "-Werror";

std::vector<Function> functions_to_compare(const LoadedRobot& model) {
  PipelineOptions options;
  const bool is_large = model.mechanism.size() > 20;
  if (is_large) options.functions = {"inverse_dynamics", "gravity", "jacobian"};
  const bool is_quick = std::getenv("FLATDYN_ALL_FUNCTIONS") == nullptr;
  if (!is_large && is_quick && model.mechanism.size() > 4) {
    options.functions = {"inverse_dynamics", "inertia_matrix", "forward_dynamics", "potential_energy", "step:rk4"};
  }
  Progress quiet(true);
  Diagnostics left_out;
  return functions_of(make_functions(model, options, quiet, left_out));
}

// Options for the C robots "in_double" or "in_float", or for the C++ robot "whole".
EmitOptions options_of(const std::string& scalar, const std::string& language, int most_lines) {
  EmitOptions options;
  options.name_space = language == "c" ? "in_" + scalar : "whole";
  options.scalar = scalar;
  options.language = language;
  options.most_lines = most_lines;
  return options;
}

std::string joined(const std::vector<std::string>& items) { return fmt::format("{}", fmt::join(items, ", ")); }

// Calls one function in all forms, and counts outputs that differ.
std::string comparison(const Function& function, const std::string& scalar, const std::string& header,
                       bool has_symbols) {
  const std::string name = cpp_identifier(function.name), in_c = "in_" + scalar + "_" + name;
  std::size_t length = 0;
  std::vector<std::string> inputs, outputs;
  for (const InputKind kind : function.inputs) inputs.push_back(input_argument(kind, 0).name);
  for (const Output& output : function.outputs) {
    outputs.push_back(fmt::format("out + {}", length));
    length += output.entries.size();
  }
  const bool returns = returns_value(function);
  if (returns) outputs.clear();
  const auto run = [&](const std::string& callee, std::vector<std::string> arguments, int place) {
    arguments.insert(arguments.end(), outputs.begin(), outputs.end());
    const bool is_void = !returns && function.validity_conditions.empty();
    return fmt::format("    {{ {}* const out = all[{}]; {}{}({}); }}\n", scalar, place,
                       returns   ? "out[0] = "
                       : is_void ? ""
                                 : "out[" + std::to_string(length) + "] = ",
                       callee, joined(arguments));
  };
  const auto with = [has_symbols](const char* parameters, std::vector<std::string> arguments) {
    if (has_symbols) arguments.insert(arguments.begin(), parameters);
    return arguments;
  };
  std::string text = fmt::format("  {{\n    {} all[3][{}] = {{}};\n", scalar, length + 1);
  text += run("whole::" + name, with("p", inputs), 0) + run(in_c, with("&p_in_c", inputs), 1);
  if (const std::size_t given = header.find(" " + in_c + "_given("); given != std::string::npos) {
    const bool takes_q = header.substr(given, header.find(';', given) - given).find(" q[") != std::string::npos;
    std::vector<std::string> arguments = inputs;
    if (!takes_q) arguments.erase(arguments.begin());
    arguments.insert(arguments.begin(), {"sine", "cosine"});
    text += run(in_c + "_given", with("&p_in_c", arguments), 2) + "    differ += !same(all[0], all[2]);\n";
  }
  return text + fmt::format("    differ += !same(all[0], all[1]);\n    changed += all[0][0] != all[0][1];\n  }}\n");
}

std::string program(const LoadedRobot& model, const std::vector<Function>& functions, const std::string (&headers)[2]) {
  const std::size_t n = static_cast<std::size_t>(model.mechanism.size()), symbols = model.mechanism.symbols.size();
  const int m = model.mechanism.position_count();
  std::string text =
      "#include <cmath>\n#include <cstdio>\n#include <cstring>\n#include \"whole.hpp\"\n"
      "#include \"in_double.h\"\n#include \"in_float.h\"\n"
      "template <class S, int n> bool same(const S (&a)[n], const S (&b)[n]) { return !std::memcmp(a, b, sizeof a); }\n"
      "static unsigned state = 1;\n"
      "static double drawn() {\n  state = state * 1664525u + 1013904223u;\n  return state / 1073741824.0 - 2;\n}\n"
      "static int differ = 0, changed = 0;\n";
  for (int s = 0; s < 2; ++s) {
    const std::string scalar = kScalars[s];
    text += fmt::format("static void compare_in_{0}() {{\n  {0} q[{2}], qd[{1}], qdd[{1}], tau[{1}], h_e[6];\n", scalar,
                        n, m);
    for (const char* array : {"q", "qd", "qdd", "tau", "h_e"}) {
      text += fmt::format("  for ({0}& x : {1}) x = {0}(drawn() * 2);\n", scalar, array);
    }
    text += fmt::format("  const {0} h[1] = {{{0}(drawn() / 64)}};\n", scalar);
    text += testing::given_sines(model.mechanism, scalar, "whole");
    if (symbols > 0) {
      std::vector<std::string> values;
      for (std::size_t k = 0; k < symbols; ++k) values.push_back(fmt::format("{}({})", scalar, 0.3 + 0.07 * double(k)));
      text += fmt::format("  const whole::Parameters<{0}> p = {{{1}}};\n", scalar, joined(values));
      text += fmt::format("  const in_{0}_parameters p_in_c = {{{1}}};\n", scalar, joined(values));
    }
    for (const Function& function : functions) text += comparison(function, scalar, headers[s], symbols > 0);
    text += "}\n";
  }
  return text +
         "int main() {\n  for (int k = 0; k < 20; ++k) compare_in_double(), compare_in_float();\n"
         "  std::printf(\"%d differ\\n\", differ);\n"
         "  return changed > 0 && in_double_rounding_is_as_written() && in_float_rounding_is_as_written() ? 0 : "
         "1;\n}\n";
}

// The number of differences of one robot, compiled in one folder.
std::string differences_of(const std::string& robot, int most_lines) {
  const LoadedRobot model = model_of(robot);
  const std::vector<Function> functions = functions_to_compare(model);
  const TemporaryFolder folder;
  std::string headers[2], sources;
  write(folder.path() / "whole.hpp", emit_header(model.mechanism, functions, options_of("double", "c++", 0)));
  for (int s = 0; s < 2; ++s) {
    const std::string name = fmt::format("in_{}", kScalars[s]),
                      own = header_name(model.mechanism, options_of("", "c", 0));
    HeaderAndSource text = emit_c(model.mechanism, functions, options_of(kScalars[s], "c", most_lines));
    const std::size_t at = text.source.find("#include \"" + own);
    text.source.replace(at + 10, own.size(), name + ".h");  // two forms of one robot share the folder
    write(folder.path() / (name + ".h"), text.header);
    write(folder.path() / (name + ".c"), text.source);
    headers[s] = text.header;
    sources += fmt::format("gcc {} -c {}.c && ", kFlagsOfC, name);
  }
  write(folder.path() / "main.cpp", program(model, functions, headers));
  return output_of(
      folder.path(),
      sources +
          "g++ -std=c++17 -O1 -ffp-contract=off -Wall -Wextra -Wpedantic -Werror "
          "-Wno-unused-variable -Wno-unused-but-set-variable main.cpp in_double.o in_float.o -o main && ./main");
}

class CForm : public ::testing::TestWithParam<std::string> {};

TEST_P(CForm, HasTheBitsOfTheCppForm) { EXPECT_EQ(differences_of(GetParam(), 0), "0 differ\n"); }

INSTANTIATE_TEST_SUITE_P(Robots, CForm, ::testing::ValuesIn(robot_files()),
                         [](const auto& test) { return test.param.substr(0, test.param.find('.')); });

TEST(CFormInParts, HasTheBitsOfTheCppForm) {
  for (const char* robot : {"scara.toml", "ur5.urdf"}) {
    EXPECT_EQ(differences_of(robot, 40), "0 differ\n") << robot;
  }
}

// The header says so, and only outputs are `restrict`. Every function is called with inputs apart and in one array.
TEST(CFormsInputs, MayBeOneArray) {
  const LoadedRobot model = model_of("ur5.urdf");
  const std::vector<Function> functions = functions_to_compare(model);
  const TemporaryFolder folder;
  const HeaderAndSource text = emit_c(model.mechanism, functions, options_of("double", "c", 0));
  write(folder.path() / "ur5.h", text.header);
  write(folder.path() / "ur5.c", text.source);
  std::string program =
      "#include <stdio.h>\n#include <string.h>\n#include \"ur5.h\"\nint main(void) {\n  const double one[6] = {0.3, "
      "-1, 2, "
      "0.5, 1, -2}, q[6] = {0.3, -1, 2, 0.5, 1, -2}, qd[6] = {0.3, -1, 2, 0.5, 1, -2}, "
      "qdd[6] = {0.3, -1, 2, 0.5, 1, -2}, tau[6] = {0.3, -1, 2, 0.5, 1, -2}, h[1] = {0.3};\n  static double a[99], "
      "b[99];\n  bool "
      "valid = true;\n";
  for (const Function& function : functions) {
    if (returns_value(function)) continue;
    std::vector<std::string> apart, together;
    for (const InputKind kind : function.inputs) {
      apart.push_back(input_argument(kind, 0).name);
      together.emplace_back("one");
    }
    std::vector<std::string> in_a, in_b;
    std::size_t before = 0;
    for (const Output& output : function.outputs) {
      in_a.push_back(fmt::format("a + {}", before));
      in_b.push_back(fmt::format("b + {}", before));
      before += output.entries.size();
    }
    apart.insert(apart.end(), in_a.begin(), in_a.end());
    together.insert(together.end(), in_b.begin(), in_b.end());
    const std::string name = "in_double_" + cpp_identifier(function.name);
    const char* const receiver = function.validity_conditions.empty() ? "" : "valid &= ";
    program += fmt::format("  {3}{0}({1});\n  {3}{0}({2});\n  if (memcmp(a, b, sizeof a)) puts(\"{0}\");\n", name,
                           joined(apart), joined(together), receiver);
  }
  write(folder.path() / "main.c", program + "  puts(\"done\");\n  return !valid;\n}\n");
  for (const char* compiler : {"gcc -O3 -flto", "gcc -O2", "clang -O3"}) {
    EXPECT_EQ(
        output_of(folder.path(), fmt::format("{} -std=c99 -Wall -Wextra -Wrestrict -Werror -Wno-unknown-warning-option "
                                             "-ffp-contract=off main.c ur5.c -o main -lm && ./main",
                                             compiler)),
        "done\n")
        << compiler;
  }
}

// Returns what a compiler says of a program over the checked-in header of the planar arm.
std::string said_by(const std::string& compiler, const std::string& statements) {
  const TemporaryFolder folder;
  write(folder.path() / "main.c",
        "#include \"planar_2r.h\"\nint main(void) {\n  const planar_2r_parameters p = {0};\n  double q[2] = {0}, g[2], "
        "less[1] = {0};\n  (void)p, (void)q, (void)g, (void)less;\n  " +
            statements + "\n  return 0;\n}\n");
  return output_of(folder.path(),
                   fmt::format("{} -I '{}/generated' -Wall -pedantic -c main.c", compiler, FLATDYN_SOURCE_DIR));
}

// gcc knows the lengths of arrays from the declarations.
TEST(CInterface, GccWarnsOfArraysThatAreTooShort) {
  EXPECT_EQ(said_by("gcc -std=c99", "planar_2r_gravity(&p, q, g);"), "");
  EXPECT_THAT(said_by("gcc -std=c99", "planar_2r_gravity(&p, q, less);"),
              ::testing::HasSubstr("accessing 16 bytes in a region of size 8"));
  EXPECT_THAT(said_by("gcc -std=c99", "planar_2r_gravity(&p, less, g);"),
              ::testing::HasSubstr("reading 16 bytes from a region of size 8"));
}

TEST(CInterface, CompilersWarnOfAnswersThatAreDropped) {
  for (const char* compiler : {"gcc -std=c99", "gcc -std=c11", "clang -std=c99", "clang -std=c2x",
                               "g++ -x c++ -std=c++11", "clang++ -x c++ -std=c++17"}) {
    const std::string call = "planar_2r_rounding_is_as_written();";
    EXPECT_THAT(said_by(compiler, call), ::testing::ContainsRegex("unused-result|nodiscard")) << compiler;
    EXPECT_EQ(said_by(compiler, "if (!" + call.substr(0, call.size() - 1) + ") return 1;"), "") << compiler;
    EXPECT_EQ(said_by(compiler + std::string(" -D PLANAR_2R_NODISCARD="), call), "") << compiler;
  }
}

TEST(CInterface, StandardsThatAreTooOldAreRefused) {
  for (const char* compiler : {"gcc -std=c89", "gcc -std=gnu89", "clang -std=c89"}) {
    EXPECT_THAT(said_by(compiler, ""), ::testing::HasSubstr("this needs C99")) << compiler;
  }
  for (const char* compiler :
       {"g++ -x c++ -std=c++14 -include panda.hpp", "clang++ -x c++ -std=c++14 -include panda.hpp"}) {
    EXPECT_THAT(said_by(compiler, ""), ::testing::HasSubstr("this needs C++17")) << compiler;
  }
}

}  // namespace
}  // namespace flatdyn::testing
