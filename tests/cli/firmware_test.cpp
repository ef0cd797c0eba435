// SPDX-License-Identifier: GPL-2.0-or-later
// `flatdyn generate --language c` and `--firmware`: the folder builds as it is, its self test passes in the emulated
// processor and fails if a vector is wrong; code and stack of the Panda's inverse dynamics stay within limits.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "base/system/process.hpp"
#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

bool has_program(const char* name) { return std::system(fmt::format("command -v {} > /dev/null", name).c_str()) == 0; }

class Firmware : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const char* program : {"arm-none-eabi-gcc", "qemu-system-arm", "make"}) {
      if (!has_program(program)) GTEST_SKIP() << program << " is not installed: scripts/setup";
    }
  }

  void generate(const std::string& arguments) const {
    const Outcome outcome = run_flatdyn(fmt::format("generate {} -q -o '{}'", arguments, folder_.path()));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
  }

  // Runs make. Returns the exit code; the output is in `log`.
  int make(const std::string& target) {
    const int status = std::system(fmt::format("make -C '{}' {} > '{}' 2>&1", folder_.path(), target, log()).c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  std::string log() const { return folder_.path("log"); }
  std::string printed() const { return folder_.read("log"); }

  // A row of `make size`: bytes of code, of .rodata and of stack; spills, instructions and conditional branches.
  std::vector<int> row(const std::string& function) const { return row_of(printed(), function); }

  static bool has_compiler_of_the_page() {
    return std::system("arm-none-eabi-gcc --version | grep -q '12\\.2\\.'") == 0;
  }

  static std::string docs_page() { return content_of_file(FLATDYN_SOURCE_DIR "/docs/firmware.md"); }

  static std::vector<int> row_of(const std::string& printed_rows, const std::string& function) {
    std::istringstream lines(printed_rows);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string name;
      words >> name;
      if (name != function) continue;
      std::vector<int> numbers;
      for (int number; words >> number;) numbers.push_back(number);
      return numbers;
    }
    return {};
  }

  // Straight-line code executes each of its instructions once; the remaining ones belong to the loop and pass
  // arguments.
  void expect_measured_as_counted(const std::string& prefix, const std::vector<std::string>& functions) {
    constexpr int kAround = 20, kCheckOfEntries = 40;  // a loop in functions that return bool
    ASSERT_EQ(make("size"), 0) << printed();
    std::vector<int> counted;
    for (const std::string& function : functions) {
      const std::vector<int> given = row(prefix + function + "_given"), own = row(prefix + function);
      ASSERT_EQ(own.size(), 6u) << function;
      counted.push_back((given.empty() ? own : given)[4]);
    }
    ASSERT_EQ(make("measure"), 0) << printed();
    EXPECT_THAT(printed(), Not(HasSubstr("warning")));
    for (std::size_t k = 0; k < functions.size(); ++k) {
      const std::vector<int> measured = row(functions[k]);  // with given sines, and with its own
      ASSERT_EQ(measured.size(), 2u) << printed();
      EXPECT_GT(measured[0], counted[k]) << functions[k];
      const int loop = functions[k] == "forward_dynamics" ? kCheckOfEntries : 0;
      EXPECT_LE(measured[0], counted[k] + kAround + loop) << functions[k];
      EXPECT_GE(measured[1], measured[0]) << functions[k];
    }
  }

  Scratch folder_;
};

