// SPDX-License-Identifier: BSD-3-Clause
// Calls generated functions with Eigen types: arguments are vectors, results are vectors and matrices by value, each of
// the function's size.
//
//   #include "panda.hpp"
//   #include "flatdyn/eigen.hpp"
//
//   namespace arm = panda::functions;
//   const Eigen::Matrix<double, 7, 1> q = …, qd = …, tau = …;
//   const auto J = flatdyn::eigen<arm::jacobian>(q);                        // Eigen::Matrix<double, 6, 7>
//   const auto B = flatdyn::eigen<arm::inertia_matrix, Eigen::RowMajor>(q); // row by row, as it is computed
//   const auto [R, p] = flatdyn::eigen<arm::forward_kinematics>(q);
//   if (const auto qdd = flatdyn::eigen<arm::forward_dynamics>(q, qd, tau)) move(*qdd);
//
// A function that returns false gives an empty std::optional here. The arguments are those of the function, without its
// outputs: a robot's Parameters first, a source of sines and cosines last; for a function in stages, the stage and the
// inputs that it does not have yet, as in flatdyn::eigen<arm::inertia_matrix>(panda::at(q.data())). Vectors must have
// the function's length at compile time: take x.head<7>() of a longer or an Eigen::Dynamic vector. Christoffel symbols
// are a matrix, c_ijk = c_ikj in row i and column k (k + 1) / 2 + j, j <= k.
//
// Nothing is copied: vectors, and matrices of Eigen::RowMajor, are written where they are returned. For a matrix of
// Eigen::ColMajor, compilers with gnu::flatten compile the function a second time, such that it stores entries in their
// final places; with other compilers entries are stored twice.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>

namespace flatdyn {

namespace eigen_detail {

// The shape of a function's parameter, which is either a result or a vector argument.
template <class Parameter, int order>
struct Shaped {
  using Results = std::tuple<>;
  using Vectors = std::tuple<>;
};

template <class Scalar, std::size_t n, int order>
struct Shaped<const Scalar (&)[n], order> {
  using Results = std::tuple<>;
  using Vectors = std::tuple<Eigen::Matrix<Scalar, int{n}, 1>>;
};

template <class Scalar, std::size_t n, int order>
struct Shaped<Scalar (&)[n], order> {
  using Results = std::tuple<Eigen::Matrix<Scalar, int{n}, 1>>;
  using Vectors = std::tuple<>;
};

// A single row or column, for which storage order does not matter.
template <class Scalar, std::size_t rows, std::size_t columns, int order>
struct Shaped<Scalar (&)[rows][columns], order> {
  static constexpr int kOrder = columns == 1 ? int{Eigen::ColMajor} : rows == 1 ? int{Eigen::RowMajor} : order;
  using Results = std::tuple<Eigen::Matrix<Scalar, int{rows}, int{columns}, kOrder>>;
  using Vectors = std::tuple<>;
};

template <class Shape, int order>
struct Signature;
template <class Returned, class... Parameters, int order>
struct Signature<Returned(Parameters...), order> {
  using Returns = Returned;
  using Results = decltype(std::tuple_cat(std::declval<typename Shaped<Parameters, order>::Results>()...));
  using Vectors = decltype(std::tuple_cat(std::declval<typename Shaped<Parameters, order>::Vectors>()...));
};

template <class Argument>
std::true_type is_eigen(const Eigen::EigenBase<Argument>*);
std::false_type is_eigen(...);
template <class Argument>
inline constexpr bool kIsEigen = decltype(is_eigen(static_cast<const Argument*>(nullptr)))::value;

template <class Type>
struct TypeIs {
  using type = Type;
};

// The scalar type of the first vector; without one, that of the stage.
template <template <class> class Stage, class Scalar>
TypeIs<Scalar> scalar_of_stage(const Stage<Scalar>*);
template <class First, class... Others>
constexpr auto scalar_of() noexcept {
  if constexpr (kIsEigen<First>) {
    return TypeIs<typename First::Scalar>{};
  } else if constexpr ((kIsEigen<Others> || ...)) {
    return scalar_of<Others...>();
  } else {
    return decltype(scalar_of_stage(static_cast<const First*>(nullptr))){};
  }
}

template <class Function, class = void>
inline constexpr bool kLeavesOut = false;
template <class Function>
inline constexpr bool kLeavesOut<Function, std::enable_if_t<Function::leaves_out>> = true;

// The place to which a function writes a result, row by row; entries that it leaves out are zero.
template <class Result, bool leaves_out>
class Target {
 public:
  using Scalar = typename Result::Scalar;
  static constexpr int kRows = Result::RowsAtCompileTime, kColumns = Result::ColsAtCompileTime;
  static constexpr int kSize = kRows * kColumns;
  static constexpr bool kIsInPlace = Result::IsRowMajor || kColumns == 1;

