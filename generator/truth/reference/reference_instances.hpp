// SPDX-License-Identifier: GPL-2.0-or-later
// Declarations of the numeric reference's templates, which take long to compile: they are instantiated once for each
// scalar, in reference_double.cpp and its siblings. This header is precompiled, so that no other file instantiates
// them.
#pragma once

#include "flatdyn/reference/derivatives.hpp"
#include "flatdyn/reference/operational.hpp"
#include "flatdyn/reference/real50.hpp"

// EXTERN: with `extern`, declares that the functions over S are instantiated elsewhere; empty, instantiates them.
#define FLATDYN_REFERENCE_OVER(S, EXTERN)                                                                              \
  namespace flatdyn::reference {                                                                                       \
  EXTERN template std::vector<LinkMotion<S>> link_motions(const Robot<S>&, const VectorX<S>&, const VectorX<S>&,       \
                                                          const VectorX<S>&, bool);                                    \
  EXTERN template VectorX<S> inverse_dynamics(const Robot<S>&, const VectorX<S>&, const VectorX<S>&,                   \
                                              const VectorX<S>&, const Environment<S>&);                               \
  EXTERN template MatrixX<S> inertia_matrix(const Robot<S>&, const VectorX<S>&);                                       \
  EXTERN template VectorX<S> bias(const Robot<S>&, const VectorX<S>&, const VectorX<S>&);                              \
  EXTERN template VectorX<S> gravity(const Robot<S>&, const VectorX<S>&);                                              \
  EXTERN template VectorX<S> forward_dynamics(const Robot<S>&, const VectorX<S>&, const VectorX<S>&,                   \
                                              const VectorX<S>&);                                                      \
  EXTERN template MatrixX<S> christoffel(const Robot<S>&, const VectorX<S>&);                                          \
  EXTERN template MatrixX<S> coriolis_matrix(const Robot<S>&, const VectorX<S>&, const VectorX<S>&);                   \
  EXTERN template Derivatives<S> inverse_dynamics_derivatives(const Robot<S>&, const VectorX<S>&, const VectorX<S>&,   \
                                                              const VectorX<S>&);                                      \
  EXTERN template AccelerationDerivatives<S> forward_dynamics_derivatives(const Robot<S>&, const VectorX<S>&,          \
                                                                          const VectorX<S>&, const VectorX<S>&);       \
  EXTERN template std::vector<Pose<S>> link_poses(const Robot<S>&, const VectorX<S>&);                                 \
  EXTERN template Pose<S> tip_pose(const Robot<S>&, const VectorX<S>&);                                                \
  EXTERN template MatrixX<S> jacobian(const Robot<S>&, const VectorX<S>&);                                             \
  EXTERN template VectorX<S> jacobian_dot_qd(const Robot<S>&, const VectorX<S>&, const VectorX<S>&);                   \
  EXTERN template S potential_energy(const Robot<S>&, const VectorX<S>&);                                              \
  EXTERN template S kinetic_energy(const Robot<S>&, const VectorX<S>&, const VectorX<S>&);                             \
  EXTERN template MatrixX<S> task_jacobian(const Robot<S>&, const VectorX<S>&, const Task<S>&);                        \
  EXTERN template VectorX<S> task_drift(const Robot<S>&, const VectorX<S>&, const VectorX<S>&, const Task<S>&);        \
  EXTERN template OperationalSpace<S> operational_space(const Robot<S>&, const VectorX<S>&, const Task<S>&);           \
  EXTERN template MatrixX<S> consistent_inverse(const OperationalSpace<S>&);                                           \
  EXTERN template S condition(const OperationalSpace<S>&);                                                             \
  EXTERN template VectorX<S> operational_coriolis(const Robot<S>&, const VectorX<S>&, const VectorX<S>&,               \
                                                  const Task<S>&);                                                     \
  EXTERN template VectorX<S> operational_gravity(const Robot<S>&, const VectorX<S>&, const Task<S>&);                  \
  EXTERN template VectorX<S> null_space_torque(const Robot<S>&, const VectorX<S>&, const VectorX<S>&, const Task<S>&); \
  EXTERN template VectorX<S> loop_closure(const Robot<S>&, const VectorX<S>&);                                         \
  EXTERN template MatrixX<S> loop_jacobian(const Robot<S>&, const VectorX<S>&);                                        \
  EXTERN template MatrixX<S> loop_motion(const Robot<S>&, const VectorX<S>&);                                          \
  EXTERN template VectorX<S> loop_drift(const Robot<S>&, const VectorX<S>&, const VectorX<S>&);                        \
  EXTERN template VectorX<S> loop_step(const Robot<S>&, const VectorX<S>&);                                            \
  EXTERN template bool close_loops(const Robot<S>&, VectorX<S>&, const S&);                                            \
  EXTERN template S loop_regularity(const Robot<S>&, const VectorX<S>&);                                               \
  }

FLATDYN_REFERENCE_OVER(double, extern)
FLATDYN_REFERENCE_OVER(Real50, extern)
