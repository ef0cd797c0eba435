// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/urdf/couplings.hpp"

#include <algorithm>
#include <map>

#include "base/diagnostics/nearest.hpp"
#include "robot/input/common/coupling.hpp"
#include "robot/input/urdf/children.hpp"
#include "robot/input/urdf/mimics.hpp"

namespace flatdyn {

namespace {

// Σ factor · position = 0, by the joints' indices.
struct CouplingEquation {
  std::string what;
  Place place;
  std::map<int, Number> factors;
  std::vector<int> preferred;  // joints that may follow, the best one first
};

// The names of the two ends and the ratio of a coupling.
struct CouplingTags {
  const char* element;
  const char* predecessor;
  const char* successor;
  const char* ratio;
};

constexpr CouplingTags kCouplings[] = {{"coupling", "predecessor", "successor", "ratio"},
                                       {"joint_constraint", "parent", "child", "gear_ratio"}};

bool moves(const Joint& joint) { return joint.type != JointType::fixed || joint.held.has_value(); }

class CouplingReader {
 public:
  CouplingReader(const UrdfValues& values, Robot& robot)
      : values_(values), diagnostics_(values.context().diagnostics), robot_(robot) {
    for (std::size_t j = 0; j < robot.joints.size(); ++j)
      joint_above_.emplace(robot.joints[j].child, static_cast<int>(j));
  }

  void read(const FileNode& root) {
    for (const CouplingTags& tags : kCouplings) {
      for (const FileNode* element : root.elements(tags.element)) read_coupling(*element, tags);
    }
    for (CouplingEquation& equation : equations_) solve(equation);
    for (const auto& [joint, equation] : solved_) couple(joint, equation);
  }

 private:
  void read_coupling(const FileNode& element, const CouplingTags& tags) {
    const std::string what = name_in_messages(element);
    refuse_other_attributes(element, what, {"name", "type"}, values_);
    refuse_children(element, what, {tags.predecessor, tags.successor, tags.ratio}, values_);
    for (const char* tag : {tags.predecessor, tags.successor, tags.ratio}) refuse_second(element, what, tag, values_);
    const std::optional<int> predecessor = link_of(element, tags.predecessor, what);
    const std::optional<int> successor = link_of(element, tags.successor, what);
    const std::optional<Number> ratio = ratio_of(element, tags, what);
    if (!predecessor || !successor || !ratio) return;
    std::vector<int> before = path_to_link(*predecessor), after = path_to_link(*successor);
    const auto [b, a] = std::mismatch(before.begin(), before.end(), after.begin(), after.end());
    before.erase(before.begin(), b);
    after.erase(after.begin(), a);
    std::erase_if(before, [this](int j) { return !moves(joint(j)); });
    std::erase_if(after, [this](int j) { return !moves(joint(j)); });
    if (before.empty() || after.empty()) {
      refuse_path(element, what, before.empty() ? tags.predecessor : tags.successor);
      return;
    }
    CouplingEquation equation{what, element.place, {}, {}};
    for (const int j : before) equation.factors[j] = *ratio;
    for (const int j : after) equation.factors[j] = -1;
    equation.preferred.assign(after.rbegin(), after.rend());
    equation.preferred.insert(equation.preferred.end(), before.rbegin(), before.rend());
    equations_.push_back(equation);
  }

  std::optional<int> link_of(const FileNode& element, const char* tag, const std::string& what) {
    const FileNode* end = element.child(tag);
    if (end == nullptr) {
      diagnostics_.error(element.place, what + " has no <" + tag + ">",
                         std::string("write <") + tag + " link=\"...\"/>");
      return std::nullopt;
    }
    refuse_other_attributes(*end, what + ", " + tag, {"link"}, values_);
    refuse_children(*end, what + ", " + tag, {}, values_);
    const std::string name = values_.required_text(*end, "link", what + ", " + tag);
    if (name.empty()) return std::nullopt;
    return find_link(robot_, {name, end->place}, what + ", " + tag, diagnostics_);
  }

  std::optional<Number> ratio_of(const FileNode& element, const CouplingTags& tags, const std::string& what) {
    const FileNode* ratio = element.child(tags.ratio);
    if (ratio == nullptr) return 1;
    refuse_other_attributes(*ratio, what + ", " + tags.ratio, {"value"}, values_);
    refuse_children(*ratio, what + ", " + tags.ratio, {}, values_);
    const std::size_t before = diagnostics_.all().size();
    const Value value = values_.required_number(*ratio, "value", what + ", " + tags.ratio);
    if (!vanishes(value.number)) return value.number;
    if (diagnostics_.all().size() == before) {
      diagnostics_.error(value.place, what + ", " + tags.ratio + " is 0",
                         "make the successor's joint type=\"fixed\" if it does not move");
    }
    return std::nullopt;
  }

  // The joints from the root to a link; links that form a cycle are reported where trees are checked.
  std::vector<int> path_to_link(int link) const {
    std::vector<int> way;
    for (auto above = joint_above_.find(link); above != joint_above_.end() && way.size() < robot_.joints.size();
         above = joint_above_.find(joint(way.back()).parent)) {
      way.push_back(above->second);
    }
    std::reverse(way.begin(), way.end());
    return way;
  }

