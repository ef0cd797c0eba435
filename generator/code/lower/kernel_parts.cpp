// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/lower/kernel_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <queue>
#include <tuple>

#include "base/diagnostics/diagnostics.hpp"
#include "code/lower/each_operand.hpp"
#include "code/lower/node_set.hpp"
#include "code/lower/schedule.hpp"
#include "graph/passes/draft.hpp"

namespace flatdyn {
namespace {

// The price of reading a number that another kernel has written, in operations: the memory delivers one in the time in
// which some twenty operations are done.
constexpr long kPriceOfReading = 20;

// The price of a kernel more, which reads inputs once more and is launched.
constexpr long kPriceOfKernel = 100;

// Numbers that fit into registers, in addition to addresses.
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
NodeSet nodes_for(const Function& function, const Entries& entries) {
  NodeSet needed(function.graph.size());
  for (const Target& each : entries) {
    const Output& output = function.outputs[static_cast<std::size_t>(each.output)];
    needed.add(output.entries[static_cast<std::size_t>(each.entry)]);
  }
  for (NodeId id = function.graph.size(); id-- > 0;) {
    if (needed.has(id)) for_each_operand(function.graph[id], [&needed](NodeId operand) { needed.add(operand); });
  }
  return needed;
}

bool is_entry_read(const Node& node) { return node.op == Op::input && node.input.kind == InputKind::stored; }

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

// The entries of each part, and what they cost together.
struct PricedParts {
  std::vector<Entries> entries;
  long price = 0;
};

class Division {
 public:
  Division(const Function& function, int registers) : function_(function), registers_(registers), probe_(function) {
    probe_.validity_conditions.clear();
    probe_.pivot_scales.clear();
    zero_ = probe_.graph.constant(0);
    price_.reserve(static_cast<std::size_t>(function.graph.size()));
    for (NodeId id = 0; id < function.graph.size(); ++id) {
      const auto operands = static_cast<long>(operands_of(function.graph[id]).size());
      price_.push_back(std::max(0L, operands - 1) + (operands > 0 ? 1 : 0));
      if (is_entry_read(function.graph[id])) price_.back() = kPriceOfReading;
    }
    units_ = units();
    for (const Entries& each : units_) nodes_.push_back(nodes_for(function, each));
  }

  // Whether the values of the whole fit into registers.
  bool whole_fits() { return whole().live <= registers_; }

  // One part if the whole is best. The search ends where it finds no division near the price `most`.
  PricedParts run(long most = std::numeric_limits<long>::max()) {
    std::vector<Group> best = {whole()};
    if (!whole_fits()) {
      for (const long caution : {1L, 8L}) {
        caution_ = caution;
        std::vector<Group> groups = merged();
        caution_ = 1;
        const bool is_near = total(groups) / kMostSavedByMoves <= most;
        if (is_near) move_units(groups);
        if (total(groups) < total(best)) best = std::move(groups);
        if (!is_near) break;
      }
    }
    std::stable_sort(best.begin(), best.end(), [](const Group& a, const Group& b) { return a.live < b.live; });
    PricedParts parts{{}, total(best)};
    for (const Group& each : best) parts.entries.push_back(entries_of(each.units));
    for (const Target& each : entries_that(true)) parts.entries.front().push_back(each);
    return parts;
  }

 private:
  // Moves and another caution make divisions cheaper by an eighth at most, seen so far; this is far more.
  static constexpr long kMostSavedByMoves = 2;

  struct Group {
    std::vector<int> units;
    NodeSet nodes;
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

