// SPDX-License-Identifier: GPL-2.0-or-later
// Declarations of Eigen's decompositions and of the loops of its products, which take long to compile: they are
// instantiated once for each scalar, in eigen_instances_*.cpp. This header is precompiled, so that no other file
// instantiates them.
#pragma once

#include <Eigen/Dense>

#include "flatdyn/reference/real50.hpp"

// EXTERN: with `extern`, declares that the decompositions of matrices of S are instantiated elsewhere; empty,
// instantiates them. Only members that are defined outside of their class are worth it: the others may be inlined, and
// are compiled by their users all the same.
#define FLATDYN_EIGEN_DECOMPOSITIONS(S, EXTERN)                                                                        \
  namespace Eigen {                                                                                                    \
  EXTERN template void PartialPivLU<MatrixX<S>>::compute();                                                            \
  EXTERN template LLT<MatrixX<S>>& LLT<MatrixX<S>>::compute(const EigenBase<MatrixX<S>>&);                             \
  EXTERN template void LLT<MatrixX<S>>::_solve_impl(const VectorX<S>&, VectorX<S>&) const;                             \
  EXTERN template void LLT<MatrixX<S>>::_solve_impl(const MatrixX<S>&, MatrixX<S>&) const;                             \
  EXTERN template LDLT<MatrixX<S>>& LDLT<MatrixX<S>>::compute(const EigenBase<MatrixX<S>>&);                           \
  }                                                                                                                    \
  namespace Eigen::internal {                                                                                          \
  EXTERN template struct general_matrix_vector_product<Index, S, const_blas_data_mapper<S, Index, ColMajor>, ColMajor, \
                                                       false, S, const_blas_data_mapper<S, Index, RowMajor>, false>;   \
  EXTERN template struct general_matrix_vector_product<Index, S, const_blas_data_mapper<S, Index, RowMajor>, RowMajor, \
                                                       false, S, const_blas_data_mapper<S, Index, ColMajor>, false>;   \
  EXTERN template struct general_matrix_vector_product<Index, S, const_blas_data_mapper<S, Index, RowMajor>, RowMajor, \
                                                       false, S, const_blas_data_mapper<S, Index, RowMajor>, false>;   \
  EXTERN template struct gebp_kernel<S, S, Index, blas_data_mapper<S, Index, ColMajor>, gebp_traits<S, S>::mr,         \
                                     gebp_traits<S, S>::nr, false, false>;                                             \
  EXTERN template struct triangular_solve_matrix<S, Index, OnTheLeft, Lower, false, ColMajor, ColMajor, 1>;            \
  EXTERN template struct triangular_solve_matrix<S, Index, OnTheLeft, Upper, false, ColMajor, ColMajor, 1>;            \
  EXTERN template struct triangular_solve_matrix<S, Index, OnTheLeft, UnitLower, false, ColMajor, ColMajor, 1>;        \
  EXTERN template struct triangular_solve_matrix<S, Index, OnTheLeft, Upper, false, RowMajor, ColMajor, 1>;            \
  }

// Those of double alone.
#define FLATDYN_EIGEN_DECOMPOSITIONS_OF_DOUBLE(EXTERN)                                                             \
  namespace Eigen {                                                                                                \
  EXTERN template void JacobiSVD<MatrixXd>::allocate(Index, Index, unsigned);                                      \
  EXTERN template JacobiSVD<MatrixXd>& JacobiSVD<MatrixXd>::compute(const MatrixXd&, unsigned);                    \
  EXTERN template void HouseholderQR<MatrixXd>::computeInPlace();                                                  \
  EXTERN template void ColPivHouseholderQR<MatrixXd>::computeInPlace();                                            \
  EXTERN template void FullPivLU<MatrixXd>::computeInPlace();                                                      \
  EXTERN template void CompleteOrthogonalDecomposition<MatrixXd>::computeInPlace();                                \
  EXTERN template void CompleteOrthogonalDecomposition<MatrixXd>::_solve_impl(const MatrixXd::IdentityReturnType&, \
                                                                              MatrixXd&) const;                    \
  EXTERN template SelfAdjointEigenSolver<MatrixXd>& SelfAdjointEigenSolver<MatrixXd>::compute(                     \
      const EigenBase<MatrixXd>&, int);                                                                            \
  EXTERN template SelfAdjointEigenSolver<Matrix3d>& SelfAdjointEigenSolver<Matrix3d>::compute(                     \
      const EigenBase<Matrix3d>&, int);                                                                            \
  EXTERN template SelfAdjointEigenSolver<Matrix4d>& SelfAdjointEigenSolver<Matrix4d>::compute(                     \
      const EigenBase<Matrix4d>&, int);                                                                            \
  EXTERN template void LDLT<MatrixXd>::_solve_impl(const VectorXd&, VectorXd&) const;                              \
  EXTERN template LLT<Matrix4d>& LLT<Matrix4d>::compute(const EigenBase<Matrix4d>&);                               \
  }

FLATDYN_EIGEN_DECOMPOSITIONS(double, extern)
FLATDYN_EIGEN_DECOMPOSITIONS(flatdyn::reference::Real50, extern)
FLATDYN_EIGEN_DECOMPOSITIONS_OF_DOUBLE(extern)
