// SPDX-License-Identifier: GPL-2.0-or-later
// flatdyn/eigen.hpp as a user compiles it: its cost in instructions, and the compiler's messages for wrong calls.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <sstream>

#include "golden/golden.hpp"

namespace flatdyn::testing {
namespace {

using ::testing::HasSubstr;

constexpr const char* kCommon = R"(#include "flatdyn/eigen.hpp"
#include "panda.hpp"
namespace arm = panda::functions;
using Vector = Eigen::Matrix<double, 7, 1>;
)";

// Results by rows beside the same code by hand; results by columns beside a plain call.
constexpr const char* kCosts = R"(
template <int rows, int columns> using ByRows = Eigen::Matrix<double, rows, columns, Eigen::RowMajor>;
ByRows<7, 7> B_by_hand(const Vector& q) { ByRows<7, 7> B; panda::inertia_matrix(q.data(), B.data()); return B; }
ByRows<6, 7> J_by_hand(const Vector& q) { ByRows<6, 7> J; panda::jacobian(q.data(), J.data()); return J; }
Vector t_by_hand(const Vector& q) { Vector t; panda::inverse_dynamics(q.data(), q.data(), q.data(), t.data()); return t; }
ByRows<7, 7> B_of_eigen(const Vector& q) { return flatdyn::eigen<arm::inertia_matrix, Eigen::RowMajor>(q); }
ByRows<6, 7> J_of_eigen(const Vector& q) { return flatdyn::eigen<arm::jacobian, Eigen::RowMajor>(q); }
Vector t_of_eigen(const Vector& q) { return flatdyn::eigen<arm::inverse_dynamics>(q, q, q); }
)";
constexpr const char* kByColumns = R"(
Eigen::Matrix<double, 6, 7> by_columns(const Vector& q) { return flatdyn::eigen<arm::jacobian>(q); }
)";
constexpr const char* kByItself = R"(
void by_itself(const Vector& q, double* J) { panda::jacobian(q.data(), J); }
)";

std::string compile(const std::string& compiler) {
  return fmt::format(
      "{0} -std=c++17 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -DNDEBUG -I'{1}/generated' "
      "-I'{1}/runtime/include' -isystem /usr/include/eigen3 ",
      compiler, FLATDYN_SOURCE_DIR);
}

using Counts = std::map<std::string, int>;  // numbers of instructions, by a function's linker name

Counts instructions(const std::string& compiler, const std::string& program) {
  const TemporaryFolder folder;
  write(folder.path() / "main.cpp", kCommon + program);
  std::istringstream lines(
      output_of(folder.path(),
                compile(compiler) + "-c main.cpp -o main.o && objdump -d --no-show-raw-insn --no-addresses main.o"));
  Counts counts;
  int* count = &counts["failed"];
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("<")) {
      count = &counts[line.substr(1, line.find('>') - 1)];
    } else if (line.starts_with("\t") && line.find("nop") == std::string::npos) {
      ++*count;
    } else if (line.starts_with("failed: ")) {
      ADD_FAILURE() << line;
    }
  }
  return counts;
}

int of(const Counts& counts, const std::string& name) {
  const auto found = std::find_if(counts.begin(), counts.end(),
                                  [&](const auto& of) { return of.first.find(name) != std::string::npos; });
  return found == counts.end() ? 0 : found->second;
}

int sum_of(const Counts& counts) {
  int sum = 0;
  for (const auto& [name, count] : counts) sum += count;
  return sum;
}

class EigenCosts : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (std::system("objdump --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "objdump counts";
  }
};

TEST_P(EigenCosts, NothingByRows) {
  const Counts counts = instructions(GetParam(), kCosts);
  for (const std::string name : {"B", "J", "t"}) {
    EXPECT_GT(of(counts, name + "_by_hand"), 5) << name;
    EXPECT_LE(of(counts, name + "_of_eigen"), of(counts, name + "_by_hand")) << name;
  }
}