  void refuse_path(const FileNode& element, const std::string& what, const std::string& tag) {
    diagnostics_.error(element.place,
                       what + ": there is no joint between its " + tag +
                           " and the nearest link that carries both links, and so no position that the ratio is about",
                       "name links of two branches; where a joint follows one below it, write <mimic joint=\"...\" "
                       "multiplier=\"...\"/>");
  }

  // Puts in what is solved before, and picks the joint that follows.
  void solve(CouplingEquation& equation) {
    for (const auto& [joint, before] : solved_) {
      const auto found = equation.factors.find(joint);
      if (found == equation.factors.end() || vanishes(found->second)) continue;
      add(equation, found->second, before);
    }
    std::erase_if(equation.factors, [](const auto& factor) { return vanishes(factor.second); });
    if (equation.factors.empty()) return;  // it says nothing that is not said before
    if (equation.factors.size() == 1) {
      diagnostics_.error(equation.place,
                         equation.what + ": with the couplings before it, joint \"" +
                             joint(equation.factors.begin()->first).name + "\" could not move",
                         "check their ratios, and that each couples other joints");
      return;
    }
    const int follower = follower_of(equation);
    if (follower < 0) {
      diagnostics_.error(
          equation.place,
          equation.what + ": all its joints are marked independent=\"true\", or follow by another coupling",
          "mark the joint that follows independent=\"false\"");
      return;
    }
    const Number own = equation.factors[follower];
    for (auto& [joint, factor] : equation.factors) factor /= -own;
    for (auto& [joint, before] : solved_) {
      if (const auto found = before.factors.find(follower); found != before.factors.end())
        add(before, Number(found->second), equation);  // a copy: it changes on the way
    }
    solved_.emplace(follower, equation);
  }

  // Takes the joint that `solved` is solved for, whose factor there is -1, out of an equation.
  static void add(CouplingEquation& equation, const Number& multiple, const CouplingEquation& solved) {
    for (const auto& [joint, factor] : solved.factors) equation.factors[joint] += multiple * factor;
  }

  int follower_of(const CouplingEquation& equation) {
    int unmarked = -1;
    for (const int j : candidates_of(equation)) {
      if (joint(j).independent == std::optional<bool>(false)) return j;
      if (unmarked < 0 && !joint(j).independent) unmarked = j;
    }
    if (unmarked >= 0) {
      diagnostics_.note(equation.place,
                        equation.what + ": none of its joints is marked independent=\"false\": \"" +
                            joint(unmarked).name + "\" follows",
                        "mark the joint that is not driven, if this is another",
                        "couplings whose follower has been chosen");
    }
    return unmarked;
  }

  std::vector<int> candidates_of(const CouplingEquation& equation) const {
    std::vector<int> candidates = equation.preferred;
    for (const auto& [j, factor] : equation.factors) {
      if (std::find(candidates.begin(), candidates.end(), j) == candidates.end()) candidates.push_back(j);
    }
    std::erase_if(candidates, [&](int j) { return equation.factors.count(j) == 0; });
    return candidates;
  }

  void couple(int follower, const CouplingEquation& equation) {
    Coupled coupled;
    coupled.place = equation.place;
    for (const auto& [j, factor] : equation.factors) {
      if (j != follower && !vanishes(factor)) coupled.terms.push_back({{joint(j).name, equation.place}, factor});
    }
    couple_joint(robot_.joints[static_cast<std::size_t>(follower)], coupled, equation.what, diagnostics_);
  }

  const Joint& joint(int j) const { return robot_.joints[static_cast<std::size_t>(j)]; }

  const UrdfValues& values_;
  Diagnostics& diagnostics_;
  Robot& robot_;
  std::map<int, int> joint_above_;  // by link
  std::vector<CouplingEquation> equations_;
  std::map<int, CouplingEquation> solved_;  // by the joint that follows
};

}  // namespace

void read_urdf_marks(const FileNode& root, const UrdfValues& values, Robot& robot) {
  std::size_t j = 0;
  for (const FileNode* element : root.elements("joint")) {
    Joint& joint = robot.joints[j++];
    for (const FileAttribute& a : element->attributes) {
      const std::string what = "joint \"" + joint.name + "\"";
      const std::string name = a.name;
      if (name == "independent") {
        joint.independent = flag_in({a.text, {element->place, what + ", independent"}}, values.context().diagnostics,
                                    "write independent=\"false\" if it follows other joints");
      } else if (const std::string hint = hint_for_unknown(name, {"independent"}, "attributes");
                 hint.starts_with("did you mean")) {
        values.context().diagnostics.error(element->place, what + ": unknown attribute \"" + name + "\"", hint);
      }
    }
  }
}

void read_urdf_couplings(const FileNode& root, const UrdfValues& values, Robot& robot) {
  CouplingReader(values, robot).read(root);
}

}  // namespace flatdyn
