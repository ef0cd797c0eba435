// SPDX-License-Identifier: GPL-2.0-or-later
// The same input gives the same bytes: in another folder, in a locale with decimal commas, and from a program built by
// another compiler. All files that `generate` writes are compared, in every form.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

#include "golden/golden.hpp"

namespace flatdyn::testing {
namespace {

namespace fs = std::filesystem;

// Robot file and options: every language and form, a scene, a search, an error budget, given names.
const std::vector<std::pair<std::string, std::string>> kRuns = {
    {"panda.urdf", "--functions inverse_dynamics,inertia_matrix,base_regressor"},
    {"panda.urdf", "--functions inverse_dynamics --error-budget 1% --search 20 --name budget"},
    {"scara.toml", "--form pair --scalar double,float --stages gravity,bias --fuse gravity,bias --name pair"},
    {"planar_2r.toml", "--language c --scalar float --max-lines 40"},
    {"planar_2r.toml", "--language javascript"},
    {"planar_2r.toml", "--python --name module"},
    {"planar_2r_example_7_2.toml", "--firmware cortex-m4 --functions inverse_dynamics,gravity --name firmware"}};

// The difference of a run from the one with which it is compared.
struct FormulationIndex {
  std::string program = FLATDYN_PROGRAM;
  std::string environment = "LC_ALL=C";
  std::string folder = "here";  // folder of robot and output, below a folder of the test's own
};

using Files = std::map<std::string, std::string>;  // content by name

Files files_in(const fs::path& folder) {
  Files files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files[entry.path().lexically_relative(folder).string()] = content_of(entry.path());
  }
  return files;
}

// All outputs, and the printed text as "log". Copies of the robots are in the folder, so that all paths differ.
Files generated(const FormulationIndex& way) {
  const TemporaryFolder scratch;
  const fs::path folder = scratch.path() / way.folder, output = folder / "out";
  fs::create_directories(output);
  for (const auto& [robot, options] : kRuns) {
    fs::copy_file(fs::path(FLATDYN_SOURCE_DIR) / "robots" / robot, folder / robot,
                  fs::copy_options::overwrite_existing);
    const std::string command = fmt::format("cd '{}' && {} '{}' generate {} -o out {} >> out/log 2>&1", folder.string(),
                                            way.environment, way.program, robot, options);
    EXPECT_EQ(std::system(command.c_str()), 0) << command << "\n" << content_of(output / "log");
  }
  return files_in(output);
}

const Files& usual() {
  static const Files files = generated({});
  return files;
}

void expect_the_usual(const Files& files) {
  EXPECT_EQ(files.size(), usual().size());
  for (const auto& [name, content] : usual()) {
    const auto other = files.find(name);
    ASSERT_NE(other, files.end()) << name;
    EXPECT_TRUE(other->second == content) << name;
  }
}

TEST(Reproducible, ComparesAllThatIsWritten) {
  for (const char* name :
       {"panda.hpp", "panda.json", "budget.hpp", "pair.hpp", "pair.cpp", "planar_2r.h", "planar_2r.c", "planar_2r.js",
        "module.py", "module_batch.c", "test_vectors.c", "makefile", "log"}) {
    EXPECT_EQ(usual().count(name), 1u) << name;
  }
}

TEST(Reproducible, InAnyFolder) { expect_the_usual(generated({.folder = "some where/else, ä"})); }

// A German locale made for the test: Debian installs none.
class Locale : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::string make = fmt::format("localedef -i de_DE -f UTF-8 '{}' > /dev/null 2>&1", (path() / "de").string());
    if (std::system(make.c_str()) != 0) GTEST_SKIP() << "no localedef with de_DE: scripts/setup";
  }

  fs::path path() const { return folder_.path(); }
  std::string environment() const { return fmt::format("LOCPATH='{}' LC_ALL=de", path().string()); }

  TemporaryFolder folder_;
};

TEST_F(Locale, ChangesNothing) {
  // This checks that the locale has an effect.
  const std::string print =
      fmt::format("{} bash -c \"printf '%.1f' 0,5\" > '{}'", environment(), (path() / "number").string());
  ASSERT_EQ(std::system(print.c_str()), 0);
  ASSERT_EQ(content_of(path() / "number"), "0,5");
  expect_the_usual(generated({.environment = environment()}));
}

TEST(Reproducible, ByAnyCompiler) {
  const char* const other = std::getenv("FLATDYN_OTHER_PROGRAM");
  if (other == nullptr) GTEST_SKIP() << "FLATDYN_OTHER_PROGRAM names no flatdyn of another compiler: scripts/test does";
  ASSERT_TRUE(fs::exists(other)) << other;
  expect_the_usual(generated({.program = fs::absolute(other).string()}));
}

}  // namespace
}  // namespace flatdyn::testing
