// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/lower/limb_classes.hpp"

#include <algorithm>
#include <map>

#include "code/lower/expressions.hpp"

namespace flatdyn {
namespace {

constexpr int kNone = -1;

template <class List>
decltype(auto) entry(List& list, int k) {
  return list[static_cast<std::size_t>(k)];
}

// A limb of a set.
struct PlaceInSet {
  int set = kNone, limb = kNone;

  bool operator==(const PlaceInSet&) const = default;
  bool is_limb() const { return set != kNone; }
};

// Whether a class of two limbs saves more than it takes to gather operands of no class: it has operands of classes, and
// at most one that differs from limb to limb otherwise.
bool pays(const LimbClasses& known, const std::vector<Term>& a, const std::vector<Term>& b) {
  int others = 0, classes = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const NodeId x = a[k].node, y = b[k].node;
    if (x < 0) continue;
    if (known.has(x)) {
      ++classes;
    } else if (x != y) {
      ++others;
    }
  }
  return a.empty() || (classes > 0 && others <= 1);
}

bool pays(const LimbClasses& known, const LimbClass& each) {
  return each.is_given() || std::all_of(each.operands.begin() + 1, each.operands.end(), [&](const auto& of_limb) {
           return pays(known, each.operands.front(), of_limb);
         });
}

class Finder {
 public:
  Finder(const Function& function, const std::vector<Limbs>& sets)
      : graph_(function.graph),
        sets_(sets),
        alive_(reachable_from(graph_, roots(function))),
        names_(alive_.size(), "x"),
        expressions_(graph_, names_),
        place_(alive_.size()),
        height_(alive_.size(), 0) {
    found_.class_of.assign(alive_.size(), kNone);
    found_.limb_of.assign(alive_.size(), kNone);
  }

  LimbClasses run() {
    find_places();
    std::map<std::pair<int, int>, std::vector<NodeId>> levels;  // by height and set
    for (NodeId id = 0; id < graph_.size(); ++id) {
      if (entry(alive_, id) && entry(place_, id).is_limb())
        levels[{entry(height_, id), entry(place_, id).set}].push_back(id);
    }
    for (const auto& [level, nodes] : levels) add_classes(level.second, nodes);
    return std::move(found_);
  }

 private:
  using Key = std::vector<int>;
  struct Candidate {
    NodeId id;
    std::vector<Term> operands;
  };

  // The limb and the place in it of an input's joint; the place is -1 if it belongs to no limb.
  std::pair<PlaceInSet, int> place_of_input(const Input& input) const {
    const bool is_of_joint = is_by_joint(input.kind);
    for (std::size_t set = 0; set < sets_.size() && is_of_joint; ++set) {
      for (int limb = 0; limb < sets_[set].count(); ++limb) {
        const std::vector<int>& joints = entry(sets_[set].joints, limb);
        const int joint = input.index - (input.kind == InputKind::q ? 0 : sets_[set].base_velocities);
        const auto found = std::find(joints.begin(), joints.end(), joint);
        if (found != joints.end()) {
          return {{static_cast<int>(set), limb}, static_cast<int>(found - joints.begin())};
        }
      }
    }
    return {{}, kNone};
  }

  // A node belongs to a limb if all of its operands that belong to limbs belong to that one.
  void find_places() {
    for (NodeId id = 0; id < graph_.size(); ++id) {
      const Node& node = graph_[id];
      if (node.op == Op::input) entry(place_, id) = place_of_input(node.input).first;
      if (node.op == Op::sign || node.op == Op::sqrt) continue;
      for (const NodeId operand : operands_of(node)) {
        const PlaceInSet place = entry(place_, operand);
        if (!place.is_limb()) continue;
        PlaceInSet& mine = entry(place_, id);
        if (mine.is_limb() && !(mine == place)) {
          mine = {};
          break;
        }
        mine = place;
        entry(height_, id) = std::max(entry(height_, id), entry(height_, operand) + 1);
      }
    }
  }

  // The operands in the order of the expression. The first two may be swapped, which changes no bit.
  std::vector<Term> operands(NodeId id) const {
    const Node& node = graph_[id];
    std::vector<Term> list;
    if (node.op == Op::sum) {
      list = expressions_.terms_in_order(id);
    } else if (node.op == Op::product || node.op == Op::quotient) {
      for (const NodeId operand : node.operands) list.push_back({1, operand});
    }
    const auto rank = [this](const Term& term) { return std::pair(token(term), order_of(term.node)); };
    const bool may_swap = node.op != Op::quotient && list.size() > 1;
    if (may_swap && rank(list[1]) < rank(list[0])) std::swap(list[0], list[1]);
    return list;
  }

  // Orders operands of no class.
  NodeId order_of(NodeId id) const { return id >= 0 && found_.has(id) ? 0 : id; }

