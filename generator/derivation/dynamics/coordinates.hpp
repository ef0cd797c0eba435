// SPDX-License-Identifier: GPL-2.0-or-later
// Conversion between the coordinates and the joints of the tree: the joints move by q_joint = A q, and torques τ at the
// joints are Aᵀ τ at the coordinates. If no joint is coupled, both are the same. With closed loops, A G replaces A for
// rates and torques, with q̇ = G q̇_a (derivation/loops/loops.hpp), and accelerations have the drift of A G. The motion
// of a floating base has its own coordinates, in addition to these.
#pragma once

#include <array>
#include <map>

#include "derivation/kernel/jacobian_column.hpp"
#include "derivation/kernel/joint_angles.hpp"

namespace flatdyn {

// The rates or accelerations of all bodies' joints, from the inputs of this kind.
std::vector<Number> joint_motion(const Mechanism& mechanism, Derivation& derivation, InputKind kind);
// The accelerations of all bodies' joints while those of the coordinates are zero: d(A G)/dt times rates of this kind.
// They are zero unless loops are closed.
std::vector<Number> joint_drift(const Mechanism& mechanism, Derivation& derivation, InputKind kind_r);
// The second derivatives of all bodies' joint positions by coordinates j and k. For closed loops only.
std::vector<Number> joint_curvature(const Mechanism& mechanism, Derivation& derivation, int j, int k);
// The derivative of A G while the coordinates have their rates: a row for each body's joint, a column for each
// coordinate; zeros for a floating base. For closed loops only.
Rows joint_motion_rate(const Mechanism& mechanism, Derivation& derivation);
// The rates of all bodies' joints from those of the coordinates. `name`: prefix of the sums' names.
std::vector<Number> joint_motion(const Mechanism& mechanism, Derivation& derivation,
                                 const std::vector<Number>& coordinates, const std::string& name);

// Aᵀ τ for torques τ at all bodies' joints. `name`: prefix of the sums' names.
std::vector<Number> at_coordinates(const Mechanism& mechanism, Derivation& derivation, const std::vector<Number>& tau,
                                   const std::string& name);

// Aᵀ M for a matrix M with a row for each body's joint.
Rows rows_at_coordinates(const Mechanism& mechanism, Derivation& derivation, const Rows& matrix,
                         const std::string& name);

// Aᵀ M A. `symmetric`: the upper half is copied from the lower one.
enum class Shape { general, symmetric };
Rows at_coordinates(const Mechanism& mechanism, Derivation& derivation, const Rows& matrix, Shape shape,
                    const std::string& name);

// c_ijk with j <= k at the coordinates, from those of the joints: Σ a_ri a_sj a_tk c_rst, without the contributions of
// closed loops.
using ChristoffelSymbols = std::map<std::array<int, 3>, Number>;
ChristoffelSymbols at_coordinates(const Mechanism& mechanism, Derivation& derivation, const ChristoffelSymbols& c);

// J A, the columns of a Jacobian at the coordinates.
std::vector<JacobianColumn> at_coordinates(const Mechanism& mechanism, Derivation& derivation,
                                           const std::vector<JacobianColumn>& columns);

}  // namespace flatdyn