TEST_F(Firmware, PandaInFloatOnCortexM4PassesAndStaysSmall) {
  generate("robots/panda.urdf --firmware cortex-m4 --functions inverse_dynamics");
  EXPECT_EQ(make("run"), 0) << printed();
  EXPECT_THAT(printed(), HasSubstr("rounding is as written\n"));
  EXPECT_THAT(printed(), ::testing::ContainsRegex("inverse_dynamics .* of 16 units, .* of the proven bound: ok\n"));
  EXPECT_THAT(printed(), HasSubstr("panda on cortex-m4, in float, at 13 states: passed\n"));
  EXPECT_THAT(printed(), Not(HasSubstr("warning")));
  EXPECT_EQ(make("size"), 0) << printed();
  const std::vector<int> given = row("panda_inverse_dynamics_given"), asking = row("panda_inverse_dynamics");
  ASSERT_EQ(given.size(), 6u) << printed();
  ASSERT_EQ(asking.size(), 6u) << printed();
  EXPECT_LE(given[0] + asking[0], 12'000);  // bytes of code
  EXPECT_EQ(given[1] + asking[1], 0);       // .rodata: constants are in the code
  EXPECT_LE(given[2] + asking[2], 700);     // bytes of stack
  EXPECT_LE(given[3], 120);                 // spills
  EXPECT_GE(given[4], 529);                 // instructions: one at least for each operation
  EXPECT_EQ(given[5], 0);                   // conditional branches
  EXPECT_THAT(printed(), HasSubstr("needs from libraries: cosf sinf \n"));
  expect_measured_as_counted("panda_", {"inverse_dynamics"});
}

TEST_F(Firmware, PandaInDoubleOnCortexM7Passes) {
  generate("robots/panda.urdf --firmware cortex-m7 --functions inverse_dynamics");
  EXPECT_EQ(make("run"), 0) << printed();
  EXPECT_THAT(printed(), HasSubstr("panda on cortex-m7, in double, at 13 states: passed\n"));
  expect_measured_as_counted("panda_", {"inverse_dynamics"});
}

// C++ in header and source, in float. It needs only <cmath> of the C++ library, which is a separate package for this
// processor.
TEST_F(Firmware, ThePairInCppIsAsSmallAsTheCForm) {
  if (!has_program("arm-none-eabi-g++")) GTEST_SKIP() << "arm-none-eabi-g++ is not installed: scripts/setup";
  generate(
      "robots/panda.urdf --form pair --scalar float --functions "
      "inverse_dynamics,inertia_matrix,gravity,forward_dynamics");
  folder_.write("cmath",
                "extern \"C\" { float sinf(float); float cosf(float); }\n"
                "namespace std {\ninline float sin(float x) { return sinf(x); }\n"
                "inline float cos(float x) { return cosf(x); }\n}\n");
  const std::string command =
      "arm-none-eabi-g++ -I. -std=c++17 -mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard -O2 "
      "-ffp-contract=off -ffunction-sections -fstack-usage -c panda.cpp && arm-none-eabi-nm -CS panda.o && "
      "cat panda.su";
  ASSERT_EQ(std::system(fmt::format("cd '{}' && ({}) > log 2>&1", folder_.path(), command).c_str()), 0) << printed();
  const std::string text = printed();
  std::smatch code, stack;
  ASSERT_TRUE(std::regex_search(text, code, std::regex(" ([0-9a-f]+) W .*inverse_dynamics<.*PolynomialSinCos>")))
      << text;
  ASSERT_TRUE(std::regex_search(text, stack, std::regex("inverse_dynamics.*PolynomialSinCos\\]\t([0-9]+)"))) << text;
  constexpr int kHexadecimal = 16;
  EXPECT_LE(std::stoi(code[1], nullptr, kHexadecimal), 3800);
  EXPECT_LE(std::stoi(stack[1]), 376);  // the C form's
  EXPECT_THAT(text, ::testing::ContainsRegex(" U cosf\n +U sinf\n"));
  EXPECT_THAT(text, Not(::testing::ContainsRegex(" U [^sc]")));
  if (!has_compiler_of_the_page()) return;
  for (const char* function : {"inverse_dynamics", "inertia_matrix", "gravity", "forward_dynamics"}) {
    std::string cells = fmt::format("| `{}` |", function);
    for (const char* source : {"PolynomialSinCos", "GivenSinCos<float>"}) {
      std::smatch bytes, taken;
      const std::string of_nm = fmt::format(" ([0-9a-f]+) W \\w+ panda::{}<float, panda::{} ?>", function, source);
      const std::string of_su = fmt::format("panda::{}\\([^\n]*SinCos = {}\\]\t([0-9]+)", function, source);
      ASSERT_TRUE(std::regex_search(text, bytes, std::regex(of_nm))) << of_nm << text;
      ASSERT_TRUE(std::regex_search(text, taken, std::regex(of_su))) << of_su << text;
      cells += fmt::format(" {} / {} |", std::stoi(bytes[1], nullptr, kHexadecimal), taken[1].str());
    }
    EXPECT_THAT(docs_page(), HasSubstr(cells));
  }
}

TEST_F(Firmware, AllFunctionsOfSmallRobotsPass) {
  generate("robots/scara.toml --firmware cortex-m4");
  EXPECT_EQ(make("run"), 0) << printed();
  EXPECT_THAT(printed(), HasSubstr("jacobian_dot_qd "));
  expect_measured_as_counted(
      "scara_", {"inverse_dynamics", "inverse_dynamics_tip_force", "inertia_matrix", "christoffel", "coriolis_matrix",
                 "gravity", "bias", "forward_dynamics", "kinetic_energy", "potential_energy", "forward_kinematics",
                 "jacobian", "jacobian_dot_qd"});
  EXPECT_EQ(make("clean"), 0);
  generate("robots/planar_2r.toml --firmware cortex-m7 --scalar float");  // with free symbols
  EXPECT_EQ(make("run"), 0) << printed();
  EXPECT_THAT(printed(), ::testing::ContainsRegex("planar_2r on cortex-m7, in float, at [0-9]+ states: passed\n"));
  expect_measured_as_counted("planar_2r_", {"gravity", "kinetic_energy", "forward_dynamics"});
}

// A processor without a unit for double: this is said, and the folder builds, runs and reports as others do.
TEST_F(Firmware, DoubleOnCortexM4IsSoftAndSaysSo) {
  const std::string generate = fmt::format(
      "generate robots/panda.urdf --firmware cortex-m4 --scalar double --functions inverse_dynamics -o '{}'",
      folder_.path());
  const Outcome outcome = run_flatdyn(generate);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("note: --firmware: cortex-m4 has no unit for double"));
  EXPECT_THAT(outcome.err, HasSubstr("hint: use --scalar float"));
  EXPECT_EQ(make("run"), 0) << printed();
  EXPECT_THAT(printed(), HasSubstr("panda on cortex-m4, in double, at 13 states: passed\n"));
  EXPECT_EQ(make("size"), 0) << printed();
  EXPECT_THAT(printed(), HasSubstr("double is computed by the compiler's functions"));
  EXPECT_EQ(make("measure"), 0) << printed();
  const std::vector<int> in_double = row("inverse_dynamics");
  const Outcome in_float = run_flatdyn(std::regex_replace(generate, std::regex("double"), "float"));
  ASSERT_EQ(in_float.code, 0) << in_float.err;
  EXPECT_THAT(in_float.err, Not(HasSubstr("has no unit")));
  ASSERT_EQ(make("clean"), 0);
  ASSERT_EQ(make("measure"), 0) << printed();
  const std::vector<int> measured = row("inverse_dynamics");
  ASSERT_EQ(in_double.size(), 2U);
  ASSERT_EQ(measured.size(), 2U);
  // The note's number of times, from these two counts of the whole function.
  const std::regex times("about ([0-9]+) times");
  std::smatch said;
  ASSERT_TRUE(std::regex_search(outcome.err, said, times)) << outcome.err;
  EXPECT_NEAR(double(in_double[1]) / measured[1], std::stod(said[1]), 2.5);
  EXPECT_THAT(docs_page(), HasSubstr(fmt::format("{} in double and {} in float", in_double[1], measured[1])));
}

