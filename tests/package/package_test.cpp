// SPDX-License-Identifier: GPL-2.0-or-later
// The result of `cmake --install` is enough for an outside project: tests/consumer/package finds it, generates code in
// its build, and does so again only after a change. The same holds with flatdyn's sources in a folder of the project.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "base/system/process.hpp"
#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::string kConsumers = std::string(FLATDYN_SOURCE_DIR) + "/tests/consumer/";

// A separate project with a copy of the consumer, whose files may be changed.
class Project {
 public:
  // `name`: the folder in tests/consumer.
  explicit Project(std::string name) : name_(std::move(name)) {
    copy("package");
    copy("subdirectory");
  }

  bool configure(const std::string& options) {
    return run(fmt::format("cmake -S '{}' -B '{}' {}", scratch_.path(name_), build(), options));
  }

  void replace(const std::string& file, const std::string& old, const std::string& text) {
    std::string content = scratch_.read(file);
    const std::size_t place = content.find(old);
    ASSERT_NE(place, std::string::npos);
    scratch_.write(file, content.replace(place, old.size(), text));
  }

  bool make(const std::string& target = "all") {
    return run(fmt::format("cmake --build '{}' --target {}", build(), target));
  }
  bool install(const std::string& prefix) {
    return run(fmt::format("cmake --install '{}' --prefix '{}'", build(), prefix));
  }
  // The command that compiles a file.
  std::string compilation_of(const std::string& file) const {
    std::istringstream commands(scratch_.read("build/compile_commands.json"));
    for (std::string line; std::getline(commands, line);) {
      if (line.find("\"command\"") != std::string::npos && line.find(file + "\"") != std::string::npos) return line;
    }
    return "no compilation of " + file;
  }
  bool runs() { return run(fmt::format("'{}/consumer'", build())); }
  std::string log() const { return scratch_.read("log"); }
  std::string generated(const std::string& file) const { return scratch_.read("build/my_arm.flatdyn/" + file); }
  bool remove(const std::string& file) { return std::filesystem::remove(scratch_.path(file)); }

 private:
  std::string build() const { return scratch_.path("build"); }

  void copy(const std::string& name) {
    std::filesystem::create_directories(scratch_.path(name));
    for (const auto& file : std::filesystem::directory_iterator(kConsumers + name)) {
      scratch_.write(name + "/" + file.path().filename().string(), content_of_file(file.path()));
    }
  }

  bool run(const std::string& command) {
    return std::system(fmt::format("{} > '{}' 2>&1", command, scratch_.path("log")).c_str()) == 0;
  }

  std::string name_;
  Scratch scratch_;
};

const std::string& prefix() {
  static const Scratch scratch;
  static const std::string folder = scratch.path("prefix");
  static const int installed = std::system(
      fmt::format("cmake --install '{}' --prefix '{}' > '{}' 2>&1", FLATDYN_BUILD_DIR, folder, scratch.path("log"))
          .c_str());
  EXPECT_EQ(installed, 0) << scratch.read("log");
  return folder;
}

// After scripts/demo there is the program, and nothing else that has been built.
TEST(Installation, NeedsTheProgramAlone) {
  const std::filesystem::path packed = std::filesystem::path(FLATDYN_BUILD_DIR) / "debian/changelog.gz";
  std::filesystem::remove(packed);
  const Scratch scratch;
  const std::string command = fmt::format("cmake --install '{}' --prefix '{}' > '{}' 2>&1", FLATDYN_BUILD_DIR,
                                          scratch.path("prefix"), scratch.path("log"));
  ASSERT_EQ(std::system(command.c_str()), 0) << scratch.read("log");
  for (const char* file : {"bin/flatdyn", "share/doc/flatdyn/changelog.gz", "share/man/man1/flatdyn-generate.1.gz",
                           "share/bash-completion/completions/flatdyn", "share/zsh/vendor-completions/_flatdyn",
                           "share/fish/vendor_completions.d/flatdyn.fish"}) {
    EXPECT_TRUE(std::filesystem::exists(scratch.path(std::string("prefix/") + file))) << file;
  }
}

