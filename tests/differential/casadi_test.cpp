// SPDX-License-Identifier: GPL-2.0-or-later
// `flatdyn generate --language casadi`: the interface keeps CasADi's contract, and CasADi itself, from the packages
// that scripts/setup installs in build/peers, loads the library and derives what differences and its own expressions
// say.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "base/system/process.hpp"
#include "base/system/temporary_folder.hpp"
#include "support/floating_robots.hpp"

namespace flatdyn {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = FLATDYN_SOURCE_DIR;

class Casadi : public ::testing::Test {
 protected:
  void generate(const std::string& robot, const std::string& functions) {
    run(fmt::format("{} generate {} --language casadi --name robot --namespace robot --functions {} -q -o .",
                    shell_word(FLATDYN_PROGRAM), robot, functions));
  }
  void compile(const std::string& options) {
    run(fmt::format("cc {} -shared -fPIC robot.c robot_casadi.c -o librobot.so -lm", options));
  }
  void run(const std::string& command) const {
    ASSERT_EQ(run_command(fmt::format("({}) > log 2>&1", command), folder_.path()), 0)
        << command << "\n"
        << content_of_file(folder_.path() / "log");
  }
  void run_peer(const std::string& arguments) {
    const fs::path python = kSource / "build" / "peers" / "bin" / "python";
    if (!fs::exists(python)) GTEST_SKIP() << "build/peers is not there: scripts/setup makes it";
    run(fmt::format("{} -B {} {}", shell_word(python.string()),
                    shell_word((kSource / "tests" / "differential" / "casadi_peer.py").string()), arguments));
    fmt::print("{}", content_of_file(folder_.path() / "log"));
  }
  static std::string robot(const std::string& name) { return shell_word((kSource / "robots" / name).string()); }

  const TemporaryFolder folder_;
};

// Null arguments are zero, null results are left alone, and questions have CasADi's answers. The robot has free
// symbols, and inertia_matrix has results that are stored column by column.
constexpr const char* kContract = R"(
#include <stdio.h>
#include <string.h>
typedef double real;
typedef long long int integer;
int gravity(const real** arg, real** res, integer* iw, real* w, int mem);
int jac_gravity(const real** arg, real** res, integer* iw, real* w, int mem);
int adj1_inertia_matrix(const real** arg, real** res, integer* iw, real* w, int mem);
int inertia_matrix(const real** arg, real** res, integer* iw, real* w, int mem);
integer jac_gravity_n_in(void);
integer jac_gravity_n_out(void);
const char* jac_gravity_name_in(integer k);
const char* jac_gravity_name_out(integer k);
const integer* jac_gravity_sparsity_in(integer k);
const integer* jac_gravity_sparsity_out(integer k);
int jac_gravity_work(integer* arg, integer* res, integer* iw, integer* w);
void jac_gravity_incref(void);
void jac_gravity_decref(void);
#define EXPECT(condition) if (!(condition)) return printf("line %d: %s\n", __LINE__, #condition), 1
int main(void) {
  real parameters[15], q[2] = {0.3, 0.7}, w[200], y[2], J[4], zero[2];
  integer sizes[4];
  for (int k = 0; k < 15; ++k) parameters[k] = k + 1;
  const real *both[] = {q, parameters}, *without_q[] = {NULL, parameters}, *at_zero[] = {zero, parameters};
  zero[0] = zero[1] = 0;
  real *result[] = {y}, *none[] = {NULL}, first[2], *result_at_zero[] = {first};
  EXPECT(gravity(both, result, NULL, w, 0) == 0 && y[0] != 0);
  EXPECT(gravity(without_q, result, NULL, w, 0) == 0 && gravity(at_zero, result_at_zero, NULL, w, 0) == 0);
  EXPECT(memcmp(y, first, sizeof y) == 0);
  EXPECT(gravity(both, none, NULL, w, 0) == 0);
  EXPECT(jac_gravity_n_in() == 3 && jac_gravity_n_out() == 2);
  EXPECT(strcmp(jac_gravity_name_in(1), "parameters") == 0 && strcmp(jac_gravity_name_in(2), "out_g") == 0);
  EXPECT(strcmp(jac_gravity_name_out(1), "jac_g_parameters") == 0);
  EXPECT(jac_gravity_name_in(-1) == NULL && jac_gravity_name_in(3) == NULL && jac_gravity_name_out(2) == NULL);
  EXPECT(jac_gravity_sparsity_in(3) == NULL && jac_gravity_sparsity_out(-1) == NULL);
  const integer *dense = jac_gravity_sparsity_out(0), *unused = jac_gravity_sparsity_in(2),
                *sparse = jac_gravity_sparsity_out(1);
  EXPECT(dense[0] == 2 && dense[1] == 2 && dense[2] == 1);
  EXPECT(unused[0] == 2 && unused[1] == 1 && unused[2] == 0 && unused[3] == 0);
  EXPECT(sparse[0] == 2 && sparse[1] == 15 && sparse[2] == 0 && sparse[17] < 30);
  EXPECT(jac_gravity_work(&sizes[0], &sizes[1], &sizes[2], &sizes[3]) == 0);
  EXPECT(sizes[0] == 3 && sizes[1] == 2 && sizes[2] == 0 && sizes[3] == 4 + sparse[17]);
  EXPECT(jac_gravity_work(NULL, NULL, NULL, NULL) == 0);
  jac_gravity_incref();
  jac_gravity_decref();
  const real* jacobian_arguments[] = {q, parameters, NULL};
  real* jacobian[] = {J, NULL};
  w[sizes[3]] = 42;
  EXPECT(jac_gravity(jacobian_arguments, jacobian, NULL, w, 0) == 0 && w[sizes[3]] == 42);
  EXPECT(J[1] == J[2] && J[0] != J[1]);
  real B[4], bar[2];
  real *inertia[] = {B}, *adjoint[] = {bar, NULL};
  EXPECT(inertia_matrix(both, inertia, NULL, w, 0) == 0 && B[0] > 0 && B[1] == B[2]);
  const real weights[4] = {1, 0, 0, 0}, *weighted[] = {q, parameters, NULL, weights};
  EXPECT(adj1_inertia_matrix(weighted, adjoint, NULL, w, 0) == 0 && bar[0] == 0 && bar[1] != 0);
  return 0;
}
)";