// The tables of docs/firmware.md, whose numbers are those of Debian 12's compiler.
TEST_F(Firmware, ThePageHasTheNumbersOfThisCompiler) {
  if (!has_compiler_of_the_page()) GTEST_SKIP() << "another compiler than that of the page";
  generate("robots/panda.urdf --firmware cortex-m4");
  ASSERT_EQ(make("size"), 0) << printed();
  const std::string sizes = printed();
  ASSERT_EQ(make("measure"), 0) << printed();
  const std::string times = printed();
  const std::string manifest = folder_.read("panda.json");
  const nlohmann::json functions = nlohmann::json::parse(manifest)["functions"];
  ASSERT_GE(functions.size(), 13U);
  const std::set<std::string> is_of_the_pair = {"inverse_dynamics", "inertia_matrix", "gravity", "forward_dynamics"};
  for (const nlohmann::json& function : functions) {
    const std::string name = function["name"];
    const std::vector<int> own = row_of(sizes, "panda_" + name), given = row_of(sizes, "panda_" + name + "_given");
    const std::vector<int> time = row_of(times, name);
    ASSERT_EQ(own.size(), 6U) << name;
    ASSERT_EQ(time.size(), 2U) << name;
    const std::vector<int>& body = given.empty() ? own : given;
    const int more = given.empty() ? 0 : 1;
    const int operations = function["multiplications"].get<int>() + function["additions"].get<int>();
    const std::string line = fmt::format("| `{}` | {} | {} | {} | {} | {} | {} | {} |\n", name, own[0] + more * body[0],
                                         own[2] + more * body[2], body[3], body[4], time[0], time[1], operations);
    EXPECT_THAT(docs_page(), HasSubstr(line));
    if (!is_of_the_pair.contains(name)) continue;
    const std::string columns =
        fmt::format(" | {} / {} | {} / {} |\n", own[0] + more * body[0], own[2] + more * body[2], body[0], body[2]);
    EXPECT_THAT(docs_page(), HasSubstr(columns)) << name;
  }
  const std::vector<int> sines = row_of(sizes, "panda_sines_and_cosines");
  ASSERT_EQ(sines.size(), 6U);
  EXPECT_THAT(docs_page(), HasSubstr(fmt::format("{} bytes of code and {} of stack", sines[0], sines[2])));
}