class Package : public ::testing::TestWithParam<const char*> {};

TEST_P(Package, IsGeneratedFromAgainOnlyWhenAFileChanged) {
  Project project("package");
  ASSERT_TRUE(project.configure(fmt::format("-G '{}' -D CMAKE_PREFIX_PATH='{}'", GetParam(), prefix())))
      << project.log();
  ASSERT_TRUE(project.make()) << project.log();
  EXPECT_THAT(project.log(), HasSubstr("Generating the dynamics of my_arm"));
  ASSERT_TRUE(project.runs()) << project.log();
  EXPECT_THAT(project.generated("my_arm.hpp"), HasSubstr("namespace my_arm {"));

  ASSERT_TRUE(project.make()) << project.log();
  EXPECT_THAT(project.log(), Not(HasSubstr("Generating")));

  // arm.urdf is named by the robot file and known only to the depfile.
  project.replace("package/arm.urdf", "<mass value=\"1\"/>", "<mass value=\"3\"/>");
  ASSERT_TRUE(project.make()) << project.log();
  EXPECT_THAT(project.log(), HasSubstr("Generating the dynamics of my_arm"));
  EXPECT_FALSE(project.runs());
  EXPECT_THAT(project.log(), HasSubstr("gravity: 78.48 29.43 N m"));
}

// Header and source are only useful together, so both are made again if the source is missing.
TEST_P(Package, MakesBothFilesOfAPairAgain) {
  Project project("package");
  ASSERT_TRUE(project.configure(fmt::format("-G '{}' -D CMAKE_PREFIX_PATH='{}'", GetParam(), prefix())))
      << project.log();
  ASSERT_TRUE(project.make("my_arm_as_pair")) << project.log();
  ASSERT_TRUE(project.remove("build/my_arm_as_pair.flatdyn/my_arm_as_pair.cpp"));
  ASSERT_TRUE(project.make("my_arm_as_pair")) << project.log();
  EXPECT_THAT(project.log(), HasSubstr("Generating the dynamics of my_arm_as_pair"));
}

TEST(InstalledPackage, SaysWhichFormsThereAre) {
  Project project("package");
  project.replace("package/CMakeLists.txt", "FORM pair", "FORM tarball");
  EXPECT_FALSE(project.configure(fmt::format("-D CMAKE_PREFIX_PATH='{}'", prefix())));
  EXPECT_THAT(project.log(), HasSubstr("FORM is header or pair, not \"tarball\""));
}

// A target's name need not be a namespace's; and one that is none is found before anything is built.
TEST(InstalledPackage, SaysWhichNameIsNoNamespace) {
  Project project("package");
  project.replace("package/CMakeLists.txt", "flatdyn_generate(my_arm ROBOT", "flatdyn_generate(my-arm ROBOT");
  EXPECT_FALSE(project.configure(fmt::format("-D CMAKE_PREFIX_PATH='{}'", prefix())));
  EXPECT_THAT(project.log(), HasSubstr("\"my-arm\" is no name of a namespace"));
  EXPECT_THAT(project.log(), HasSubstr("NAMESPACE my_arm"));
}

// Only sources that are generated have -ffp-contract=off, unless users of the header ask for it.
TEST(InstalledPackage, LeavesOptionsOfUsersAlone) {
  Project project("package");
  const std::string options = fmt::format("-G Ninja -D CMAKE_PREFIX_PATH='{}'", prefix());
  ASSERT_TRUE(project.configure(options + " -D CMAKE_EXPORT_COMPILE_COMMANDS=ON")) << project.log();
  EXPECT_THAT(project.compilation_of("main.cpp"), Not(HasSubstr("-ffp-contract=off")));
  EXPECT_THAT(project.compilation_of("my_arm_as_pair.cpp"), HasSubstr("-ffp-contract=off"));
  project.replace("package/CMakeLists.txt", "inverse_dynamics)", "inverse_dynamics ROUNDED_AS_WRITTEN)");
  ASSERT_TRUE(project.configure(options)) << project.log();
  EXPECT_THAT(project.compilation_of("main.cpp"), HasSubstr("-ffp-contract=off"));
}

