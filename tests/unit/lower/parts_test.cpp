// SPDX-License-Identifier: GPL-2.0-or-later
// Functions in parts: no function is too long, no storage is wasted, and the bits are the same.
#include "code/lower/parts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "code/emit/printer.hpp"
#include "code/languages/cpp/dialect.hpp"
#include "code/languages/emit.hpp"
#include "functions/planning/make_functions.hpp"
#include "support/robot_models.hpp"
#include "unit/emit/compiled.hpp"

namespace flatdyn {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::vector<std::string> kStaged = {"inertia_matrix", "bias", "forward_dynamics", "kinetic_energy"};

// Functions made once and written in several ways.
class PartsOf {
 public:
  explicit PartsOf(const char* robot) : model_(testing::model_of(robot)) {
    PipelineOptions options;
    options.functions = {"inverse_dynamics", "inertia_matrix", "forward_dynamics", "kinetic_energy", "christoffel"};
    Progress quiet(true);
    Diagnostics left_out;
    functions_ = functions_of(make_functions(model_, options, quiet, left_out));
    stages_ = stages_of(make_fusion(model_, kStaged, quiet).fusion);
  }

  // The header; most_lines = 0 leaves functions whole.
  std::string header(int most_lines) const {
    EmitOptions emit;
    emit.name_space = most_lines == 0 ? "whole" : "cut";
    emit.most_lines = most_lines;
    return emit_header(model_.mechanism, functions_, emit, stages_);
  }

 private:
  LoadedRobot model_;
  std::vector<Function> functions_;
  std::optional<Stages> stages_;
};

bool begins_with(const std::string& line, const std::string& begin) { return line.rfind(begin, 0) == 0; }

// The length in lines of the longest of the robot's functions, from its name to its closing brace. They are between
// the sines and rounding_is_as_written(), which are never cut.
int longest_function(const std::string& header) {
  const std::size_t begin = header.find("}  // namespace detail", header.find("void sines_and_cosines("));
  std::istringstream text(header.substr(begin, header.find("static bool rounding_is_as_written()") - begin));
  int longest = 0, lines = 0;
  for (std::string line; std::getline(text, line); ++lines) {
    const auto begins_so = [&line](const char* word) { return begins_with(line, word); };
    const bool begins =
        begins_so("void ") || begins_so("inline ") || begins_so("static ") || begins_so("[[nodiscard]] ");
    if (begins) lines = 0;
    if (line == "}") longest = std::max(longest, lines + 1);
  }
  return longest;
}

TEST(Parts, AreNotLongerThanAskedFor) {
  for (const char* robot : {"scara.toml", "ur5.urdf", "planar_2r.toml"}) {
    const PartsOf parts(robot);
    for (const int lines : {30, 47, 100}) {
      const std::string header = parts.header(lines);
      EXPECT_LE(longest_function(header), lines) << robot;
      EXPECT_GT(longest_function(header), lines / 3) << robot;
    }
    EXPECT_THAT(parts.header(0), Not(HasSubstr("_part_")));
  }
}

// Both headers in one program. Outputs may overlap inputs, and a state that is not a number is detected.
constexpr const char* kComparison = R"(#include <limits>
#include <cstdio>
#include <cstring>
#include "cut.hpp"
#include "whole.hpp"
constexpr int n = whole::joint_count;
template <class S, int m> bool same(const S (&a)[m], const S (&b)[m]) { return std::memcmp(a, b, sizeof a) == 0; }
template <class S> int differences() {
  S q[n], qd[n], qdd[n], a[n * n], b[n * n], c[n * n * (n + 1) / 2], d[n * n * (n + 1) / 2];
  for (int i = 0; i < n; ++i) { q[i] = S(0.3 * i - 0.7); qd[i] = S(1.1 - 0.2 * i); qdd[i] = S(0.5 * i); }
  for (int i = 0; i < n * n; ++i) a[i] = b[i] = S(0.0);
  int count = 0;
  whole::inverse_dynamics(q, qd, qdd, a), cut::inverse_dynamics(q, qd, qdd, b);
  count += !same(a, b);
  whole::inertia_matrix(q, a), cut::inertia_matrix(q, b);
  count += !same(a, b);
  whole::christoffel(q, c), cut::christoffel(q, d);
  count += !same(c, d);
  for (int i = 0; i < n; ++i) a[i] = b[i] = qdd[i];
  count += !(whole::forward_dynamics(q, qd, a, a) && cut::forward_dynamics(q, qd, b, b)) + !same(a, b);
  a[0] = whole::kinetic_energy(q, qd), b[0] = cut::kinetic_energy(q, qd);
  count += !same(a, b);
  const auto there = whole::at(q);
  const auto here = cut::at(q);
  there.inertia_matrix(a), here.inertia_matrix(b);
  count += !same(a, b);
  there.with(qd).bias(a), here.with(qd).bias(b);
  count += !same(a, b);
  count += !(there.with(qd).forward_dynamics(qdd, a) && here.with(qd).forward_dynamics(qdd, b)) + !same(a, b);
  q[1] = std::numeric_limits<S>::quiet_NaN();
  return count + cut::forward_dynamics(q, qd, qdd, b);
}
int main() { std::printf("%d\n", differences<double>() + differences<float>()); }
)";

TEST(Parts, ComputeTheSameBits) {
  const PartsOf parts("ur5.urdf");
  const std::string whole = parts.header(0), cut = parts.header(40);
  for (const std::string& compiler : testing::compilers()) {
    const testing::Run run =
        testing::build_and_run(compiler, {{"whole.hpp", whole}, {"cut.hpp", cut}, {"main.cpp", kComparison}});
    ASSERT_TRUE(run.built) << run.output;
    EXPECT_EQ(run.output, "0\n") << compiler;
  }
}

// The body x_0 = 1; x_1 = x_0; x_2 = x_1; … in parts of ten lines.
Parts parts_of_chain(int count, int most_calls) {
  const CppDialect cpp;
  const HeaderScope scope(cpp);
  const Printer printer(scope);
  code::Statements chain;
  for (int k = 0; k < count; ++k) {
    const code::Expression before = code::Variable{"x_" + std::to_string(k - 1)};
    chain.emplace_back(code::Define{{{"x_" + std::to_string(k), k == 0 ? code::Literal{1} : before}}});
  }
  return in_parts({"f", chain, {}, {{code::Argument::Role::output, kKept}}, 10, printer}, most_calls);
}

TEST(Parts, UsePlacesAgain) {
  const Parts parts = parts_of_chain(100, 100);
  EXPECT_EQ(parts.kept, 1);
  EXPECT_GT(parts.calls.size(), 10u);
}

TEST(Parts, AreCalledByGroups) {
  const Parts parts = parts_of_chain(400, 4);
  EXPECT_LE(parts.calls.size(), 4u);
  const auto is_first_group = [](const code::Part& part) { return part.name == "f_parts_1_to_3"; };
  const auto group = std::find_if(parts.definitions.begin(), parts.definitions.end(), is_first_group);
  ASSERT_NE(group, parts.definitions.end());
  const CppDialect cpp;
  const HeaderScope scope(cpp);
  EXPECT_THAT(Printer(scope).text(*group),
              HasSubstr("void f_parts_1_to_3(Scalar* kept) noexcept {\n  f_part_1(kept);\n"));
  EXPECT_THAT(Printer(scope).text(parts.calls), HasSubstr("  detail::f_parts_"));
}

}  // namespace
}  // namespace flatdyn