// Compiler flags change the instructions of inverse dynamics.
TEST_F(Firmware, ThePageHasTheEffectOfFlags) {
  if (!has_compiler_of_the_page()) GTEST_SKIP() << "another compiler than that of the page";
  generate("robots/panda.urdf --firmware cortex-m4 --functions inverse_dynamics");
  std::string cells = "|";
  for (const char* flags : {"-O2", "-Os", "-O1", "-O2 -fno-schedule-insns"}) {
    ASSERT_EQ(make("clean"), 0);
    ASSERT_EQ(make(fmt::format("size CFLAGS='$(TARGET) -std=c99 {} -ffp-contract=off -ffunction-sections "
                               "-fdata-sections -fstack-usage'",
                               flags)),
              0)
        << printed();
    const std::vector<int> given = row("panda_inverse_dynamics_given");
    ASSERT_EQ(given.size(), 6U) << printed();
    cells += fmt::format(" {} / {} |", given[0], given[2]);
  }
  EXPECT_THAT(docs_page(), HasSubstr(cells + "\n"));
}

class OtherProcessor : public Firmware, public ::testing::WithParamInterface<const char*> {
 protected:
  void SetUp() override {
    for (const char* program :
         {"riscv64-unknown-elf-gcc", "qemu-system-riscv32", "aarch64-linux-gnu-gcc", "qemu-aarch64"}) {
      if (!has_program(program)) GTEST_SKIP() << program << " is not installed: scripts/setup";
    }
  }

  // The number of different constants in a function.
  int numbers_in(const std::string& function) const {
    const std::string source = folder_.read("panda.c");
    const std::size_t begin = source.find("{\n", source.find("void " + function + "("));
    const std::string body = source.substr(begin, source.find("\n}\n", begin) - begin);
    const std::regex number("[^A-Za-z0-9_][0-9]+\\.[0-9]+(e-?[0-9]+)?");
    std::set<std::string> found;
    for (std::sregex_iterator at(body.begin(), body.end(), number), end; at != end; ++at)
      found.insert(at->str().substr(1));
    return static_cast<int>(found.size());
  }
};