#if defined(__x86_64__) && !defined(__clang__)
// g++ tunes generated code as it suits it, unless the user has other options for that.
TEST(InstalledPackage, TunesForGeneratedCode) {
  Project project("package");
  const std::string options = fmt::format("-G Ninja -D CMAKE_CXX_COMPILER=g++ -D CMAKE_PREFIX_PATH='{}'", prefix());
  ASSERT_TRUE(project.configure(options + " -D CMAKE_EXPORT_COMPILE_COMMANDS=ON")) << project.log();
  for (const char* file : {"main.cpp", "my_arm_as_pair.cpp"}) {
    EXPECT_THAT(project.compilation_of(file), HasSubstr("-mtune=generic")) << file;
  }
  ASSERT_TRUE(project.configure(options + " -D FLATDYN_TUNING=")) << project.log();
  for (const char* file : {"main.cpp", "my_arm_as_pair.cpp"}) {
    EXPECT_THAT(project.compilation_of(file), Not(HasSubstr("-mtune"))) << file;
  }
}
#endif

// A library that links with generated code can be installed and found by a third project.
TEST(InstalledPackage, IsExportedWithItsUsers) {
  Project project("package");
  ASSERT_TRUE(project.configure(fmt::format("-D CMAKE_PREFIX_PATH='{}'", prefix()))) << project.log();
  ASSERT_TRUE(project.make()) << project.log();
  const Scratch third;
  ASSERT_TRUE(project.install(third.path("prefix"))) << project.log();
  third.write("CMakeLists.txt",
              "cmake_minimum_required(VERSION 3.20)\nproject(third CXX)\nfind_package(controller REQUIRED)\n"
              "add_executable(third main.cpp)\ntarget_link_libraries(third consumer::controller)\n");
  third.write("main.cpp", "#include <my_arm.hpp>\n#include <my_arm_as_pair.hpp>\nint main() {}\n");
  const std::string build = fmt::format(
      "(cd '{0}' && cmake -S . -B b -D CMAKE_PREFIX_PATH='{0}/prefix' && "
      "cmake --build b) > '{0}/log' 2>&1",
      third.path());
  EXPECT_EQ(std::system(build.c_str()), 0) << third.read("log");
}

INSTANTIATE_TEST_SUITE_P(Generators, Package, ::testing::Values("Ninja", "Unix Makefiles"),
                         [](const auto& tool) { return std::string(tool.param, 4); });

TEST(InstalledPackage, SaysWhichFileOfWhichProjectIsWrong) {
  Project project("package");
  ASSERT_TRUE(project.configure(fmt::format("-D CMAKE_PREFIX_PATH='{}'", prefix()))) << project.log();
  project.replace("package/arm.urdf", "<mass value=\"1\"/>", "<mass value=\"-1\"/>");
  EXPECT_FALSE(project.make());
  EXPECT_THAT(project.log(), HasSubstr("package/arm.urdf:"));
  EXPECT_EQ(project.generated("my_arm.hpp"), "");
}

// Builds and runs a project of docs/examples with the installed program; `says` is part of what it prints.
void run_example(const std::string& name, const char* says) {
  const Scratch build;
  const std::string command = fmt::format(
      "(cmake -S '{}/docs/examples/{}' -B '{}' -D CMAKE_PREFIX_PATH='{}' && cmake --build '{}' && '{}/{}') > '{}' 2>&1",
      FLATDYN_SOURCE_DIR, name, build.path("b"), prefix(), build.path("b"), build.path("b"), name, build.path("log"));
  EXPECT_EQ(std::system(command.c_str()), 0) << build.read("log");
  EXPECT_THAT(build.read("log"), HasSubstr(says));
}

