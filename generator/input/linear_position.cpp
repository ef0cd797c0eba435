// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/linear_position.hpp"

#include "input/expression.hpp"

namespace flatdyn {

namespace {

// The joints' names stand for symbols of this one expression, in the order in which they appear.
struct NamedSymbols {
  std::vector<std::pair<std::string, GiNaC::symbol>> all;

  Number get(std::string_view name) {
    for (const auto& [known, symbol] : all) {
      if (known == name) return symbol;
    }
    all.emplace_back(std::string(name), GiNaC::symbol(std::string(name)));
    return all.back().second;
  }
};

// Σ factor · name + offset; nullopt if it is not linear.
std::optional<Coupled> linear_terms(const Number& expression, const NamedSymbols& symbols, const Place& place) {
  Coupled result;
  result.place = place;
  Number rest = expression.expand();
  for (const auto& [name, symbol] : symbols.all) {
    const Number factor = rest.coeff(symbol, 1);
    rest = (rest - factor * symbol).expand();
    if (has_symbols(factor)) return std::nullopt;
    if (!vanishes(factor)) result.terms.push_back({{name, place}, factor});
  }
  if (has_symbols(rest)) return std::nullopt;
  result.offset = rest;
  return result;
}

}  // namespace

std::optional<Coupled> read_linear_position(const std::string& text, JointType type, const Spot& spot,
                                            ReadContext& context) {
  const char* const hint =
      "write a sum of joints with numbers as factors, e.g. \"elbow - shoulder\", \"2*drive + pi/4\"";
  NamedSymbols symbols;
  std::optional<Coupled> coupled;
  try {
    const Number value = parse_expression(text, [&](std::string_view name, std::size_t) { return symbols.get(name); });
    coupled = linear_terms(value, symbols, spot.place);
  } catch (const ExpressionError& error) {
    context.diagnostics.error(
        spot.place,
        spot.what + ": \"" + text + "\": " + error.what() + " (column " + std::to_string(error.column()) + ")", hint);
    return std::nullopt;
  }
  if (!coupled || coupled->terms.empty()) {
    context.diagnostics.error(
        spot.place, spot.what + ": \"" + text + "\" is " + (coupled ? "constant" : "not linear in the joints' names"),
        coupled ? "a joint that does not move has type = \"fixed\"" : hint);
    return std::nullopt;
  }
  if (type != JointType::prismatic) coupled->offset = canonical_angle(coupled->offset, spot, context.diagnostics);
  return coupled;
}

}  // namespace flatdyn
