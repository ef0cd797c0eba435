// SPDX-License-Identifier: GPL-2.0-or-later
// Generated code and runtime headers of two versions in one build: neither compiler accepts them, and their messages
// say what to do.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "golden/golden.hpp"

namespace flatdyn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr const char* kTogether = R"(#include "ur5.hpp"
#include "flatdyn/trigonometry.hpp"
int main() {
  double q[6] = {}, g[6];
  ur5::gravity(q, g, flatdyn::TogetherSinCos());
}
)";
constexpr const char* kLanes = R"(#include "flatdyn/batch.hpp"
#include "ur5.hpp"
int main() {
  const flatdyn::Lanes<double> q[6] = {};
  flatdyn::Lanes<double> g[6];
  ur5::gravity(q, g);
}
)";
constexpr const char* kOwnScalar = R"(#include "ur5.hpp"
int main() {
  const long double q[6] = {};
  long double g[6];
  ur5::gravity(q, g);
}
)";

constexpr const char* kLanesWithoutSines = R"(#include "cartesian_2.hpp"
#include "flatdyn/batch.hpp"
int main() {
  const cartesian_2::Parameters<flatdyn::Lanes<double>> parameters = {};
  const flatdyn::Lanes<double> q[2] = {};
  flatdyn::Lanes<double> B[4];
  cartesian_2::inertia_matrix(parameters, q, B);
}
)";
constexpr const char* kGivenLanes = R"(#include "flatdyn/batch.hpp"
#include "ur5.hpp"
int main() {
  const flatdyn::Lanes<double> q[6] = {}, sine[6] = {}, cosine[6] = {};
  flatdyn::Lanes<double> g[6];
  ur5::gravity(q, g, ur5::GivenSinCos<flatdyn::Lanes<double>>{sine, cosine});
}
)";

// Calls with integer positions: functions with sines, without, with the caller's sines, and in stages.
constexpr const char* kIntegers[] = {"ur5::gravity(q, g);",
                                     "cartesian_2::inertia_matrix(cartesian_2::Parameters<int>(), q, g);",
                                     "ur5::gravity(q, g, ur5::GivenSinCos<int>{q, q});",
                                     "ur5::gravity(q, g, [](auto...) {});",
                                     "const long p[6] = {};\n  long tau[6];\n  ur5::gravity(p, tau);",
                                     "const bool p[6] = {};\n  bool tau[6];\n  ur5::gravity(p, tau);"};

// A folder with the runtime and a generated header, either of which may be changed.
class Interface : public ::testing::TestWithParam<const char*> {
 protected:
  Interface() {
    fs::create_directory(folder_.path() / "flatdyn");
    for (const char* name :
         {"batch.hpp", "states.hpp", "lanes.hpp", "trigonometry.hpp", "sincos.hpp", "interface.hpp"}) {
      fs::copy_file(kSource / "runtime/include/flatdyn" / name, folder_.path() / "flatdyn" / name);
    }
    for (const char* name : {"ur5.hpp", "cartesian_2.hpp"}) {
      fs::copy_file(kSource / "generated" / name, folder_.path() / name);
    }
  }

  void replace(const std::string& file, const std::string& old, const std::string& text) const {
    std::string content = content_of(folder_.path() / file);
    const std::size_t at = content.find(old);
    ASSERT_NE(at, std::string::npos) << file << " has no " << old;
    std::ofstream(folder_.path() / file) << content.replace(at, old.size(), text);
  }

  // The compiler's message; empty if it accepts the program.
  std::string complaint(const char* program) const {
    std::ofstream(folder_.path() / "main.cpp") << program;
    const std::string command = fmt::format(
        "cd '{}' && {} -std=c++17 -fsyntax-only -Wall -Wextra -Werror -I. main.cpp "
        "> log 2>&1",
        folder_.path().string(), GetParam());
    const int status = std::system(command.c_str());
    return (status == 0 ? "" : "failed: ") + content_of(folder_.path() / "log");
  }

  const fs::path kSource = FLATDYN_SOURCE_DIR;
  TemporaryFolder folder_;
};

TEST_P(Interface, FitsWithinAVersion) {
  for (const char* program : {kTogether, kLanes, kOwnScalar, kLanesWithoutSines, kGivenLanes}) {
    EXPECT_EQ(complaint(program), "");
  }
}

TEST_P(Interface, IntegersAreRefused) {
  for (const char* call : kIntegers) {
    const std::string program = fmt::format(
        "#include \"ur5.hpp\"\n#include \"cartesian_2.hpp\"\n"
        "int main() {{\n  const int q[6] = {{}};\n  int g[6];\n  {}\n}}\n",
        call);
    EXPECT_THAT(complaint(program.c_str()), HasSubstr("integers cannot hold positions, velocities or torques")) << call;
  }
  EXPECT_THAT(complaint("#include \"flatdyn/batch.hpp\"\nint main() { flatdyn::Lanes<int> q; }\n"),
              HasSubstr("lanes are of float or double"));
}

