// SPDX-License-Identifier: GPL-2.0-or-later
// Generated code has sines and cosines of its own, so that results have the same bits in every language, from every
// compiler, and on every processor: 2,000 states of the Panda's inverse dynamics, angles up to 4e4 rad among them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

// C and C++, by the name of the function. Every tenth state has large angles.
constexpr const char* kProgram = R"(
#include <stdint.h>
#include <stdio.h>
#include <string.h>

static uint32_t state = 1;
static double drawn(void) {{
  state = state * 1664525u + 1013904223u;
  return state / 4294967296.0 * 8.0 - 4.0;
}}

int main(void) {{
  uint64_t hash = 14695981039346656037u;
  for (int k = 0; k < 2000; ++k) {{
    double q[7], qd[7], qdd[7], tau[7];
    for (int i = 0; i < 7; ++i) q[i] = drawn() * (k % 10 == 0 ? 10000.0 : 1.0);
    for (int i = 0; i < 7; ++i) qd[i] = drawn();
    for (int i = 0; i < 7; ++i) qdd[i] = drawn();
    {}(q, qd, qdd, tau);
    for (int i = 0; i < 7; ++i) {{
      uint64_t bits;
      memcpy(&bits, &tau[i], sizeof bits);
      hash = (hash ^ bits) * 1099511628211u;
    }}
  }}
  printf("%016llx", (unsigned long long)hash);
  return 0;
}}
)";

constexpr const char* kScript = R"(import {inverse_dynamics} from './panda.js';
let state = 1;
const drawn = () => {
  state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
  return state / 4294967296 * 8 - 4;
};
let hash = 14695981039346656037n;
const tau = new Float64Array(7), bits = new BigUint64Array(tau.buffer);
for (let k = 0; k < 2000; ++k) {
  const draw = (factor) => Array.from({length: 7}, () => drawn() * factor);
  const q = draw(k % 10 === 0 ? 10000 : 1), qd = draw(1), qdd = draw(1);
  inverse_dynamics(q, qd, qdd, tau);
  for (const each of bits) hash = BigInt.asUintN(64, (hash ^ each) * 1099511628211n);
}
process.stdout.write(hash.toString(16).padStart(16, '0'));
)";

class SameSines : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<Scratch>();
    for (const char* language : {"c++", "c", "javascript"}) {
      const Outcome outcome = run_flatdyn(fmt::format(
          "generate robots/panda.urdf -q --functions inverse_dynamics --language {} -o {}", language, folder_->path()));
      ASSERT_EQ(outcome.code, 0) << outcome.err;
    }
    folder_->write("package.json", R"({"type": "module"})");
    folder_->write("main.js", kScript);
    folder_->write("main.c", "#include \"panda.h\"\n" + fmt::format(kProgram, "panda_inverse_dynamics"));
    folder_->write("main.cpp", "#include \"panda.hpp\"\n" + fmt::format(kProgram, "panda::inverse_dynamics"));
    reference_ = answer("g++ -std=c++17 -O0 -ffp-contract=off main.cpp -o main && ./main");
    ASSERT_EQ(reference_.size(), 16u) << reference_;
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static std::string answer(const std::string& command) {
    const std::string whole = fmt::format("cd '{}' && ({}) > log 2>&1", folder_->path(), command);
    return std::system(whole.c_str()) == 0 ? folder_->read("log") : "failed: " + command + "\n" + folder_->read("log");
  }

  static bool has(const std::string& program) {
    return std::system(fmt::format("command -v {} > /dev/null", program).c_str()) == 0;
  }

  static void expect_same(const std::string& command) { EXPECT_EQ(answer(command), reference_) << command; }

  static inline std::unique_ptr<Scratch> folder_;
  static inline std::string reference_;
};

TEST_F(SameSines, OfEveryCompilerAndLanguage) {
  for (const char* flags : {"g++ -O3", "clang++ -O2", "clang++ -O0"}) {
    expect_same(fmt::format("{} -std=c++17 -ffp-contract=off main.cpp -o main && ./main", flags));
  }
  for (const char* flags : {"gcc -O3", "clang -O1"}) {
    expect_same(fmt::format("{} -std=c99 -ffp-contract=off main.c panda.c -lm -o main && ./main", flags));
  }
  if (has("node")) expect_same("node main.js");
}

TEST_F(SameSines, OfWiderRegisters) {
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) GTEST_SKIP() << "this machine has no AVX2";
  for (const char* compiler : {"g++", "clang++"}) {
    expect_same(
        fmt::format("{} -O2 -mavx2 -mfma -fno-tree-slp-vectorize -std=c++17 -ffp-contract=off main.cpp -o main "
                    "&& ./main",
                    compiler));
  }
}

TEST_F(SameSines, OfAnotherProcessor) {
  if (!has("aarch64-linux-gnu-gcc") || !has("qemu-aarch64")) GTEST_SKIP() << "not installed: scripts/setup all";
  expect_same(
      "aarch64-linux-gnu-gcc -O2 -static -std=c99 -ffp-contract=off main.c panda.c -lm -o main && qemu-aarch64 ./main");
}

// Those of the library are others: the comparison would notice.
TEST_F(SameSines, AreNotThoseOfTheLibrary) {
  const Scratch other;
  ASSERT_EQ(
      run_flatdyn("generate robots/panda.urdf -q --functions inverse_dynamics --sincos library -o " + other.path())
          .code,
      0);
  const std::string of_library = answer(
      fmt::format("cp main.cpp '{0}' && cd '{0}' && g++ -std=c++17 -O1 -ffp-contract=off main.cpp -o main && ./main",
                  other.path()));
  EXPECT_EQ(of_library.size(), 16u) << of_library;
  EXPECT_NE(of_library, reference_);
}

}  // namespace
}  // namespace flatdyn::testing
