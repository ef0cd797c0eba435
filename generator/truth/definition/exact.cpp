// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/definition/exact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "base/diagnostics/diagnostics.hpp"
#include "graph/mod_p.hpp"
#include "truth/definition/definition_point.hpp"
#include "truth/definition/degree.hpp"
#include "truth/definition/derivative_places.hpp"
#include "truth/definition/dual_point.hpp"

namespace flatdyn {
namespace {

constexpr double kLog2Prime = 60.99;  // all primes are above 2^60.99

using MismatchKey = std::tuple<std::size_t, int>;  // output, entry

// The (row, column) of an entry in the output's layout.
ExactMismatch describe(const std::string& name, int cols, int entry) {
  return {name, entry, cols > 0 ? entry / cols : 0, cols > 0 ? entry % cols : 0};
}

std::vector<ExactMismatch> describe(const Function& function, const std::set<MismatchKey>& keys) {
  std::vector<ExactMismatch> result;
  for (const auto& [output, entry] : keys) {
    if (output == function.outputs.size()) {
      result.push_back(describe("positive", 1, entry));
    } else {
      result.push_back(describe(function.outputs[output].name, function.outputs[output].cols, entry));
    }
  }
  return result;
}

// Runs `compare(arithmetic, mismatches)` at one point of one field, with unit quaternions at these entries of q. If it
// divides by zero, which has probability below D/p, or takes the square root of a non-square, which has probability
// 1/2, another point is drawn.
template <std::uint64_t P, class Compare>
void at_point(std::uint64_t seed, const std::vector<int>& quaternions, const Compare& compare,
              std::set<MismatchKey>& mismatches) {
  constexpr int kAttempts = 64;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    try {
      const ModPArithmetic<P> drawn(splitmix64(seed, static_cast<std::uint64_t>(attempt)));
      ModPArithmetic<P> arithmetic = drawn.with_quaternions(quaternions);
      compare(arithmetic, mismatches);
      return;
    } catch (const std::domain_error&) {
      continue;
    }
  }
  throw Failure(FailureKind::unsupported, "the function divides by zero at every position",
                "give the links between its joints their inertia");
}

template <class Compare>
std::set<MismatchKey> at_all_points(const ExactOptions& options, const std::vector<int>& quaternions,
                                    const Compare& compare) {
  std::set<MismatchKey> mismatches;
  for (int point = 0; point < options.points; ++point) {
    const std::uint64_t seed = splitmix64(options.seed, static_cast<std::uint64_t>(point));
    at_point<kMersenne61>(seed, quaternions, compare, mismatches);
    at_point<kPrime61b>(seed, quaternions, compare, mismatches);
    at_point<kPrime61c>(seed, quaternions, compare, mismatches);
  }
  return mismatches;
}

// log2 of the probability that a difference of this degree is not seen at one point.
double unseen_log2(double degree) { return std::log2(std::max(1.0, degree)) - kLog2Prime; }

// With as many points as the degree asks for.
ExactOptions with_enough_points(ExactOptions options, const Function& function, double degree) {
  constexpr int kPrimes = 3;
  const double per_point = unseen_log2(degree), entries = static_cast<double>(entry_count(function));
  if (options.most_points <= options.points || per_point >= 0) return options;
  const double points = (kEnoughLog2 - std::log2(std::max(1.0, entries))) / per_point;
  options.points = std::clamp(static_cast<int>(std::ceil(points / kPrimes)), options.points, options.most_points);
  return options;
}

ExactResult finished(const Function& function, const std::set<MismatchKey>& mismatches, int entries, double degree,
                     const ExactOptions& options) {
  ExactResult result;
  result.equal = mismatches.empty();
  result.entries = entries;
  result.primes = 3;
  result.points = result.primes * options.points;
  result.degree_bound = degree;
  result.failure_log2 = std::min(0.0, std::log2(std::max(1, entries)) + unseen_log2(degree) * result.points);
  result.mismatches = describe(function, mismatches);
  return result;
}

// With closed loops, the determinants of the loops are common denominators, see Degree.
double degree_factor(const Mechanism& mechanism, const Function& function, const Definition& definition) {
  return (mechanism.has_loops() ? 2 : 1) * definition.degree_factor(mechanism, function);
}

}  // namespace

