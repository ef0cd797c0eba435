// SPDX-License-Identifier: GPL-2.0-or-later
// The header as users get it: it compiles without a warning, and computes the graph's values.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "base/diagnostics/diagnostics.hpp"
#include "support/emitted_forms.hpp"
#include "unit/emit/compiled.hpp"
#include "unit/emit/hand_made.hpp"

namespace flatdyn {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::vector<Function> all_functions() {
  return {testing::two_link_inverse_dynamics(), testing::two_link_inertia_matrix(), testing::two_link_kinetic_energy(),
          testing::two_link_forward_dynamics(), testing::pendulum_gravity()};
}

std::string header() { return emit_header(testing::two_link_mechanism({"m1"}), all_functions(), {}); }

// A program that prints all outputs at the state of testing::values_of, in the order of all_functions().
std::string driver(const std::string& scalar) {
  return R"(#include <cstdio>
#include "robot.hpp"
using S = )" +
         scalar + R"(;
static void print(S x) { std::printf("%.17g\n", static_cast<double>(x)); }
template <int n> static void print(const S (&x)[n]) { for (S value : x) print(value); }
int second_unit();
int main() {
  namespace arm = two_link_arm;
  const S q[2] = {S(0.3), S(1.3)}, qd[2] = {S(-0.7), S(0.3)}, qdd[2] = {S(0.2), S(1.2)}, tau[2] = {S(1.5), S(0.5)};
  const arm::Parameters<S> parameters = {S(1.25)};
  S computed[2], B[4], D[4], solved[2], g[2];
  arm::inverse_dynamics(parameters, q, qd, qdd, computed);
  print(computed);
  arm::inertia_matrix(parameters, q, B, D);
  print(B);
  print(D);
  print(arm::kinetic_energy(parameters, q, qd));
  if (!arm::forward_dynamics(parameters, q, qd, tau, solved)) return 1;
  print(solved);
  arm::gravity(parameters, q, g);
  print(g);
  return second_unit();
}
)";
}

// Another translation unit with the same header: overlapping arguments, and states that are not numbers.
constexpr const char* kSecondUnit = R"(#include "robot.hpp"
int second_unit();
int second_unit() {
  namespace arm = two_link_arm;
  static_assert(arm::joint_count == 2 && arm::inertia_matrix_D_nonzero[0] && !arm::inertia_matrix_D_nonzero[1], "");
  const arm::Parameters<> parameters = {1.25};
  const double q[2] = {0.3, 1.3}, qd[2] = {-0.7, 0.3}, tau[2] = {1.5, 0.5};
  double apart[2], in_place[2] = {1.5, 0.5};
  if (!arm::forward_dynamics(parameters, q, qd, tau, apart)) return 2;
  if (!arm::forward_dynamics(parameters, q, qd, in_place, in_place)) return 3;
  if (apart[0] < in_place[0] || apart[0] > in_place[0] || apart[1] < in_place[1] || apart[1] > in_place[1]) return 4;
  const double no_state[2] = {0.3, std::nan("")};
  return arm::forward_dynamics(parameters, no_state, qd, tau, apart) ? 5 : 0;
}
)";

std::vector<double> numbers_in(const std::string& text) {
  std::istringstream stream(text);
  std::vector<double> numbers;
  for (double value; stream >> value;) numbers.push_back(value);
  return numbers;
}

void expect_values(const std::string& output, double tolerance) {
  std::vector<double> expected;
  for (const Function& function : all_functions()) {
    const std::vector<double> values = testing::values_of(function);
    expected.insert(expected.end(), values.begin(), values.end());
  }
  const std::vector<double> computed = numbers_in(output);
  ASSERT_EQ(computed.size(), expected.size()) << output;
  for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(computed[k], expected[k], tolerance) << k;
}

TEST(Header, CompilesAndComputesInDoubleAndFloat) {
  for (const std::string& compiler : testing::compilers()) {
    for (const auto& [scalar, tolerance] : {std::pair("double", 1e-14), std::pair("float", 1e-5)}) {
      SCOPED_TRACE(compiler + " " + scalar);
      const testing::Run run = testing::build_and_run(
          compiler, {{"robot.hpp", header()}, {"main.cpp", driver(scalar)}, {"second.cpp", kSecondUnit}});
      ASSERT_TRUE(run.built) << run.output;
      expect_values(run.output, tolerance);
    }
  }
}

