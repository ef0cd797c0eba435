// SPDX-License-Identifier: GPL-2.0-or-later
// Closed loops inside one derivation: the closure Φ(q) of each loop in the frame of its carrier, its derivatives along
// the joints of the loop, and what the dependent joints do. Linear equations of up to five unknowns, one loop after
// the other, are solved by Cramer's rule.
#pragma once

#include <functional>
#include <vector>

#include "derivation/kernel/frames.hpp"

namespace flatdyn {

class ClosedLoops {
 public:
  ClosedLoops(const Mechanism& mechanism, Derivation& derivation);

  // Φ, loop by loop: the way from the one end to the other, m, and cosines between axes that meet, and what is across
  // them; zero where the loops are closed.
  std::vector<Number> closure() const;
  // Φ_q, a row for each entry of Φ, a column for each entry of q.
  Rows jacobian() const;
  // G, m × n: q̇ = G q̇_a keeps Φ where it is.
  Rows motion() const;
  // The accelerations of all entries of q for no acceleration of the independent joints: d/dt G times q̇_r = G_r q̇_a,
  // while q̇ moves as `rates`; `rates` and `rates_r` by body.
  std::vector<Number> drift(const std::vector<Number>& rates, const std::vector<Number>& rates_r,
                            const std::string& name) const;
  // Newton's step: what it takes to be added to q, in which independent joints stay where they are.
  std::vector<Number> step() const;

  // By independent joint, the size of the terms whose sum its entry of the diagonal of Gᵀ B G is; `of_tree`: by entry
  // of q, the largest entry of the diagonal of the tree's B.
  std::vector<Number> sizes_of_inertia(const std::vector<Number>& of_tree) const;

  // For each loop, the determinant that is divided by, squared, less a small share of the largest that it could be.
  // Positive, unless the loop is singular or within 1e-6 of it. The scale makes that 6e-5 in float, whose rounding
  // errors are larger (Function::pivot_scales).
  struct Condition {
    NodeId reciprocal;  // of the determinant: who does not need it does not need the condition
    NodeId value, scale;
  };
  std::vector<Condition> conditions() const;

 private:
  // The effect of one joint of the loop on one end, in the loop's axes.
  struct Joint {
    int body = 0;
    bool slides = false;
    Vec3 axis, column;  // z; what the end does per rad or m
    Vec3 link;          // from the joint's frame to the next one's, or to the end
  };
  // From the carrier to one end, in the loop's axes.
  struct Path {
    std::vector<Joint> joints;
    Vec3 end;
    Mat3 R;  // from the end's body
  };
  struct Loop {
    std::vector<Joint> paths[2];
    std::vector<Number> gap;  // by component
    Rows J;                   // by row, by entry of q
    Number determinant, reciprocal;
    Vec3 across[2], axis;  // where axes meet: e_1, e_2 and a, see LoopClosure
    Vec3 normals[2];       // a × e_1, a × e_2
  };
  using Extra = std::function<std::vector<Number>(const Loop&, std::size_t)>;
  // The acceleration of an end while q̈ = 0.
  struct Motion {
    Vec3 omega_u = zero_vector(), omega_v = zero_vector();
    Vec3 domega = zero_vector(), a = zero_vector();
  };

  Path path_to(const LoopClosure& closure, std::size_t end, const std::string& name);
  Loop geometry(const LoopClosure& closure, std::size_t l);
  void find_axes(const LoopClosure& closure, const Path& first, const Path& second, const std::string& name,
                 Loop& loop);
  Number factor(int body, std::size_t position) const;
  // Values of all entries of q: those of the independent ones as given, those of the dependent ones so that
  // Φ_q values + extra = 0.
  std::vector<Number> completed(std::vector<Number> values, const Extra& extra, const std::string& name) const;
  Motion motion_of(const std::vector<Joint>& path, const std::vector<Number>& rates,
                   const std::vector<Number>& rates_r) const;
  std::vector<Number> drift_of(const Loop& loop, std::size_t l, const std::vector<Number>& rates,
                               const std::vector<Number>& rates_r) const;
  std::vector<Number> axis_drift(const Loop& loop, const Motion& first, const Motion& second) const;
  struct Lengths {
    Number squares;  // their sum
    int count;
  };
  // The largest effect of an entry of q per rad or m, squared.
  struct Reach {
    Number moves, turns;  // of the end, of its axis
  };
  Lengths lengths_beyond(const std::vector<Joint>& path, std::size_t j, const LoopClosure::End& end) const;
  Reach reach_of(std::size_t l, int position) const;
  Number length_scale(std::size_t l) const;
  Number largest_determinant(std::size_t l, const Number& scale) const;
  Number largest_column(std::size_t l, int position, const Number& scale) const;  // its length, squared
  void add_dependent(std::size_t l, Rows& squares) const;

  const Mechanism& mechanism_;
  Derivation& d_;
  Frames frames_;
  std::vector<Loop> loops_;
};

}  // namespace flatdyn