TEST_P(OtherProcessor, RunsThePandaAndNoticesAWrongVector) {
  generate(fmt::format("robots/panda.urdf --firmware {} --functions inverse_dynamics", GetParam()));
  EXPECT_EQ(make("run"), 0) << printed();
  EXPECT_THAT(printed(), HasSubstr("rounding is as written\n"));
  EXPECT_THAT(printed(),
              ::testing::ContainsRegex(fmt::format("panda on {}, in .*, at 13 states: passed\n", GetParam())));
  EXPECT_THAT(printed(), Not(HasSubstr("warning")));
  EXPECT_EQ(make("size"), 0) << printed();
  const std::vector<int> given = row("panda_inverse_dynamics_given");
  ASSERT_EQ(given.size(), 6u) << printed();
  EXPECT_GE(given[4], 529);  // instructions: one at least for each operation
  EXPECT_EQ(given[5], 0);    // conditional branches
  // .rodata holds the constants of the text, except those that fit into an instruction, and perhaps a negative beside
  // its number.
  const int numbers = numbers_in("panda_inverse_dynamics_given"), bytes = GetParam() == std::string("riscv32") ? 4 : 8;
  EXPECT_EQ(given[1] % bytes, 0);
  EXPECT_LE(given[1], (numbers + 2) * bytes);
  EXPECT_GE(given[1], numbers * bytes * 9 / 10);
  if (GetParam() == std::string("aarch64")) {
    EXPECT_NE(make("measure"), 0);  // a program for Linux
  } else {
    expect_measured_as_counted("panda_", {"inverse_dynamics"});
  }
  std::string vectors = folder_.read("test_vectors.c");
  vectors.insert(vectors.find("{ ", vectors.find("expected_inverse_dynamics[")) + 2, "100 + ");
  folder_.write("test_vectors.c", vectors);
  EXPECT_NE(make("run"), 0);
}

INSTANTIATE_TEST_SUITE_P(Firmware, OtherProcessor, ::testing::Values("riscv32", "riscv64", "aarch64"),
                         [](const auto& test) { return std::string(test.param); });

// Control at the tip; states with a singular task are left out.
TEST_F(Firmware, TheOperationalSpaceRunsThere) {
  generate("robots/ur5.urdf --firmware cortex-m7 --functions operational_inertia,operational_bias");
  EXPECT_EQ(make("run"), 0) << printed();
  EXPECT_THAT(printed(), ::testing::ContainsRegex("operational_inertia +73 entries.*: ok\n"));
}

TEST_F(Firmware, ASelfTestCanFail) {
  generate("robots/scara.toml --firmware cortex-m4 --functions gravity,forward_dynamics");
  std::string vectors = folder_.read("test_vectors.c");
  std::size_t entry = vectors.find("{ ", vectors.find("expected_gravity["));
  while (vectors.compare(entry, 5, "{ 0.0") == 0) entry = vectors.find("{ ", entry + 1);
  vectors.insert(entry + 2, "1 + ");  // another torque is expected
  folder_.write("test_vectors.c", vectors);
  EXPECT_NE(make("run"), 0);
  EXPECT_THAT(printed(), HasSubstr("units: FAILED\n"));
  EXPECT_THAT(printed(), ::testing::ContainsRegex("forward_dynamics .*: ok\n"));
  EXPECT_THAT(printed(), ::testing::ContainsRegex("in float, at [0-9]+ states: FAILED\n"));
}

