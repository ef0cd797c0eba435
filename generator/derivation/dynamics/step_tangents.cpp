// SPDX-License-Identifier: GPL-2.0-or-later
// The derivatives of step_chart.hpp.
#include "derivation/dynamics/step_chart.hpp"

namespace flatdyn {

StepChart::Tangents StepChart::tangents(const Entries& change, const Turns& turns) const {
  Tangents result{of_joints(1), of_joints(1)};
  for (std::size_t part = 0; part < parts_.size(); ++part) {
    const std::size_t at = parts_[part].rate;
    const Block back = turned_back(turns[part]);
    put(back, at, at, result.by_position);
    put(turn_by_parameters(turns[part]), at, at, result.by_change);
    if (parts_[part].quaternion >= 0) continue;
    // δp' = Eᵀ (δp + δ × d + dd).
    Block displaced;
    for (std::size_t k = 0; k < displaced.size(); ++k) {
      displaced[k] = turned(turns[part], cross(unit(k), three_of(change, 0)), Sense::backwards);
    }
    put(back, 0, 0, result.by_position);
    put(back, 0, 0, result.by_change);
    put(displaced, 0, at, result.by_position);
  }
  return result;
}

StepChart::Tangents StepChart::tangents_in_the_middle(const Turns& turns) const {
  Tangents result{of_joints(1), of_joints(Rational(1, 2))};
  for (std::size_t part = 0; part < parts_.size(); ++part) {
    const std::size_t at = parts_[part].rate;
    put(turned_back(turns[part]), at, at, result.by_position);
    put(multiple(Rational(1, 8), turn_by_parameters(turns[part])), at, at, result.by_change);
  }
  return result;
}

StepChart::Tangents StepChart::tangents_along(const Entries& w, const Turns& turns) const {
  Tangents result{of_joints(1), of_joints(1)};
  const Turns both = twice(turns);
  for (std::size_t part = 0; part < parts_.size(); ++part) {
    const std::size_t at = parts_[part].rate;
    const Quaternion& E = turns[part];
    const Block back = turned_back(both[part]), first = multiple(Rational(1, 8), turn_by_parameters(E));
    Block second;
    for (std::size_t k = 0; k < 3; ++k) second[k] = sum(turned(E, first[k], Sense::backwards), first[k]);
    put(back, at, at, result.by_position);
    put(second, at, at, result.by_change);
    if (parts_[part].quaternion >= 0) continue;
    // δp' = (E²)ᵀ (δp + δ × E w) + Eᵀ (dw + T dσ × w), with (E²)ᵀ (δ × E w) = (E²)ᵀ δ × Eᵀ w.
    const Triple linear = three_of(w, 0), behind = turned(E, linear, Sense::backwards);
    Block displaced, through_turn;
    for (std::size_t k = 0; k < 3; ++k) {
      displaced[k] = cross(back[k], behind);
      through_turn[k] = turned(E, cross(first[k], linear), Sense::backwards);
    }
    put(back, 0, 0, result.by_position);
    put(displaced, 0, at, result.by_position);
    put(turned_back(E), 0, 0, result.by_change);
    put(through_turn, 0, at, result.by_change);
  }
  return result;
}

// By σ: ∂σ̇ = ((σ·ω) dσ + σ (ω·dσ) - ω (σ·dσ) - ω × dσ) / 2, and of ḋ = E v: E (T dσ × v).
StepChart::RateTangents StepChart::tangents_of_rates(const Entries& change, const Turns& turns,
                                                     const Entries& v) const {
  RateTangents result{of_joints(0), of_joints(1)};
  for (std::size_t part = 0; part < parts_.size(); ++part) {
    const std::size_t at = parts_[part].rate;
    const Triple sigma = three_of(change, at), omega = three_of(v, at);
    const NodeId less = graph_.sum({{-1, dot(sigma, sigma)}}, 1), along = dot(sigma, omega);
    Block by_sigma, by_omega;
    for (std::size_t k = 0; k < 3; ++k) {
      const Triple e = unit(k), outer = sum(scaled(omega[k], sigma), scaled(sigma[k], omega), -1);
      by_sigma[k] = multiple(Rational(1, 2), sum(sum(scaled(along, e), outer), cross(omega, e), -1));
      const Triple doubled = sum(cross(sigma, e), scaled(sigma[k], sigma));
      by_omega[k] = sum(multiple(Rational(1, 4), scaled(less, e)), multiple(Rational(1, 2), doubled));
    }
    put(by_sigma, at, at, result.by_change);
    put(by_omega, at, at, result.by_velocity);
    if (parts_[part].quaternion >= 0) continue;
    const Block T = turn_by_parameters(turns[part]);
    Block displacement, by_linear;
    for (std::size_t k = 0; k < 3; ++k) {
      displacement[k] = turned(turns[part], cross(T[k], three_of(v, 0)), Sense::forwards);
      by_linear[k] = turned(turns[part], unit(k), Sense::forwards);
    }
    put(displacement, 0, at, result.by_change);
    put(by_linear, 0, 0, result.by_velocity);
  }
  return result;
}

SquareMatrices::Entries StepChart::of_joints(const Rational& x) const {
  const SquareMatrices m(graph_, mechanism_.size());
  SquareMatrices::Entries result = m.zero();
  for (int k = 0; k < m.size(); ++k) {
    if (is_rate(static_cast<std::size_t>(k))) result[m.at(k, k)] = graph_.constant(x);
  }
  return result;
}

StepChart::Triple StepChart::unit(std::size_t k) const {
  Triple e = {graph_.constant(0), graph_.constant(0), graph_.constant(0)};
  e[k] = graph_.constant(1);
  return e;
}

StepChart::Block StepChart::multiple(const Rational& factor, Block block) const {
  for (Triple& column : block) column = multiple(factor, column);
  return block;
}

StepChart::Block StepChart::turned_back(const Quaternion& E) const {
  return {turned(E, unit(0), Sense::backwards), turned(E, unit(1), Sense::backwards),
          turned(E, unit(2), Sense::backwards)};
}

// T = 2 (1 + c) (c - S(r)) + 2 r rᵀ, the inverse of the matrix of σ̇, with E = (c, r).
StepChart::Block StepChart::turn_by_parameters(const Quaternion& E) const {
  const Triple r = vector_of(E);
  const NodeId factor = graph_.sum({{2, E[0]}}, 2), diagonal = graph_.product({factor, E[0]});
  Block block;
  for (std::size_t k = 0; k < block.size(); ++k) {
    const Triple across = scaled(factor, cross(r, unit(k)));
    block[k] = sum(sum(scaled(diagonal, unit(k)), across, -1), scaled(graph_.scaled(2, r[k]), r));
  }
  return block;
}

void StepChart::put(const Block& block, std::size_t row, std::size_t column, SquareMatrices::Entries& to) const {
  const SquareMatrices m(graph_, mechanism_.size());
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) to[m.at(static_cast<int>(row + i), static_cast<int>(column + k))] = block[k][i];
  }
}

}  // namespace flatdyn
