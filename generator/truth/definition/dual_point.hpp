// SPDX-License-Identifier: GPL-2.0-or-later
// A function at a point of a prime field over dual numbers: its exact derivatives along any direction. How entries of q
// and g_b change along a direction of the tangent space is written here once more, not taken from the derivation.
#pragma once

#include <array>
#include <vector>

#include "graph/evaluate.hpp"
#include "graph/mod_p.hpp"
#include "robot/model/field_vector.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

template <std::uint64_t P>
class DualPoint {
 public:
  using F = ModP<P>;
  using Scalar = Dual<F>;

  // The directions are those of the function's arguments, one after the other, and of the free symbols; of q they are
  // as many as of q̇. Weights do
  // not move. All arguments must outlive this object.
  DualPoint(const Mechanism& mechanism, const Function& function, FieldArithmetic<F>& arithmetic)
      : mechanism_(mechanism), function_(function), arithmetic_(arithmetic) {
    for (const InputKind kind : function.inputs) {
      if (argument_row(kind).length != ArgumentLength::own) add(kind, length_of(kind));
    }
    add(InputKind::parameter, static_cast<int>(mechanism.symbols.size()));
  }

  // The directions of one argument.
  struct Block {
    InputKind kind;
    int first, length;
  };

  int directions() const { return count_; }
  const std::vector<Block>& blocks() const { return blocks_; }

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
  // Those along direction k of the space.
  std::vector<F> derivatives_by(int k) {
    std::vector<F> unit(static_cast<std::size_t>(count_), F(0));
    unit[static_cast<std::size_t>(k)] = F(1);
    return derivatives_along(unit);
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

 private:
  int length_of(InputKind kind) const {
    if (is_by_joint(kind)) return mechanism_.size();
    if (kind == InputKind::h_e) return kWrenchLength;
    return kind == InputKind::g_b ? kVectorLength : own_length(function_, argument_row(kind).length);
  }
  void add(InputKind kind, int length) {
    blocks_.push_back({kind, count_, length});
    count_ += length;
  }
  F along(int direction) const { return (*direction_)[static_cast<std::size_t>(direction)]; }

  F rate_of(const Input& input) const {
    F rate(0);
    for (const Block& block : blocks_) {
      if (block.kind == InputKind::q && input.kind == InputKind::q) rate += rate_of_position(input.index, block.first);
      if (block.kind == InputKind::q && input.kind == InputKind::g_b) {
        const Vector3<F> turn = {along(block.first + 3), along(block.first + 4), along(block.first + 5)};
        rate += cross(vector_of(InputKind::g_b, 0), turn)[static_cast<std::size_t>(input.index)];
      }
      if (block.kind == input.kind && input.kind != InputKind::q) rate += along(block.first + input.index);
    }
    return rate;
  }

  // The rate of an entry of q: a coordinate's own, or that of a quaternion whose joint turns, q̇ = ½ q (0, δ).
  F rate_of_position(int entry, int first) const {
    if (!mechanism_.is_of_quaternion(entry)) {
      for (int k = mechanism_.base_bodies(); k < mechanism_.size(); ++k) {
        if (mechanism_.position_of(k) == entry && !mechanism_.is_of_spherical(mechanism_.body_of(k))) {
          return along(first + k);
        }
      }
      return F(0);
    }
    const int body = mechanism_.body_at(entry);
    const int joint = body - (mechanism_.body(body).spherical - 1), w = mechanism_.quaternion_of(joint);
    const Vector3<F> r = vector_of(InputKind::q, w + 1);
    const Vector3<F> turn = {along(first + joint), along(first + joint + 1), along(first + joint + 2)};
    const F half = F(1) / F(2);
    if (entry == w) return -(half * (r[0] * turn[0] + r[1] * turn[1] + r[2] * turn[2]));
    const auto k = static_cast<std::size_t>(entry - w - 1);
    return half * (arithmetic_.input({InputKind::q, w}) * turn[k] + cross(r, turn)[k]);
  }

  Vector3<F> vector_of(InputKind kind, int first) const {
    return {arithmetic_.input({kind, first}), arithmetic_.input({kind, first + 1}),
            arithmetic_.input({kind, first + 2})};
  }

  const Mechanism& mechanism_;
  const Function& function_;
  FieldArithmetic<F>& arithmetic_;
  std::vector<Block> blocks_;
  int count_ = 0;
  const std::vector<F>* direction_ = nullptr;
};

}  // namespace flatdyn
