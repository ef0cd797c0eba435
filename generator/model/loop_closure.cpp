// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/loop_closure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "flatdyn/reference/real50.hpp"
#include "graph/arithmetic.hpp"
#include "model/field_loops.hpp"
#include "model/joint_points.hpp"
#include "model/rational_rotation.hpp"

namespace flatdyn {
namespace {

using Real = reference::Real50;
using RealTree = RealArithmetic<Real>;

// Frames that are turned by any angles are rational to 40 digits, so what is zero in a plane is nearly so.
bool is_zero(const Real& x) { return abs(x) < Real("1e-30"); }

// Somewhere, the symbols being something: none a multiple of another.
Real drawn(const Input& input) {
  const int k = 7 * input.index + (input.kind == InputKind::parameter ? 3 : 0);
  return Real(3) / 10 + Real(k + 1) * Real("0.6180339887498948482") -
         floor(Real(k + 1) * Real("0.6180339887498948482"));
}

std::size_t index(int i) { return static_cast<std::size_t>(i); }

LoopClosure::End end_of(const Mechanism& tree, const std::string& name, const Vec3& point) {
  const auto link =
      std::find_if(tree.links.begin(), tree.links.end(), [&name](const LinkFrame& each) { return each.link == name; });
  return {link->body, expanded(link->p + link->R * rationalised(point))};
}

// The body that all of a loop moves with, and the bodies from there to each end.
struct Chains {
  int carrier = -1;
  std::array<std::vector<int>, 2> ways;
};

Chains chains_of(const Mechanism& tree, const LoopClosure& loop) {
  Chains chains{-1, {way_to(tree, loop.ends[0].body), way_to(tree, loop.ends[1].body)}};
  auto& [a, b] = chains.ways;
  std::size_t common = 0;
  while (common < a.size() && common < b.size() && a[common] == b[common]) ++common;
  if (common > 0) chains.carrier = a[common - 1];
  for (std::vector<int>& way : chains.ways) way.erase(way.begin(), way.begin() + static_cast<std::ptrdiff_t>(common));
  return chains;
}

// Those of the first joint that turns, seen from the carrier with all joints before it at 0, which slide: in those a
// loop in a plane has two components.
std::optional<Mat3> axes_of_turning(const Mechanism& tree, const std::vector<int>& chain) {
  Mat3 axes = identity_matrix();
  for (const int body : chain) {
    const Body& joint = tree.bodies[index(body)];
    axes = expanded(axes * joint_axes(joint));
    if (!joint.prismatic) return axes;
  }
  return std::nullopt;
}

Mat3 axes_of(const Mechanism& tree, const std::array<std::vector<int>, 2>& ways) {
  const bool longer = ways[1].size() >= ways[0].size();
  for (const std::vector<int>* way : {&ways[longer], &ways[!longer]}) {
    if (const std::optional<Mat3> axes = axes_of_turning(tree, *way)) return *axes;
  }
  return identity_matrix();
}

// The tree with this one loop, its joints at a position like any other.
class RandomTree {
 public:
  RandomTree(const Mechanism& tree, const LoopClosure& loop) : arithmetic_(drawn) {
    Mechanism closed = tree;
    closed.loops = {loop};
    field_ = field_mechanism(closed, arithmetic_);
    points_ = joint_points(closed, arithmetic_);
  }

  Matrix<Real> jacobian() const { return geometry().jacobian(field_.loops.front()); }
  Matrix<Real> rows() const { return geometry().rows(field_.loops.front()); }
  Vector3<Real> gap() const { return geometry().gap(field_.loops.front()); }

 private:
  LoopGeometry<Real, Real> geometry() const { return {field_, points_}; }