  const Group& whole() {
    std::vector<int> all;
    for (std::size_t k = 0; k < units_.size(); ++k) all.push_back(static_cast<int>(k));
    return group(std::move(all));
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

  NodeSet nodes_of(const std::vector<int>& units) const {
    NodeSet nodes(function_.graph.size());
    for (const int unit : units) nodes.add(nodes_[static_cast<std::size_t>(unit)]);
    return nodes;
  }

  // Measured once for each set of units.
  const Group& group(std::vector<int> units) {
    std::sort(units.begin(), units.end());
    const auto [place, is_new] = known_.emplace(units, Group());
    Group& result = place->second;
    if (!is_new) return result;
    const Entries entries = entries_of(units);
    result.nodes = nodes_of(units);
    result.units = std::move(units);
    result.live = live_values_of(entries);
    result.operations = result.nodes.weight(price_);
    return result;
  }

  // The values that are live at once in a part with these entries. The graph is not copied for it, as it may be large.
  long live_values_of(const Entries& entries) {
    for (Output& output : probe_.outputs) {
      output.left_out.assign(output.entries.size(), true);
      std::fill(output.entries.begin(), output.entries.end(), zero_);
    }
    for (const Target& each : entries) {
      Output& output = probe_.outputs[static_cast<std::size_t>(each.output)];
      output.entries[static_cast<std::size_t>(each.entry)] = node_of(each);
      output.left_out[static_cast<std::size_t>(each.entry)] = false;
    }
    return most_live_values(probe_);
  }

  long spilled(const Group& group) const { return caution_ * price_of_spilling(group.live - registers_); }
  long cost(const Group& group) const {
    return group.units.empty() ? 0 : kPriceOfKernel + group.operations + spilled(group);
  }
  long total(const std::vector<Group>& groups) const {
    long sum = 0;
    for (const Group& each : groups) sum += cost(each);
    return sum;
  }

  long shared(const Group& a, const Group& b) const { return a.nodes.weight_with(b.nodes, price_); }

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
    const NodeSet& nodes = nodes_[static_cast<std::size_t>(unit)];
    const long operations = nodes.weight(price_);
    // A group with the unit costs so much more at least: its operations, if nothing is put aside any more.
    const auto least_added = [&](const Group& to) {
      return operations - nodes.weight_with(to.nodes, price_) - spilled(to);
    };
    const long most_freed = cost(from) - (without.empty() ? 0 : kPriceOfKernel + nodes_of(without).weight(price_));
    std::optional<Group> rest;
    Group* best = nullptr;
    long most_saved = 0;
    for (Group& to : groups) {
      if (&to == &from || to.units.empty() || most_freed - least_added(to) <= most_saved) continue;
      if (!rest) rest = without.empty() ? Group() : group(without);
      const long freed = cost(from) - cost(*rest);
      if (freed - least_added(to) <= most_saved) continue;
      const long saved = freed + cost(to) - cost(group(joined(to.units, {unit})));
      if (saved <= most_saved) continue;
      most_saved = saved;
      best = &to;
    }
    if (best == nullptr) return false;
    *best = group(joined(best->units, {unit}));
    from = *rest;
    return true;
  }

  static std::vector<int> joined(std::vector<int> a, const std::vector<int>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }

  const Group& at(int k) const { return groups_[static_cast<std::size_t>(k)]; }

  const Function& function_;
  long registers_;
  Function probe_;              // the function with some of its entries
  NodeId zero_ = 0;             // in its graph
  long caution_ = 1;            // a factor of the price of spilling
  std::vector<long> price_;     // by node: its operations
  std::vector<Entries> units_;  // what is not divided
  std::vector<NodeSet> nodes_;  // by unit: those that it needs
  std::map<std::vector<int>, Group> known_;
  std::vector<Group> groups_;
  std::vector<bool> alive_;  // by group: it has not become part of another one
  std::priority_queue<Pair> pairs_;
};

// The entries of the function's outputs that `rest` leaves out.
Entries entries_without(const Function& rest) {
  Entries entries;
  for (int k = 0; k < static_cast<int>(rest.outputs.size()); ++k) {
    const Output& output = rest.outputs[static_cast<std::size_t>(k)];
    for (int e = 0; e < static_cast<int>(output.entries.size()); ++e) {
      if (output.leaves_out(static_cast<std::size_t>(e))) entries.push_back({k, e});
    }
  }
  return entries;
}

// The parts of a function; none if it stays whole. The first one checks.
std::vector<Function> parts_of(const Function& function, int registers, const std::optional<Function>& reading) {
  Division direct(function, registers);
  std::vector<Function> parts;
  if (direct.whole_fits()) return parts;
  const auto add = [&parts](const Function& of, const PricedParts& more) {
    for (const Entries& each : more.entries) parts.push_back(restricted(of, each, parts.empty()));
  };
  if (!reading) {
    const PricedParts alone = direct.run();
    if (alone.entries.size() > 1) add(function, alone);
    return parts;
  }
  const Function before = restricted(function, entries_without(*reading), true);
  const PricedParts first = Division(before, registers).run(), rest = Division(*reading, registers).run();
  const PricedParts alone = direct.run(first.price + rest.price);
  if (first.price + rest.price < alone.price) {
    add(before, first);
    add(*reading, rest);
  } else if (alone.entries.size() > 1) {
    add(function, alone);
  }
  return parts;
}

// The entries that parts have written so far.
class Memory {
 public:
  explicit Memory(const Function& whole) : whole_(whole), composed_(whole) {
    composed_.graph = Graph();
    entries_.resize(entry_count(whole), kNone);
  }

