// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/planning/moves.hpp"

namespace flatdyn {
namespace {

template <class Choice>
bool changed(Choice& choice, const Choice& value) {
  if (choice == value) return false;
  choice = value;
  return true;
}

void add_units(std::vector<Move>& moves, const Mechanism& raised) {
  if (raised.has_lengths()) return;
  std::vector<Number> units = possible_length_units(raised);
  units.emplace_back(1);
  for (const Number& unit : units) {
    moves.emplace_back([unit](Choices& choices) {
      if (choices.length_unit.is_equal(unit)) return false;
      choices.length_unit = unit;
      return true;
    });
  }
}

void add_axial_shifts(std::vector<Move>& moves, const Mechanism& raised) {
  for (int i = 0; i < raised.size(); ++i) {
    for (const Number& axial_shift : possible_axial_shifts(raised, i)) {
      moves.emplace_back([i, axial_shift](Choices& choices) {
        Number& sum = choices.joints[static_cast<std::size_t>(i)].axial_shift;
        sum = (sum + axial_shift).expand();
        return true;
      });
    }
  }
}

}  // namespace

std::vector<Move> possible_moves(const Mechanism& mechanism, const Choices& choices) {
  std::vector<Move> moves;
  const Mechanism raised = with_shifted_frames(mechanism, choices);
  add_units(moves, raised);
  for (std::size_t k = 0; k < choices.joints.size(); ++k) {
    for (const Balance balance : kBalances) {
      moves.emplace_back([k, balance](Choices& c) { return changed(c.joints[k].grouping.balance, balance); });
    }
  }
  add_axial_shifts(moves, raised);
  for (std::size_t k = 0; k < choices.joints.size(); ++k) {
    for (const Grouping grouping : kGroupings) {
      moves.emplace_back([k, grouping](Choices& c) { return changed(c.joints[k].grouping.grouping, grouping); });
    }
  }
  for (std::size_t k = 0; k < choices.joints.size(); ++k) {
    if (!can_be_still(mechanism, static_cast<int>(k))) continue;
    for (const Axes axes : {Axes::turning, Axes::still}) {
      moves.emplace_back([k, axes](Choices& c) { return changed(c.joints[k].axes, axes); });
    }
  }
  return moves;
}

}  // namespace flatdyn
