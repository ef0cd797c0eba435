// SPDX-License-Identifier: GPL-2.0-or-later
// The Rust form of robots beside their C form, in one program: the same bits in double and in float, whole and in
// parts. rustc takes them without a warning. Angles of any size have the sines that they have in 400 digits.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "code/languages/emit.hpp"
#include "code/lower/arguments.hpp"
#include "functions/planning/make_functions.hpp"
#include "golden/golden.hpp"
#include "robot/model/identifiers.hpp"
#include "support/robot_models.hpp"
#include "support/written_model.hpp"

namespace flatdyn::testing {
namespace {

constexpr const char* kRustc = "rustc --edition 2021 -D warnings -C opt-level=1";

bool has_rustc() { return std::system("rustc --version > /dev/null 2>&1") == 0; }

std::vector<Function> functions_of_robot(const LoadedRobot& model, const std::vector<std::string>& names = {}) {
  PipelineOptions options;
  options.functions = names;
  if (names.empty() && model.mechanism.size() > 4) {
    options.functions = {"inverse_dynamics", "inertia_matrix", "forward_dynamics", "potential_energy"};
  }
  Progress quiet(true);
  Diagnostics left_out;
  return functions_of(make_functions(model, options, quiet, left_out));
}

EmitOptions rust_options_in(const std::string& language, const std::string& scalar, int most_lines) {
  EmitOptions options;
  options.language = language;
  options.scalar = scalar;
  options.most_lines = most_lines;
  options.file_name = "robot";
  if (language == "c") options.name_space = "in_c";
  return options;
}

void write_files(const TemporaryFolder& folder, const LoadedRobot& model, const std::vector<Function>& functions,
                 const EmitOptions& options) {
  for (const GeneratedFile& file : emit_code(model.mechanism, functions, options)) {
    const std::filesystem::path path = folder.path() / file.name;
    std::filesystem::create_directories(path.parent_path());
    write(path, file.text);
  }
}

std::string listed(const std::vector<std::string>& items) { return fmt::format("{}", fmt::join(items, ", ")); }

// The declaration of the C function, and the statements that call both and count outputs that differ.
struct RustComparison {
  std::string declaration, statements;
};

RustComparison rust_comparison(const Function& function, const std::string& real, bool has_symbols) {
  const std::string name = cpp_identifier(function.name);
  std::vector<std::string> declared, in_rust, in_c, results;
  if (has_symbols) {
    declared.push_back("p: *const " + real);
    in_rust.emplace_back("&parameters");
    in_c.emplace_back("p.as_ptr()");
  }
  for (const InputKind kind : function.inputs) {
    const std::string input = input_argument(kind, 0).name;
    declared.push_back(fmt::format("{}: *const {}", input, real));
    in_rust.push_back("&" + input);
    in_c.push_back(input + ".as_ptr()");
  }
  const bool returns = returns_value(function), is_checked = !function.validity_conditions.empty();
  RustComparison text;
  for (std::size_t k = 0; k < function.outputs.size() && !returns; ++k) {
    const std::size_t length = function.outputs[k].entries.size();
    text.statements += fmt::format("      let (mut a{0}, mut b{0}) = ([0.0; {1}], [0.0; {1}]);\n", k, length);
    declared.push_back(fmt::format("o{}: *mut {}", k, real));
    in_rust.push_back(fmt::format("&mut a{}", k));
    in_c.push_back(fmt::format("b{}.as_mut_ptr()", k));
    results.push_back(fmt::format("same(&a{0}, &b{0})", k));
  }
  const std::string call_of_rust = fmt::format("robot::{}({})", name, listed(in_rust)),
                    call_of_c = fmt::format("unsafe {{ in_c_{}({}) }}", name, listed(in_c));
  text.declaration = fmt::format("  fn in_c_{}({}){};\n", name, listed(declared),
                                 returns      ? " -> " + real
                                 : is_checked ? " -> bool"
                                              : "");
  if (returns) {
    text.statements += fmt::format("      let (a, b) = ([{}], [{}]);\n", call_of_rust, call_of_c);
    results.emplace_back("same(&a, &b)");
  } else if (is_checked) {
    text.statements += fmt::format("      let (x, y) = ({}, {});\n", call_of_rust, call_of_c);
    results.emplace_back("x == y");
  } else {
    text.statements += fmt::format("      {};\n      {};\n", call_of_rust, call_of_c);
  }
  text.statements = fmt::format("    {{\n{}      differ += usize::from(!({}));\n    }}\n", text.statements,
                                fmt::join(results, " && "));
  return text;
}

std::string rust_program(const LoadedRobot& model, const std::vector<Function>& functions, const std::string& real) {
  const std::vector<FreeSymbol>& symbols = model.mechanism.symbols;
  std::string declarations, statements;
  for (const Function& function : functions) {
    const RustComparison each = rust_comparison(function, real, !symbols.empty());
    declarations += each.declaration;
    statements += each.statements;
  }
  std::string values;
  for (std::size_t k = 0; k < symbols.size(); ++k) {
    values += fmt::format("{}: p[{}], ", cpp_identifier(symbols[k].name), k);
  }
  const std::string parameters = symbols.empty()
                                     ? ""
                                     : fmt::format(
                                           "    let p: [{0}; {1}] = core::array::from_fn(|k| 0.3 + 0.07 * k as {0});\n"
                                           "    let parameters = robot::Parameters {{ {2} }};\n",
                                           real, symbols.size(), values);
  return fmt::format(R"rust(#![allow(unused_variables)]
extern "C" {{
{1}}}
fn same(a: &[{0}], b: &[{0}]) -> bool {{ a.iter().zip(b).all(|(x, y)| x.to_bits() == y.to_bits()) }}
fn drawn<const N: usize>(state: &mut u32) -> [{0}; N] {{
  [(); N].map(|_| {{
    *state = state.wrapping_mul(1664525).wrapping_add(1013904223);
    (f64::from(*state) / 536870912.0 - 4.0) as {0}
  }})
}}
fn main() {{
  let (mut state, mut differ) = (1, 0);
  for _ in 0..20 {{
    let q: [{0}; {2}] = drawn(&mut state);
    let [qd, qdd, tau]: [[{0}; {3}]; 3] = [drawn(&mut state), drawn(&mut state), drawn(&mut state)];
    let h_e: [{0}; 6] = drawn(&mut state);
{4}{5}  }}
  println!("{{differ}} differ, as written: {{}}", robot::rounding_is_as_written());
}}
)rust",
                     real, declarations, model.mechanism.position_count(), model.mechanism.size(), parameters,
                     statements);
}

std::string rust_differences_of(const std::string& robot, const std::string& scalar, int most_lines) {
  const LoadedRobot model = model_of(robot);
  const std::vector<Function> functions = functions_of_robot(model);
  const TemporaryFolder folder;
  for (const char* language : {"c", "rust"}) {
    write_files(folder, model, functions, rust_options_in(language, scalar, most_lines));
  }
  write(folder.path() / "main.rs", rust_program(model, functions, scalar == "float" ? "f32" : "f64"));
  return output_of(
      folder.path(),
      fmt::format("gcc -std=c99 -O1 -ffp-contract=off -c robot.c && {0} --crate-type rlib --crate-name robot "
                  "robot/src/lib.rs && {0} main.rs --extern robot=librobot.rlib -C link-arg=robot.o -C "
                  "link-arg=-lm && ./main",
                  kRustc));
}

class RustForm : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (!has_rustc()) GTEST_SKIP() << "rustc is not installed: scripts/setup";
  }
};

