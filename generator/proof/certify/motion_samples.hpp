// SPDX-License-Identifier: GPL-2.0-or-later
// The results of all operations at one random point, and the links' motions there, in real numbers or in a prime field.
#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "code/readback/execute.hpp"
#include "graph/arithmetic.hpp"
#include "graph/mod_p.hpp"
#include "proof/certify/motion_recogniser.hpp"
#include "truth/definition/field_motion.hpp"

namespace flatdyn {

// A point of real numbers: rates and accelerations between -1 and 1. Literals have their own values.
class RealPoint {
 public:
  using Scalar = double;

  explicit RealPoint(std::uint64_t seed) : seed_(seed) {}

  std::optional<double> constant(double literal) const { return literal; }
  double input(const Input& input) const {
    return drawn((static_cast<std::uint64_t>(input.kind) << 32) + static_cast<std::uint64_t>(input.index));
  }
  JointPoint<double> joint(int i) const {
    const double angle = std::numbers::pi * input({InputKind::q, i});
    return {std::cos(angle), std::sin(angle)};
  }
  double unrelated_number(std::uint64_t number) const { return drawn(~number); }
  RealArithmetic<double> arithmetic() const {
    return RealArithmetic<double>([](const Input&) { return 0.0; });
  }

 private:
  double drawn(std::uint64_t what) const {
    return std::ldexp(static_cast<double>(splitmix64(seed_, what) >> 11), -52) - 1;
  }

  std::uint64_t seed_;
};

// A point of GF(p), with exact constants.
class FieldPoint {
 public:
  using Scalar = ModP<kMersenne61>;

  FieldPoint(std::uint64_t seed, const ExactConstants& constants)
      : seed_(seed), arithmetic_(seed), constants_(constants) {}

  std::optional<Scalar> constant(double literal) const {
    const std::optional<Rational> exact = constants_(std::abs(literal));
    if (!exact) return std::nullopt;
    const Scalar size = Scalar::from(*exact);
    return literal < 0 ? -size : size;
  }
  Scalar input(const Input& input) const { return arithmetic_.input(input); }
  JointPoint<Scalar> joint(int i) const {
    const auto point = arithmetic_.point(input({InputKind::q, i}));
    return {point.c, point.s};
  }
  Scalar unrelated_number(std::uint64_t number) const { return Scalar(splitmix64(seed_, ~number)); }
  ModPArithmetic<> arithmetic() const { return arithmetic_; }

 private:
  std::uint64_t seed_;
  ModPArithmetic<> arithmetic_;
  const ExactConstants& constants_;
};

// Arithmetic for execute(). A result that is not a sum or product of inputs, joints' sines and known constants becomes
// an independent random number.
template <class Point>
class PointArithmetic {
 public:
  using Scalar = typename Point::Scalar;

  explicit PointArithmetic(const Point& point) : point_(point) {}

  Scalar constant(double literal) {
    const std::optional<Scalar> known = point_.constant(literal);
    return known ? *known : unrelated_number();
  }
  Scalar input(const Input& input) const { return point_.input(input); }
  Scalar sine(const Input& position) const { return point_.joint(position.index).s; }
  Scalar cosine(const Input& position) const { return point_.joint(position.index).c; }
  Scalar sine(const Scalar&) { return unrelated_number(); }
  Scalar cosine(const Scalar&) { return unrelated_number(); }
  Scalar divide(const Scalar&, const Scalar&) { return unrelated_number(); }
  Scalar sign(const Scalar&) { return unrelated_number(); }
  Scalar sqrt(const Scalar&) { return unrelated_number(); }

 private:
  Scalar unrelated_number() { return point_.unrelated_number(unrelated_count_++); }

  Point point_;
  std::uint64_t unrelated_count_ = 0;
};

// The inputs that are read; others count as 0.
using ReadInputs = std::set<std::pair<InputKind, int>>;

template <class Point>
class MotionSample {
 public:
  using F = typename Point::Scalar;

  MotionSample(const Mechanism& mechanism, const Point& point, const ReadInputs& read) : arithmetic_(point) {
    auto arithmetic = point.arithmetic();
    mechanism_ = mechanism_over(mechanism, arithmetic);
    const auto drawn = [&](InputKind kind, int i) {
      return read.count({kind, i}) != 0 ? point.input({kind, i}) : F(0);
    };
    base_bodies_ = mechanism.base_bodies();
    if (mechanism.floating_base) {
      for (int k = 0; k < 3; ++k) mechanism_.gravity[static_cast<std::size_t>(k)] = drawn(InputKind::g_b, k);
    }
    for (int i = 0; i < mechanism.body_count(); ++i) {
      q_.push_back(mechanism.is_of_base(i) ? JointPoint<F>{F(1), F(0)} : point.joint(i - base_bodies_));
      qd_.push_back(drawn(with_base(InputKind::qd, mechanism.floating_base), i));
      qdd_.push_back(drawn(with_base(InputKind::qdd, mechanism.floating_base), i));
    }
    motions_ = field_motions(mechanism_, q_, qd_, qdd_, base_bodies_);
  }

  // Evaluates the operations that are new.
  void evaluate(const StraightLine& lines) { execute(lines, lines.size(), arithmetic_, values_); }

  F value(int operation) const { return values_[static_cast<std::size_t>(operation)]; }
  std::vector<F> entries_of_motion(int link) const { return entries_of(motions_[static_cast<std::size_t>(link)]); }

  // u and u × r of the joint's axis, in the link's frame; 0 and u of a direction in which a floating base slides.
  std::vector<F> entries_of_axis(int joint, int link) const {
    MechanismOver<F> weightless = mechanism_;
    weightless.gravity = {F(0), F(0), F(0)};
    const std::vector<F> at_rest(q_.size(), F(0));
    std::vector<F> alone = at_rest;
    alone[static_cast<std::size_t>(joint)] = F(1);
    const FieldMotion<F> motion =
        field_motions(weightless, q_, at_rest, alone, base_bodies_)[static_cast<std::size_t>(link)];
    std::vector<F> result(motion.domega.begin(), motion.domega.end());
    result.insert(result.end(), motion.ddp.begin(), motion.ddp.end());
    return result;
  }

 private:
  PointArithmetic<Point> arithmetic_;
  MechanismOver<F> mechanism_;
  int base_bodies_ = 0;
  std::vector<JointPoint<F>> q_;
  std::vector<F> qd_, qdd_, values_;
  std::vector<FieldMotion<F>> motions_;
};

}  // namespace flatdyn
