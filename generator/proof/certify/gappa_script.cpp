// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/certify/gappa_script.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <set>

#include "code/emit/literals.hpp"
#include "graph/text.hpp"

namespace flatdyn {
namespace {

// The largest number of terms in a formula, as Gappa's time grows with the square of its length.
constexpr std::size_t kLongest = 250;

std::string expression(ErrorAnalysis& analysis, int k);

// An operand in Gappa's language. Constants have names; exact operations are expanded: "k3", "-x5", "k4 * qd_1".
std::string operand(ErrorAnalysis& analysis, int k) {
  const StraightLine& lines = analysis.text();
  const Operation& operation = lines[k];
  switch (operation.step) {
    case Step::constant:
      return fmt::format("k{}", k);
    case Step::input:
      return fmt::format("{}_{}", argument_row(operation.input.kind).name, operation.input.index + 1);
    case Step::sine:
      return fmt::format("s_{}", operation.input.index + 1);
    case Step::cosine:
      return fmt::format("c_{}", operation.input.index + 1);
    case Step::sign:
      return fmt::format("x{}", k);
    default:
      return analysis.norms().own_error(k) > 0 ? fmt::format("x{}", k) : "(" + expression(analysis, k) + ")";
  }
}

// An operation as the text has it: "s_2 * qd_1".
std::string expression(ErrorAnalysis& analysis, int k) {
  const StraightLine& lines = analysis.text();
  const Operation& operation = lines[k];
  const auto binary = [&](const char* sign) {
    return fmt::format("{} {} {}", operand(analysis, operation.a), sign, operand(analysis, operation.b));
  };
  switch (operation.step) {
    case Step::add:
      return binary("+");
    case Step::subtract:
      return binary("-");
    case Step::multiply:
      return binary("*");
    case Step::negate:
      return "-" + operand(analysis, operation.a);
    default:
      return operand(analysis, k);
  }
}

// Adds the constants of an expression: those of the operation's operands, and of exact operations among them.
void add_constants(ErrorAnalysis& analysis, int k, std::set<int>& constants) {
  const Operation& operation = analysis.text()[k];
  for (const int a : {operation.a, operation.b}) {
    if (a < 0) continue;
    if (analysis.text()[a].step == Step::constant) {
      constants.insert(a);
    } else if (analysis.norms().own_error(a) == 0) {
      add_constants(analysis, a, constants);
    }
  }
}

// The definitions of constants: "k3 = rnd(0.333);".
std::string definitions(const StraightLine& lines, const std::set<int>& constants) {
  std::string text;
  for (const int k : constants) text += fmt::format("k{} = rnd({});\n", k, decimal_literal(lines[k].value));
  return text.empty() ? "" : text + "\n";
}

// A number in Gappa's language; powers of two exactly: "1b-53".
std::string number(double value) {
  int exponent = 0;
  if (std::frexp(value, &exponent) == 0.5) return fmt::format("1b{}", exponent - 1);
  return fmt::format("{:.17g}", value);
}

std::string within(const std::string& what, const std::string& bound) {
  return fmt::format("{} in [-{}, {}]", what, bound, bound);
}

struct Line {
  std::string text, comment;
};

std::string conjunction(const std::vector<Line>& lines) {
  std::string text;
  for (const Line& line : lines) {
    text += "  " + line.text;
    if (&line != &lines.back()) text += " /\\";
    text += line.comment.empty() ? "\n" : "  # " + line.comment + "\n";
  }
  return text;
}

std::string formula(const std::vector<Line>& hypotheses, const std::vector<Line>& goals) {
  return "{\n" + conjunction(hypotheses) + "->\n" + conjunction(goals) + "}\n";
}

std::string error_name(const ErrorTerm& term) { return fmt::format("r{}", term.operation); }

// The length of a group's vector of errors: "r5"; "(r5 + r6)"; "sqrt(r5 * r5 + (r6 + r7) * (r6 + r7))".
std::string length_of_errors(const ErrorGroup& group) {
  std::vector<std::string> sums, squares;
  for (const AlikeErrors& alike : group.components) {
    std::vector<std::string> names;
    for (const ErrorTerm& term : alike) names.push_back(error_name(term));
    sums.push_back(names.size() == 1 ? names.front() : fmt::format("({})", fmt::join(names, " + ")));
    squares.push_back(sums.back() + " * " + sums.back());
  }
  return sums.size() == 1 ? sums.front() : fmt::format("sqrt({})", fmt::join(squares, " + "));
}

constexpr const char* kRoundings =
    "# Errors of the operations of {}().\n"
    "# An operation is no larger than it says here before it is rounded (x5: the result of operation 5; k5: a "
    "constant;\n"
    "# s, c: sines and cosines), as flatdyn has shown from norms. Gappa proves that its rounding error is then no "
    "larger than the "
    "bound.\n"
    "#   gappa {}\n"
    "# ends with code 0 if all of that is true.\n\n"
    "@rnd = {};\n\n";

constexpr const char* kSum =
    "# The error of {} of {}(){}.\n"
    "# r5: the error that operation 5 makes itself, see {}.roundings_1.g; also those of sines, cosines and constants.\n"
    "# a5: how much of it reaches the output, which is the derivative by it; of several, of which the length follows,\n"
    "# the derivative in their direction, which is no longer than the vector of their derivatives. No larger than "
    "this,\n"
    "# as flatdyn has shown from norms. Gappa proves that the error of the output, the sum of all, is within the "
    "bound.\n"
    "#   gappa {}\n"
    "# ends with code 0 if it is.\n\n";

}  // namespace

std::string name_in_scripts(ErrorAnalysis& analysis, int k) { return operand(analysis, k); }

std::vector<GappaScript> rounding_scripts(const std::string& function, ErrorAnalysis& analysis,
                                          const RoundingFormat& format) {
  std::vector<GappaScript> scripts;
  std::vector<Line> hypotheses, goals;
  std::set<int> constants;
  const auto finish = [&] {
    if (goals.empty()) return;
    const std::string name = fmt::format("{}.roundings_{}.g", function, scripts.size() + 1);
    scripts.push_back({name, fmt::format(fmt::runtime(kRoundings), function, name, format.gappa) +
                                 definitions(analysis.text(), constants) + formula(hypotheses, goals)});
    hypotheses.clear();
    goals.clear();
    constants.clear();
  };
  for (int k = 0; k < analysis.executed(); ++k) {
    const double before = analysis.norms().largest_before_rounding(k);
    if (!(before > 0)) continue;
    const std::string exact = expression(analysis, k);
    add_constants(analysis, k, constants);
    const std::string result = operand(analysis, k);
    hypotheses.push_back({within(exact, bound_text(before)), result});
    goals.push_back({within(fmt::format("rnd({0}) - ({0})", exact), number(analysis.norms().own_error(k))), ""});
    if (goals.size() == kLongest) finish();
  }
  finish();
  return scripts;
}

GappaScript sum_script(const std::string& function, const std::string& output, const std::string& unit,
                       const OutputError& error) {
  std::string file_name = output;
  for (char& c : file_name) c = c == '[' ? '_' : c;
  std::erase(file_name, ']');
  const std::string name = fmt::format("{}.{}.g", function, file_name);
  std::vector<Line> hypotheses;
  std::vector<std::string> terms;
  for (const ErrorGroup& group : error.groups) {
    const std::string derivative = fmt::format("a{}", group.components.front().front().operation);
    std::string line;
    for (const AlikeErrors& alike : group.components) {
      for (const ErrorTerm& term : alike) line += within(error_name(term), number(term.error)) + " /\\ ";
    }
    hypotheses.push_back({line + within(derivative, bound_text(group.sensitivity)), ""});
    terms.push_back(derivative + " * " + length_of_errors(group));
  }
  const std::string in = unit.empty() ? "" : ", " + unit;
  const std::string sum = fmt::format("{}", fmt::join(terms, "\n  + "));
  return {name, fmt::format(fmt::runtime(kSum), output, function, in, function, name) +
                    formula(hypotheses, {{within(sum, bound_text(error.bound)), ""}})};
}

}  // namespace flatdyn
