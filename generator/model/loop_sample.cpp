// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/loop_sample.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "model/joint_points.hpp"
#include "model/rational_rotation.hpp"

namespace flatdyn {
namespace {

using Real = LoopSample::Real;

std::size_t entry(int i) { return static_cast<std::size_t>(i); }

Mechanism with_loop(Mechanism tree, const LoopClosure& loop) {
  tree.loops = {loop};
  return tree;
}

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
    const Body& joint = tree.bodies[entry(body)];
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

bool is_zero_row(const Matrix<Real>& J, int row) {
  for (int k = 0; k < J.cols(); ++k) {
    if (!LoopSample::is_zero(J(row, k))) return false;
  }
  return true;
}

void find_rows(const Mechanism& tree, LoopClosure& loop) {
  const Matrix<Real> J = LoopSample(tree, loop).jacobian();
  for (int row = 0; row < J.rows(); ++row) {
    if (!is_zero_row(J, row)) loop.rows.push_back(entry(row));
  }
}

}  // namespace

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

Mechanism open_mechanism(const Robot& robot) {
  Robot tree = robot;
  tree.loops.clear();
  return make_mechanism(tree);
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

bool LoopSample::is_zero(const Real& x) { return abs(x) < Real("1e-30"); }

Real LoopSample::drawn(const Input& input) {
  const int k = 7 * input.index + (input.kind == InputKind::parameter ? 3 : 0);
  return Real(3) / 10 + Real(k + 1) * Real("0.6180339887498948482") -
         floor(Real(k + 1) * Real("0.6180339887498948482"));
}

LoopSample::LoopSample(const Mechanism& tree, const LoopClosure& loop)
    : arithmetic_(drawn),
      field_(mechanism_over(with_loop(tree, loop), arithmetic_)),
      points_(joint_points(tree, arithmetic_)) {}

Matrix<Real> LoopSample::jacobian() const { return geometry().jacobian(field_.loops.front()); }
Matrix<Real> LoopSample::rows() const { return geometry().rows(field_.loops.front()); }
Vector3<Real> LoopSample::gap() const { return geometry().gap(field_.loops.front()); }

bool depends_on(const Matrix<Real>& J, int position) {
  for (int row = 0; row < J.rows(); ++row) {
    if (!LoopSample::is_zero(J(row, position))) return true;
  }
  return false;
}

}  // namespace flatdyn