namespace {

// Compares every output that is not left out at one point; returns the number of entries compared.
template <std::uint64_t P>
int compare_at(DefinitionPoint<ModPArithmetic<P>>& point, const Definition& definition,
               std::set<MismatchKey>& mismatches) {
  int entries = 0;
  const Function& function = point.function;
  for (std::size_t k = 0; k < function.outputs.size(); ++k) {
    const Output& output = function.outputs[k];
    const auto expected = definition.expected.over<P>()(point, output);
    const auto found = definition.found.over<P>()(point, output);
    if (expected.size() != found.size()) {
      throw Failure(FailureKind::bug, "output " + output.name + " of " + function.name + " has the wrong shape");
    }
    for (std::size_t e = 0; e < expected.size(); ++e) {
      if (output.leaves_out(e)) continue;
      if (!(expected[e] == found[e])) mismatches.emplace(k, static_cast<int>(e));
      ++entries;
    }
  }
  return entries;
}

}  // namespace

ExactResult prove_exactly(const Mechanism& mechanism, const Function& function, const Definition& definition,
                          const ExactOptions& asked) {
  int entries = 0;
  const auto compare = [&]<std::uint64_t P>(FieldArithmetic<ModP<P>>& arithmetic, std::set<MismatchKey>& mismatches) {
    const auto values = evaluate(function, arithmetic);
    // The function itself is given velocities in any case: if it holds at rest, it must not read them.
    auto lagrangian_arithmetic = function.at_rest ? arithmetic.at_rest() : arithmetic;
    DefinitionPoint<ModPArithmetic<P>> point(mechanism, function, lagrangian_arithmetic, values);
    entries = compare_at<P>(point, definition, mismatches);
  };
  const MechanismDegrees lagrangian =
      definition.is_over_parameters ? regressor_degrees(mechanism) : lagrangian_degrees(mechanism);
  const FunctionDegrees own = function_degrees(function);
  const double factor = degree_factor(mechanism, function, definition), of_own = own.numerator + own.denominator;
  const double degree = in_drawn_values(
      definition.is_apart ? 2 * factor * lagrangian.degree + of_own : factor * (lagrangian.degree + of_own),
      drawn_angles(function, mechanism), lagrangian.reciprocals);
  const ExactOptions options = with_enough_points(asked, function, degree);
  const std::set<MismatchKey> mismatches = at_all_points(options, mechanism.quaternions(), compare);
  return finished(function, mismatches, entries, degree, options);
}

namespace {

// A function whose derivatives are compared, and which ones.
struct Differentiated {
  const Function& function;
  Derivative derivative;
  const Tangents& tangents;
  const DerivativePlaces& places;
};

// The entries that the derivatives must have, in order, from the function over dual numbers.
template <std::uint64_t P>
std::vector<ModP<P>> expected_derivatives(const Mechanism& mechanism, const Differentiated& of,
                                          FieldArithmetic<ModP<P>>& arithmetic) {
  using F = ModP<P>;
  DualPoint<P> dual(mechanism, of.function, of.tangents, arithmetic);
  if (of.derivative == Derivative::jacobian_times_vector) {
    std::vector<F> direction;
    for (int k = 0; k < of.tangents.count(); ++k) direction.push_back(arithmetic.input({InputKind::direction, k}));
    return dual.derivatives_along(direction);
  }
  const std::vector<std::vector<F>> columns = dual.derivatives();
  std::vector<F> expected;
  if (of.derivative == Derivative::vector_times_jacobian) {
    for (const std::vector<F>& column : columns) {
      F sum(0);
      int entry = 0;
      for (const F& derivative : column) sum += arithmetic.input({InputKind::weights, entry++}) * derivative;
      expected.push_back(sum);
    }
  }
  for (const DerivativePlace& place : of.places.left_out) {
    if (columns[place.column][place.row] == F(0)) continue;
    throw Failure(FailureKind::bug, "a matrix of second derivatives that are not zero is missing");
  }
  for (const DerivativePlace& place : of.places.entries) {
    const std::vector<F>& column = columns[place.column];
    if (place.row >= column.size()) throw Failure(FailureKind::bug, "a Jacobian has more rows than its function");
    expected.push_back(column[place.row]);
  }
  return expected;
}

// Compares the entries of all outputs that are not left out, in order; returns how many these are.
template <class F>
int compare_entries(const Function& function, const std::vector<F>& values, const std::vector<F>& expected,
                    std::set<MismatchKey>& mismatches) {
  int entries = 0;
  std::size_t place = 0;
  if (expected.size() != entry_count(function)) {
    throw Failure(FailureKind::bug, function.name + " has the wrong shape");
  }
  for (std::size_t k = 0; k < function.outputs.size(); ++k) {
    const Output& output = function.outputs[k];
    for (std::size_t e = 0; e < output.entries.size(); ++e, ++place) {
      if (output.leaves_out(e)) continue;
      ++entries;
      const bool is_right = values[static_cast<std::size_t>(output.entries[e])] == expected[place];
      if (!is_right) mismatches.emplace(k, static_cast<int>(e));
    }
  }
  return entries;
}

}  // namespace

