// SPDX-License-Identifier: GPL-2.0-or-later
#include "emit/kernel_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <queue>
#include <tuple>

#include "emit/schedule.hpp"
#include "passes/draft.hpp"

namespace flatdyn {
namespace {

// Numbers that fit into registers, beside addresses.
constexpr int kDoublesInRegisters = 115, kFloatsInRegisters = 235;

// The price of so many live values more than that, in operations. Fitted to kernels measured on an H100: twice as many
// values come and go through memory twice as often, and from some number on the compiler loses track of them.
long price_of_spilling(long values) {
  constexpr long kMany = 150;
  const long some = std::max(0L, values), many = std::max(0L, values - kMany);
  return some * some / 5 + 3 * many * many;
}

// Entries of outputs: their places in Function::outputs and Output::entries.
using Entries = std::vector<Target>;

// The nodes that some entries need.
std::vector<bool> nodes_for(const Function& function, const Entries& entries) {
  std::vector<bool> needed(static_cast<std::size_t>(function.graph.size()), false);
  for (const Target& each : entries) {
    const Output& output = function.outputs[static_cast<std::size_t>(each.output)];
    needed[static_cast<std::size_t>(output.entries[static_cast<std::size_t>(each.entry)])] = true;
  }
  for (NodeId id = function.graph.size(); id-- > 0;) {
    if (!needed[static_cast<std::size_t>(id)]) continue;
    for (const NodeId operand : operands_of(function.graph[id])) needed[static_cast<std::size_t>(operand)] = true;
  }
  return needed;
}

// The function with these entries and none of the others. `checks`: with the conditions of validity; without, the
// entries must still be finite numbers.
Function restricted(const Function& whole, const Entries& entries, bool checks) {
  Function part = whole;
  const NodeId zero = part.graph.constant(0);
  for (Output& output : part.outputs) {
    output.left_out.assign(output.entries.size(), true);
    std::fill(output.entries.begin(), output.entries.end(), zero);
  }
  for (const Target& each : entries) {
    const auto output = static_cast<std::size_t>(each.output), entry = static_cast<std::size_t>(each.entry);
    part.outputs[output].entries[entry] = whole.outputs[output].entries[entry];
    part.outputs[output].left_out[entry] = false;
  }
  if (!whole.validity_conditions.empty() && !checks) {
    part.validity_conditions = {part.graph.constant(1)};
    part.pivot_scales.clear();
    part.proven_pivot_share = 0;
    part.loop_conditions = 0;
  }
  return without_dead_code(part);
}

class Division {
 public:
  Division(const Function& function, int registers) : function_(function), registers_(registers) {
    price_.reserve(static_cast<std::size_t>(function.graph.size()));
    for (NodeId id = 0; id < function.graph.size(); ++id) {
      const auto operands = static_cast<long>(operands_of(function.graph[id]).size());
      price_.push_back(std::max(0L, operands - 1) + (operands > 0 ? 1 : 0));
    }
  }

  // The parts; empty if the whole is best.
  std::vector<Entries> run() {
    units_ = units();
    std::vector<int> all;
    for (std::size_t k = 0; k < units_.size(); ++k) all.push_back(static_cast<int>(k));
    const Group whole = group(all);
    if (whole.live <= registers_) return {};
    std::vector<Group> best = {whole};
    for (const long caution : {1L, 8L}) {
      caution_ = caution;
      std::vector<Group> groups = merged();
      caution_ = 1;
      move_units(groups);
      if (total(groups) < total(best)) best = std::move(groups);
    }
    if (best.size() < 2) return {};
    std::stable_sort(best.begin(), best.end(), [](const Group& a, const Group& b) { return a.live < b.live; });
    std::vector<Entries> parts;
    for (const Group& each : best) parts.push_back(entries_of(each.units));
    for (const Target& each : entries_that(true)) parts.front().push_back(each);
    return parts;
  }

 private:
  struct Group {
    std::vector<int> units;
    std::vector<bool> nodes;
    long live = 0, operations = 0;
  };

