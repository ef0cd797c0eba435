// SPDX-License-Identifier: GPL-2.0-or-later
// The free symbols of a robot file: one GiNaC symbol per name, and what each stands for.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "base/diagnostics/diagnostics.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// The quantity of a value, so that a symbol with two meanings is found.
enum class Quantity {
  length,
  angle,
  mass,
  inertia,
  acceleration,
  gear_ratio,
  viscous_friction,
  coulomb_friction,
  stiffness,
  speed,
  other,  // not tracked
};

class SymbolTable {
 public:
  explicit SymbolTable(std::string scene_file = {}) : scene_file_(std::move(scene_file)) {}

  // The symbol of this name, made at its first use. `column` orders symbols of one line.
  GiNaC::symbol get(std::string_view name, const Place& place, std::size_t column, Diagnostics& diagnostics);

  // To be called with each value that was read. Each symbol that is a term of it by itself or with a number before it,
  // as in 2*m + 1e-3 or (l_1 - l_2)/2, is such a quantity; a second, different one is an error. Of symbols in products
  // and powers nothing is known: the numbers there may have units of their own.
  void check_quantity(const Number& value, Quantity quantity, const Place& place, Diagnostics& diagnostics);

  // In order of first appearance in the file; those of the scene alone behind them.
  std::vector<FreeSymbol> in_order() const;

 private:
  struct Entry {
    FreeSymbol symbol;
    std::size_t column = 0;
    Quantity quantity = Quantity::other;
    Place quantity_place;
  };

  using Rank = std::tuple<bool, int, std::size_t>;
  Rank rank(const Place& place, std::size_t column) const;
  static void check_quantity(Entry& entry, Quantity quantity, const Place& place, Diagnostics& diagnostics);
  void report_bad_name(const std::string& name, const Place& place, Diagnostics& diagnostics) const;

  std::string scene_file_;
  std::vector<Entry> entries_;
};

}  // namespace flatdyn
