// SPDX-License-Identifier: GPL-2.0-or-later
// flatdyn bench --gpu without a graphics processor: what it says then, the folder that it prepares, and how it reads
// what its program prints, which a stand-in for nvcc writes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;

// Compares the references of a folder with what its headers compute on the host in double.
constexpr const char* kComparison = R"(
#include <cmath>
#include <cstdio>
#include "gpu_states.hpp"
#include "ur5_double.cuh"

int main() {
  std::FILE* file = std::fopen("ur5.inertia_matrix.reference", "rb");
  double worst = 0, pair[2];
  for (int state = 0; state < reference_states; ++state) {
    double q[6], B[36];
    for (int k = 0; k < 6; ++k) q[k] = number_at(state, 0, k);
    ur5::inertia_matrix<double>(q, B);
    for (double entry : B) {
      if (std::fread(pair, sizeof(pair), 1, file) != 1) return 1;
      worst = std::fmax(worst, std::fabs((entry - pair[0]) - pair[1]));
    }
  }
  return std::fread(pair, 1, 1, file) == 0 && worst > 0 && worst < 1e-14 ? 0 : 2;
}
)";

// Writes a program that prints what a device would: its name, or the row of a case, taken from -D.
constexpr const char* kStandIn = R"(#!/bin/bash
for word; do
  case $word in
    --version) exit 0 ;;
    FUNCTION=*) function=${word#*=} ;;
    LAYOUT=*) layout=${word#*=} ;;
    SCALAR=*) scalar=${word#*=} ;;
    ROBOT=*) robot=${word#*=} ;;
  esac
  [[ $last == -o ]] && out=$word
  last=$word
done
[[ $function/$scalar == NONE ]] && exit 1
line="| $robot | $function | $layout | $scalar | 0.0372 | 64 | 40 | 2300 | 1.5 | 2 | 3.1 |"
[[ $function ]] || line="Stand-in, compute capability 9.0: a copy moves 3000 GB/s"
printf '#!/bin/bash\n[[ -z "%s" || -s $1 ]] && echo "%s"\n' "$function" "$line" > "$out"
chmod +x "$out"
)";

// A file that can be run, instead of nvcc; it cannot compile the case `failing`.
std::string stand_in(const Scratch& scratch, const std::string& failing = "NONE") {
  std::string text = kStandIn;
  text.replace(text.find("NONE"), std::string("NONE").size(), failing);
  scratch.write("nvcc", text);
  fs::permissions(scratch.path("nvcc"), fs::perms::owner_all);
  return scratch.path("nvcc");
}

// Runs flatdyn bench with this compiler in $NVCC.
Outcome bench_with(const std::string& nvcc, const std::string& arguments) {
  ::setenv("NVCC", nvcc.c_str(), 1);
  const Outcome outcome = run_flatdyn("bench -q " + arguments);
  ::unsetenv("NVCC");
  return outcome;
}

TEST(BenchGpu, SaysWhatIsMissingAndWritesNothing) {
  const Scratch scratch;
  const std::string command = "robots/ur5.urdf --gpu -o " + scratch.path("out");
  const Outcome compiler = bench_with("/no/nvcc", command);
  EXPECT_EQ(compiler.code, 6);
  EXPECT_THAT(compiler.err, HasSubstr("bench --gpu needs nvcc, and \"/no/nvcc\" cannot be run"));
  const Outcome device = bench_with("true", command);  // compiles nothing
  EXPECT_EQ(device.code, 6);
  EXPECT_THAT(device.err, HasSubstr("bench --gpu needs a device that CUDA can use"));
  EXPECT_FALSE(fs::exists(scratch.path("out")));
}