// In float, with an arm that is simulated in double.
TEST(InstalledPackage, ControlsASimulatedArm) { run_example("controller", "computed torque: follows to"); }

// Whole-body inverse dynamics with four contacts, a thousand times per second, and the robot simulated.
TEST(InstalledPackage, LetsASimulatedQuadrupedStand) { run_example("standing", "it stands"); }

// Every library that the program needs is listed, and Debian's checker finds no error.
TEST(InstalledPackage, IsADebianPackage) {
  const Scratch scratch;
  const std::string command = fmt::format(
      "(cd '{0}' && cpack -B '{1}' && lintian --allow-root --fail-on error '{1}'/*.deb && dpkg-deb -x '{1}'/*.deb "
      "'{1}/x' && "
      "dpkg-deb -f '{1}'/*.deb Depends && '{1}/x/usr/bin/flatdyn' --version) > '{1}/log' 2>&1",
      FLATDYN_BUILD_DIR, scratch.path());
  EXPECT_EQ(std::system(command.c_str()), 0) << scratch.read("log");
  for (const char* library : {"libginac", "libcln", "libtinyxml2", "libtomlplusplus", "libnlopt"}) {
    EXPECT_THAT(scratch.read("log"), HasSubstr(library));
  }
}

TEST(InstalledPackage, IsFoundByPkgConfig) {
  const Scratch scratch;
  scratch.write("main.cpp", "#include <flatdyn/sincos.hpp>\nint main() {}\n");
  const std::string command = fmt::format(
      "cd '{0}' && PKG_CONFIG_PATH='{1}/share/pkgconfig' && export PKG_CONFIG_PATH && "
      "g++ -std=c++17 $(pkg-config --cflags flatdyn-runtime) main.cpp -o main && ./main",
      scratch.path(), prefix());
  EXPECT_EQ(std::system(command.c_str()), 0);
}

TEST(Subdirectory, GeneratesWithAProgramThatIsThere) {
  Project project("subdirectory");
  ASSERT_TRUE(project.configure(
      fmt::format("-D FLATDYN_SOURCE='{}' -D FLATDYN_EXECUTABLE='{}'", FLATDYN_SOURCE_DIR, FLATDYN_PROGRAM)))
      << project.log();
  ASSERT_TRUE(project.make()) << project.log();
  EXPECT_TRUE(project.runs()) << project.log();
}

// As for firmware, the compiler targets another machine, and flatdyn runs on this one.
TEST(Subdirectory, GeneratesInACrossBuild) {
  if (std::system("command -v arm-none-eabi-gcc > /dev/null") != 0)
    GTEST_SKIP() << "no arm-none-eabi-gcc: scripts/setup";
  Project project("subdirectory");
  ASSERT_TRUE(
      project.configure(fmt::format("-D FLATDYN_SOURCE='{}' -D FLATDYN_EXECUTABLE='{}' -D CMAKE_SYSTEM_NAME=Generic "
                                    "-D CMAKE_C_COMPILER=arm-none-eabi-gcc -D CMAKE_CXX_COMPILER=arm-none-eabi-g++ "
                                    "-D CMAKE_TRY_COMPILE_TARGET_TYPE=STATIC_LIBRARY",
                                    FLATDYN_SOURCE_DIR, FLATDYN_PROGRAM)))
      << project.log();
  EXPECT_TRUE(project.make("my_arm_in_c")) << project.log();
}

TEST(Subdirectory, SaysWhatACrossBuildNeeds) {
  Project project("subdirectory");
  EXPECT_FALSE(project.configure(
      fmt::format("-D FLATDYN_SOURCE='{}' -D CMAKE_SYSTEM_NAME=Generic -D CMAKE_TRY_COMPILE_TARGET_TYPE=STATIC_LIBRARY",
                  FLATDYN_SOURCE_DIR)));
  EXPECT_THAT(project.log(), HasSubstr("FLATDYN_EXECUTABLE"));
}

}  // namespace
}  // namespace flatdyn::testing
