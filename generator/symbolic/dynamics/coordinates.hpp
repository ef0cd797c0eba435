// SPDX-License-Identifier: GPL-2.0-or-later
// From the coordinates to the joints of the tree and back: the joints move by q_joint = A q, and what is felt at the
// joints is felt at the coordinates as Aᵀ τ. Where no joint is coupled, nothing is done. Where loops are closed, rates
// and torques go by A G in place of A, with q̇ = G q̇_a (symbolic/loops/loops.hpp), and accelerations have the drift of A
// G.
#pragma once

#include <array>
#include <map>

#include "symbolic/kernel/jacobian_column.hpp"
#include "symbolic/kernel/joint_angles.hpp"

namespace flatdyn {

// Rates or accelerations of all bodies' joints, of the inputs of this kind.
std::vector<Number> joint_motion(const Mechanism& mechanism, Derivation& derivation, InputKind kind);
// Accelerations of all bodies' joints where those of the coordinates are zero: d(A G)/dt times rates of this kind. Zero
// unless loops are closed.
std::vector<Number> joint_drift(const Mechanism& mechanism, Derivation& derivation, InputKind kind_r);
// Second derivatives of all bodies' joints' positions by coordinates j and k. For closed loops only.
std::vector<Number> joint_curvature(const Mechanism& mechanism, Derivation& derivation, int j, int k);
// Rates of what the coordinates' are. `name`: of the sums.
std::vector<Number> joint_motion(const Mechanism& mechanism, Derivation& derivation,
                                 const std::vector<Number>& coordinates, const std::string& name);

// Aᵀ τ, of torques at all bodies' joints. `name`: of the sums.
std::vector<Number> at_coordinates(const Mechanism& mechanism, Derivation& derivation, const std::vector<Number>& tau,
                                   const std::string& name);

// Aᵀ M, of a matrix with a row for each body's joint.
Rows rows_at_coordinates(const Mechanism& mechanism, Derivation& derivation, const Rows& matrix,
                         const std::string& name);

// Aᵀ M A. `symmetric`: the upper half is taken from the lower one.
enum class Shape { general, symmetric };
Rows at_coordinates(const Mechanism& mechanism, Derivation& derivation, const Rows& matrix, Shape shape,
                    const std::string& name);

// c_ijk with j <= k, of those of the joints: Σ a_ri a_sj a_tk c_rst; without what closed loops add to them.
using ChristoffelSymbols = std::map<std::array<int, 3>, Number>;
ChristoffelSymbols at_coordinates(const Mechanism& mechanism, Derivation& derivation, const ChristoffelSymbols& c);

// J A.
std::vector<JacobianColumn> at_coordinates(const Mechanism& mechanism, Derivation& derivation,
                                           const std::vector<JacobianColumn>& columns);

}  // namespace flatdyn