// Classes over integers, such as fixed-point numbers, are allowed as scalars.
TEST_P(Interface, ScalarsOfOthersFit) {
  EXPECT_EQ(complaint(R"(#include "ur5.hpp"
struct Fixed {
  long n = 0;
  Fixed() = default;
  explicit Fixed(double x) : n(static_cast<long>(x * 65536)) {}
  friend Fixed operator+(Fixed a, Fixed b) { a.n += b.n; return a; }
  friend Fixed operator-(Fixed a, Fixed b) { a.n -= b.n; return a; }
  friend Fixed operator-(Fixed a) { a.n = -a.n; return a; }
  friend Fixed operator*(Fixed a, Fixed b) { a.n = a.n * b.n / 65536; return a; }
  friend Fixed sin(Fixed a) { return Fixed(std::sin(double(a.n) / 65536)); }
  friend Fixed cos(Fixed a) { return Fixed(std::cos(double(a.n) / 65536)); }
};
int main() {
  const Fixed q[6] = {};
  Fixed g[6];
  ur5::gravity(q, g);
  const __float128 p[6] = {};
  __float128 tau[6];
  ur5::gravity(p, tau, [](const __float128*, auto, __float128*, __float128*) {});
}
)"),
            "");
}

TEST_P(Interface, OfANewerRuntimeIsRefused) {
  replace("flatdyn/interface.hpp", "kInterface = 1", "kInterface = 2");
  EXPECT_THAT(complaint(kTogether), HasSubstr("flatdyn/trigonometry.hpp is of another version of flatdyn than this "
                                              "generated code: generate it again"));
  for (const char* program : {kLanes, kLanesWithoutSines, kGivenLanes}) {
    EXPECT_THAT(complaint(program), HasSubstr("this scalar is of another version of flatdyn's runtime than this "
                                              "generated code: generate it again"));
  }
  EXPECT_EQ(complaint(kOwnScalar), "");
}

// Generated code as it was before versions existed.
TEST_P(Interface, OfGeneratedCodeWithoutANumberIsRefused) {
  replace("ur5.hpp", "  static constexpr int flatdyn_interface = 1;", "");
  EXPECT_THAT(complaint(kTogether), HasSubstr("generate it again, with the flatdyn that the header came with"));
}

// Objects in place of arrays have one message that says what to pass, and nothing else.
TEST_P(Interface, ObjectsInPlaceOfArraysAreRefusedInASentence) {
  const auto with = [this](const char* types, const char* call) {
    const std::string program = fmt::format(
        "#include \"ur5.hpp\"\n#include <array>\n#include <vector>\n{}\nint main() {{\n  double p[6] = {{}}, t[6];\n"
        "  (void)p, (void)t;\n  {}\n}}\n",
        types, call);
    return complaint(program.c_str());
  };
  const auto is_the_message = [](const std::string& said) {
    std::size_t errors = 0;
    for (std::size_t at = said.find(" error: "); at != std::string::npos; at = said.find(" error: ", at + 1)) ++errors;
    return errors == 1 &&
           said.find("arguments are plain arrays: of a std::array, std::vector or std::span pass q.data()") !=
               std::string::npos;
  };
  constexpr const char* kMatrix =
      "struct Matrix { double* data(); const double* data() const; };\n"
      "struct Sum { Matrix eval() const; };";
  for (const char* call :
       {"std::array<double, 6> q{}, g; ur5::gravity(q, g);", "std::vector<double> q(6), g(6); ur5::gravity(q, g);",
        "const std::array<float, 6> q{}; std::array<float, 6> g; ur5::gravity(q, g);",
        "std::array<double, 6> q{}; ur5::gravity(q, t);", "Matrix g; ur5::gravity(p, g);",
        "Sum q; ur5::gravity(q, t, ur5::LibrarySinCos());",
        "std::array<double, 6> q{}; if (!ur5::forward_dynamics(q, p, p, t)) return 1;",
        "std::array<double, 6> q{}; const double T = ur5::kinetic_energy(q, p); (void)T;"}) {
    const std::string said = with(kMatrix, call);
    EXPECT_TRUE(is_the_message(said)) << call << "\n" << said;
  }
  EXPECT_EQ(with("", "std::array<double, 6> q{}, g; ur5::gravity(q.data(), g.data());"), "");
  EXPECT_EQ(with("", "ur5::gravity(p, t); ur5::gravity<double>(p, t); ur5::gravity(p, t, ur5::LibrarySinCos());"), "");
  EXPECT_EQ(with("", "auto* const f = &ur5::gravity<double, ur5::LibrarySinCos>; (void)f;"), "");
}

// A result that says whether the others mean something must not be dropped.
TEST_P(Interface, DroppedAnswersAreWarnings) {
  const std::string calls = "#include \"ur5.hpp\"\nint main() {\n  double q[6] = {}, qdd[6];\n  ";
  EXPECT_THAT(complaint((calls + "ur5::forward_dynamics(q, q, q, qdd);\n}\n").c_str()), HasSubstr("nodiscard"));
  EXPECT_THAT(complaint((calls + "(void)qdd, (void)q;\n  ur5::rounding_is_as_written();\n}\n").c_str()),
              HasSubstr("nodiscard"));
  EXPECT_EQ(complaint((calls + "(void)ur5::forward_dynamics(q, q, q, qdd);\n}\n").c_str()), "");
}

INSTANTIATE_TEST_SUITE_P(Compilers, Interface, ::testing::Values("g++", "clang++"),
                         [](const auto& test) { return test.param == std::string("g++") ? "gcc" : "clang"; });

}  // namespace
}  // namespace flatdyn::testing
