// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/linear_loops.hpp"

#include <fmt/ranges.h>

#include <algorithm>

#include "base/diagnostics/nearest.hpp"
#include "graph/mod_p.hpp"
#include "robot/model/body_poses.hpp"
#include "robot/model/dependent_joints.hpp"
#include "robot/model/loop_axes.hpp"
#include "robot/model/loop_closure.hpp"
#include "robot/model/loop_sample.hpp"

namespace flatdyn {
namespace {

using Arithmetic = ModPArithmetic<>;
using F = Arithmetic::Scalar;
using Point = Arithmetic::CirclePoint;

// The loop in the tree that is left when it is cut, all joints moving by themselves.
struct CutLoop {
  Mechanism tree;
  LinkFrame ends[2];             // the points that meet
  std::vector<int> dependent;    // bodies
  std::vector<int> independent;  // bodies of the loop that turn, too
};

// A dependent joint's angle: by a multiple of each independent one's, and quarter turns.
struct Candidate {
  std::vector<int> factors;  // by entry of CutLoop::independent; -1, 0, 1
  int quarters = 0;          // 0 to 3
};

Point sum(const Point& a, const Point& b) { return {a.c * b.c - a.s * b.s, a.s * b.c + a.c * b.s}; }

Point quarter_turns(int count) {
  static const int kCosines[] = {1, 0, -1, 0}, kSines[] = {0, 1, 0, -1};
  const auto entry = [](int x) { return x < 0 ? -F(1) : F(static_cast<std::uint64_t>(x)); };
  return {entry(kCosines[count]), entry(kSines[count])};
}

// All factors and quarter turns, simplest first.
std::vector<Candidate> all_candidates(std::size_t joints) {
  std::vector<Candidate> all = {{}};
  for (std::size_t k = 0; k < joints; ++k) {
    std::vector<Candidate> longer;
    for (const int factor : {0, 1, -1}) {
      for (Candidate candidate : all) {
        candidate.factors.push_back(factor);
        longer.push_back(std::move(candidate));
      }
    }
    all = std::move(longer);
  }
  std::vector<Candidate> turned;
  for (int quarters = 0; quarters < 4; ++quarters) {
    for (Candidate candidate : all) {
      candidate.quarters = quarters;
      turned.push_back(std::move(candidate));
    }
  }
  return turned;
}

// One random position of all joints but the dependent ones.
class RandomPosition {
 public:
  RandomPosition(const CutLoop& loop, std::uint64_t seed)
      : loop_(loop), arithmetic_(seed), field_(mechanism_over(loop.tree, arithmetic_)) {
    for (int i = 0; i < field_.body_count(); ++i) {
      const F value = arithmetic_.input({InputKind::q, i});
      const Point turned = arithmetic_.point(value);
      points_.push_back({turned.c, turned.s, value});
    }
  }

  bool closes(const std::vector<Candidate>& candidates) {
    for (std::size_t d = 0; d < candidates.size(); ++d) {
      Point total = quarter_turns(candidates[d].quarters);
      for (std::size_t k = 0; k < loop_.independent.size(); ++k) {
        const JointPoint<F>& leader = points_[static_cast<std::size_t>(loop_.independent[k])];
        const int factor = candidates[d].factors[k];
        if (factor != 0) total = sum(total, {leader.c, factor < 0 ? -leader.s : leader.s});
      }
      JointPoint<F>& point = points_[static_cast<std::size_t>(loop_.dependent[d])];
      point.c = total.c;
      point.s = total.s;
    }
    const std::vector<Pose3<F>> poses = body_poses(field_, points_);
    const Vector3<F> gap = minus(place(poses, loop_.ends[0]), place(poses, loop_.ends[1]));
    return std::all_of(gap.begin(), gap.end(), [](const F& x) { return x == F(0); });
  }

 private:
  Vector3<F> place(const std::vector<Pose3<F>>& poses, const LinkFrame& end) {
    const NumberMap<Arithmetic> number(loop_.tree.symbols, arithmetic_);
    const Vector3<F> p = {number(end.p[0]), number(end.p[1]), number(end.p[2])};
    if (end.body < 0) return p;
    const Pose3<F>& body = poses[static_cast<std::size_t>(end.body)];
    return plus(body.p, times(body.R, p));
  }

