// SPDX-License-Identifier: GPL-2.0-or-later
// A function at a point of a prime field over dual numbers: its exact derivatives along any direction. How entries of q
// and g_b change along turns is that of the definitions of derivatives (torque_derivatives.hpp), not of the derivation.
#pragma once

#include <optional>
#include <vector>

#include "derivation/differentiation/tangents.hpp"
#include "graph/evaluate.hpp"
#include "graph/mod_p.hpp"
#include "robot/model/joint_points.hpp"
#include "truth/definition/torque_derivatives.hpp"

namespace flatdyn {

template <std::uint64_t P>
class DualPoint {
 public:
  using F = ModP<P>;
  using Scalar = Dual<F>;

  // Weights, if the function takes some, do not move. All arguments must outlive this object.
  DualPoint(const Mechanism& mechanism, const Function& function, const Tangents& tangents,
            FieldArithmetic<F>& arithmetic)
      : mechanism_(mechanism), function_(function), tangents_(tangents), arithmetic_(arithmetic) {}

  // The derivatives of all entries of the outputs along a direction.
  std::vector<F> derivatives_along(const std::vector<F>& direction) {
    direction_ = &direction;
    const std::vector<Scalar> values = evaluate(function_, *this);
    std::vector<F> result;
    for (const Output& output : function_.outputs) {
      for (const NodeId entry : output.entries) result.push_back(values[static_cast<std::size_t>(entry)].derivative);
    }
    return result;
  }

  // The same along each direction of the space.
  std::vector<std::vector<F>> derivatives() {
    std::vector<std::vector<F>> columns;
    for (int k = 0; k < tangents_.count(); ++k) {
      std::vector<F> unit(static_cast<std::size_t>(tangents_.count()), F(0));
      unit[static_cast<std::size_t>(k)] = F(1);
      columns.push_back(derivatives_along(unit));
    }
    return columns;
  }

  // The arithmetic that evaluate() asks for.
  Scalar constant(const Rational& value) const { return Scalar(arithmetic_.constant(value)); }
  Scalar input(const Input& input) const { return {arithmetic_.input(input), rate_of(input)}; }
  Scalar divide(const Scalar& a, const Scalar& b) const { return a / b; }
  Scalar sin(const Graph& graph, NodeId angle, const Scalar& x) const {
    return {arithmetic_.sin(graph, angle, x.value), arithmetic_.cos(graph, angle, x.value) * x.derivative};
  }
  Scalar cos(const Graph& graph, NodeId angle, const Scalar& x) const {
    return {arithmetic_.cos(graph, angle, x.value), -(arithmetic_.sin(graph, angle, x.value) * x.derivative)};
  }
  Scalar sign(const Scalar& x) const { return Scalar(arithmetic_.sign(x.value)); }
  Scalar sqrt(const Scalar& x) const {
    const F root = arithmetic_.sqrt(x.value);
    return {root, x.derivative / (root + root)};
  }
  Scalar tanh(const Scalar& x) const {
    const F value = rational_tanh(arithmetic_, x.value);
    return {value, (F(1) - value * value) * x.derivative};
  }

 private:
  F rate_of(const Input& input) const {
    F rate(0);
    for (const TangentBlock& block : tangents_.blocks()) {
      if (block.kind == InputKind::q) {
        for (int k = 0; k < block.length; ++k) rate += rate_by_position(input, k) * along(block.first + k);
      } else if (block.kind == input.kind) {
        rate += along(block.first + input.index);
      }
    }
    return rate;
  }

  // The rate of an input along direction k of q.
  F rate_by_position(const Input& input, int k) const {
    if (input.kind == InputKind::g_b) {
      const Vector3<F> g = {gravity(0), gravity(1), gravity(2)};
      return gravity_along(mechanism_, g, k)[static_cast<std::size_t>(input.index)];
    }
    if (input.kind != InputKind::q || mechanism_.is_of_base(k)) return F(0);
    if (mechanism_.has_loops()) return along_loops()(input.index, k - mechanism_.base_bodies());
    const int body = mechanism_.body_of(k);
    if (mechanism_.is_of_spherical(body)) return turning(mechanism_, arithmetic_, body).input(input).derivative;
    return F(mechanism_.position_of(k) == input.index ? 1 : 0);
  }

  // G: how all entries of q move along with the independent ones.
  const Matrix<F>& along_loops() const {
    if (!along_loops_) {
      along_loops_ = loop_motion(mechanism_over(mechanism_, arithmetic_), joint_points(mechanism_, arithmetic_));
    }
    return *along_loops_;
  }

  F gravity(int k) const { return arithmetic_.input({InputKind::g_b, k}); }
  F along(int direction) const { return (*direction_)[static_cast<std::size_t>(direction)]; }

  const Mechanism& mechanism_;
  const Function& function_;
  const Tangents& tangents_;
  FieldArithmetic<F>& arithmetic_;
  const std::vector<F>* direction_ = nullptr;
  mutable std::optional<Matrix<F>> along_loops_;
};

}  // namespace flatdyn
