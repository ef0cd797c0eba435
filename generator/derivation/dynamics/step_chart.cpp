// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/step_chart.hpp"

#include <algorithm>
#include <utility>

namespace flatdyn {
namespace {

constexpr std::size_t kBaseTurn = 3;  // the first entry of a floating base's ω

}  // namespace

StepChart::Triple StepChart::three_of(const Entries& entries, std::size_t first) {
  return {entries[first], entries[first + 1], entries[first + 2]};
}

void StepChart::put_three(const Triple& x, std::size_t first, Entries& to) {
  for (std::size_t k = 0; k < x.size(); ++k) to[first + k] = x[k];
}

StepChart::StepChart(const Mechanism& mechanism, Graph& graph) : mechanism_(mechanism), graph_(graph) {
  if (mechanism.floating_base) parts_.push_back({kBaseTurn, -1});
  for (const int first : mechanism.spherical) {
    parts_.push_back({static_cast<std::size_t>(first), mechanism.quaternion_of(first)});
  }
  for (int k = 0; k < mechanism.size(); ++k) {
    const bool is_rate = !mechanism.is_around_pose(mechanism.body_of(k));
    position_of_.push_back(is_rate ? mechanism.position_of(k) : -1);
  }
}

StepChart::Positions StepChart::start() const {
  Positions positions;
  for (int k = 0; k < mechanism_.position_count(); ++k) positions.q.push_back(graph_.input({InputKind::q, k}));
  if (!mechanism_.has_base_gravity()) return positions;
  for (int k = 0; k < kVectorLength; ++k) positions.g_b.push_back(graph_.input({InputKind::g_b, k}));
  return positions;
}

StepChart::Entries StepChart::arguments(InputKind kind) const {
  Entries entries;
  for (int k = 0; k < mechanism_.size(); ++k) {
    entries.push_back(graph_.input({with_base(kind, mechanism_.has_quasi_velocities()), k}));
  }
  return entries;
}

StepChart::Turns StepChart::turns(const Entries& change, const Rational& factor) const {
  const NodeId one = graph_.constant(1);
  Turns turns;
  for (const TurningPart& part : parts_) {
    const Triple sigma = multiple(factor, three_of(change, part.rate));
    const NodeId square = dot(sigma, sigma), inverse = graph_.quotient(one, sum(one, square));
    const Triple r = scaled(graph_.scaled(2, inverse), sigma);
    turns.push_back({graph_.product({sum(one, square, -1), inverse}), r[0], r[1], r[2]});
  }
  return turns;
}

StepChart::Turns StepChart::twice(const Turns& turns) const {
  Turns result;
  for (const Quaternion& E : turns) {
    const Triple r = scaled(graph_.scaled(2, E[0]), vector_of(E));
    result.push_back({graph_.sum({{2, graph_.product({E[0], E[0]})}}, -1), r[0], r[1], r[2]});
  }
  return result;
}

StepChart::Positions StepChart::after(const Entries& change, const Turns& turns) const {
  Positions positions = start();
  for (std::size_t k = 0; k < position_of_.size(); ++k) {
    if (!is_rate(k)) continue;
    NodeId& q = positions.q[static_cast<std::size_t>(position_of_[k])];
    q = sum(q, change[k]);
  }
  for (std::size_t part = 0; part < parts_.size(); ++part) {
    if (parts_[part].quaternion < 0) {
      if (positions.g_b.empty()) continue;
      put_three(turned(turns[part], three_of(positions.g_b, 0), Sense::backwards), 0, positions.g_b);
      continue;
    }
    const auto first = positions.q.begin() + parts_[part].quaternion;
    const Quaternion next = product({first[0], first[1], first[2], first[3]}, turns[part]);
    std::copy(next.begin(), next.end(), first);
  }
  return positions;
}

StepChart::Entries StepChart::with_base_turned(const Turns& turns, Entries change) const {
  if (mechanism_.floating_base) put_three(turned(turns[0], three_of(change, 0), Sense::forwards), 0, change);
  return change;
}

StepChart::Entries StepChart::rates(const Entries& change, const Turns& turns, const Entries& v) const {
  Entries result = with_base_turned(turns, v);
  for (const TurningPart& part : parts_) {
    const Triple sigma = three_of(change, part.rate), omega = three_of(v, part.rate);
    const NodeId less = graph_.sum({{-1, dot(sigma, sigma)}}, 1), along = dot(sigma, omega);
    const Triple twist = cross(sigma, omega);
    for (std::size_t k = 0; k < 3; ++k) {
      result[part.rate + k] = graph_.sum({{Rational(1, 4), graph_.product({less, omega[k]})},
                                          {Rational(1, 2), twist[k]},
                                          {Rational(1, 2), graph_.product({along, sigma[k]})}});
    }
  }
  return result;
}

StepChart::Triple StepChart::sum(const Triple& a, const Triple& b, int sign) const {
  return {sum(a[0], b[0], sign), sum(a[1], b[1], sign), sum(a[2], b[2], sign)};
}

StepChart::Triple StepChart::scaled(NodeId factor, const Triple& x) const {
  return {graph_.product({factor, x[0]}), graph_.product({factor, x[1]}), graph_.product({factor, x[2]})};
}

StepChart::Triple StepChart::cross(const Triple& a, const Triple& b) const {
  const auto entry = [&](std::size_t i, std::size_t j) {
    return sum(graph_.product({a[i], b[j]}), graph_.product({a[j], b[i]}), -1);
  };
  return {entry(1, 2), entry(2, 0), entry(0, 1)};
}

NodeId StepChart::dot(const Triple& a, const Triple& b) const {
  std::vector<Term> terms;
  for (std::size_t k = 0; k < a.size(); ++k) terms.push_back({1, graph_.product({a[k], b[k]})});
  return graph_.sum(std::move(terms));
}

StepChart::Quaternion StepChart::product(const Quaternion& a, const Quaternion& b) const {
  const Triple r = vector_of(a), s = vector_of(b);
  const Triple v = sum(sum(scaled(a[0], s), scaled(b[0], r)), cross(r, s));
  return {sum(graph_.product({a[0], b[0]}), dot(r, s), -1), v[0], v[1], v[2]};
}

StepChart::Triple StepChart::turned(const Quaternion& E, const Triple& x, Sense sense) const {
  const Triple r = vector_of(E), t = multiple(2, cross(r, x));
  return sum(sum(x, scaled(E[0], t), sense == Sense::forwards ? 1 : -1), cross(r, t));
}

}  // namespace flatdyn