// Compilers with gnu::flatten keep the entries in registers until they store them in their final places; without it
// they would need another 42 loads and 42 stores. How much is inlined differs by some instructions.
TEST_P(EigenCosts, NextToNothingByColumns) {
  const bool flattens = std::string(GetParam()).starts_with("g++");
  const int more = sum_of(instructions(GetParam(), kByColumns)) - sum_of(instructions(GetParam(), kByItself));
  EXPECT_LT(more, flattens ? 60 : 120);
}

INSTANTIATE_TEST_SUITE_P(Compilers, EigenCosts, ::testing::Values("g++ -O2", "clang++ -O2"),
                         [](const auto& test) { return std::string(test.param).starts_with("g++") ? "gcc" : "clang"; });

class EigenCalls : public ::testing::TestWithParam<const char*> {
 protected:
  std::string complaint(const std::string& body) const {
    const TemporaryFolder folder;
    write(folder.path() / "main.cpp", kCommon + ("int main() {\n" + body + "}\n"));
    return output_of(folder.path(), compile(GetParam()) + "-Wno-unused -fsyntax-only main.cpp");
  }
};

TEST_P(EigenCalls, AreCheckedWhenTheyAreCompiled) {
  EXPECT_EQ(complaint("  flatdyn::eigen<arm::gravity>(Vector());\n"), "");
  const std::string said = complaint(R"(
  flatdyn::eigen<arm::gravity>(Eigen::Matrix<double, 6, 1>());
  flatdyn::eigen<arm::gravity>(Eigen::VectorXd(7));
  flatdyn::eigen<arm::gravity>(Eigen::Matrix<double, 1, 7>());
  flatdyn::eigen<arm::gravity>(Vector(), Vector());
  flatdyn::eigen<arm::inverse_dynamics>(Vector(), Vector());
  flatdyn::eigen<arm::gravity>(Eigen::Matrix<int, 7, 1>());
)");
  std::size_t columns = 0;
  const std::string expected = "a column vector of the function's length is expected";
  for (std::size_t at = 0; (at = said.find(expected, at)) != std::string::npos; ++at) ++columns;
  EXPECT_GE(columns, 3u) << said;
  EXPECT_THAT(said, HasSubstr("these are more vectors than the function has inputs"));
  EXPECT_THAT(said, HasSubstr("no match"));
  EXPECT_THAT(said, HasSubstr("integers cannot hold positions"));
}

INSTANTIATE_TEST_SUITE_P(Compilers, EigenCalls, ::testing::Values("g++", "clang++"),
                         [](const auto& test) { return test.param == std::string("g++") ? "gcc" : "clang"; });

// Functions of stages, from a header whose source is compiled separately.
TEST(EigenStages, KnowTheirPositions) {
  const TemporaryFolder folder;
  write(folder.path() / "main.cpp", R"(#include "flatdyn/eigen.hpp"
#include "example_7_2_pair.hpp"
int main() {
  namespace arm = example_7_2_pair;
  const Eigen::Vector2d q(0.3, -0.4), qd(1, 2), qdd(3, -4);
  const auto here = arm::at(q.data());
  const Eigen::Vector2d g = flatdyn::eigen<arm::functions::gravity>(here);
  const Eigen::Vector2d tau = flatdyn::eigen<arm::functions::inverse_dynamics>(here.with(qd.data()), qdd);
  const bool right = g.isApprox(flatdyn::eigen<arm::functions::gravity>(q), 1e-12) &&
                     tau.isApprox(flatdyn::eigen<arm::functions::inverse_dynamics>(q, qd, qdd), 1e-12);
  return right ? 0 : 1;
}
)");
  EXPECT_EQ(output_of(folder.path(), compile("g++") + "main.cpp '" FLATDYN_SOURCE_DIR
                                                      "/generated/example_7_2_pair.cpp' -o main && ./main"),
            "");
}

}  // namespace
}  // namespace flatdyn::testing
