// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <bitset>
#include <map>

#include "code/lower/limb_classes.hpp"

namespace flatdyn {
namespace {

constexpr std::size_t kMostGiven = 128;  // given values of a limb whose signs are chosen; those of others stay

// A sign, as a product of unknown signs of given values, and -1 if the last bit is set: bits are added modulo 2.
using Sign = std::bitset<kMostGiven + 1>;
constexpr std::size_t kMinus = kMostGiven;

// Conditions that products of signs are 1, each kept if it agrees with those before it.
class SignConditions {
 public:
  void add(Sign condition) {
    for (const auto& [unknown, sign] : known_) {
      if (condition[unknown]) condition ^= sign;
    }
    for (std::size_t unknown = 0; unknown < kMostGiven; ++unknown) {
      if (!condition[unknown]) continue;
      for (auto& [other, sign] : known_) {
        if (sign[unknown]) sign ^= condition;
      }
      known_[unknown] = condition;
      return;
    }
  }

  // The sign with the unknown ones replaced; those that are free are 1.
  int value(Sign sign) const {
    for (const auto& [unknown, condition] : known_) {
      if (sign[unknown]) sign ^= condition;
    }
    return sign[kMinus] ? -1 : 1;
  }

 private:
  std::map<std::size_t, Sign> known_;  // by the unknown that the condition determines
};

// Chooses the signs of one limb other than the first one of its set.
class Chooser {
 public:
  Chooser(const Graph& graph, LimbClasses& classes, int set, std::size_t limb)
      : graph_(graph), classes_(classes), set_(set), limb_(limb), signs_(classes.classes.size()) {}

  void run() {
    for (std::size_t k = 0; k < signs_.size(); ++k) {
      if (is_mine(k)) follow(k);
    }
    SignConditions conditions;
    for (const auto* list : {&of_units_, &of_given_, &of_sizes_}) {
      for (const Sign& each : *list) conditions.add(each);
    }
    for (std::size_t k = 0; k < signs_.size(); ++k) {
      if (is_mine(k)) classes_.classes[k].signs[limb_] = conditions.value(signs_[k]);
    }
  }

 private:
  bool is_mine(std::size_t k) const {
    return classes_.classes[k].set == set_ && limb_ < classes_.classes[k].members.size();
  }

  void follow(std::size_t k) {
    const LimbClass& each = classes_.classes[k];
    if (each.is_given()) {
      if (given_ < kMostGiven) {
        signs_[k].set(given_++);
        of_given_.push_back(signs_[k]);
      }
    } else if (graph_[each.members.front()].op == Op::sum) {
      follow_sum(k);
    } else {
      for (const Term& term : each.operands.front()) {
        if (classes_.has(term.node)) signs_[k] ^= sign_of(term.node);
      }
    }
  }

  // The sign of a sum is the one that the first of its terms asks for, those with the coefficient 1 or -1 before
  // others. Each further term is a condition.
  void follow_sum(std::size_t k) {
    std::vector<Sign> units, sizes;
    const std::vector<Term>&first = classes_.classes[k].operands.front(), &mine = classes_.classes[k].operands[limb_];
    for (std::size_t t = 0; t < first.size(); ++t) {
      const NodeId node = first[t].node;
      const bool is_gathered = node >= 0 && !classes_.has(node) && node != mine[t].node;
      if (is_gathered || abs(first[t].coefficient) != abs(mine[t].coefficient)) continue;
      Sign sign = node >= 0 && classes_.has(node) ? sign_of(node) : Sign();
      if ((first[t].coefficient < 0) != (mine[t].coefficient < 0)) sign.flip(kMinus);
      (abs(first[t].coefficient) == 1 && node >= 0 ? units : sizes).push_back(sign);
    }
    const std::vector<Sign>& deciding = units.empty() ? sizes : units;
    if (deciding.empty()) return;
    signs_[k] = deciding.front();
    for (const Sign& each : units) of_units_.push_back(each ^ signs_[k]);
    for (const Sign& each : sizes) of_sizes_.push_back(each ^ signs_[k]);
  }

  const Sign& sign_of(NodeId id) const { return signs_[static_cast<std::size_t>(classes_.of(id))]; }

  const Graph& graph_;
  LimbClasses& classes_;
  int set_;
  std::size_t limb_, given_ = 0;
  std::vector<Sign> signs_;  // by class
  std::vector<Sign> of_units_, of_given_, of_sizes_;
};

}  // namespace

void choose_signs(const Graph& graph, LimbClasses& classes) {
  std::map<int, std::size_t> limbs;  // by set
  for (const LimbClass& each : classes.classes) limbs[each.set] = each.members.size();
  for (const auto& [set, count] : limbs) {
    for (std::size_t limb = 1; limb < count; ++limb) Chooser(graph, classes, set, limb).run();
  }
}

}  // namespace flatdyn