TEST(Header, FloatConstantsAndOtherNamespaceCompile) {
  EmitOptions options;
  options.scalar = "float";
  options.name_space = "acme::arm";
  const std::string text = emit_header(testing::two_link_mechanism({"m1"}), all_functions(), options);
  EXPECT_THAT(text, HasSubstr("namespace acme::arm {"));
  EXPECT_THAT(text, HasSubstr("#ifndef FLATDYN_ACME_ARM_HPP_"));
  const char* main = R"(#include "robot.hpp"
int main() {
  float parameters_default = acme::arm::Parameters<>{1.25F}.m1;
  return acme::arm::position_upper[0] > 2.8F && parameters_default > 1.0F ? 0 : 1;
}
)";
  for (const std::string& compiler : testing::compilers()) {
    const testing::Run run = testing::build_and_run(compiler, {{"robot.hpp", text}, {"main.cpp", main}});
    EXPECT_TRUE(run.built) << run.output;
    EXPECT_EQ(run.output, "");
  }
}

EmitOptions in_namespace(const std::string& name) {
  EmitOptions options;
  options.name_space = name;
  return options;
}

std::string guard_in(const std::string& text) {
  const std::size_t begin = text.find("#ifndef ") + 8;
  return text.substr(begin, text.find('\n', begin) - begin);
}

// Names that are equal in capitals; and one name for two robots, where the second header must not vanish.
TEST(Header, HasAGuardOfItsOwn) {
  std::map<std::string, std::string> owners;
  for (const std::string language : {"c++", "c"}) {
    for (const char* name : {"acme::arm", "acme_arm", "Acme::arm", "acme::Arm"}) {
      for (const char* hash : {"sha1:1", "sha1:2"}) {
        EmitOptions options = in_namespace(name);
        options.language = language;
        options.input_hash = hash;
        const Mechanism mechanism = testing::two_link_mechanism({"m1"});
        const std::string text = language == "c" ? testing::emit_c(mechanism, all_functions(), options).header
                                                 : emit_header(mechanism, all_functions(), options);
        const std::string owner = std::string(name) + hash + (language == "c" ? ".h" : ".hpp");
        EXPECT_TRUE(owners.emplace(guard_in(text), owner).second) << owner << " and " << owners[guard_in(text)];
        EXPECT_THAT(text, HasSubstr("#define " + guard_in(text) + "\n"));
        EXPECT_THAT(text, HasSubstr("#endif  // " + guard_in(text) + "\n"));
      }
    }
  }
}

TEST(Header, WithALikeNameDoesNotHideAnother) {
  const EmitOptions nested = in_namespace("acme::arm"), flat = in_namespace("acme_arm");
  const Mechanism mechanism = testing::two_link_mechanism({"m1"});
  const std::vector<Function> functions = {testing::pendulum_gravity()};
  const char* main = R"(#include "nested.hpp"
#include "flat.hpp"
int main() {
  const double q[2] = {0.3, 0.4};
  double a[2], b[2];
  acme::arm::gravity(acme::arm::Parameters<>{1.25}, q, a);
  acme_arm::gravity(acme_arm::Parameters<>{1.25}, q, b);
  return a[0] - b[0] > 0 || a[0] - b[0] < 0 ? 1 : 0;
}
)";
  const testing::Run run = testing::build_and_run("g++", {{"nested.hpp", emit_header(mechanism, functions, nested)},
                                                          {"flat.hpp", emit_header(mechanism, functions, flat)},
                                                          {"main.cpp", main}});
  EXPECT_TRUE(run.built) << run.output;
  EXPECT_EQ(run.output, "");
}

TEST(Header, TellsAdaptersTheShapes) {
  const EmitOptions options = in_namespace("acme::arm");
  EXPECT_THAT(emit_header(testing::two_link_mechanism({"m1"}), all_functions(), options), HasSubstr(R"(
struct inertia_matrix {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[2], Scalar (&B)[2][2],
      Scalar (&D)[2][2]);
  template <class... Of>
  [[gnu::always_inline]] auto operator()(Of&&... of) const noexcept {
    return ::acme::arm::inertia_matrix(of...);
  }
};
)"));
  Function few = testing::two_link_inverse_dynamics();
  few.outputs[0].left_out = {true, false};
  EXPECT_THAT(emit_header(testing::two_link_mechanism({"m1"}), {few}, options),
              HasSubstr("  static constexpr bool leaves_out = true;"));
}

TEST(Header, IsTheSameEveryTime) { EXPECT_EQ(header(), header()); }

