// SPDX-License-Identifier: GPL-2.0-or-later
// Emitted text with one change: whatever is changed outside of comments, and wherever, the proof of the text fails.
// Each row is a kind of change in one language or more; the first place of the text is changed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <memory>

#include "diagnostics/diagnostics.hpp"
#include "support/printed_code.hpp"
#include "support/robot_models.hpp"
#include "support/written_model.hpp"
#include "unit/readback/mutants.hpp"

namespace flatdyn::testing {
namespace {

// Two joints with friction, limits and a symbol.
constexpr const char* kArm = R"(
name = "arm"
gravity = [0, 0, -9.81]
[[link]]
joint = "shoulder"
mass = "m_1"
com = [0.3, 0, 0]
inertia = { xx = 0.1, yy = 0.2, zz = 0.2 }
inertia_about = "com"
coulomb = 0.5
limits = { lower = -2, upper = 2, velocity = 3 }
[[link]]
joint = "elbow"
xyz = [0.5, 0, 0]
rpy = ["pi/2", 0, 0]
mass = 2
com = [0.1, 0.2, 0]
inertia = { xx = 0.1, yy = 0.2, zz = 0.3 }
inertia_about = "com"
)";

const PrintedCode& code_of(const std::string& robot) {
  static std::map<std::string, std::unique_ptr<PrintedCode>> made;
  std::unique_ptr<PrintedCode>& code = made[robot];
  if (code != nullptr) return *code;
  if (robot == "arm") {
    code = std::make_unique<PrintedCode>(
        model_of_toml(kArm),
        std::vector<std::string>{"inverse_dynamics", "inertia_matrix", "forward_dynamics", "kinetic_energy", "gravity"},
        std::vector<std::string>{"inertia_matrix", "forward_dynamics"});
  } else if (robot == "orientation") {
    LoadedRobot model = model_of_toml(kArm);
    model.mechanism.task = {{3}, Orientation::zyz};
    code = std::make_unique<PrintedCode>(std::move(model), std::vector<std::string>{"operational_inertia"});
  } else if (robot == "base") {
    code = std::make_unique<PrintedCode>(model_of("planar_2r_example_7_2.toml"),
                                         std::vector<std::string>{"inverse_dynamics_base"});
  } else if (robot == "four_bar") {
    code = std::make_unique<PrintedCode>(model_of("four_bar.toml"),
                                         std::vector<std::string>{"loop_closure", "loop_step", "gravity"});
  } else {
    code = std::make_unique<PrintedCode>(model_of(robot + ".toml"),
                                         std::vector<std::string>{"gravity", "bias", "forward_dynamics"});
  }
  return *code;
}

const std::string& text_of(const Mutant& mutant, const std::string& form) {
  static std::map<std::string, std::string> made;
  const int most_lines = mutant.has_parts ? 30 : 0;
  std::string& text = made[fmt::format("{} {} {}", mutant.robot, form, most_lines)];
  if (text.empty()) text = code_of(mutant.robot).text(form_of(form, most_lines));
  return text;
}

std::string changed(const Mutant& mutant, const std::string& text) {
  const std::size_t begin = text.find(mutant.behind);
  const std::size_t place = begin == std::string::npos ? begin : text.find(mutant.from, begin);
  if (place == std::string::npos) return "";
  std::string wrong = text;
  return wrong.replace(place, std::string(mutant.from).size(), mutant.to);
}

class Mutants : public ::testing::TestWithParam<const char*> {};

TEST_P(Mutants, AreRefused) {
  const std::string form = GetParam();
  int count = 0;
  for (const Mutant& mutant : mutants()) {
    if (!is_in(mutant, form)) continue;
    const std::string wrong = changed(mutant, text_of(mutant, form));
    ASSERT_FALSE(wrong.empty()) << mutant.kind << ": nothing to change: " << mutant.from;
    EXPECT_THROW(code_of(mutant.robot).prove(wrong, form_of(form)), Failure) << mutant.kind << ": " << mutant.to;
    ++count;
  }
  EXPECT_GE(count, 43);
}

TEST_P(Mutants, AreMadeOfTextThatHolds) {
  const std::string form = GetParam();
  for (const Mutant& mutant : mutants()) {
    if (!is_in(mutant, form)) continue;
    EXPECT_NO_THROW(code_of(mutant.robot).prove(text_of(mutant, form), form_of(form))) << mutant.robot;
  }
}

INSTANTIATE_TEST_SUITE_P(InEveryForm, Mutants, ::testing::Values("c++", "pair", "javascript", "c", "float"),
                         [](const auto& form) {
                           const std::string name = form.param;
                           return name == "c++" ? "cpp" : name;
                         });

}  // namespace
}  // namespace flatdyn::testing