  // A number for the operand's class and whether its coefficient is 1 or -1.
  int token(const Term& term) const {
    const int of = term.node < 0 ? kNone - 1 : found_.of(term.node);
    return 2 * of + (abs(term.coefficient) == 1 ? 1 : 0);
  }

  Key key_of(const Candidate& candidate) const {
    const Node& node = graph_[candidate.id];
    Key key = {static_cast<int>(node.op)};
    if (node.op == Op::input) {
      key.push_back(static_cast<int>(node.input.kind));
      key.push_back(place_of_input(node.input).second);
    } else if (candidate.operands.empty()) {
      key.push_back(place_of_input(graph_[angle_of(graph_, candidate.id).node].input).second);
    }
    for (const Term& term : candidate.operands) key.push_back(token(term));
    return key;
  }

  void add_classes(int set, const std::vector<NodeId>& nodes) {
    const auto limbs = static_cast<std::size_t>(entry(sets_, set).count());
    std::map<Key, std::vector<std::vector<Candidate>>> buckets;
    for (const NodeId id : nodes) {
      Candidate candidate{id, operands(id)};
      const Key key = key_of(candidate);
      std::vector<std::vector<Candidate>>& bucket = buckets[key];
      bucket.resize(limbs);
      entry(bucket, entry(place_, id).limb).push_back(std::move(candidate));
    }
    for (auto& [key, bucket] : buckets) add_matches(set, bucket);
  }

  // Adds the classes of one bucket: first those whose sizes and shared operands agree, then others.
  void add_matches(int set, std::vector<std::vector<Candidate>>& bucket) {
    for (const bool only_alike : {true, false}) {
      std::vector<Candidate>& first = bucket.front();
      for (std::size_t k = 0; k < first.size();) {
        if (add_match(set, bucket, k, only_alike)) {
          first.erase(first.begin() + static_cast<std::ptrdiff_t>(k));
        } else {
          ++k;
        }
      }
    }
  }

  bool add_match(int set, std::vector<std::vector<Candidate>>& bucket, std::size_t k, bool only_alike) {
    const Candidate first = bucket.front()[k];
    std::vector<std::size_t> chosen;
    for (std::size_t limb = 1; limb < bucket.size(); ++limb) {
      const auto found = std::find_if(bucket[limb].begin(), bucket[limb].end(), [&](const Candidate& other) {
        return only_alike ? is_alike(first, other) : can_be_class(first, other);
      });
      if (found == bucket[limb].end()) return false;
      chosen.push_back(static_cast<std::size_t>(found - bucket[limb].begin()));
    }
    LimbClass made{set, {first.id}, std::vector<int>(bucket.size(), 1), {}};
    if (!first.operands.empty()) made.operands.push_back(first.operands);
    for (std::size_t limb = 1; limb < bucket.size(); ++limb) {
      const auto at = bucket[limb].begin() + static_cast<std::ptrdiff_t>(chosen[limb - 1]);
      made.members.push_back(at->id);
      if (!first.operands.empty()) made.operands.push_back(at->operands);
      bucket[limb].erase(at);
    }
    for (std::size_t limb = 0; limb < made.members.size(); ++limb) {
      entry(found_.class_of, made.members[limb]) = static_cast<int>(found_.classes.size());
      entry(found_.limb_of, made.members[limb]) = static_cast<int>(limb);
    }
    found_.classes.push_back(std::move(made));
    return true;
  }

  // Whether all sizes and all operands of no class are the same.
  bool is_alike(const Candidate& a, const Candidate& b) const {
    for (std::size_t k = 0; k < a.operands.size(); ++k) {
      const Term &x = a.operands[k], &y = b.operands[k];
      if (abs(x.coefficient) != abs(y.coefficient)) return false;
      if (x.node >= 0 && !found_.has(x.node) && x.node != y.node) return false;
    }
    return can_be_class(a, b);
  }

  bool can_be_class(const Candidate& a, const Candidate& b) const { return pays(found_, a.operands, b.operands); }

  const Graph& graph_;
  const std::vector<Limbs>& sets_;
  std::vector<bool> alive_;
  VariableNames names_;
  NodeExpressions expressions_;
  std::vector<PlaceInSet> place_;
  std::vector<int> height_;  // above the inputs of the limb
  LimbClasses found_;
};

}  // namespace

LimbClasses without(const LimbClasses& classes, const std::vector<bool>& left_out) {
  LimbClasses kept = {{}, std::vector<int>(classes.class_of.size(), kNone), classes.limb_of};
  for (std::size_t k = 0; k < classes.classes.size(); ++k) {
    const LimbClass& each = classes.classes[k];
    if (left_out[k] || !pays(kept, each)) continue;
    for (const NodeId member : each.members) entry(kept.class_of, member) = static_cast<int>(kept.classes.size());
    kept.classes.push_back(each);
  }
  return kept;
}

LimbClasses limb_classes(const Function& function, const std::vector<Limbs>& sets) {
  return Finder(function, sets).run();
}

}  // namespace flatdyn
