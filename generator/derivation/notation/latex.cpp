// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/notation/latex.hpp"

#include <cctype>
#include <set>

namespace flatdyn {
namespace {

const std::set<std::string> kGreek = {"alpha", "beta",   "gamma", "delta", "epsilon", "zeta",  "eta",   "theta",
                                      "kappa", "lambda", "mu",    "nu",    "xi",      "pi",    "rho",   "sigma",
                                      "tau",   "phi",    "chi",   "psi",   "omega",   "Delta", "Omega", "Sigma"};

std::string letters(const std::string& word) {
  if (kGreek.contains(word)) return "\\" + word;
  if (word.size() <= 1) return word;
  return "\\mathit{" + word + "}";
}

// A word with a subscript for the number at its end: "l1" → "l_{1}".
std::string numbered(const std::string& word) {
  std::size_t digits = word.size();
  while (digits > 0 && std::isdigit(static_cast<unsigned char>(word[digits - 1])) != 0) --digits;
  if (digits == word.size() || digits == 0) return digits == 0 ? word : letters(word);
  return letters(word.substr(0, digits)) + "_{" + word.substr(digits) + "}";
}

// The width of a line of 10 pt on A4, in characters; subscripts count at their smaller size.
constexpr double kWidthOfLine = 68;
constexpr double kSubscriptWidth = 0.65;

// The approximate printed width, in characters.
double printed_width(const std::string& text) {
  double width = 0;
  int depth = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] == '\\') {  // a command counts as one character, or is an accent over one
      while (k + 1 < text.size() && std::isalpha(static_cast<unsigned char>(text[k + 1])) != 0) ++k;
      width += 1;
    } else if (text[k] == '{' || text[k] == '}') {
      depth += text[k] == '{' ? 1 : -1;
    } else if (text[k] != '_' && text[k] != '^') {
      width += depth > 0 ? kSubscriptWidth : 1;
    }
  }
  return width;
}

}  // namespace

std::string latex_name(const std::string& name) {
  const std::size_t bracket = name.find_first_of("( ");
  if (bracket != std::string::npos) {  // sin(alpha), (a + b): the text inside is not changed
    const bool is_function = name.rfind("sin(", 0) == 0 || name.rfind("cos(", 0) == 0;
    return is_function ? "\\" + name.substr(0, 4) + latex_name(name.substr(4, name.size() - 5)) + ")" : name;
  }
  const std::size_t underscore = name.find('_');
  if (underscore == std::string::npos || underscore == 0) return numbered(name);
  std::string tail = name.substr(underscore + 1);
  for (std::size_t next = tail.find('_'); next != std::string::npos; next = tail.find('_')) tail[next] = ',';
  return letters(name.substr(0, underscore)) + "_{" + numbered(tail) + "}";
}

std::string latex_number(const std::string& decimal) {
  const std::size_t e = decimal.find('e');
  if (e == std::string::npos) return decimal;
  return decimal.substr(0, e) + " \\cdot 10^{" + std::to_string(std::stoi(decimal.substr(e + 1))) + "}";
}

std::string latex_lines(const std::string& formula) {
  std::string result;
  double width = 0;
  for (std::size_t begin = 0; begin < formula.size();) {
    // The end of one summand, which begins with its sign.
    std::size_t end = formula.find_first_of("+-", begin + 1);
    while (end != std::string::npos && (formula[end - 1] != ' ' || formula[end + 1] != ' ')) {
      end = formula.find_first_of("+-", end + 1);
    }
    const std::string summand = formula.substr(begin, end == std::string::npos ? end : end - begin);
    const double more = printed_width(summand);
    if (width > 0 && width + more > kWidthOfLine) {
      result += "\\\\\n    &\\quad ";
      width = 0;
    }
    result += summand;
    width += more;
    begin = end == std::string::npos ? formula.size() : end;
  }
  return result;
}

}  // namespace flatdyn