  Target(Result& result) noexcept : result_(result) {  // NOLINT(google-explicit-constructor): an element of a tuple
    if constexpr (leaves_out) {
      for (int k = 0; k < kSize; ++k) data()[k] = Scalar(0.0);
    }
  }

  Scalar* data() noexcept {
    if constexpr (kIsInPlace) {
      return result_.data();
    } else {
      return rows_;
    }
  }

  void finish() noexcept {
    constexpr int kMost = 1024;  // compilers take long for more
    if constexpr (!kIsInPlace && kSize <= kMost) {
      store_all(std::make_integer_sequence<int, kSize>{});
    } else if constexpr (!kIsInPlace) {
      for (int k = 0; k < kSize; ++k) store(k);
    }
  }

 private:
  // Stores the entries one by one, so that the compiler knows their indices.
  template <int... k>
  void store_all(std::integer_sequence<int, k...>) noexcept {
    const int each[] = {(store(k), 0)...};
    static_cast<void>(each);
  }
  void store(int k) noexcept { result_.data()[k % kColumns * kRows + k / kColumns] = rows_[k]; }

  Result& result_;
  Scalar rows_[kIsInPlace ? 1 : kSize];
};

// An argument in the form that a generated function takes: the numbers of a vector, anything else as it is.
template <class Argument, class Vector>
class Passed {
 public:
  Passed(const Argument& argument) noexcept : vector_(argument) {}  // NOLINT(google-explicit-constructor)
  const typename Vector::Scalar* get() const noexcept { return vector_.data(); }

 private:
  static_assert(int{Argument::RowsAtCompileTime} == int{Vector::RowsAtCompileTime} && Argument::ColsAtCompileTime == 1,
                "a column vector of the function's length is expected, which of a longer one is x.head<7>()");
  Eigen::Ref<const Vector> vector_;
};
template <class Argument>
class Passed<Argument, void> {
 public:
  Passed(const Argument& argument) noexcept : argument_(argument) {}  // NOLINT(google-explicit-constructor)
  const Argument& get() const noexcept { return argument_; }

 private:
  const Argument& argument_;
};

// The places of arguments: which are vectors, and how many come before the outputs.
template <class... Arguments>
struct Places {
  static constexpr std::size_t kCount = sizeof...(Arguments);
  static constexpr bool kIsVector[kCount] = {kIsEigen<Arguments>...};

  static constexpr std::size_t vectors_before(std::size_t end) noexcept {
    std::size_t count = 0;
    for (std::size_t k = 0; k < end; ++k) count += kIsVector[k] ? 1 : 0;
    return count;
  }
  static constexpr std::size_t kVectors = vectors_before(kCount);

  // The outputs follow the last vector or, if there is none, the stage.
  static constexpr std::size_t before_outputs() noexcept {
    std::size_t count = kVectors == 0 ? 1 : kCount;
    while (kVectors > 0 && !kIsVector[count - 1]) --count;
    return count;
  }
};

// The index of the function's vector that the argument at a place stands for: a stage may already have the first ones.
template <class Vectors, class Placed, std::size_t place>
constexpr auto vector_at() noexcept {
  constexpr std::size_t count = std::tuple_size_v<Vectors>;
  static_assert(Placed::kVectors <= count, "these are more vectors than the function has inputs");
  if constexpr (Placed::kIsVector[place]) {
    return TypeIs<std::tuple_element_t<count - Placed::kVectors + Placed::vectors_before(place), Vectors>>{};
  } else {
    return TypeIs<void>{};
  }
}

// The type that is returned for one result, several, or none.
template <class Results>
struct ValueOf {
  using Type = Results;
};
template <class Result>
struct ValueOf<std::tuple<Result>> {
  using Type = Result;
};

// Calls the function and inlines it here, so that it stores entries in their final places. Every file has its own copy,
// compiled with its own flags.
template <class OfCall, class Value, class... Arguments>
[[gnu::flatten]] static auto called_in_one(Value& value, const Arguments&... arguments) noexcept {
  return OfCall::called(value, arguments...);
}

template <class Function, class Signature, class... Arguments>
class Call {
 public:
  [[gnu::always_inline]] static auto run(const Arguments&... arguments) noexcept {
    if constexpr (kResults == 0) {
      Value nothing;
      return called(nothing, arguments...);
    } else if constexpr (std::is_same_v<typename Signature::Returns, bool>) {
      return perhaps(arguments...);
    } else {
      return always(arguments...);
    }
  }

