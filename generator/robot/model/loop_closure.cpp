// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/loop_closure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "robot/model/loop_axes.hpp"
#include "robot/model/loop_sample.hpp"

namespace flatdyn {
namespace {

using Real = LoopSample::Real;

bool is_zero(const Real& x) { return LoopSample::is_zero(x); }

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// Whether all joints of the loop are its own or known before.
bool finds_its_joints(const Mechanism& tree, const LoopClosure& loop, const std::vector<bool>& unknown) {
  const Matrix<Real> J = LoopSample(tree, loop).rows();
  for (int k = 0; k < J.cols(); ++k) {
    const bool own = std::find(loop.dependent.begin(), loop.dependent.end(), k) != loop.dependent.end();
    if (!own && unknown[index(k)] && depends_on(J, k)) return false;
  }
  return true;
}

// The loops in an order in which each comes after those that it depends on; loops without such an order are left out.
std::vector<std::size_t> sorted(const Mechanism& tree, const std::vector<LoopClosure>& loops) {
  std::vector<std::size_t> order;
  std::vector<bool> unknown(index(tree.position_count()), false);
  for (const LoopClosure& loop : loops) {
    for (const int k : loop.dependent) unknown[index(k)] = true;
  }
  std::vector<bool> done(loops.size(), false);
  for (bool found = true; found;) {
    found = false;
    for (std::size_t l = 0; l < loops.size(); ++l) {
      if (done[l] || !finds_its_joints(tree, loops[l], unknown)) continue;
      done[l] = found = true;
      order.push_back(l);
      for (const int k : loops[l].dependent) unknown[index(k)] = false;
    }
  }
  return order;
}

// Finds why one loop, taken by itself, does not determine its dependent joints.
class LoopCheck {
 public:
  LoopCheck(const Mechanism& tree, const Loop& written, Diagnostics& diagnostics)
      : tree_(tree), written_(written), diagnostics_(diagnostics), loop_(closure_of(written, tree)) {}

  void run() {
    const LoopSample sample(tree_, loop_);
    if (loop_.aligns_axes() && !can_align(sample)) return;
    if (!can_close(sample.gap())) {
      error("its points can never meet: they lie apart in a direction in which no joint moves them",
            std::string("check ") + (written_.is_marked ? "the origins of its two ends" : "from and to") +
                ": in a loop in a plane, both have the same height above it");
    } else if (moving_joints(sample.rows()) < loop_.rows.size()) {
      error(fmt::format("it takes {} coordinates, which is more than it has joints", loop_.rows.size()),
            "name links that more joints hold apart; joints that move both ends do not count");
    } else if (loop_.rows.size() != loop_.dependent.size()) {
      refuse_count();
    } else if (!is_driven(sample.rows())) {
      error("nothing drives it: no joint but its dependent ones moves its points against each other",
            written_.is_marked ? "mark one of them independent=\"true\", or make them fixed"
                               : "leave one of them out of `dependent`, or make them fixed");
    } else if (is_zero(determinant(columns_of(sample.rows(), loop_.dependent)))) {
      error("it does not determine its dependent joints: they could move while the others stand still",
            written_.is_marked ? "mark others of its joints independent=\"false\"" : "name others of its joints");
    }
  }

 private:
  bool stays_open(std::size_t row, const std::vector<Real>& gap) const {
    const bool moves = std::find(loop_.rows.begin(), loop_.rows.end(), row) != loop_.rows.end();
    return !moves && !is_zero(gap[row]);
  }

  bool can_close(const std::vector<Real>& gap) const {
    return !stays_open(0, gap) && !stays_open(1, gap) && !stays_open(2, gap);
  }

  // For a loop along axes in space.
  bool can_align(const LoopSample& sample) {
    const std::vector<Real> gap = sample.gap();
    const Matrix<Real> rows = sample.rows();
    std::vector<int> all(index(rows.cols()));
    std::iota(all.begin(), all.end(), 0);
    const std::size_t rank = independent_columns(rows, all).size(), joints = moving_joints(rows);
    if (stays_open(3, gap) || stays_open(4, gap)) {
      error("its axes are never parallel: no joint turns them towards each other",
            "check the axes: the loop's joints have to turn one onto the other");
      return false;
    }
    if (joints > loop_.rows.size() && rank == loop_.rows.size()) return true;
    const std::string has = joints > loop_.rows.size() ? fmt::format("its joints change only {} of them freely", rank)
                                                       : fmt::format("has {} joints for them", joints);
    diagnostics_.unsupported(
        written_.place,
        fmt::format("{}: along its axes it takes {} coordinates, and {}: it stands still, or moves only because its "
                    "lengths and angles are special (overconstrained), which is not supported",
                    name_of(written_), loop_.rows.size(), has),
        "cut the loop at a ball joint, if it has one; if it lies in a plane, its axes have to be exactly parallel");
    return false;
  }