  // Carries out a part. The conditions are those of the first one.
  void carry_out(const Function& part) {
    std::vector<NodeId> image;
    for (NodeId id = 0; id < part.graph.size(); ++id) {
      const Node& node = part.graph[id];
      image.push_back(is_entry_read(node) ? read(node.input.index, part.name) : composed_.graph.copy(node, image));
    }
    std::size_t place = 0;
    for (const Output& output : part.outputs) {
      for (std::size_t e = 0; e < output.entries.size(); ++e, ++place) {
        if (!output.leaves_out(e)) entries_[place] = image[static_cast<std::size_t>(output.entries[e])];
      }
    }
    if (is_checked_) return;
    is_checked_ = true;
    const auto of_image = [&image](NodeId& id) { id = image[static_cast<std::size_t>(id)]; };
    composed_.validity_conditions = part.validity_conditions;
    composed_.pivot_scales = part.pivot_scales;
    std::for_each(composed_.validity_conditions.begin(), composed_.validity_conditions.end(), of_image);
    std::for_each(composed_.pivot_scales.begin(), composed_.pivot_scales.end(), of_image);
  }

  Function result() && {
    std::size_t place = 0;
    for (Output& output : composed_.outputs) {
      for (std::size_t e = 0; e < output.entries.size(); ++e, ++place) {
        if (!output.leaves_out(e)) {
          output.entries[e] = read(static_cast<int>(place), whole_.name);
        } else {
          output.entries[e] = composed_.graph.constant(0);
        }
      }
    }
    return std::move(composed_);
  }

 private:
  static constexpr NodeId kNone = -1;

  NodeId read(int place, const std::string& reader) const {
    const NodeId value = entries_.at(static_cast<std::size_t>(place));
    if (value != kNone) return value;
    throw Failure(FailureKind::bug, fmt::format("{}: entry {} of its outputs is not written before", reader, place));
  }

  const Function& whole_;
  Function composed_;
  std::vector<NodeId> entries_;  // over all outputs, in order
  bool is_checked_ = false;
};

}  // namespace

int values_in_registers(bool is_double) { return is_double ? kDoublesInRegisters : kFloatsInRegisters; }

KernelParts kernel_parts(const std::vector<Function>& functions, int registers, const ReadingParts& reading) {
  KernelParts result;
  for (std::size_t f = 0; f < functions.size(); ++f) {
    const Function& function = functions[f];
    std::vector<Function> parts = parts_of(function, registers, f < reading.size() ? reading[f] : std::nullopt);
    result.counts.push_back(static_cast<int>(parts.size()));
    for (std::size_t k = 0; k < parts.size(); ++k) {
      Function& part = parts[k];
      part.name = fmt::format("{}_part_{}", function.name, k + 1);
      part.summary = fmt::format("Part {} of {} of {}, for its kernels", k + 1, parts.size(), function.name);
      part.equation.clear();
      result.functions.push_back(std::move(part));
    }
  }
  return result;
}

Target entry_read(const Function& part, int index) {
  Target target{0, index};
  for (const Output& output : part.outputs) {
    const auto length = static_cast<int>(output.entries.size());
    if (target.entry < length) break;
    target.entry -= length;
    ++target.output;
  }
  return target;
}

Function composed(const Function& whole, const std::vector<Function>& parts) {
  Memory memory(whole);
  for (const Function& part : parts) memory.carry_out(part);
  return std::move(memory).result();
}

}  // namespace flatdyn