  // Two groups and what is saved if they are one: at most (not measured) or exactly.
  struct Pair {
    long saved = 0;
    bool is_measured = false;
    int a = 0, b = 0;
    bool operator<(const Pair& other) const {
      return std::tuple(saved, -a, -b, is_measured) < std::tuple(other.saved, -other.a, -other.b, other.is_measured);
    }
  };

  NodeId node_of(const Target& target) const {
    return function_.outputs[static_cast<std::size_t>(target.output)].entries[static_cast<std::size_t>(target.entry)];
  }

  // The entries that are written and are constants, or are not.
  Entries entries_that(bool are_constant) const {
    Entries entries;
    for (int k = 0; k < static_cast<int>(function_.outputs.size()); ++k) {
      const Output& output = function_.outputs[static_cast<std::size_t>(k)];
      for (int e = 0; e < static_cast<int>(output.entries.size()); ++e) {
        if (output.leaves_out(static_cast<std::size_t>(e))) continue;
        if (function_.graph.is_constant(node_of({k, e})) == are_constant) entries.push_back({k, e});
      }
    }
    return entries;
  }

  // Columns of matrices, and vectors, without constants. Equal entries are in the column of the first of them.
  std::vector<Entries> units() const {
    std::vector<Entries> list;
    std::map<NodeId, std::size_t> unit_of;
    std::map<std::pair<int, int>, std::size_t> unit_of_column;
    for (const Target& each : entries_that(false)) {
      const Output& output = function_.outputs[static_cast<std::size_t>(each.output)];
      auto found = unit_of.find(node_of(each));
      if (found == unit_of.end()) {
        const int column = output.layout == Layout::matrix ? each.entry % output.cols : 0;
        const auto [place, is_new] = unit_of_column.emplace(std::pair(each.output, column), list.size());
        if (is_new) list.emplace_back();
        found = unit_of.emplace(node_of(each), place->second).first;
      }
      list[found->second].push_back(each);
    }
    return list;
  }

  Entries entries_of(const std::vector<int>& units) const {
    Entries entries;
    for (const int unit : units) {
      const Entries& more = units_[static_cast<std::size_t>(unit)];
      entries.insert(entries.end(), more.begin(), more.end());
    }
    return entries;
  }

  // Measured once for each set of units.
  const Group& group(std::vector<int> units) {
    std::sort(units.begin(), units.end());
    const auto [place, is_new] = known_.emplace(units, Group());
    Group& result = place->second;
    if (!is_new) return result;
    const Entries entries = entries_of(units);
    result.units = std::move(units);
    result.nodes = nodes_for(function_, entries);
    result.live = most_live_values(restricted(function_, entries, false));
    for (std::size_t k = 0; k < price_.size(); ++k) result.operations += result.nodes[k] ? price_[k] : 0;
    return result;
  }

  long spilled(const Group& group) const { return caution_ * price_of_spilling(group.live - registers_); }
  // A kernel more reads inputs once more and is launched.
  long cost(const Group& group) const {
    constexpr long kPriceOfKernel = 100;
    return group.units.empty() ? 0 : kPriceOfKernel + group.operations + spilled(group);
  }
  long total(const std::vector<Group>& groups) const {
    long sum = 0;
    for (const Group& each : groups) sum += cost(each);
    return sum;
  }

  long shared(const Group& a, const Group& b) const {
    long sum = 0;
    for (std::size_t k = 0; k < price_.size(); ++k) sum += a.nodes[k] && b.nodes[k] ? price_[k] : 0;
    return sum;
  }