  RealTree arithmetic_;
  FieldMechanism<Real> field_;
  std::vector<JointPoint<Real>> points_;
};

bool is_zero_row(const Matrix<Real>& J, int row) {
  for (int k = 0; k < J.cols(); ++k) {
    if (!is_zero(J(row, k))) return false;
  }
  return true;
}

void find_rows(const Mechanism& tree, LoopClosure& loop) {
  const Matrix<Real> J = RandomTree(tree, loop).jacobian();
  for (int row = 0; row < J.rows(); ++row) {
    if (!is_zero_row(J, row)) loop.rows.push_back(index(row));
  }
}

LoopClosure closure_of(const Loop& written, const Mechanism& tree) {
  LoopClosure loop;
  for (std::size_t e = 0; e < 2; ++e) loop.ends[e] = end_of(tree, written.links[e].name, written.points[e]);
  const Chains chains = chains_of(tree, loop);
  loop.carrier = chains.carrier;
  loop.axes = axes_of(tree, chains.ways);
  find_rows(tree, loop);
  for (const Reference& joint : written.dependent) {
    for (int k = 0; k < tree.position_count(); ++k) {
      if (tree.joint_at(k).joint == joint.name) loop.dependent.push_back(k);
    }
  }
  return loop;
}

// Every joint a coordinate: as where joints are coupled, with A = 1.
Mechanism with_coupling(Mechanism tree) {
  if (tree.is_coupled()) return tree;
  const std::size_t n = tree.bodies.size();
  tree.coupling.assign(n, std::vector<Number>(n, 0));
  tree.offsets.assign(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    tree.coupling[i][i] = 1;
    tree.coordinates.push_back(static_cast<int>(i));
  }
  return tree;
}

bool depends_on(const Matrix<Real>& J, int position) {
  for (int row = 0; row < J.rows(); ++row) {
    if (!is_zero(J(row, position))) return true;
  }
  return false;
}

// Whether all joints of the loop are its own or known before.
bool finds_its_joints(const Mechanism& tree, const LoopClosure& loop, const std::vector<bool>& unknown) {
  const Matrix<Real> J = RandomTree(tree, loop).rows();
  for (int k = 0; k < J.cols(); ++k) {
    const bool own = std::find(loop.dependent.begin(), loop.dependent.end(), k) != loop.dependent.end();
    if (!own && unknown[index(k)] && depends_on(J, k)) return false;
  }
  return true;
}

// The loops in an order in which each finds all that it depends on; without those for which there is none.
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

std::string name_of(const Loop& loop) {
  return "loop between \"" + loop.links[0].name + "\" and \"" + loop.links[1].name + "\": ";
}

// What keeps one loop, taken by itself, from determining its dependent joints.
class LoopCheck {
 public:
  LoopCheck(const Mechanism& tree, const Loop& written, Diagnostics& diagnostics)
      : tree_(tree), written_(written), diagnostics_(diagnostics), loop_(closure_of(written, tree)) {}

  void run() {
    const RandomTree random(tree_, loop_);
    if (!can_close(random.gap())) {
      error("its points can never meet: they lie apart in a direction in which no joint moves them",
            "check from and to: in a loop in a plane, both have the same height above it");
    } else if (moving_joints(random.rows()) < loop_.rows.size()) {
      error(fmt::format("it takes {} coordinates, which is more than it has joints", loop_.rows.size()),
            "name links that more joints hold apart; joints that move both ends do not count");
    } else if (loop_.rows.size() != loop_.dependent.size()) {
      error(fmt::format("it takes {} coordinate{}, and names {} dependent joint{}", loop_.rows.size(),
                        loop_.rows.size() == 1 ? "" : "s", loop_.dependent.size(),
                        loop_.dependent.size() == 1 ? "" : "s"),
            fmt::format("name {} of its joints: those that are not driven", loop_.rows.size()));
    } else if (!is_driven(random.rows())) {
      error("nothing drives it: no joint but its dependent ones moves its points against each other",
            "leave one of them out of `dependent`, or make them fixed");
    } else if (is_zero(determinant(columns_of(random.rows(), loop_.dependent)))) {
      error("it does not determine its dependent joints: they could move while the others stand still",
            "name others of its joints");
    }
  }

 private:
  bool can_close(const Vector3<Real>& gap) const {
    for (std::size_t row = 0; row < 3; ++row) {
      const bool moves = std::find(loop_.rows.begin(), loop_.rows.end(), row) != loop_.rows.end();
      if (!moves && !is_zero(gap[row])) return false;
    }
    return true;
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
    diagnostics_.error(written_.place, name_of(written_) + what, hint);
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
    diagnostics.error(joint->place, name_of(robot.loops[l]) + "\"" + joint->name + "\" is named as dependent before",
                      "name each joint once, in one loop; a loop that is closed twice is one loop");
  }
}

std::vector<LoopClosure> closures(const Robot& robot, const Mechanism& tree) {
  std::vector<LoopClosure> loops;
  for (const Loop& loop : robot.loops) loops.push_back(closure_of(loop, tree));
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
    diagnostics.unsupported(robot.loops[l].place,
                            name_of(robot.loops[l]) +
                                "its joints depend on those of another loop, and those on its own: loops that have to "
                                "be solved together are not supported yet",
                            "choose the dependent joints so that one loop is determined without the other");
  }
}

}  // namespace flatdyn
