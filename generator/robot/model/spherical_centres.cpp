// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/spherical_centres.hpp"

#include <algorithm>

#include "robot/model/loop_sample.hpp"

namespace flatdyn {
namespace {

class SphericalCentres {
 public:
  SphericalCentres(const Mechanism& tree, const LoopClosure& loop)
      : tree_(tree), loop_(loop), arithmetic_(LoopSample::drawn), value_(tree.symbols, arithmetic_) {}

  std::optional<std::array<Vec3, 2>> find() const {
    std::array<std::optional<Vec3>, 2> found = {on_last_joint(0), on_last_joint(1)};
    for (std::size_t e = 0; e < 2; ++e) {
      if (found[e]) continue;
      if (!found[1 - e] || loop_.ends[e].body != loop_.carrier) return std::nullopt;
      found[e] = in_carrier(1 - e, *found[1 - e]);
      if (!is_on_axis(e, *found[e])) return std::nullopt;
    }
    return {{*found[0], *found[1]}};
  }

 private:
  bool is_trifling(const Number& x) const { return LoopSample::is_zero(value_(x)); }

  Vec3 axis_of(std::size_t e) const { return e == 0 ? cross(loop_.across[0], loop_.across[1]) : loop_.axis; }

  // A joint's axis is z of its body's frame.
  std::optional<Vec3> on_last_joint(std::size_t e) const {
    const int body = loop_.ends[e].body;
    if (body == loop_.carrier || tree_.bodies[static_cast<std::size_t>(body)].prismatic) return std::nullopt;
    const Vec3 axis = expanded(axis_of(e));
    const std::size_t k = is_trifling(axis[0]) ? 1 : 0;
    if (is_trifling(axis[k])) return std::nullopt;  // parallel
    const Vec3& p = loop_.ends[e].p;
    const Vec3 point = expanded(p - Number(p[k] / axis[k]) * axis);
    if (!is_trifling(point[1 - k])) return std::nullopt;
    return Vec3{0, 0, point[2]};
  }

  Vec3 in_carrier(std::size_t e, Vec3 point) const {
    for (int i = loop_.ends[e].body; i != loop_.carrier; i = tree_.bodies[static_cast<std::size_t>(i)].parent) {
      const Body& body = tree_.bodies[static_cast<std::size_t>(i)];
      point = expanded(body.p + constant_rotation(body) * point);
    }
    return point;
  }

  bool is_on_axis(std::size_t e, const Vec3& point) const {
    const Vec3 beside = expanded(cross(point - loop_.ends[e].p, axis_of(e)));
    return std::all_of(beside.begin(), beside.end(), [this](const Number& x) { return is_trifling(x); });
  }

  const Mechanism& tree_;
  const LoopClosure& loop_;
  RealArithmetic<LoopSample::Real> arithmetic_;
  NumberMap<RealArithmetic<LoopSample::Real>> value_;
};

}  // namespace

std::optional<std::array<Vec3, 2>> spherical_centres(const Mechanism& tree, const LoopClosure& loop) {
  return SphericalCentres(tree, loop).find();
}

}  // namespace flatdyn