TEST(Header, HasOnlyWhatIsNeeded) {
  const std::string text = emit_header(testing::two_link_mechanism(), {testing::two_link_inertia_matrix()}, {});
  EXPECT_THAT(text, Not(HasSubstr("Parameters {")));
  EXPECT_THAT(text, Not(HasSubstr("Scalar sign(")));
  EXPECT_THAT(text, Not(HasSubstr("velocity_limit")));
  EXPECT_THAT(text, Not(HasSubstr("\n\n\n")));
  EXPECT_THAT(text, HasSubstr("#include <cmath>\n\n#if defined(__FAST_MATH__)"));
  EXPECT_THAT(text, HasSubstr("-fsingle-precision-constant\");\n\nnamespace two_link_arm {\n"));
}

TEST(Header, SaysWhatTheFunctionIs) {
  EXPECT_THAT(header(), HasSubstr(R"(// Joint torques of a motion, without contact (7.42).
//   q[2]    in   joint positions, rad or m
//   qd[2]   in   joint velocities, rad/s or m/s
//   qdd[2]  in   joint accelerations, rad/s^2 or m/s^2
//   tau[2]  out  joint torques, N m
// Reads q[0..1], qd[0..1], qdd[0..1]. Operations: )"));
}

TEST(Header, ListsJointsAndLimits) {
  const std::string text = header();
  EXPECT_THAT(text, HasSubstr(R"(
//   index  joint     moves link  type        unit  lower                upper   effort
//   0      shoulder  upper_arm   revolute    rad   -1.5707963267948966  2.8973  87
//   1      double    forearm     continuous  rad   none                 none    none
)"));
  EXPECT_THAT(text, HasSubstr("position_lower[joint_count] = {Real(-1.5707963267948966), Real(-HUGE_VAL)};"));
  EXPECT_THAT(text, HasSubstr("Gravity is (0, 0, -9.81) m/s^2 in the base frame."));
}

// A name cannot break out of its comment or its string.
TEST(Header, SurvivesHostileNames) {
  Mechanism mechanism = testing::two_link_mechanism();
  mechanism.name = "a\\\n*/ #error";
  mechanism.bodies[0].joint = "x\"); exit(1); //\\";
  mechanism.bodies[1].joint = "?\?/\n";
  mechanism.bodies[1].link = "{{robot}} <&> \\";
  mechanism.tip.link = "tip\\";
  const std::string text = emit_header(mechanism, {testing::two_link_inertia_matrix()}, {});
  EXPECT_THAT(text, HasSubstr("{{robot}} <&> /"));
  const testing::Run run =
      testing::build_and_run("g++", {{"robot.hpp", text}, {"main.cpp", "#include \"robot.hpp\"\nint main() {}\n"}});
  EXPECT_TRUE(run.built) << run.output;
}

TEST(Header, NamesNeverCollide) {
  testing::Builder b;
  const NodeId x = b.named(b.plus({b.q(0), b.qd(0)}), "q_1");
  const NodeId y = b.named(b.plus({b.q(1), b.qd(1)}), "class");
  const NodeId z = b.named(b.plus({b.q(0), b.qd(1)}), "tau");
  const NodeId w = b.named(b.plus({b.q(1), b.qd(0)}), "joint_count");
  Function function = testing::two_link_inverse_dynamics();
  function.outputs[0].entries = {b.times({x, y, z, w}), b.times({x, x})};
  function.graph = b.graph;
  const std::string text = emit_header(testing::two_link_mechanism(), {function}, {});
  for (const char* line : {"const Scalar q_1_2 = q_1 + qd_1;", "const Scalar class_ = q_2 + qd_2;",
                           "const Scalar tau_2 = q_1 + qd_2;", "const Scalar joint_count_2 = q_2 + qd_1;"}) {
    EXPECT_THAT(text, HasSubstr(line));
  }
  const testing::Run run =
      testing::build_and_run("g++", {{"robot.hpp", text}, {"main.cpp", "#include \"robot.hpp\"\nint main() {}\n"}});
  EXPECT_TRUE(run.built) << run.output;
}

TEST(Header, RefusesWrongOptions) {
  for (const char* name : {"2arm", "a b", "a::", "std", "class"}) {
    EmitOptions options;
    options.name_space = name;
    EXPECT_THROW(emit_header(testing::two_link_mechanism(), {}, options), Failure) << name;
  }
  EmitOptions options;
  options.scalar = "long double";
  EXPECT_THROW(emit_header(testing::two_link_mechanism(), {}, options), Failure);
}

TEST(Header, IsNamedAfterTheRobot) { EXPECT_EQ(header_name(testing::two_link_mechanism(), {}), "two_link_arm.hpp"); }

}  // namespace
}  // namespace flatdyn
