// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/symbol_table.hpp"

#include <algorithm>
#include <regex>

#include "robot/input/common/context.hpp"
#include "robot/model/identifiers.hpp"

namespace flatdyn {

namespace {

std::string with_article(Quantity quantity) {
  switch (quantity) {
    case Quantity::length:
      return "a length";
    case Quantity::angle:
      return "an angle";
    case Quantity::mass:
      return "a mass";
    case Quantity::inertia:
      return "a moment of inertia";
    case Quantity::acceleration:
      return "an acceleration";
    case Quantity::gear_ratio:
      return "a gear ratio";
    case Quantity::viscous_friction:
      return "a viscous friction";
    case Quantity::coulomb_friction:
      return "a Coulomb friction";
    case Quantity::stiffness:
      return "a stiffness";
    case Quantity::speed:
      return "a speed";
    case Quantity::other:
      return "a value";
  }
  throw std::logic_error("unknown quantity");
}

// Where it goes by the type of a joint that is not known here, both.
const char* unit_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::length:
      return "m";
    case Quantity::angle:
      return "rad";
    case Quantity::mass:
      return "kg";
    case Quantity::inertia:
      return "kg m^2";
    case Quantity::acceleration:
      return "m/s^2";
    case Quantity::viscous_friction:
      return "N m s/rad or N s/m";
    case Quantity::coulomb_friction:
      return "N m or N";
    case Quantity::stiffness:
      return "N m/rad or N/m";
    case Quantity::speed:
      return "rad/s or m/s";
    case Quantity::gear_ratio:
    case Quantity::other:
      return "";
  }
  throw std::logic_error("unknown quantity");
}

// The symbols among the terms of a sum, numeric factors left aside.
void add_linear_symbols(const Number& value, std::vector<GiNaC::symbol>& symbols) {
  if (GiNaC::is_a<GiNaC::symbol>(value)) {
    symbols.push_back(GiNaC::ex_to<GiNaC::symbol>(value));
  } else if (GiNaC::is_a<GiNaC::add>(value)) {
    for (const Number& term : value) add_linear_symbols(term, symbols);
  } else if (GiNaC::is_a<GiNaC::mul>(value) && std::count_if(value.begin(), value.end(), has_symbols) == 1) {
    add_linear_symbols(*std::find_if(value.begin(), value.end(), has_symbols), symbols);
  }
}

}  // namespace

SymbolTable::Rank SymbolTable::rank(const Place& place, std::size_t column) const {
  return {!scene_file_.empty() && place.file == scene_file_, place.line, column};
}

GiNaC::symbol SymbolTable::get(std::string_view name, const Place& place, std::size_t column,
                               Diagnostics& diagnostics) {
  const auto found =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.symbol.name == name; });
  if (found != entries_.end()) {
    if (rank(place, column) < rank(found->symbol.place, found->column)) {
      found->symbol.place = place;
      found->column = column;
    }
    return found->symbol.symbol;
  }
  report_bad_name(std::string(name), place, diagnostics);
  const std::string text(name);
  entries_.push_back({{GiNaC::symbol(text), text, place}, column, Quantity::other, {}});
  return entries_.back().symbol.symbol;
}

void SymbolTable::report_bad_name(const std::string& name, const Place& place, Diagnostics& diagnostics) const {
  // Names that the program itself prints and emits: q_1, qd_1, s_12 = sin(q_1 + q_2), tau_1.
  static const std::regex kOwnNames("(q|qd|qdd|dq|ddq|tau)_?[0-9]*|[sc]_?[0-9]+");
  if (std::regex_match(name, kOwnNames)) {
    diagnostics.error(place,
                      "symbol \"" + name + "\" has two meanings: it is also a joint variable, or its sine or cosine",
                      "rename the symbol, e.g. \"" + name + "_0\" or \"k_" + name + "\"");
  }
  for (const Entry& entry : entries_) {
    if (cpp_identifier(entry.symbol.name) == cpp_identifier(name)) {
      diagnostics.error(
          place,
          "symbols \"" + entry.symbol.name + "\" and \"" + name + "\" have the same C++ name, " + cpp_identifier(name),
          "rename one of them");
    }
  }
}

void SymbolTable::check_quantity(const Number& value, Quantity quantity, const Place& place, Diagnostics& diagnostics) {
  if (quantity == Quantity::other) return;
  std::vector<GiNaC::symbol> symbols;
  add_linear_symbols(value, symbols);
  // In the order of the file, not in GiNaC's, which differs from run to run.
  for (Entry& entry : entries_) {
    const bool is_one = std::any_of(symbols.begin(), symbols.end(),
                                    [&](const GiNaC::symbol& symbol) { return entry.symbol.symbol.is_equal(symbol); });
    if (is_one) check_quantity(entry, quantity, place, diagnostics);
  }
}

void SymbolTable::check_quantity(Entry& entry, Quantity quantity, const Place& place, Diagnostics& diagnostics) {
  if (entry.quantity == Quantity::other) {
    entry.quantity = quantity;
    entry.quantity_place = place;
  } else if (entry.quantity != quantity) {
    diagnostics.error(place,
                      "symbol \"" + entry.symbol.name + "\" is used as " + with_article(quantity) + " here and as " +
                          with_article(entry.quantity) + " in " + relative_place_text(place, entry.quantity_place),
                      "give each quantity a symbol of its own");
  }
}

std::vector<FreeSymbol> SymbolTable::in_order() const {
  std::vector<Entry> sorted = entries_;
  std::stable_sort(sorted.begin(), sorted.end(), [this](const Entry& a, const Entry& b) {
    return rank(a.symbol.place, a.column) < rank(b.symbol.place, b.column);
  });
  std::vector<FreeSymbol> symbols;
  for (const Entry& entry : sorted) {
    symbols.push_back(entry.symbol);
    symbols.back().unit = unit_of(entry.quantity);
  }
  return symbols;
}

}  // namespace flatdyn