TEST_F(Casadi, ContractIsKept) {
  ASSERT_NO_FATAL_FAILURE(generate(robot("planar_2r.toml"), "gravity,inertia_matrix"));
  write_file(folder_.path() / "main.c", kContract);
  for (const char* compiler : {"cc", "clang"}) {
    if (run_command(fmt::format("command -v {} > /dev/null", compiler), folder_.path()) != 0) continue;
    run(
        fmt::format("{} -std=c99 -O1 -Wall -Wextra -pedantic -Werror robot.c robot_casadi.c main.c -o contract -lm && "
                    "./contract",
                    compiler));
  }
}

TEST_F(Casadi, ReturnsOneWhereResultsMeanNothing) {
  ASSERT_NO_FATAL_FAILURE(generate(robot("planar_2r.toml"), "forward_dynamics"));
  write_file(folder_.path() / "main.c",
             "#include <stddef.h>\n"
             "int forward_dynamics(const double** arg, double** res, long long* iw, double* w, int mem);\n"
             "int main(void) { const double* arg[4] = {NULL}; double* res[1] = {NULL}; double w[8];\n"
             "  return forward_dynamics(arg, res, NULL, w, 0) == 1 ? 0 : 1; }\n");
  run("cc -O1 robot.c robot_casadi.c main.c -o none -lm && ./none");
}

TEST_F(Casadi, DerivesARobotWithFreeSymbols) {
  ASSERT_NO_FATAL_FAILURE(generate(robot("planar_2r.toml"),
                                   "inertia_matrix,jac:forward_dynamics,vjp:forward_dynamics,jvp:forward_dynamics,"
                                   "hessian:forward_dynamics"));
  ASSERT_NO_FATAL_FAILURE(compile("-O0"));
  run_peer("derivatives ./librobot.so inertia_matrix forward_dynamics");
}

TEST_F(Casadi, DerivesARobotWithAFloatingBase) {
  write_file(folder_.path() / "satellite.toml", testing::kSatellite);
  ASSERT_NO_FATAL_FAILURE(generate("satellite.toml",
                                   "inverse_dynamics,jac:forward_dynamics,vjp:forward_dynamics,jvp:forward_dynamics,"
                                   "hessian:forward_dynamics"));
  ASSERT_NO_FATAL_FAILURE(compile("-O0"));
  run_peer("derivatives ./librobot.so inverse_dynamics forward_dynamics");
}

// A scene that asks for some entries only, and one that holds still: what is left out, and velocities, have no
// derivatives.
TEST_F(Casadi, DerivesWhatASceneLeaves) {
  write_file(folder_.path() / "parts.toml",
             "[outputs]\ninverse_dynamics = [\"tau[0]\"]\ninertia_matrix = [\"B[1]\"]\n");
  const std::string arm = robot("planar_2r_example_7_2.toml");
  for (const char* scene : {"--scene parts.toml", "--scene still.toml"}) {
    write_file(folder_.path() / "still.toml", "static = true\n");
    ASSERT_NO_FATAL_FAILURE(generate(fmt::format("{} {}", arm, scene),
                                     "jac:inverse_dynamics,vjp:inverse_dynamics,jvp:inverse_dynamics,"
                                     "hessian:inverse_dynamics,inertia_matrix"));
    ASSERT_NO_FATAL_FAILURE(compile("-O0"));
    run_peer("derivatives ./librobot.so inverse_dynamics inertia_matrix");
  }
}

// CasADi's names have no prefix.
TEST_F(Casadi, NamesThatAreEqualAreRefused) {
  const std::string command =
      fmt::format("{} generate {} --language casadi --functions gravity -q -o . --namespace jac",
                  shell_word(FLATDYN_PROGRAM), robot("planar_2r_example_7_2.toml"));
  EXPECT_EQ(run_command(command + " 2> log", folder_.path()), 2);
  EXPECT_NE(content_of_file(folder_.path() / "log").find("\"jac_gravity\""), std::string::npos);
}

// A fused function is one of CasADi, too, even of derivatives.
TEST_F(Casadi, HasFusedFunctions) {
  ASSERT_NO_FATAL_FAILURE(generate(robot("planar_2r_example_7_2.toml") + " --fuse jac:gravity,vjp:gravity", "gravity"));
  const std::string text = content_of_file(folder_.path() / "robot_casadi.c");
  EXPECT_NE(text.find("QUERIES(jac_gravity_vjp_gravity, 2, 2, "), std::string::npos);
}

TEST_F(Casadi, SolvesTheProblemThatItsOwnExpressionsSolve) {
  ASSERT_NO_FATAL_FAILURE(generate(robot("panda.urdf"), "inverse_dynamics,forward_dynamics"));
  ASSERT_NO_FATAL_FAILURE(compile("-O2"));
  run_peer(fmt::format("reach ./librobot.so {} {}", robot("panda.urdf"),
                       shell_word((kSource / "docs" / "examples" / "casadi" / "reach.py").string())));
}

}  // namespace
}  // namespace flatdyn
