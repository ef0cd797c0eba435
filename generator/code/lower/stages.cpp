// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/lower/stages.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace flatdyn {
namespace {

enum Level { kPosition = 1, kVelocity = 2, kRest = 3 };

int level_of(InputKind kind) {
  if (kind == InputKind::q || kind == InputKind::parameter) return kPosition;
  return is_velocity(kind) ? kVelocity : kRest;
}

// The stage of a function with this argument: gravity in axes of a floating base belongs to the position, but may
// change while that is kept, so that no stage stores it.
int level_of_argument(InputKind kind) { return kind == InputKind::g_b ? kPosition : level_of(kind); }

std::size_t at(NodeId id) { return static_cast<std::size_t>(id); }

// Whether only the value's own stage can compute it: inputs, sines and cosines.
bool is_source(const Node& node) { return node.op == Op::input || node.op == Op::sin || node.op == Op::cos; }

using FieldPlaces = std::map<NodeId, int>;  // node of the whole → index of the field

class Splitter {
 public:
  explicit Splitter(const Fusion& fusion)
      : graph_(fusion.function.graph), levels_(at(graph_.size()), 0), users_(at(graph_.size()), 0) {
    for (NodeId id = 0; id < graph_.size(); ++id) levels_[at(id)] = level(id);
    for (std::size_t k = 0; k < fusion.parts.size(); ++k) {
      parts_.push_back(function_of(fusion, k));
      part_levels_.push_back(0);
      for (const InputKind kind : parts_.back().inputs) {
        part_levels_.back() = std::max(part_levels_.back(), level_of_argument(kind));
        if (is_velocity(kind)) velocity_ = kind;
      }
    }
  }

  Stages run() {
    Stages stages;
    const std::vector<NodeId> in_configuration = stored(kPosition);
    const std::vector<NodeId> in_motion = stored(kVelocity);
    FieldPlaces configuration = places(in_configuration);
    stages.configuration.fields = names_of(in_configuration, "x");
    stages.configuration.make = maker("at", {InputKind::q}, in_configuration, {});
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      if (part_levels_[k] <= kPosition) stages.configuration.members.push_back(member(parts_[k], configuration));
    }
    add_motion(stages, in_motion, configuration);
    return stages;
  }

 private:
  int level(NodeId id) const {
    const Node& node = graph_[id];
    if (node.op == Op::input) return level_of(node.input.kind);
    int highest = 0;
    for (const NodeId operand : operands_of(node)) highest = std::max(highest, levels_[at(operand)]);
    return highest;
  }