ExactResult prove_derivatives(const Mechanism& mechanism, const Function& derivatives, const Function& of,
                              Derivative derivative, const ExactOptions& asked) {
  int entries = 0;
  const Tangents tangents(mechanism, of.inputs, of.base_parameters);
  const DerivativePlaces places = derivative_places(derivatives, derivative, tangents);
  const auto compare = [&]<std::uint64_t P>(FieldArithmetic<ModP<P>>& arithmetic, std::set<MismatchKey>& mismatches) {
    const auto values = evaluate(derivatives, arithmetic);
    auto of_arithmetic = derivatives.at_rest ? arithmetic.at_rest() : arithmetic;
    const auto expected = expected_derivatives<P>(mechanism, {of, derivative, tangents, places}, of_arithmetic);
    entries = compare_entries(derivatives, values, expected, mismatches);
  };
  const FunctionDegrees own = function_degrees(derivatives), function = function_degrees(of);
  // A derivative of N / D has the numerator N' D - N D' over D², times a weight and a rate.
  const double expected = 2 * (function.numerator + function.denominator) + 2;
  const double angles = drawn_angles(derivatives, mechanism) + drawn_angles(of, mechanism);
  const double degree = std::max(root_factor(derivatives), root_factor(of)) *
                        in_drawn_values(expected + own.numerator + own.denominator, angles, 0);
  const ExactOptions options = with_enough_points(asked, derivatives, degree);
  const std::set<MismatchKey> mismatches = at_all_points(options, mechanism.quaternions(), compare);
  return finished(derivatives, mismatches, entries, degree, options);
}

ExactResult prove_equal(const Function& a, const Function& b, const ExactOptions& options) {
  const std::vector<NodeId> roots_a = roots(a), roots_b = roots(b);
  ExactResult different_shape;
  if (roots_a.size() != roots_b.size() || a.outputs.size() != b.outputs.size()) return different_shape;
  for (std::size_t k = 0; k < a.outputs.size(); ++k) {
    if (a.outputs[k].entries.size() != b.outputs[k].entries.size()) return different_shape;
  }
  const auto compare = [&](auto& arithmetic, std::set<MismatchKey>& mismatches) {
    const auto in_a = evaluate(a, arithmetic), in_b = evaluate(b, arithmetic);
    const auto differ = [&](NodeId x, NodeId y) {
      return !(in_a[static_cast<std::size_t>(x)] == in_b[static_cast<std::size_t>(y)]);
    };
    for (std::size_t k = 0; k < a.outputs.size(); ++k) {
      for (std::size_t e = 0; e < a.outputs[k].entries.size(); ++e) {
        if (differ(a.outputs[k].entries[e], b.outputs[k].entries[e])) mismatches.emplace(k, static_cast<int>(e));
      }
    }
    for (std::size_t e = 0; e < a.validity_conditions.size(); ++e) {
      if (differ(a.validity_conditions[e], b.validity_conditions[e]))
        mismatches.emplace(a.outputs.size(), static_cast<int>(e));
    }
    for (std::size_t e = 0; e < a.pivot_scales.size(); ++e) {
      if (differ(a.pivot_scales[e], b.pivot_scales[e])) mismatches.emplace(a.outputs.size(), static_cast<int>(e));
    }
  };
  const std::set<MismatchKey> mismatches = at_all_points(options, {}, compare);
  const FunctionDegrees in_a = function_degrees(a), in_b = function_degrees(b);
  const double angles = drawn_angles(a, {}) + drawn_angles(b, {});
  const double degree =
      std::max(root_factor(a), root_factor(b)) *
      in_drawn_values(in_a.numerator + in_a.denominator + in_b.numerator + in_b.denominator, angles, 0);
  return finished(a, mismatches, static_cast<int>(roots_a.size()), degree, options);
}

std::string ExactResult::summary() const {
  if (!equal) {
    if (mismatches.empty()) return "outputs of different shape";
    const ExactMismatch& first = mismatches.front();
    return fmt::format("{} of {} entries differ, the first is {}[{}, {}]", mismatches.size(), entries, first.output,
                       first.row, first.col);
  }
  const std::string equal_at = fmt::format("{} entries equal at {} points modulo {} primes; degree at most {:.3g}",
                                           entries, points, primes, degree_bound);
  if (is_weak()) return equal_at + ", too large to bound the probability of an error";
  return fmt::format("{}; wrong with probability below 2^{:.0f}", equal_at, std::ceil(failure_log2));
}

}  // namespace flatdyn
