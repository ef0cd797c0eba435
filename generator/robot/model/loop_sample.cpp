// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/loop_sample.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

#include "robot/model/joint_points.hpp"
#include "robot/model/rational_rotation.hpp"
#include "robot/model/spherical_centres.hpp"

namespace flatdyn {
namespace {

using Real = LoopSample::Real;

std::size_t entry(int i) { return static_cast<std::size_t>(i); }

Mechanism with_loop(Mechanism tree, const LoopClosure& loop) {
  tree.loops = {loop};
  return tree;
}

LoopClosure::End end_of(const Mechanism& tree, const std::string& name, const Vec3& point) {
  const LinkFrame& link = frame_of(tree, name);
  return {link.body, expanded(link.p + link.R * rationalised(point))};
}

Vec3 column_of(const Mat3& m, std::size_t k) { return {m[0][k], m[1][k], m[2][k]}; }

// Exactly orthonormal, whatever the axes' lengths.
void set_axes(const Loop& written, const Mechanism& tree, LoopClosure& loop) {
  if (!written.axes) return;
  const Mat3 first = expanded(frame_of(tree, written.links[0].name).R * rotation_onto((*written.axes)[0])),
             second = expanded(frame_of(tree, written.links[1].name).R * rotation_onto((*written.axes)[1]));
  loop.components = 5;
  for (std::size_t k = 0; k < 2; ++k) loop.across[k] = column_of(first, k);
  loop.axis = column_of(second, 2);
}

// The body that all of a loop moves with, and the bodies from there to each end.
struct Chains {
  int carrier = -1;
  std::array<std::vector<int>, 2> paths;
};

Chains chains_of(const Mechanism& tree, const LoopClosure& loop) {
  Chains chains{-1, {path_to(tree, loop.ends[0].body), path_to(tree, loop.ends[1].body)}};
  auto& [a, b] = chains.paths;
  std::size_t common = 0;
  while (common < a.size() && common < b.size() && a[common] == b[common]) ++common;
  if (common > 0) chains.carrier = a[common - 1];
  for (std::vector<int>& path : chains.paths)
    path.erase(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(common));
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

Mat3 axes_of(const Mechanism& tree, const std::array<std::vector<int>, 2>& paths) {
  const bool longer = paths[1].size() >= paths[0].size();
  for (const std::vector<int>* path : {&paths[longer], &paths[!longer]}) {
    if (const std::optional<Mat3> axes = axes_of_turning(tree, *path)) return *axes;
  }
  return identity_matrix();
}

bool is_zero_row(const Matrix<Real>& J, int row) {
  for (int k = 0; k < J.cols(); ++k) {
    if (!LoopSample::is_zero(J(row, k))) return false;
  }
  return true;
}

// Whether its points are together wherever the joints are.
bool holds_points(const Mechanism& tree, const LoopClosure& loop) {
  const LoopSample sample(tree, loop);
  const Matrix<Real> J = sample.jacobian();
  const std::vector<Real> gap = sample.gap();
  for (std::size_t row = 0; row < LoopClosure::kOfPoints; ++row) {
    if (!is_zero_row(J, static_cast<int>(row)) || !LoopSample::is_zero(gap[row])) return false;
  }
  return true;
}

// Along an axis, any of its points will do: in a spherical linkage its centre, where they are together anyway.
void cut_at_centre(const Mechanism& tree, LoopClosure& loop) {
  if (loop.components == LoopClosure::kOfPoints) return;
  const std::optional<std::array<Vec3, 2>> points = spherical_centres(tree, loop);
  if (!points) return;
  LoopClosure moved = loop;
  for (std::size_t e = 0; e < 2; ++e) moved.ends[e].p = (*points)[e];
  if (holds_points(tree, moved)) loop = std::move(moved);
}

void find_rows(const Mechanism& tree, LoopClosure& loop) {
  const Matrix<Real> J = LoopSample(tree, loop).jacobian();
  for (int row = 0; row < J.rows(); ++row) {
    if (!is_zero_row(J, row)) loop.rows.push_back(entry(row));
  }
}

}  // namespace

const LinkFrame& frame_of(const Mechanism& tree, const std::string& link) {
  return *std::find_if(tree.links.begin(), tree.links.end(),
                       [&link](const LinkFrame& each) { return each.link == link; });
}

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
  tree.floating_base = false;
  return make_mechanism(tree);
}

LoopClosure closure_of(const Loop& written, const Mechanism& tree) {
  LoopClosure loop;
  for (std::size_t e = 0; e < 2; ++e) loop.ends[e] = end_of(tree, written.links[e].name, written.points[e]);
  const Chains chains = chains_of(tree, loop);
  loop.carrier = chains.carrier;
  loop.axes = axes_of(tree, chains.paths);
  set_axes(written, tree, loop);
  cut_at_centre(tree, loop);
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

LoopSample::LoopSample(const Mechanism& tree, const LoopClosure& loop,
                       const std::function<Real(const Input&)>& value_of)
    : arithmetic_(value_of),
      field_(mechanism_over(with_loop(tree, loop), arithmetic_)),
      points_(joint_points(tree, arithmetic_)) {}

Matrix<Real> LoopSample::jacobian() const { return geometry().jacobian(field_.loops.front()); }
Matrix<Real> LoopSample::rows() const { return geometry().rows(field_.loops.front()); }
std::vector<Real> LoopSample::gap() const { return geometry().gap(field_.loops.front()); }
Real LoopSample::cosine() const { return geometry().cosine(field_.loops.front()); }

bool depends_on(const Matrix<Real>& J, int position) {
  for (int row = 0; row < J.rows(); ++row) {
    if (!LoopSample::is_zero(J(row, position))) return true;
  }
  return false;
}

namespace {

// The rest of a column without its parts along unit vectors.
std::vector<Real> rest_of(const Matrix<Real>& J, int column, const std::vector<std::vector<Real>>& units) {
  std::vector<Real> rest;
  for (int i = 0; i < J.rows(); ++i) rest.push_back(J(i, column));
  for (const std::vector<Real>& unit : units) {
    const Real along = std::inner_product(rest.begin(), rest.end(), unit.begin(), Real(0));
    for (std::size_t i = 0; i < rest.size(); ++i) rest[i] -= along * unit[i];
  }
  return rest;
}

}  // namespace

std::vector<int> independent_columns(const Matrix<Real>& J, const std::vector<int>& positions) {
  std::vector<std::vector<Real>> units;
  std::vector<int> chosen;
  for (const int k : positions) {
    std::vector<Real> rest = rest_of(J, k, units);
    const Real length = sqrt(std::inner_product(rest.begin(), rest.end(), rest.begin(), Real(0)));
    if (LoopSample::is_zero(length)) continue;
    for (Real& each : rest) each /= length;
    units.push_back(std::move(rest));
    chosen.push_back(k);
  }
  return chosen;
}

}  // namespace flatdyn
