// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/linear_position.hpp"

#include <algorithm>
#include <map>

#include "robot/input/common/expression.hpp"
#include "robot/input/common/units.hpp"
#include "robot/model/unit_plausibility.hpp"

namespace flatdyn {

namespace {

// The joints' names stand for symbols of this one expression, in the order in which they appear.
struct NamedSymbols {
  std::vector<std::pair<std::string, GiNaC::symbol>> all;
  std::map<std::string, std::string> quoted;  // names that are no identifiers, by what stands for them

  Number get(std::string_view written) {
    const auto stands_for = quoted.find(std::string(written));
    const std::string name = stands_for == quoted.end() ? std::string(written) : stands_for->second;
    for (const auto& [known, symbol] : all) {
      if (known == name) return symbol;
    }
    all.emplace_back(name, GiNaC::symbol(name));
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

// Names that are no identifiers stand in single quotes; they are exchanged for identifiers.
std::string with_quoted_names(const std::string& text, NamedSymbols& symbols) {
  std::string plain;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const std::size_t end = text[at] == '\'' ? text.find('\'', at + 1) : std::string::npos;
    if (end == std::string::npos) {
      plain += text[at];
      continue;
    }
    const std::string stand_in = "quoted__" + std::to_string(symbols.quoted.size());
    symbols.quoted[stand_in] = text.substr(at + 1, end - at - 1);
    plain += stand_in;
    at = end;
  }
  return plain;
}

std::string shortened(const std::string& text) {
  constexpr std::size_t kShown = 40;
  return text.size() > kShown ? text.substr(0, kShown) + "..." : text;
}

bool check_magnitudes(const Coupled& coupled, const Spot& spot, Diagnostics& diagnostics) {
  const auto is_fine = [&](const Number& number) {
    return check_magnitude(number, "a number of it", spot, diagnostics);
  };
  return is_fine(coupled.offset) && std::all_of(coupled.terms.begin(), coupled.terms.end(),
                                                [&](const Coupled::Term& term) { return is_fine(term.factor); });
}

}  // namespace

std::optional<Coupled> read_linear_position(const std::string& text, JointType type, const Units& units,
                                            const Spot& spot, ReadContext& context) {
  const char* const hint =
      "write a sum of joints with numbers as factors, e.g. \"elbow - shoulder\", \"2*drive + pi/4\"";
  NamedSymbols symbols;
  std::optional<Coupled> coupled;
  try {
    const std::string plain = with_quoted_names(text, symbols);
    const Number value = parse_expression(plain, [&](std::string_view name, std::size_t) { return symbols.get(name); });
    coupled = linear_terms(value, symbols, spot.place);
  } catch (const ExpressionError& error) {
    context.diagnostics.error(spot.place,
                              spot.what + ": \"" + shortened(text) + "\": " + error.what() + " (column " +
                                  std::to_string(error.column()) + ")",
                              hint);
    return std::nullopt;
  }
  if (!coupled || coupled->terms.empty()) {
    context.diagnostics.error(
        spot.place,
        spot.what + ": \"" + shortened(text) + "\" is " + (coupled ? "constant" : "not linear in the joints' names"),
        coupled ? "a joint that does not move has type = \"fixed\"" : hint);
    return std::nullopt;
  }
  if (!check_magnitudes(*coupled, spot, context.diagnostics)) return std::nullopt;
  if (type == JointType::prismatic) {
    coupled->offset = in_metres(coupled->offset, units, spot, context.diagnostics);
    return coupled;
  }
  const Number written = coupled->offset, angle = in_radians(written, units, spot, context.diagnostics);
  coupled->offset = canonical_angle(angle, spot, context.diagnostics);
  if (!units.degrees && may_be_degrees(coupled->offset)) {
    warn_of_degrees(coupled->offset, spot, degrees_hint(written), context.diagnostics);
  }
  return coupled;
}

}  // namespace flatdyn