  const CutLoop& loop_;
  Arithmetic arithmetic_;
  MechanismOver<F> field_;
  std::vector<JointPoint<F>> points_;
};

using Candidates = std::vector<Candidate>;

bool holds_a_joint_still(const Candidates& solution) {
  return std::any_of(solution.begin(), solution.end(), [](const Candidate& candidate) {
    return std::all_of(candidate.factors.begin(), candidate.factors.end(), [](int factor) { return factor == 0; });
  });
}

// All angles of the dependent joints for which the loop stays closed. Two joints at most: more are not determined by a
// loop in a plane.
std::vector<Candidates> linear_solutions(const CutLoop& loop) {
  const std::vector<Candidate> all = all_candidates(loop.independent.size());
  RandomPosition first(loop, 1), second(loop, 2), third(loop, 3);
  std::vector<Candidates> solutions;
  const auto try_out = [&](const Candidates& tried) {
    if (first.closes(tried) && second.closes(tried) && third.closes(tried)) solutions.push_back(tried);
  };
  for (const Candidate& a : all) {
    if (loop.dependent.size() == 1) {
      try_out({a});
      continue;
    }
    for (const Candidate& b : all) try_out({a, b});
  }
  return solutions;
}

class LinearLoopCoupler {
 public:
  LinearLoopCoupler(Robot& robot, Diagnostics& diagnostics) : robot_(robot), diagnostics_(diagnostics) {}

  // Whether its dependent joints are coupled now.
  bool settle(const Loop& loop) {
    CutLoop cut;
    cut.tree = make_mechanism(open_tree());
    if (!find_ends(loop, cut) || !find_joints(loop, cut) || !is_determined_by_points(loop, robot_, diagnostics_))
      return false;
    constexpr std::size_t kMostDependent = 2, kMostIndependent = 3;
    std::vector<Candidates> solutions;
    if (cut.dependent.size() <= kMostDependent && cut.independent.size() <= kMostIndependent) {
      solutions = linear_solutions(cut);
    }
    // Folded, opposite links lie on each other and turn as one: that is not what the loop is there for.
    std::erase_if(solutions, holds_a_joint_still);
    if (solutions.size() > 1) {
      diagnostics_.error(
          loop.place, name_of(loop) + ": it does not determine its dependent joints: it stays closed in several ways",
          "check its points and lengths, and which joints depend on the others");
    }
    if (solutions.size() != 1) return false;
    for (std::size_t d = 0; d < cut.dependent.size(); ++d) couple(loop, cut, d, solutions[0][d]);
    return true;
  }

 private:
  // Every joint moves by itself.
  Robot open_tree() const {
    Robot tree = robot_;
    tree.loops.clear();
    for (Joint& joint : tree.joints) joint.coupled.reset();
    return tree;
  }

  Joint& joint_of(const CutLoop& cut, int body) {
    const std::string& name = cut.tree.bodies[static_cast<std::size_t>(body)].joint;
    return *std::find_if(robot_.joints.begin(), robot_.joints.end(),
                         [&name](const Joint& joint) { return joint.name == name; });
  }

  bool find_ends(const Loop& loop, CutLoop& cut) {
    for (std::size_t end = 0; end < 2; ++end) {
      const auto link = std::find_if(cut.tree.links.begin(), cut.tree.links.end(),
                                     [&](const LinkFrame& each) { return each.link == loop.links[end].name; });
      if (link == cut.tree.links.end()) {
        std::vector<std::string> known;
        for (const LinkFrame& each : cut.tree.links) known.push_back(each.link);
        diagnostics_.error(loop.links[end].place, "loop: there is no link \"" + loop.links[end].name + "\"",
                           hint_for_unknown(loop.links[end].name, known, "links"));
        return false;
      }
      cut.ends[end] = *link;
      cut.ends[end].p = expanded(link->p + link->R * loop.points[end]);
    }
    return true;
  }