// An error that is allowed but larger than the proven bound shows that the proof or the target is wrong.
TEST_F(Firmware, AnErrorBeyondTheProvenBoundIsAFailure) {
  generate("robots/panda.urdf --firmware cortex-m4 --functions gravity");
  std::string vectors = folder_.read("test_vectors.c");
  vectors = std::regex_replace(vectors, std::regex(", [1-9][0-9.]*e-[0-9]+ }"), ", 1e-30 }");
  folder_.write("test_vectors.c", vectors);
  EXPECT_NE(make("run"), 0);
  EXPECT_THAT(printed(), ::testing::ContainsRegex("gravity .* of 16 units, .* of the proven bound: FAILED\n"));
}

TEST_F(Firmware, FusedMultiplyAddsAreNoticed) {
  generate("robots/scara.toml --firmware cortex-m4 --functions gravity");
  EXPECT_NE(make("run TARGET='-mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard -ffp-contract=fast' "
                 "CFLAGS='$(TARGET) -std=gnu99 -O2'"),
            0);
  EXPECT_THAT(printed(), HasSubstr("rounding is NOT as written\n"));
}

TEST(LanguageC, WritesHeaderAndSource) {
  const Scratch folder;
  const Outcome outcome = run_flatdyn(fmt::format(
      "generate robots/puma560.toml --language c --scalar float --functions inverse_dynamics -o '{}'", folder.path()));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              HasSubstr(fmt::format("wrote {}\nwrote {}\n", folder.path("puma560.h"), folder.path("puma560.c"))));
  EXPECT_THAT(outcome.out, HasSubstr("the text, read back, says the same with constants rounded to float"));
  EXPECT_THAT(folder.read("puma560.json"), HasSubstr("\"source\": \"puma560.c\""));
  const std::string source = folder.read("puma560.c");
  EXPECT_THAT(source, HasSubstr("static float puma560_sign(float x)"));
  EXPECT_THAT(source, Not(HasSubstr("double ")));
}

// Rules 8.14, restrict, and 21.15, memcpy, are the required ones that are violated; docs/firmware.md explains all.
TEST(LanguageC, DeviatesFromNoOtherRuleOfMisra) {
  if (!has_program("cppcheck")) GTEST_SKIP() << "cppcheck is not installed: scripts/setup";
  const std::set<std::string> listed = {"2.4", "8.7", "8.14", "10.5", "12.1", "12.3", "13.4", "15.5", "21.15"};
  std::set<std::string> found;
  for (const char* options : {"scara.toml", "scara.toml --max-lines 30", "puma560.toml --functions inverse_dynamics"}) {
    const Scratch folder;  // with both robots in one folder, the addon confuses their enumerations without tags
    const Outcome outcome =
        run_flatdyn(fmt::format("generate robots/{} --language c --scalar float -q -o '{}'", options, folder.path()));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    ASSERT_EQ(std::system(
                  fmt::format("cd '{}' && cppcheck --addon=misra --std=c99 -q *.c > log 2>&1", folder.path()).c_str()),
              0);
    const std::string log = folder.read("log");
    const std::regex rule("misra-c2012-([0-9.]+)");
    for (std::sregex_iterator at(log.begin(), log.end(), rule), end; at != end; ++at) found.insert((*at)[1]);
  }
  EXPECT_EQ(found, listed);
}

TEST(LanguageC, RefusesWhatItHasNot) {
  const Scratch folder;
  const auto refused = [&](const std::string& options) {
    const Outcome outcome = run_flatdyn(fmt::format("generate robots/scara.toml {} -o '{}'", options, folder.path()));
    EXPECT_EQ(outcome.code, 2) << options;
    EXPECT_TRUE(folder.is_empty()) << options;
    return outcome.err;
  };
  EXPECT_THAT(refused("--language c --stages gravity,bias"), HasSubstr("--stages: there are none in C"));
  EXPECT_THAT(refused("--firmware cortex-m4 --language c++"), HasSubstr("its code is in C"));
  EXPECT_THAT(refused("--firmware cortex-m4 --fuse gravity,bias"), HasSubstr("have no self test"));
  refused("--firmware z80");
  refused("--language fortran");
}

}  // namespace
}  // namespace flatdyn::testing
