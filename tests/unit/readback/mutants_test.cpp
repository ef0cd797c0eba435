// SPDX-License-Identifier: GPL-2.0-or-later
// Emitted text with one change: whatever is changed outside of comments, and wherever, the proof of the text fails.
// Each row is a kind of change in one language or more; the first place of the text is changed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <memory>

#include "base/diagnostics/diagnostics.hpp"
#include "code/emit/writer.hpp"
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

// A function with a square root, which only those of the operational space have otherwise, and zeros in a row.
Function with_a_root_and_zeros() {
  Function function;
  function.name = "gravity";
  function.inputs = {InputKind::q};
  const NodeId q = function.graph.input({InputKind::q, 0});
  const NodeId square = function.graph.sum({{1, function.graph.product({q, q})}, {1, function.graph.constant(1)}});
  Output g;
  g.name = "g";
  g.rows = 18;
  g.entries.assign(18, function.graph.constant(0));
  g.entries.front() = function.graph.sqrt(square);
  g.entries.back() = q;
  function.outputs = {g};
  return function;
}

const PrintedCode& code_for(const std::string& robot) {
  static std::map<std::string, std::unique_ptr<PrintedCode>> made;
  std::unique_ptr<PrintedCode>& code = made[robot];
  if (code != nullptr) return *code;
  if (robot == "arm") {
    code = std::make_unique<PrintedCode>(
        model_of_toml(kArm),
        std::vector<std::string>{"inverse_dynamics", "inertia_matrix", "forward_dynamics", "kinetic_energy", "gravity"},
        std::vector<std::string>{"inertia_matrix", "forward_dynamics"});
  } else if (robot == "root") {
    code = std::make_unique<PrintedCode>(model_of_toml(kArm), std::vector<Function>{with_a_root_and_zeros()});
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

std::string text_in(const PrintedCode& code, const std::string& form, int most_lines = 0) {
  const EmitOptions options = form_of(form, most_lines);
  return form == "lanes" ? code.text_over_states(options) : code.text(options);
}

void prove_in(const PrintedCode& code, const std::string& text, const std::string& form) {
  if (form == "lanes") {
    code.prove_over_states(text, form_of(form));
  } else {
    code.prove(text, form_of(form));
  }
}

const std::string& text_of(const Mutant& mutant, const std::string& form) {
  static std::map<std::string, std::string> made;
  const int most_lines = mutant.has_parts ? 30 : 0;
  std::string& text = made[fmt::format("{} {} {}", mutant.robot, form, most_lines)];
  if (text.empty()) text = text_in(code_for(mutant.robot), form, most_lines);
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
    if (wrong.empty()) {
      ADD_FAILURE() << mutant.kind << ": nothing to change: " << mutant.from;
      continue;
    }
    EXPECT_THROW(prove_in(code_for(mutant.robot), wrong, form), Failure) << mutant.kind << ": " << mutant.to;
    ++count;
  }
  EXPECT_GE(count, 43);
}

TEST_P(Mutants, AreMadeOfTextThatHolds) {
  const std::string form = GetParam();
  for (const Mutant& mutant : mutants()) {
    if (!is_in(mutant, form)) continue;
    EXPECT_NO_THROW(prove_in(code_for(mutant.robot), text_of(mutant, form), form)) << mutant.robot;
  }
}

// A text that somebody holds is compared with the robot's statement by statement: whatever the proof refuses is named
// there, and what it does not refuse is not.
TEST_P(Mutants, AreFoundInTextThatIsHeld) {
  const std::string form = GetParam();
  if (form == "lanes") GTEST_SKIP() << "functions over states are made with the module that calls them";
  const std::string whole = text_in(code_for("arm"), form);
  EXPECT_TRUE(code_for("arm").compare("// edited\n" + whole, whole, form_of(form)).passed());
  for (const Mutant& mutant : mutants()) {
    if (!is_in(mutant, form)) continue;
    const PrintedCode& code = code_for(mutant.robot);
    const std::string &text = text_of(mutant, form), wrong = changed(mutant, text);
    const EmitOptions options = form_of(form, mutant.has_parts ? 30 : 0);
    const HeldReport report = code.compare(wrong, text, options);
    EXPECT_FALSE(report.passed()) << mutant.kind << ": " << mutant.to;
    EXPECT_FALSE(report.differences.empty() && report.unreadable.empty()) << mutant.kind << ": " << mutant.to;
  }
}

// The text of these tokens, line by line.
std::string text_of_tokens(const std::vector<Token>& tokens) {
  std::string text;
  int line = 1;
  for (const Token& token : tokens) {
    text += token.line == line ? " " : "\n";
    line = token.line;
    text += token.text + (token.is_directive() ? "\n" : "");
  }
  return text;
}

bool is_proven(const PrintedCode& code, const std::vector<Token>& tokens, const std::string& form) {
  try {
    prove_in(code, text_of_tokens(tokens), form);
  } catch (const Failure&) {
    return false;
  }
  return true;
}

// Without one of its tokens, or with one twice, no text holds.
TEST_P(Mutants, EveryTokenCounts) {
  const std::string form = GetParam();
  const PrintedCode& code = code_for("arm");
  const std::vector<Token> tokens = tokens_of(text_in(code, form));
  ASSERT_TRUE(is_proven(code, tokens, form));
  constexpr std::size_t kStride = 41;  // a prime number: any kind of token is among them
  for (std::size_t k = 0; k < tokens.size(); k += kStride) {
    std::vector<Token> wrong = tokens;
    wrong.erase(wrong.begin() + static_cast<std::ptrdiff_t>(k));
    EXPECT_FALSE(is_proven(code, wrong, form)) << "without \"" << tokens[k].text << "\" in line " << tokens[k].line;
    wrong = tokens;
    wrong.insert(wrong.begin() + static_cast<std::ptrdiff_t>(k), tokens[k]);
    EXPECT_FALSE(is_proven(code, wrong, form)) << "twice \"" << tokens[k].text << "\" in line " << tokens[k].line;
  }
}

// Checks that entries of qdd are finite, as each form writes them.
class ChecksOfEntries {
 public:
  ChecksOfEntries(const std::string& form, const std::string& robot)
      : is_cpp_(form == "c++" || form == "pair"), is_script_(form == "javascript"), form_(form), robot_(robot) {}

  std::string one(const std::string& index) const {
    if (is_rust()) return fmt::format("valid &= qdd[{}].is_finite();", index);
    return fmt::format("valid {} {} * qdd[{}] < {};", is_script_ ? "&&=" : "&=", literal("0.0"), index, literal("1.0"));
  }
  std::string loop(int first, int end) const {
    if (is_rust()) return fmt::format("valid &= qdd[{}..{}].iter().all(|x| x.is_finite());", first, end);
    const std::string body = is_cpp_ ? one("k") : "{ " + one("k") + " }";
    return fmt::format("for ({} k = {}; k < {}; ++k) {}", is_script_ ? "let" : "int", first, end, body);
  }
  // Changes of the loop that no longer check what it checks.
  std::vector<std::string> changed(const std::string& loop) const {
    if (is_rust()) {
      return {with_replaced(loop, "all", "any"), with_replaced(loop, "qdd", "tau"), with_replaced(loop, "..", "..=")};
    }
    return {with_replaced(loop, "<", "<="), with_replaced(loop, "1.0", "2.0"), with_replaced(loop, "qdd", "tau"),
            with_replaced(loop, "++k", "k += 2")};
  }

 private:
  bool is_rust() const { return form_ == "rust"; }
  std::string literal(const std::string& number) const {
    return form_ == "lanes"   ? fmt::format("{}_lanes_all({})", robot_, number)
           : is_cpp_          ? "Scalar(" + number + ")"
           : form_ == "float" ? number + "f"
                              : number;
  }

  bool is_cpp_, is_script_;
  std::string form_, robot_;
};

TEST_P(Mutants, ChecksOfEntriesAreOfAllThatAreWritten) {
  const std::string form = GetParam();
  const ChecksOfEntries checks(form, "arm");
  const PrintedCode& code = code_for("arm");
  const std::string text = text_in(code, form), usual = checks.loop(0, 2);
  ASSERT_NE(text.find(usual), std::string::npos) << usual;
  for (const std::string& all : {checks.one("0") + checks.one("1"), checks.loop(1, 2) + checks.one("0")}) {
    EXPECT_NO_THROW(prove_in(code, with_replaced(text, usual, all), form)) << all;
  }
  std::vector<std::string> all_wrong = checks.changed(usual);
  for (const std::string& each : {std::string(), checks.one("0"), checks.loop(0, 1), checks.loop(0, 3),
                                  usual + checks.one("1"), checks.loop(2, 0)}) {
    all_wrong.push_back(each);
  }
  for (const std::string& wrong : all_wrong) {
    EXPECT_THROW(prove_in(code, with_replaced(text, usual, wrong), form), Failure) << wrong;
  }
}

TEST_P(Mutants, ChecksOfEntriesMayFollowParts) {
  const std::string form = GetParam();
  const ChecksOfEntries checks(form, "finger");
  const PrintedCode& code = code_for("finger");
  const std::string text = text_in(code, form, 30), usual = checks.loop(0, 3);
  ASSERT_NE(text.find(usual), std::string::npos) << usual;
  EXPECT_THROW(prove_in(code, with_replaced(text, usual, checks.loop(0, 2)), form), Failure);
}

INSTANTIATE_TEST_SUITE_P(InEveryForm, Mutants,
                         ::testing::Values("c++", "pair", "javascript", "c", "float", "lanes", "rust"),
                         [](const auto& form) {
                           const std::string name = form.param;
                           return name == "c++" ? "cpp" : name;
                         });

}  // namespace
}  // namespace flatdyn::testing