  // Joints of the loop: on the paths from its ends to the base, but not on both.
  bool find_joints(const Loop& loop, CutLoop& cut) {
    const std::vector<int> a = path_to(cut.tree, cut.ends[0].body), b = path_to(cut.tree, cut.ends[1].body);
    std::vector<int> bodies;
    const auto is_on = [](const std::vector<int>& path, int body) {
      return std::find(path.begin(), path.end(), body) != path.end();
    };
    std::copy_if(a.begin(), a.end(), std::back_inserter(bodies), [&](int body) { return !is_on(b, body); });
    std::copy_if(b.begin(), b.end(), std::back_inserter(bodies), [&](int body) { return !is_on(a, body); });
    std::sort(bodies.begin(), bodies.end());
    if (bodies.empty()) {
      diagnostics_.error(loop.place, name_of(loop) + ": no joint moves its two ends against each other",
                         "name two links that joints hold apart");
      return false;
    }
    std::vector<std::string> known;
    for (const int body : bodies) known.push_back(cut.tree.bodies[static_cast<std::size_t>(body)].joint);
    for (const Reference& joint : loop.dependent) {
      const auto found = std::find(known.begin(), known.end(), joint.name);
      if (found == known.end()) {
        refuse_dependent(joint, known);
        return false;
      }
      cut.dependent.push_back(bodies[static_cast<std::size_t>(found - known.begin())]);
    }
    for (const int body : bodies) {
      const bool turns = !cut.tree.bodies[static_cast<std::size_t>(body)].prismatic;
      if (turns && !is_on(cut.dependent, body)) cut.independent.push_back(body);
    }
    return check_dependent(loop, cut);
  }

  void refuse_dependent(const Reference& name, const std::vector<std::string>& known) {
    const auto joint = std::find_if(robot_.joints.begin(), robot_.joints.end(),
                                    [&name](const Joint& each) { return each.name == name.name; });
    const std::string what = "loop, dependent: \"" + name.name + "\" is ";
    if (joint == robot_.joints.end()) {
      diagnostics_.error(name.place, what + "no joint of it that moves",
                         hint_for_unknown(name.name, known, "joints of the loop"));
    } else if (joint->type == JointType::fixed) {
      diagnostics_.error(name.place, what + "fixed or held: it cannot follow the others",
                         "hold the joints that it follows instead");
    } else {
      diagnostics_.error(name.place, what + "no joint of it that moves",
                         fmt::format("it moves both ends, or none: joints of the loop are {}", fmt::join(known, ", ")));
    }
  }

  bool check_dependent(const Loop& loop, const CutLoop& cut) {
    if (loop.dependent.empty()) {
      diagnostics_.error(loop.place, name_of(loop) + ": no joint depends on the others",
                         loop.is_marked ? "mark joints of the loop independent=\"false\": those that are not driven"
                                        : "write dependent = [\"...\"]: the joints of the loop that are not driven");
      return false;
    }
    for (const int body : cut.dependent) {
      const Joint& joint = joint_of(cut, body);
      if (!joint.coupled) continue;
      diagnostics_.error(loop.place, "loop, dependent: joint \"" + joint.name + "\" follows others already",
                         "name each joint once, in one loop or by its position");
      return false;
    }
    return true;
  }

  void couple(const Loop& loop, const CutLoop& cut, std::size_t d, const Candidate& candidate) {
    Coupled coupled;
    coupled.place = loop.place;
    coupled.offset = (candidate.quarters == 3 ? -1 : candidate.quarters) * GiNaC::Pi / 2;
    for (std::size_t k = 0; k < candidate.factors.size(); ++k) {
      if (candidate.factors[k] != 0) add_leader(joint_of(cut, cut.independent[k]), candidate.factors[k], coupled);
    }
    joint_of(cut, cut.dependent[d]).coupled = coupled;
  }

  // Multiples of a joint's position, which is not its coordinate where it is coupled itself.
  static void add_leader(const Joint& leader, const Number& factor, Coupled& coupled) {
    if (!leader.coupled) {
      coupled.terms.push_back({{leader.name, coupled.place}, factor});
      return;
    }
    coupled.offset += factor * leader.coupled->offset;
    for (const Coupled::Term& term : leader.coupled->terms) {
      coupled.terms.push_back({term.joint, factor * term.factor});
    }
  }

  Robot& robot_;
  Diagnostics& diagnostics_;
};

}  // namespace

void couple_linear_loops(Robot& robot, Diagnostics& diagnostics) {
  close_at_zero(robot);
  Diagnostics choices;
  find_dependent_joints(robot, choices);
  const auto tell = [&] {
    for (const Diagnostic& choice : choices.all()) diagnostics.add(choice);
  };
  if (choices.has_errors()) return tell();
  std::erase_if(robot.loops, [&](const Loop& loop) { return LinearLoopCoupler(robot, diagnostics).settle(loop); });
  if (diagnostics.has_errors()) return;
  if (!robot.loops.empty()) check_loops(robot, open_mechanism(robot), diagnostics);
  if (!diagnostics.has_errors()) tell();
}

}  // namespace flatdyn
