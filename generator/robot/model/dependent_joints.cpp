// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/dependent_joints.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "robot/model/loop_sample.hpp"

namespace flatdyn {
namespace {

using Real = LoopSample::Real;
using Positions = std::vector<int>;  // entries of q

const Joint& joint_at(const Robot& robot, const Mechanism& tree, int position) {
  const std::string& name = tree.joint_at(position).joint;
  return *std::find_if(robot.joints.begin(), robot.joints.end(),
                       [&name](const Joint& joint) { return joint.name == name; });
}

// A loop whose dependent joints are to be found.
struct OpenLoop {
  Loop* written;
  Matrix<Real> rows;
  Positions own;  // joints between its ends that move them relative to each other
};

OpenLoop open_loop(Loop& written, const Mechanism& tree) {
  const LoopClosure closure = closure_of(written, tree);
  OpenLoop loop{&written, LoopSample(tree, closure).rows(), {}};
  std::set<int> bodies;
  for (const LoopClosure::End& end : closure.ends) {
    for (const int body : path_to(tree, end.body)) {
      if (!bodies.insert(body).second) bodies.erase(body);  // it moves both ends
    }
  }
  for (int k = 0; k < tree.position_count(); ++k) {
    if (bodies.count(tree.body_at(k)) > 0 && depends_on(loop.rows, k)) loop.own.push_back(k);
  }
  return loop;
}

class DependentJoints {
 public:
  DependentJoints(Robot& robot, Diagnostics& diagnostics)
      : robot_(robot), diagnostics_(diagnostics), tree_(with_coupling(open_mechanism(robot))) {
    for (Loop& loop : robot.loops) {
      if (loop.is_marked) loops_.push_back(open_loop(loop, tree_));
    }
  }

  void find() {
    give_marked();
    for (OpenLoop& loop : loops_) {
      if (loop.written->dependent.empty()) give_unmarked(loop);
    }
  }

 private:
  bool is_marked(int position, bool independent) const {
    return joint_at(robot_, tree_, position).independent == std::optional<bool>(independent);
  }

  Positions marked_of(const OpenLoop& loop) const {
    Positions marked;
    std::copy_if(loop.own.begin(), loop.own.end(), std::back_inserter(marked),
                 [this](int k) { return is_marked(k, false) && taken_.count(k) == 0; });
    return marked;
  }

  void give(OpenLoop& loop, Positions positions) {
    std::sort(positions.begin(), positions.end());
    taken_.insert(positions.begin(), positions.end());
    for (const int k : positions) loop.written->dependent.push_back({tree_.joint_at(k).joint, loop.written->place});
  }

  // Assigns marked joints in an order in which the loops can be solved one by one: a loop takes all marked joints that
  // are left to it if it determines exactly as many. If no such loop remains, the others take the marked joints left to
  // them.
  void give_marked() {
    std::vector<OpenLoop*> left;
    for (OpenLoop& loop : loops_) left.push_back(&loop);
    for (bool found = true; found;) {
      const auto solved = std::find_if(left.begin(), left.end(), [this](const OpenLoop* loop) {
        const std::size_t count = marked_of(*loop).size();
        return count > 0 && count == static_cast<std::size_t>(loop->rows.rows());
      });
      found = solved != left.end();
      if (!found) break;
      give(**solved, marked_of(**solved));
      left.erase(solved);
    }
    for (OpenLoop* loop : left) give(*loop, marked_of(*loop));
  }

  std::ptrdiff_t loops_with(int position) const {
    return std::count_if(loops_.begin(), loops_.end(), [position](const OpenLoop& loop) {
      return std::find(loop.own.begin(), loop.own.end(), position) != loop.own.end();
    });
  }

  void give_unmarked(OpenLoop& loop) {
    Positions candidates;
    std::copy_if(loop.own.rbegin(), loop.own.rend(), std::back_inserter(candidates),
                 [this](int k) { return !is_marked(k, true) && taken_.count(k) == 0; });
    const auto rank = [this](int k) { return std::pair(joint_at(robot_, tree_, k).driven, loops_with(k)); };
    std::stable_sort(candidates.begin(), candidates.end(), [&rank](int a, int b) { return rank(a) < rank(b); });
    give(loop, independent_columns(loop.rows, candidates));
    if (loop.written->dependent.empty()) return;  // the check of the loop reports the reason
    std::vector<std::string> names;
    for (const Reference& joint : loop.written->dependent) names.push_back("\"" + joint.name + "\"");
    diagnostics_.note(
        loop.written->place,
        fmt::format("{}: no mark says which of its joints follow: {} {} from the others", name_of(*loop.written),
                    fmt::join(names, " and "), names.size() == 1 ? "follows" : "follow"),
        "in a URDF, mark the joints that are not driven independent=\"false\", if these are others; in MJCF, "
        "let actuators drive the others",
        "loops whose dependent joints have been chosen");
  }

  Robot& robot_;
  Diagnostics& diagnostics_;
  Mechanism tree_;
  std::vector<OpenLoop> loops_;
  std::set<int> taken_;
};

bool is_dependent(const Robot& robot, const Joint& joint) {
  return std::any_of(robot.loops.begin(), robot.loops.end(), [&joint](const Loop& loop) {
    return std::any_of(loop.dependent.begin(), loop.dependent.end(),
                       [&joint](const Reference& each) { return each.name == joint.name; });
  });
}

void check_marks(const Robot& robot, Diagnostics& diagnostics) {
  for (const Joint& joint : robot.joints) {
    if (joint.type == JointType::fixed || !joint.independent) continue;
    const bool follows = joint.coupled.has_value() || is_dependent(robot, joint);
    if (*joint.independent == !follows) continue;
    const std::string what = "joint \"" + joint.name + "\" is marked independent=\"" +
                             (*joint.independent ? "true\", and follows others" : "false\", and follows no others");
    diagnostics.error(joint.place, what,
                      *joint.independent
                          ? "delete the mark, or what couples the joint"
                          : "add the <loop> or <coupling> that moves it, or mark it independent=\"true\"");
  }
}

}  // namespace

void find_dependent_joints(Robot& robot, Diagnostics& diagnostics) {
  const bool any = std::any_of(robot.loops.begin(), robot.loops.end(), [](const Loop& loop) { return loop.is_marked; });
  if (any) DependentJoints(robot, diagnostics).find();
  check_marks(robot, diagnostics);
}

}  // namespace flatdyn