  // Returns what the function returns, and its results in `value`.
  template <class AllResults>
  [[gnu::always_inline]] static auto called(AllResults& value, const Arguments&... arguments) noexcept {
    return called_with(value, kAtResults, kAtArguments, arguments...);
  }

 private:
  using Results = typename Signature::Results;
  using Value = typename ValueOf<Results>::Type;
  using Placed = Places<Arguments...>;
  static constexpr std::size_t kResults = std::tuple_size_v<Results>, kBefore = Placed::before_outputs();
  static constexpr std::make_index_sequence<kResults> kAtResults{};
  static constexpr std::make_index_sequence<Placed::kCount> kAtArguments{};
  static constexpr std::make_index_sequence<kBefore> kAtBefore{};
  static constexpr std::make_index_sequence<Placed::kCount - kBefore> kAtBehind{};

  template <std::size_t k>
  using TargetAt = Target<std::tuple_element_t<k, Results>, kLeavesOut<Function>>;
  template <std::size_t k>
  using VectorAt = typename decltype(vector_at<typename Signature::Vectors, Placed, k>())::type;

  template <std::size_t k>
  static auto& result_at(Value& value) noexcept {
    if constexpr (kResults == 1) {
      return value;
    } else {
      return std::get<k>(value);
    }
  }

  // The variable itself is returned, which compilers ensure at the outermost level of a function.
  [[gnu::always_inline]] static Value always(const Arguments&... arguments) noexcept {
    Value value;
    written(value, arguments...);
    return value;
  }

  [[gnu::always_inline]] static std::optional<Value> perhaps(const Arguments&... arguments) noexcept {
    std::optional<Value> value(std::in_place);
    if (!written(*value, arguments...)) value.reset();
    return value;
  }

  [[gnu::always_inline]] static auto written(Value& value, const Arguments&... arguments) noexcept {
    if constexpr (is_in_place(kAtResults)) {
      return called(value, arguments...);
    } else {
      return called_in_one<Call>(value, arguments...);
    }
  }

  template <std::size_t... k>
  static constexpr bool is_in_place(std::index_sequence<k...>) noexcept {
    return (TargetAt<k>::kIsInPlace && ...);
  }

  template <std::size_t... result, std::size_t... place>
  [[gnu::always_inline]] static auto called_with(Value& value, std::index_sequence<result...>,
                                                 std::index_sequence<place...>,
                                                 const Arguments&... arguments) noexcept {
    const std::tuple<Passed<Arguments, VectorAt<place>>...> passed(arguments...);
    std::tuple<TargetAt<result>...> targets(result_at<result>(value)...);
    const auto returned = call(passed, targets, kAtBefore, kAtResults, kAtBehind);
    (std::get<result>(targets).finish(), ...);
    return returned;
  }

  // Returns true for a function that returns nothing.
  template <class AllPassed, class Targets, std::size_t... before, std::size_t... result, std::size_t... behind>
  [[gnu::always_inline]] static auto call(const AllPassed& passed, Targets& targets, std::index_sequence<before...>,
                                          std::index_sequence<result...>, std::index_sequence<behind...>) noexcept {
    const auto function = [&] {
      return Function{}(std::get<before>(passed).get()..., std::get<result>(targets).data()...,
                        std::get<kBefore + behind>(passed).get()...);
    };
    if constexpr (std::is_void_v<decltype(function())>) {
      function();
      return true;
    } else {
      return function();
    }
  }
};

}  // namespace eigen_detail

// Calls `Function` of generated code, such as panda::functions::jacobian, with these arguments. `order`: the storage
// order of the matrices returned, Eigen::ColMajor or Eigen::RowMajor.
template <class Function, int order = Eigen::ColMajor, class... Arguments>
[[gnu::always_inline]] inline auto eigen(const Arguments&... arguments) noexcept {
  using Scalar = typename decltype(eigen_detail::scalar_of<Arguments...>())::type;
  using Signature = eigen_detail::Signature<typename Function::template Shape<Scalar>, order>;
  return eigen_detail::Call<Function, Signature, Arguments...>::run(arguments...);
}

}  // namespace flatdyn
