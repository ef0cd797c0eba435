// SPDX-License-Identifier: GPL-2.0-or-later
#include "symbolic/latex.hpp"

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

// Letters with a number at the end: "l1" → "l_{1}".
std::string numbered(const std::string& word) {
  std::size_t digits = word.size();
  while (digits > 0 && std::isdigit(static_cast<unsigned char>(word[digits - 1])) != 0) --digits;
  if (digits == word.size() || digits == 0) return digits == 0 ? word : letters(word);
  return letters(word.substr(0, digits)) + "_{" + word.substr(digits) + "}";
}

}  // namespace

std::string latex_name(const std::string& name) {
  const std::size_t bracket = name.find_first_of("( ");
  if (bracket != std::string::npos) {  // sin(alpha), (a + b): what is inside stays as it is
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

}  // namespace flatdyn