  // Counts the users of each node of this level: a member counts 1; one that may be called repeatedly for one value of
  // this level counts 2.
  void count_users(int level) {
    std::fill(users_.begin(), users_.end(), 0);
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      const std::vector<bool> needed = reachable_from(graph_, roots(parts_[k]));
      for (NodeId id = 0; id < graph_.size(); ++id) {
        if (needed[at(id)] && levels_[at(id)] == level) users_[at(id)] += part_levels_[k] > level ? 2 : 1;
      }
    }
  }

  bool is_shared(NodeId id, int level) const {
    if (levels_[at(id)] != level || is_negation(graph_[id])) return false;
    return users_[at(id)] > 1 || (users_[at(id)] > 0 && is_source(graph_[id]));
  }

  // Shared values that are used outside of their stage, in the order of ids.
  std::vector<NodeId> stored(int level) {
    count_users(level);
    std::vector<bool> needed(users_.size(), false);
    const auto use = [&](NodeId id) {
      while (is_negation(graph_[id])) id = graph_[id].terms[0].node;
      if (is_shared(id, level)) needed[at(id)] = true;
    };
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      const std::vector<bool> of_part = reachable_from(graph_, roots(parts_[k]));
      for (NodeId id = 0; id < graph_.size(); ++id) {
        if (!of_part[at(id)] || is_shared(id, level) || levels_[at(id)] < level) continue;
        for (const NodeId operand : operands_of(graph_[id])) use(operand);
      }
      for (const NodeId root : roots(parts_[k])) use(root);
    }
    std::vector<NodeId> result;
    for (NodeId id = 0; id < graph_.size(); ++id) {
      if (needed[at(id)]) result.push_back(id);
    }
    return result;
  }

  static FieldPlaces places(const std::vector<NodeId>& fields) {
    FieldPlaces result;
    for (std::size_t k = 0; k < fields.size(); ++k) result[fields[k]] = static_cast<int>(k);
    return result;
  }

  // The nodes' own names, s_2 and c_2, or x1, x2, …: each is unique in both stages.
  std::vector<std::string> names_of(const std::vector<NodeId>& fields, const std::string& prefix) {
    std::vector<std::string> names;
    int next = 0;
    for (const NodeId id : fields) {
      std::string name = own_name(id);
      while (name.empty() || !names_.insert(name).second) name = prefix + std::to_string(++next);
      names.push_back(name);
    }
    return names;
  }

  std::string own_name(NodeId id) const {
    const Node& node = graph_[id];
    if (const std::string* name = graph_.name(id)) return *name;
    if (node.op != Op::sin && node.op != Op::cos) return "";
    return (node.op == Op::sin ? "s_" : "c_") + std::to_string(graph_[angle_of(graph_, id).node].input.index + 1);
  }

  // A copy of a function with these roots, with stored values as inputs.
  struct Copy {
    Graph graph;
    std::vector<NodeId> image;
  };
  Copy copy(const std::vector<NodeId>& wanted, const FieldPlaces& given) const {
    std::vector<bool> needed(users_.size(), false);
    for (const NodeId id : wanted) needed[at(id)] = true;
    for (NodeId id = graph_.size() - 1; id >= 0; --id) {
      if (!needed[at(id)] || given.count(id) != 0) continue;
      for (const NodeId operand : operands_of(graph_[id])) needed[at(operand)] = true;
    }
    Copy result;
    result.image.assign(users_.size(), 0);
    for (NodeId id = 0; id < graph_.size(); ++id) {
      if (!needed[at(id)]) continue;
      const auto place = given.find(id);
      NodeId& here = result.image[at(id)];
      here = place != given.end() ? result.graph.input({InputKind::stored, place->second})
                                  : result.graph.copy(graph_[id], result.image);
      copy_name(graph_, id, result.graph, here);
    }
    return result;
  }

  Function maker(const std::string& name, std::vector<InputKind> inputs, const std::vector<NodeId>& fields,
                 const FieldPlaces& given) const {
    Copy made = copy(fields, given);
    Output output{"stage", Layout::fields, static_cast<int>(fields.size()), 1, {}, ""};
    for (const NodeId id : fields) output.entries.push_back(made.image[at(id)]);
    return {.name = name,
            .summary = "",
            .equation = "",
            .inputs = std::move(inputs),
            .graph = std::move(made.graph),
            .outputs = {output},
            .validity_conditions = {}};
  }

  Function member(const Function& part, const FieldPlaces& given) const {
    Copy made = copy(roots(part), given);
    Function result = with_graph(part, std::move(made.graph), made.image);
    std::erase_if(result.inputs, [this](InputKind kind) { return kind == InputKind::q || kind == velocity_; });
    return result;
  }

  // Adds the second stage. Its fields are its own and those of the configuration that its functions read.
  void add_motion(Stages& stages, std::vector<NodeId> own, const FieldPlaces& configuration) {
    std::vector<std::string> names = names_of(own, "v");
    std::map<NodeId, int> given = places(own);
    for (const auto& [id, place] : configuration) given.emplace(id, -1);
    std::vector<bool> read(users_.size(), false);
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      if (part_levels_[k] <= kPosition) continue;
      mark_given(roots(parts_[k]), given, read);
    }
    for (const auto& [id, place] : configuration) {
      if (!read[at(id)]) continue;
      own.push_back(id);
      names.push_back(stages.configuration.fields[static_cast<std::size_t>(place)]);
    }
    const FieldPlaces motion = places(own);
    stages.motion.fields = names;
    stages.motion.make = maker("with", {velocity_}, own, configuration);
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      if (part_levels_[k] > kPosition) stages.motion.members.push_back(member(parts_[k], motion));
    }
  }

  // Marks the given nodes that are met first on paths from these roots.
  void mark_given(const std::vector<NodeId>& wanted, const std::map<NodeId, int>& given,
                  std::vector<bool>& read) const {
    std::vector<bool> needed(users_.size(), false);
    for (const NodeId id : wanted) needed[at(id)] = true;
    for (NodeId id = graph_.size() - 1; id >= 0; --id) {
      if (!needed[at(id)]) continue;
      if (given.count(id) != 0) {
        read[at(id)] = true;
        continue;
      }
      for (const NodeId operand : operands_of(graph_[id])) needed[at(operand)] = true;
    }
  }

  const Graph& graph_;
  std::vector<int> levels_;
  std::vector<int> users_;
  std::vector<Function> parts_;
  std::vector<int> part_levels_;
  InputKind velocity_ = InputKind::qd;
  std::set<std::string> names_;  // names of fields
};

// `function` with stored values replaced by the nodes of `made` that compute them.
Function in_full(const Function& function, const Function& made) {
  Graph graph = made.graph;
  const std::vector<NodeId>& fields = made.outputs[0].entries;
  std::vector<NodeId> image;
  for (NodeId id = 0; id < function.graph.size(); ++id) {
    const Node& node = function.graph[id];
    const bool is_stored = node.op == Op::input && node.input.kind == InputKind::stored;
    image.push_back(is_stored ? fields[at(node.input.index)] : graph.copy(node, image));
  }
  Function result = with_graph(function, std::move(graph), image);
  result.inputs.insert(result.inputs.begin(), made.inputs.begin(), made.inputs.end());
  return result;
}

}  // namespace

std::vector<Function> members_in_full(const Stages& stages) {
  std::vector<Function> members;
  for (const Function& member : stages.configuration.members) {
    members.push_back(in_full(member, stages.configuration.make));
  }
  if (stages.motion.members.empty()) return members;
  const Function motion = in_full(stages.motion.make, stages.configuration.make);
  for (const Function& member : stages.motion.members) members.push_back(in_full(member, motion));
  return members;
}

Stages stages_of(const Fusion& fusion) { return Splitter(fusion).run(); }

}  // namespace flatdyn
