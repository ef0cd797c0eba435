// SPDX-License-Identifier: GPL-2.0-or-later
// Closed loops inside one derivation: the closure Φ(q) of each loop in the frame of its carrier, its derivatives along
// the joints of the loop, and what the dependent joints do. Linear equations of up to three unknowns, one loop after
// the other, are solved by Cramer's rule.
#pragma once

#include <functional>
#include <vector>

#include "symbolic/kernel/frames.hpp"

namespace flatdyn {

class ClosedLoops {
 public:
  ClosedLoops(const Mechanism& mechanism, Derivation& derivation);

  // Φ, loop by loop, m: the way from the one end to the other; zero where the loops are closed.
  std::vector<Number> closure() const;
  // Φ_q, a row for each entry of Φ, a column for each entry of q.
  Rows jacobian() const;
  // G, m × n: q̇ = G q̇_a keeps Φ where it is.
  Rows motion() const;
  // Of all entries of q, for no acceleration of the independent joints: d/dt G times q̇_r = G_r q̇_a, while q̇ moves as
  // `rates`; `rates` and `rates_r` by body.
  std::vector<Number> drift(const std::vector<Number>& rates, const std::vector<Number>& rates_r,
                            const std::string& name) const;
  // Newton's step: what it takes to be added to q, in which independent joints stay where they are.
  std::vector<Number> step() const;

  // Of each loop: the determinant that is divided by, squared, less a trifle of the largest that it could be. Positive,
  // unless the loop is singular or within 1e-6 of it.
  struct Condition {
    NodeId reciprocal;  // of the determinant: who does not need it does not need the condition
    NodeId validity_conditions;
  };
  std::vector<Condition> conditions() const;

 private:
  // What one joint of the loop does to one end, in the loop's axes.
  struct Joint {
    int body = 0;
    bool slides = false;
    Vec3 axis, column;  // z; what the end does per rad or m
    Vec3 link;          // from the joint's frame to the next one's, or to the end
  };
  struct Loop {
    std::vector<Joint> ways[2];
    Vec3 gap;
    Rows J;  // by row, by entry of q
    Number determinant, reciprocal;
  };
  using Extra = std::function<std::vector<Number>(const Loop&, std::size_t)>;

  std::vector<Joint> way_to(const LoopClosure& closure, std::size_t end, Vec3& point, const std::string& name);
  Loop geometry(const LoopClosure& closure, std::size_t l);
  Number factor(int body, std::size_t position) const;
  // Values of all entries of q: those of the independent ones as given, those of the dependent ones so that
  // Φ_q values + extra = 0.
  std::vector<Number> completed(std::vector<Number> values, const Extra& extra, const std::string& name) const;
  Vec3 acceleration(const std::vector<Joint>& way, const std::vector<Number>& rates,
                    const std::vector<Number>& rates_r) const;
  struct Lengths {
    Number squares;  // their sum
    int count;
  };
  Lengths lengths_beyond(const std::vector<Joint>& way, std::size_t j, const LoopClosure::End& end) const;
  Number largest_determinant(std::size_t l) const;

  const Mechanism& mechanism_;
  Derivation& d_;
  Frames frames_;
  std::vector<Loop> loops_;
};

}  // namespace flatdyn
