// SPDX-License-Identifier: GPL-2.0-or-later
// Dust of CAD exporters costs nothing: the code of a dusty robot equals that of the clean one, to the last character.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "base/system/temporary_folder.hpp"
#include "code/languages/emit.hpp"
#include "functions/planning/make_functions.hpp"
#include "graph/count.hpp"

namespace flatdyn {
namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

// The text with zeros of an attribute replaced by `dust` with alternating signs.
std::string with_dust(const std::string& text, const std::string& attribute, const std::string& dust) {
  const std::regex values(attribute + "=\"([^\"]*)\"");
  std::string result;
  auto from = text.begin();
  bool negative = false;
  for (std::sregex_iterator found(text.begin(), text.end(), values), end; found != end; ++found) {
    result.append(from, text.begin() + found->position(1));
    std::istringstream words((*found)[1].str());
    std::string separator;
    for (std::string word; words >> word; separator = " ") {
      const bool is_zero = std::stod(word) == 0;
      result += separator + (is_zero ? (negative ? "-" : "") + dust : word);
      negative = is_zero ? !negative : negative;
    }
    from = text.begin() + found->position(1) + found->length(1);
  }
  return result.append(from, text.end());
}

class DustyRobots : public ::testing::Test {
 protected:
  struct Derived {
    Mechanism mechanism;
    std::vector<Function> functions;
  };
  // The mechanism of the robot in this text.
  Derived effective_mechanism(const std::string& urdf) const {
    std::ofstream(file_) << urdf;
    PipelineOptions options;
    options.functions = {"inverse_dynamics", "inertia_matrix", "gravity"};
    const LoadedRobot model = load_robot(file_, options);
    Progress silent(true);
    Diagnostics none;
    return {model.mechanism, functions_of(make_functions(model, options, silent, none))};
  }
  std::string code_of(const std::string& urdf) const {
    const Derived derived = effective_mechanism(urdf);
    return emit_header(derived.mechanism, derived.functions, EmitOptions{}, std::nullopt);
  }
  std::vector<OperationCount> counts_of(const std::string& urdf) const {
    std::vector<OperationCount> counts;
    for (const Function& function : effective_mechanism(urdf).functions) counts.push_back(count_operations(function));
    return counts;
  }
  static std::string robot(const std::string& name) { return text_of(FLATDYN_SOURCE_DIR "/robots/" + name + ".urdf"); }

  void expect_same_code_with_all_dust(const std::string& clean) const {
    std::string dusty = with_dust(clean, "xyz", "1.2e-17");
    dusty = with_dust(dusty, "rpy", "1e-17");
    for (const char* product : {"ixy", "ixz", "iyz"}) dusty = with_dust(dusty, product, "3.7e-19");
    EXPECT_NE(clean, dusty);
    EXPECT_EQ(code_of(clean), code_of(dusty));
  }

  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "robot.urdf";
};

TEST_F(DustyRobots, EachKindOfDustInUr5) {
  const std::string clean = robot("ur5"), code = code_of(clean);
  EXPECT_EQ(code, code_of(with_dust(clean, "<origin xyz", "1.2e-17")));
  EXPECT_EQ(code, code_of(with_dust(clean, "<axis xyz", "1.2E-15")));
  EXPECT_EQ(code, code_of(with_dust(clean, "rpy", "1e-17")));
  for (const char* product : {"ixy", "ixz", "iyz"}) EXPECT_EQ(code, code_of(with_dust(clean, product, "3.7e-19")));
}

TEST_F(DustyRobots, AllDustTogether) {
  expect_same_code_with_all_dust(robot("ur5"));
  expect_same_code_with_all_dust(robot("panda"));
}

TEST_F(DustyRobots, CasesThatWereReported) {
  const std::filesystem::path cases = FLATDYN_SOURCE_DIR "/../shared/cases";
  if (!std::filesystem::exists(cases)) GTEST_SKIP() << "the cases are not here";
  const std::vector<OperationCount> counts = counts_of(robot("ur5"));
  EXPECT_EQ(counts.at(0).arithmetic(), 243);
  for (const char* name : {"ax_a.urdf", "iner_a.urdf"}) EXPECT_EQ(counts, counts_of(text_of(cases / name))) << name;
}

}  // namespace
}  // namespace flatdyn