  void refuse_count() {
    const std::size_t wanted = loop_.rows.size(), found = loop_.dependent.size();
    error(fmt::format("it takes {} coordinate{}, and {} {} dependent joint{}", wanted, wanted == 1 ? "" : "s",
                      written_.is_marked ? "marks leave it" : "names", found, found == 1 ? "" : "s"),
          fmt::format("{} {} of its joints{}: those that are not driven", written_.is_marked ? "mark" : "name", wanted,
                      written_.is_marked ? " independent=\"false\"" : ""));
  }

  static std::size_t moving_joints(const Matrix<Real>& J) {
    std::size_t count = 0;
    for (int k = 0; k < J.cols(); ++k) count += depends_on(J, k);
    return count;
  }

  bool is_driven(const Matrix<Real>& J) const {
    for (int k = 0; k < J.cols(); ++k) {
      const bool own = std::find(loop_.dependent.begin(), loop_.dependent.end(), k) != loop_.dependent.end();
      if (!own && depends_on(J, k)) return true;
    }
    return false;
  }

  void error(const std::string& what, const std::string& hint) {
    diagnostics_.error(written_.place, name_of(written_) + ": " + what, hint);
  }

  const Mechanism& tree_;
  const Loop& written_;
  Diagnostics& diagnostics_;
  LoopClosure loop_;
};

// The first name that another loop, or this one, has named before.
const Reference* named_before(const Robot& robot, std::size_t l) {
  std::vector<std::string> before;
  for (std::size_t k = 0; k < l; ++k) {
    for (const Reference& joint : robot.loops[k].dependent) before.push_back(joint.name);
  }
  for (const Reference& joint : robot.loops[l].dependent) {
    if (std::find(before.begin(), before.end(), joint.name) != before.end()) return &joint;
    before.push_back(joint.name);
  }
  return nullptr;
}

// Each loop takes as many coordinates as it names joints: so no joint may count twice.
void check_names(const Robot& robot, Diagnostics& diagnostics) {
  for (std::size_t l = 0; l < robot.loops.size(); ++l) {
    const Reference* joint = named_before(robot, l);
    if (joint == nullptr) continue;
    diagnostics.error(joint->place, name_of(robot.loops[l]) + ": \"" + joint->name + "\" is named as dependent before",
                      "name each joint once, in one loop; a loop that is closed twice is one loop");
  }
}

std::vector<LoopClosure> closures(const Robot& robot, const Mechanism& tree) {
  std::vector<LoopClosure> loops;
  for (const Loop& loop : robot.loops) {
    loops.push_back(closure_of(loop, tree));
    if (loops.back().aligns_axes()) loops.back().sense = sense_of_axes(robot, tree, loops.back());
  }
  return loops;
}

}  // namespace

void add_loops(const Robot& robot, Mechanism& mechanism) {
  if (robot.loops.empty()) return;
  mechanism = with_coupling(std::move(mechanism));
  const std::vector<LoopClosure> written = closures(robot, mechanism);
  std::vector<bool> dependent(index(mechanism.position_count()), false);
  std::vector<LoopClosure> loops;
  for (const std::size_t l : sorted(mechanism, written)) {
    loops.push_back(written[l]);
    for (const int k : written[l].dependent) dependent[index(k)] = true;
  }
  for (int k = 0; k < mechanism.position_count(); ++k) {
    if (!dependent[index(k)]) mechanism.independent.push_back(k);
  }
  mechanism.loops = std::move(loops);
}

void check_loops(const Robot& robot, const Mechanism& open, Diagnostics& diagnostics) {
  if (robot.loops.empty()) return;
  const Mechanism tree = with_coupling(open);
  check_names(robot, diagnostics);
  if (diagnostics.has_errors()) return;
  for (const Loop& loop : robot.loops) LoopCheck(tree, loop, diagnostics).run();
  if (diagnostics.has_errors()) return;
  const std::vector<std::size_t> order = sorted(tree, closures(robot, tree));
  for (std::size_t l = 0; l < robot.loops.size(); ++l) {
    if (std::find(order.begin(), order.end(), l) != order.end()) continue;
    diagnostics.unsupported(
        robot.loops[l].place,
        name_of(robot.loops[l]) +
            ": its joints depend on those of another loop, and those on its own: loops that have to "
            "be solved together are not supported yet",
        "choose the dependent joints so that one loop is determined without the other");
  }
}

bool aligns_axes(const Mechanism& mechanism) {
  return std::any_of(mechanism.loops.begin(), mechanism.loops.end(),
                     [](const LoopClosure& loop) { return loop.aligns_axes(); });
}

}  // namespace flatdyn