TEST_P(RustForm, HasTheBitsOfTheCForm) {
  for (const char* scalar : {"double", "float"}) {
    EXPECT_EQ(rust_differences_of(GetParam(), scalar, 0), "0 differ, as written: true\n") << scalar;
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, RustForm, ::testing::ValuesIn(robot_files()),
                         [](const auto& test) { return test.param.substr(0, test.param.find('.')); });

class RustFormInParts : public RustForm {};

TEST_P(RustFormInParts, HasTheBitsOfTheCForm) {
  EXPECT_EQ(rust_differences_of(GetParam(), "double", 40), "0 differ, as written: true\n");
}

INSTANTIATE_TEST_SUITE_P(Robots, RustFormInParts, ::testing::Values("scara.toml", "finger.toml"),
                         [](const auto& test) { return test.param.substr(0, test.param.find('.')); });

using Real400 = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<400>>;

// Angles of every exponent beyond the range of the polynomials, with some whose multiples of pi/2 are very near.
template <class T>
std::vector<T> large_angles() {
  std::vector<T> angles = {T(1e22), T(6381956970095103.0 * std::pow(2.0, sizeof(T) == 8 ? 797 : 60)),
                           std::numeric_limits<T>::max()};
  std::uint32_t state = 1;
  for (int exponent = sizeof(T) == 8 ? 17 : 13; exponent < std::numeric_limits<T>::max_exponent; ++exponent) {
    state = state * 1664525U + 1013904223U;
    angles.push_back(std::ldexp(T(1) + T(state >> 9U) / T(8388608), exponent) * (state % 2 == 0 ? T(1) : T(-1)));
  }
  return angles;
}

// A pendulum whose forward kinematics are the sine and cosine of its angle.
constexpr const char* kPendulum = R"(
name = "pendulum"
gravity = [0, 0, -9.81]
[[link]]
joint = "hinge"
mass = 1
com = [1, 0, 0]
inertia = { xx = 0.1, yy = 0.1, zz = 0.1 }
inertia_about = "com"
)";

