// SPDX-License-Identifier: GPL-2.0-or-later
// Positions of a robot around those at the start of a step, as nodes of a graph.
//
// A change of position has one number for each entry of q̇: for a joint of one axis how far it moves; for a floating
// base its displacement d, m, in base axes at the start; for the turn of a floating base, and of a spherical joint, the
// modified Rodrigues parameters σ = e tan(φ/4) of a turn about e by φ, R' = R E(σ) (Schaub and Junkins, Analytical
// Mechanics of Space Systems, 3.6). E is the unit quaternion (1 - σ², 2 σ) / (1 + σ²).
#pragma once

#include <array>
#include <vector>

#include "derivation/dynamics/square_matrices.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

class StepChart {
 public:
  using Entries = std::vector<NodeId>;  // by entry of q̇
  using Triple = std::array<NodeId, 3>;
  using Quaternion = std::array<NodeId, 4>;  // (w, x, y, z)
  using Turns = std::vector<Quaternion>;     // of a floating base first, then of each spherical joint

  // All entries of q, and gravity in base axes: empty where there is none or the base is fixed.
  struct Positions {
    Entries q, g_b;
  };

  // Both must outlive this object.
  StepChart(const Mechanism& mechanism, Graph& graph);

  // The arguments of a function: positions, and those with an entry for each entry of q̇.
  Positions start() const;
  Entries arguments(InputKind kind) const;

  bool has_turns() const { return !parts_.empty(); }
  int size() const { return mechanism_.size(); }  // entries of q̇
  bool has_base() const { return mechanism_.floating_base; }
  bool has_quaternions() const { return mechanism_.has_spherical_joints(); }
  // Whether entry k of q̇ is the derivative of an entry of q.
  bool is_rate(std::size_t k) const { return position_of_[k] >= 0; }

  // E(factor σ) of a change.
  Turns turns(const Entries& change, const Rational& factor = 1) const;
  // The same turns one after the other.
  Turns twice(const Turns& turns) const;
  // The positions after a change of joints of one axis, and these turns.
  Positions after(const Entries& change, const Turns& turns) const;
  // d = E x for the velocity or displacement x of the base in axes that have turned; the other entries stay.
  Entries with_base_turned(const Turns& turns, Entries change) const;
  // The rates of a change whose turns are E(σ), from the velocities v there: ḋ = E v, and (Schaub and Junkins, (3.150))
  // σ̇ = ((1 - σ²) ω + 2 σ × ω + 2 σ σᵀω) / 4.
  Entries rates(const Entries& change, const Turns& turns, const Entries& v) const;

  // How positions after a change depend on positions before it and on the change. They are in tangent spaces
  // (docs/floating-base.md): R ← R exp(S(δ)), p ← p + R δ.
  struct Tangents {
    SquareMatrices::Entries by_position, by_change;
  };
  Tangents tangents(const Entries& change, const Turns& turns) const;
  // The same for w = h (v, ω, ...) as the change, where positions turn by E(ω h / 8), once in the middle of the step
  // and twice in all, and d is h v along axes in the middle. The base's displacement in the middle is left out, as no
  // torque depends on it.
  Tangents tangents_along(const Entries& w, const Turns& turns) const;
  Tangents tangents_in_the_middle(const Turns& turns) const;

  // How rates of a change depend on the change and on v.
  struct RateTangents {
    SquareMatrices::Entries by_change, by_velocity;
  };
  RateTangents tangents_of_rates(const Entries& change, const Turns& turns, const Entries& v) const;

 private:
  // A part that turns: its first entry of ω in q̇, and the first one of its quaternion in q; -1 for a base.
  struct TurningPart {
    std::size_t rate;
    int quaternion;
  };
  using Block = std::array<Triple, 3>;  // column by column

  static Triple three_of(const Entries& entries, std::size_t first);
  static void put_three(const Triple& x, std::size_t first, Entries& to);
  static Triple vector_of(const Quaternion& E) { return {E[1], E[2], E[3]}; }
  NodeId sum(NodeId a, NodeId b, int sign = 1) const { return graph_.sum({{1, a}, {sign, b}}); }
  Triple sum(const Triple& a, const Triple& b, int sign = 1) const;
  Triple scaled(NodeId factor, const Triple& x) const;
  Triple multiple(const Rational& factor, const Triple& x) const { return scaled(graph_.constant(factor), x); }
  Block multiple(const Rational& factor, Block block) const;
  Triple cross(const Triple& a, const Triple& b) const;
  NodeId dot(const Triple& a, const Triple& b) const;
  Quaternion product(const Quaternion& a, const Quaternion& b) const;
  enum class Sense { forwards, backwards };  // E x, Eᵀ x
  Triple turned(const Quaternion& E, const Triple& x, Sense sense) const;
  Triple unit(std::size_t k) const;
  Block turned_back(const Quaternion& E) const;         // Eᵀ
  Block turn_by_parameters(const Quaternion& E) const;  // T with E exp(S(T dσ)) = E(σ + dσ)
  void put(const Block& block, std::size_t row, std::size_t column, SquareMatrices::Entries& to) const;
  // The diagonal matrix with x where entries of q̇ are rates, and zeros elsewhere.
  SquareMatrices::Entries of_joints(const Rational& x) const;

  const Mechanism& mechanism_;
  Graph& graph_;
  std::vector<TurningPart> parts_;
  std::vector<int> position_of_;  // by entry of q̇: the entry of q of which it is the rate; -1: of none
};

}  // namespace flatdyn