  // Joins the two groups that save most by it, as long as any two do. A bound of what they save says which to measure.
  std::vector<Group> merged() {
    groups_.clear();
    pairs_ = {};
    for (int k = 0; k < static_cast<int>(units_.size()); ++k) groups_.push_back(group({k}));
    alive_.assign(groups_.size(), true);
    for (int k = 0; k < static_cast<int>(groups_.size()); ++k) add_pairs(k);
    while (!pairs_.empty()) {
      const Pair pair = pairs_.top();
      pairs_.pop();
      if (!alive_[static_cast<std::size_t>(pair.a)] || !alive_[static_cast<std::size_t>(pair.b)]) continue;
      const Group& both = group(joined(at(pair.a).units, at(pair.b).units));
      if (!pair.is_measured) {
        const long saved = cost(at(pair.a)) + cost(at(pair.b)) - cost(both);
        if (saved > 0) pairs_.push({saved, true, pair.a, pair.b});
        continue;
      }
      alive_[static_cast<std::size_t>(pair.a)] = alive_[static_cast<std::size_t>(pair.b)] = false;
      groups_.push_back(both);
      alive_.push_back(true);
      add_pairs(static_cast<int>(groups_.size()) - 1);
    }
    std::vector<Group> left;
    for (std::size_t k = 0; k < groups_.size(); ++k) {
      if (alive_[k]) left.push_back(groups_[k]);
    }
    return left;
  }

  void add_pairs(int k) {
    for (int other = 0; other < k; ++other) {
      if (!alive_[static_cast<std::size_t>(other)]) continue;
      const Group &a = at(k), &b = at(other);
      const long most = shared(a, b) + std::min(cost(a) - a.operations, cost(b) - b.operations);
      if (most > 0) pairs_.push({most, false, other, k});
    }
  }

  // Moves single units to other groups where that costs less.
  void move_units(std::vector<Group>& groups) {
    constexpr int kMostSweeps = 2;
    bool moves = true;
    for (int sweep = 0; sweep < kMostSweeps && moves; ++sweep) {
      moves = false;
      for (int unit = 0; unit < static_cast<int>(units_.size()); ++unit) moves = move_unit(unit, groups) || moves;
    }
    std::erase_if(groups, [](const Group& each) { return each.units.empty(); });
  }

  bool move_unit(int unit, std::vector<Group>& groups) {
    const auto has_it = [unit](const Group& each) {
      return std::find(each.units.begin(), each.units.end(), unit) != each.units.end();
    };
    Group& from = *std::find_if(groups.begin(), groups.end(), has_it);
    std::vector<int> without = from.units;
    std::erase(without, unit);
    const Group rest = without.empty() ? Group() : group(without);
    Group* best = nullptr;
    long most_saved = 0;
    for (Group& to : groups) {
      if (&to == &from || to.units.empty()) continue;
      const long saved = cost(from) + cost(to) - cost(rest) - cost(group(joined(to.units, {unit})));
      if (saved <= most_saved) continue;
      most_saved = saved;
      best = &to;
    }
    if (best == nullptr) return false;
    *best = group(joined(best->units, {unit}));
    from = rest;
    return true;
  }

  static std::vector<int> joined(std::vector<int> a, const std::vector<int>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }

  const Group& at(int k) const { return groups_[static_cast<std::size_t>(k)]; }

  const Function& function_;
  long registers_;
  long caution_ = 1;            // a factor of the price of spilling
  std::vector<long> price_;     // by node: its operations
  std::vector<Entries> units_;  // what is not divided
  std::map<std::vector<int>, Group> known_;
  std::vector<Group> groups_;
  std::vector<bool> alive_;  // by group: it has not become part of another one
  std::priority_queue<Pair> pairs_;
};

}  // namespace

int values_in_registers(bool is_double) { return is_double ? kDoublesInRegisters : kFloatsInRegisters; }

KernelParts kernel_parts(const std::vector<Function>& functions, int registers) {
  KernelParts parts;
  for (const Function& function : functions) {
    const std::vector<Entries> division = Division(function, registers).run();
    parts.counts.push_back(static_cast<int>(division.size()));
    for (std::size_t k = 0; k < division.size(); ++k) {
      Function part = restricted(function, division[k], k == 0);
      part.name = fmt::format("{}_part_{}", function.name, k + 1);
      part.summary = fmt::format("Part {} of {} of {}, for its kernels", k + 1, division.size(), function.name);
      part.equation.clear();
      parts.functions.push_back(std::move(part));
    }
  }
  return parts;
}

}  // namespace flatdyn