template <class T>
void expect_sines_of_large_angles(const std::string& scalar, const std::string& real) {
  const LoadedRobot model = model_of_toml(kPendulum);
  const std::vector<Function> functions = functions_of_robot(model, {"forward_kinematics"});
  const TemporaryFolder folder;
  write_files(folder, model, functions, rust_options_in("rust", scalar, 0));
  const std::vector<T> angles = large_angles<T>();
  std::string list;
  for (const T angle : angles) list += fmt::format("{:.17e}, ", angle);
  std::string outputs, arguments;
  for (std::size_t k = 0; k < functions[0].outputs.size(); ++k) {
    outputs += fmt::format("let mut o{} = [0.0; {}]; ", k, functions[0].outputs[k].entries.size());
    arguments += fmt::format(", &mut o{}", k);
  }
  write(
      folder.path() / "main.rs",
      fmt::format("#![allow(clippy::all)]\nfn main() {{\n  let angles: [{}; {}] = [{}];\n  for x in angles {{\n    {}\n"
                  "    robot::forward_kinematics(&[x]{});\n    println!(\"{{:e}} {{:e}}\", o0[3], o0[0]);\n  }}\n}}\n",
                  real, angles.size(), list, outputs, arguments));
  const std::string output =
      output_of(folder.path(), fmt::format("{0} --crate-type rlib --crate-name robot robot/src/lib.rs && {0} main.rs "
                                           "--extern robot=librobot.rlib && ./main",
                                           kRustc));
  std::istringstream lines(output);
  for (const T angle : angles) {
    T sine = 2, cosine = 2;
    lines >> sine >> cosine;
    const Real400 right_sine = sin(Real400(angle)), right_cosine = cos(Real400(angle));
    const auto error = [](T value, const Real400& right) {
      const T place = std::nextafter(std::abs(T(right)), T(2)) - std::abs(T(right));
      return double(abs(Real400(value) - right) / Real400(place));
    };
    EXPECT_LE(error(sine, right_sine), 1) << angle << ": " << sine << "\n" << output.substr(0, 300);
    EXPECT_LE(error(cosine, right_cosine), 1) << angle << ": " << cosine;
  }
}

class RustNumbers : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_rustc()) GTEST_SKIP() << "rustc is not installed: scripts/setup";
  }
};

TEST_F(RustNumbers, AreSinesOfLargeAnglesToAPlace) {
  expect_sines_of_large_angles<double>("double", "f64");
  expect_sines_of_large_angles<float>("float", "f32");
}

// A function that is the square root of a position.
Function root_of_a_position() {
  Function function;
  function.name = "gravity";
  function.inputs = {InputKind::q};
  Output g;
  g.name = "g";
  g.rows = 1;
  g.entries = {function.graph.sqrt(function.graph.input({InputKind::q, 0}))};
  function.outputs = {g};
  return function;
}

// Numbers of all sizes, those without all their digits too, have the bits that the standard library gives.
TEST_F(RustNumbers, AreRootsRoundedToNearest) {
  for (const auto& [scalar, real, bits] : {std::tuple("double", "f64", "u64"), std::tuple("float", "f32", "u32")}) {
    const TemporaryFolder folder;
    write_files(folder, model_of_toml(kPendulum), {root_of_a_position()}, rust_options_in("rust", scalar, 0));
    write(folder.path() / "main.rs", fmt::format(R"rust(fn main() {{
  let (mut state, mut differ) = (1_u64, 0);
  let special = [0.0, -0.0, 1.0, -1.0, {0}::INFINITY, {0}::NAN, {0}::MIN_POSITIVE, {0}::MAX, {0}::from_bits(1)];
  let random = (0..200000).map(|_| {{
    state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
    {0}::from_bits((state >> (u64::BITS - {1}::BITS)) as {1})
  }});
  for x in special.into_iter().chain(random) {{
    let mut root = [0.0];
    robot::gravity(&[x], &mut root);
    let right = x.sqrt();
    differ += usize::from(root[0].to_bits() != right.to_bits() && !(root[0].is_nan() && right.is_nan()));
  }}
  println!("{{differ}} differ");
}}
)rust",
                                                 real, bits));
    EXPECT_EQ(output_of(folder.path(), fmt::format("{0} --crate-type rlib --crate-name robot robot/src/lib.rs && {0} "
                                                   "main.rs --extern robot=librobot.rlib && ./main",
                                                   kRustc)),
              "0 differ\n");
  }
}

}  // namespace
}  // namespace flatdyn::testing