TEST(BenchGpu, PreparesAFolderThatIsRight) {
  const Scratch scratch;
  const Outcome outcome = bench_with(
      "/no/nvcc", "robots/ur5.urdf --gpu --prepare --functions inertia_matrix,bias -o " + scratch.path("out"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(scratch.read("out/cases"),
            "ur5 ur5_float.cuh ur5 inertia_matrix Packed<Tiles> float\n"
            "ur5 ur5_double.cuh ur5 inertia_matrix Packed<Tiles> double\n"
            "ur5 ur5_float.cuh ur5 bias Tiles float\n"
            "ur5 ur5_double.cuh ur5 bias Tiles double\n");
  for (const char* file : {"run", "bench.cu", "copy.cu", "flatdyn/cuda_batch.cuh", "ur5.bias.reference"}) {
    EXPECT_GT(fs::file_size(scratch.path(std::string("out/") + file)), 0u) << file;
  }
  scratch.write("out/compare.cpp", kComparison);
  EXPECT_EQ(std::system(("cd " + scratch.path("out") +
                         " && c++ -std=c++17 -Wall -Wextra -Werror -I. compare.cpp -o compare && ./compare")
                            .c_str()),
            0);
}

TEST(BenchGpu, ReadsWhatItsProgramPrints) {
  const Scratch scratch;
  const std::string command = "robots/ur5.urdf robots/planar_2r_example_7_2.toml --gpu --functions bias ";
  const Outcome outcome = bench_with(stand_in(scratch), command + "--json -o " + scratch.path("out"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json result = json::parse(outcome.out);
  EXPECT_EQ(json::parse(scratch.read("out/gpu.json")), result);
  EXPECT_EQ(result["device"], "Stand-in, compute capability 9.0: a copy moves 3000 GB/s");
  ASSERT_EQ(result["gpu"].size(), 4u);
  const json expected = {{"robot", "ur5"},         {"function", "bias"}, {"layout", "Tiles"},     {"scalar", "float"},
                         {"ns_per_state", 0.0372}, {"registers", 64},    {"local_bytes", 40},     {"gb_per_s", 2300.0},
                         {"error_ulp", 1.5},       {"kernels", 2},       {"single_state_us", 3.1}};
  EXPECT_EQ(result["gpu"][0], expected);
  EXPECT_EQ(result["gpu"][3]["robot"], "planar_2r_example_7_2");
  EXPECT_EQ(result["failures"].size(), 0u);
  EXPECT_THAT(bench_with(stand_in(scratch), command).out, HasSubstr("ur5                    bias      Tiles   float "));
}

TEST(BenchGpu, EndsWithAnErrorIfACaseFails) {
  const Scratch scratch;
  const std::string nvcc = stand_in(scratch, "bias/double");
  const Outcome outcome = bench_with(nvcc, "robots/ur5.urdf --gpu --functions bias --json");
  EXPECT_EQ(outcome.code, 1);
  const json result = json::parse(outcome.out);
  EXPECT_EQ(result["gpu"].size(), 1u) << "what was measured is printed";
  EXPECT_EQ(result["failures"][0], "cannot compile ur5.bias.Tiles.double:");
}

TEST(BenchGpu, RefusesWhatItCannotDo) {
  for (const char* arguments :
       {"robots/ur5.urdf --prepare -o out", "robots/ur5.urdf --gpu --prepare",
        "robots/ur5.urdf --gpu --variants double", "--gpu", "--gpu --growth", "robots/ur5.urdf --gpu --generator"}) {
    EXPECT_EQ(bench_with("true", arguments).code, 2) << arguments;
  }
  const Scratch scratch;
  const std::string prepare = " --gpu --prepare -o " + scratch.path("out");
  EXPECT_EQ(bench_with("true", "robots/planar_2r.toml" + prepare).code, 4) << "free symbols";
  EXPECT_EQ(bench_with("true", "robots/four_bar.toml" + prepare).code, 4) << "closed loops";
  EXPECT_EQ(bench_with("true", "robots/ur5.urdf robots/ur5.urdf --functions gravity" + prepare).code, 2);
  scratch.write("ball.urdf", R"(<robot name="ball"><link name="body"><inertial><mass value="2"/>
      <inertia ixx="1" ixy="0" ixz="0" iyy="2" iyz="0" izz="2"/></inertial></link></robot>)");
  const Outcome body = bench_with("true", scratch.path("ball.urdf") + " --base floating" + prepare);
  EXPECT_EQ(body.code, 4);
  EXPECT_THAT(body.err, HasSubstr("bench --gpu is for robots with joints"));
  EXPECT_FALSE(fs::exists(scratch.path("out")));
}

}  // namespace
}  // namespace flatdyn::testing
