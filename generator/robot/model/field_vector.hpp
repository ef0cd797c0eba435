// SPDX-License-Identifier: GPL-2.0-or-later
// Vectors and matrices over any field, and dual numbers over it. Nothing here depends on real numbers.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace flatdyn {

// A dual number value + derivative ε with ε² = 0: it carries one directional derivative, exactly.
template <class F>
struct Dual {
  F value = F(0), derivative = F(0);

  Dual() = default;
  explicit Dual(int zero_or_one) : value(zero_or_one == 0 ? F(0) : F(1)) {}
  explicit Dual(const F& v) : value(v) {}
  Dual(const F& v, const F& d) : value(v), derivative(d) {}

  Dual& operator+=(const Dual& b) {
    value += b.value;
    derivative += b.derivative;
    return *this;
  }
  Dual operator-() const { return {-value, -derivative}; }
  friend Dual operator+(Dual a, const Dual& b) { return a += b; }
  friend Dual operator-(const Dual& a, const Dual& b) { return a + -b; }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, a.value * b.derivative + a.derivative * b.value};
  }
  Dual& operator*=(const Dual& b) { return *this = *this * b; }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const F quotient = a.value / b.value;
    return {quotient, (a.derivative - quotient * b.derivative) / b.value};
  }
  friend Dual operator*(const Dual& a, const F& b) { return {a.value * b, a.derivative * b}; }
  friend Dual operator*(const F& a, const Dual& b) { return b * a; }
};

template <class F>
using Vector3 = std::array<F, 3>;
template <class F>
using Matrix3 = std::array<Vector3<F>, 3>;  // row-major

template <class A, class B>
using Product = std::remove_cv_t<decltype(std::declval<A>() * std::declval<B>())>;

template <class F>
Vector3<F> plus(const Vector3<F>& a, const Vector3<F>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

template <class F>
Vector3<F> minus(const Vector3<F>& a, const Vector3<F>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <class A, class B>
Vector3<Product<A, B>> scaled(const A& a, const Vector3<B>& b) {
  return {a * b[0], a * b[1], a * b[2]};
}

template <class A, class B>
Product<A, B> dot(const Vector3<A>& a, const Vector3<B>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class A, class B>
Vector3<Product<A, B>> cross(const Vector3<A>& a, const Vector3<B>& b) {  // a × b
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class A, class B>
Vector3<Product<A, B>> times(const Matrix3<A>& a, const Vector3<B>& b) {
  return {dot(a[0], b), dot(a[1], b), dot(a[2], b)};
}

template <class F>
Matrix3<F> transposed(const Matrix3<F>& a) {
  return {Vector3<F>{a[0][0], a[1][0], a[2][0]}, Vector3<F>{a[0][1], a[1][1], a[2][1]},
          Vector3<F>{a[0][2], a[1][2], a[2][2]}};
}

template <class A, class B>
Matrix3<Product<A, B>> times(const Matrix3<A>& a, const Matrix3<B>& b) {
  const Matrix3<B> columns = transposed(b);
  Matrix3<Product<A, B>> result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = times(columns, a[i]);
  return result;
}

// A dense matrix, row-major.
template <class F>
class Matrix {
 public:
  Matrix() = default;
  Matrix(int rows, int cols) : cols_(cols), entries_(static_cast<std::size_t>(rows * cols), F{}) {}

  F& operator()(int row, int col) { return entries_[static_cast<std::size_t>(row * cols_ + col)]; }
  const F& operator()(int row, int col) const { return entries_[static_cast<std::size_t>(row * cols_ + col)]; }
  Matrix(int cols, std::vector<F> entries) : cols_(cols), entries_(std::move(entries)) {}

  int cols() const { return cols_; }
  int rows() const { return cols_ == 0 ? 0 : static_cast<int>(entries_.size()) / cols_; }
  const std::vector<F>& entries() const { return entries_; }

 private:
  int cols_ = 0;
  std::vector<F> entries_;
};

template <class F>
Matrix<F> times(const Matrix<F>& a, const Matrix<F>& b) {
  Matrix<F> result(a.rows(), b.cols());
  for (int i = 0; i < a.rows(); ++i) {
    for (int j = 0; j < b.cols(); ++j) {
      for (int k = 0; k < a.cols(); ++k) result(i, j) += a(i, k) * b(k, j);
    }
  }
  return result;
}

template <class F>
std::vector<F> times(const Matrix<F>& a, const std::vector<F>& x) {
  std::vector<F> result(static_cast<std::size_t>(a.rows()), F(0));
  for (int i = 0; i < a.rows(); ++i) {
    for (int j = 0; j < a.cols(); ++j) result[static_cast<std::size_t>(i)] += a(i, j) * x[static_cast<std::size_t>(j)];
  }
  return result;
}

}  // namespace flatdyn
