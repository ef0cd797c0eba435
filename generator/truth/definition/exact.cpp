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

ExactResult finished(const Function& function, const std::set<MismatchKey>& mismatches, int entries, double degree,
                     const ExactOptions& options) {
  ExactResult result;
  result.equal = mismatches.empty();
  result.entries = entries;
  result.primes = 3;
  result.points = result.primes * options.points;
  result.degree_bound = degree;
  const double per_point = std::log2(std::max(1.0, degree)) - kLog2Prime;
  result.failure_log2 = std::min(0.0, std::log2(std::max(1, entries)) + per_point * result.points);
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
                          const ExactOptions& options) {
  int entries = 0;
  const auto compare = [&]<std::uint64_t P>(FieldArithmetic<ModP<P>>& arithmetic, std::set<MismatchKey>& mismatches) {
    const auto values = evaluate(function, arithmetic);
    // The function itself is given velocities in any case: if it holds at rest, it must not read them.
    auto lagrangian_arithmetic = function.at_rest ? arithmetic.at_rest() : arithmetic;
    DefinitionPoint<ModPArithmetic<P>> point(mechanism, function, lagrangian_arithmetic, values);
    entries = compare_at<P>(point, definition, mismatches);
  };
  const std::set<MismatchKey> mismatches = at_all_points(options, mechanism.quaternions(), compare);
  const MechanismDegrees lagrangian =
      definition.is_over_parameters ? regressor_degrees(mechanism) : lagrangian_degrees(mechanism);
  const FunctionDegrees own = function_degrees(function);
  const double degree = in_drawn_values(
      degree_factor(mechanism, function, definition) * (lagrangian.degree + own.numerator + own.denominator),
      drawn_angles(function, mechanism), lagrangian.reciprocals);
  return finished(function, mismatches, entries, degree, options);
}

namespace {

// Compares derivatives with those of a function over dual numbers, at one point.
template <std::uint64_t P>
class DerivativeComparison {
 public:
  using F = ModP<P>;

  DerivativeComparison(const Mechanism& mechanism, const Function& derivatives, const Function& of,
                       FieldArithmetic<F>& arithmetic, std::set<MismatchKey>& mismatches)
      : derivatives_(derivatives),
        of_(of),
        arithmetic_(arithmetic),
        values_(evaluate(derivatives, arithmetic)),
        at_(arithmetic.at_rest()),
        dual_(mechanism, of, derivatives.at_rest ? at_ : arithmetic),
        mismatches_(mismatches) {}

  // Returns the number of entries compared.
  int compare(Derivative derivative) {
    if (derivative == Derivative::jacobian_times_vector) {
      compare_rates();
    } else {
      for (int k = 0; k < dual_.directions(); ++k) columns_.push_back(dual_.derivatives_by(k));
    }
    if (derivative == Derivative::vector_times_jacobian) compare_weighted();
    if (derivative == Derivative::jacobian) compare_matrices();
    if (derivative == Derivative::contracted_hessian) compare_hessian();
    return entries_;
  }

 private:
  void expect(std::size_t output, std::size_t entry, const F& value) {
    const Output& own = derivatives_.outputs[output];
    if (own.leaves_out(entry)) return;
    ++entries_;
    if (!(values_[static_cast<std::size_t>(own.entries[entry])] == value)) {
      mismatches_.emplace(output, static_cast<int>(entry));
    }
  }

  void compare_rates() {
    std::vector<F> direction;
    for (int k = 0; k < dual_.directions(); ++k) direction.push_back(arithmetic_.input({InputKind::direction, k}));
    const std::vector<F> rates = dual_.derivatives_along(direction);
    std::size_t place = 0;
    for (std::size_t o = 0; o < of_.outputs.size(); ++o) {
      for (std::size_t e = 0; e < of_.outputs[o].entries.size(); ++e) expect(o, e, rates[place++]);
    }
  }

  void compare_weighted() {
    for (std::size_t b = 0; b < dual_.blocks().size(); ++b) {
      const auto& block = dual_.blocks()[b];
      for (int k = 0; k < block.length; ++k) {
        F sum(0);
        int entry = 0;
        for (const F& derivative : column(block.first + k)) {
          sum += arithmetic_.input({InputKind::weights, entry++}) * derivative;
        }
        if (block.length > 0) expect(b, static_cast<std::size_t>(k), sum);
      }
    }
  }

  void compare_matrices() {
    std::size_t output = 0, first = 0;
    for (const Output& own : of_.outputs) {
      for (const auto& block : dual_.blocks()) {
        if (block.length == 0) continue;
        std::size_t entry = 0;
        for (std::size_t row = 0; row < own.entries.size(); ++row) {
          for (int k = 0; k < block.length; ++k) expect(output, entry++, column(block.first + k)[first + row]);
        }
        ++output;
      }
      first += own.entries.size();
    }
  }

  // Pairs of arguments that have no output must have zeros.
  void compare_hessian() {
    std::size_t output = 0;
    for (auto a = dual_.blocks().begin(); a != dual_.blocks().end(); ++a) {
      for (auto b = a; b != dual_.blocks().end(); ++b) {
        if (a->length == 0 || b->length == 0) continue;
        const std::string name = "H_" + name_of(a->kind) + "_" + name_of(b->kind);
        const bool is_there = output < derivatives_.outputs.size() && derivatives_.outputs[output].name == name;
        std::size_t entry = 0;
        for (int k = a->first; k < a->first + a->length; ++k) {
          for (int l = b->first; l < b->first + b->length; ++l) {
            const F& value = column(l)[static_cast<std::size_t>(k)];
            if (is_there) expect(output, entry++, value);
            if (!is_there && !(value == F(0))) mismatches_.emplace(derivatives_.outputs.size(), entries_);
          }
        }
        if (is_there) ++output;
      }
    }
  }

  static std::string name_of(InputKind argument) {
    return argument == InputKind::parameter ? "parameters" : argument_row(argument).name;
  }

  const std::vector<F>& column(int k) const { return columns_[static_cast<std::size_t>(k)]; }

  const Function &derivatives_, &of_;
  FieldArithmetic<F>& arithmetic_;
  std::vector<F> values_;
  FieldArithmetic<F> at_;  // at rest
  DualPoint<P> dual_;
  std::set<MismatchKey>& mismatches_;
  std::vector<std::vector<F>> columns_;  // by direction
  int entries_ = 0;
};

}  // namespace

ExactResult prove_derivatives(const Mechanism& mechanism, const Function& derivatives, const Function& of,
                              Derivative derivative, const ExactOptions& options) {
  int entries = 0;
  const auto compare = [&]<std::uint64_t P>(FieldArithmetic<ModP<P>>& arithmetic, std::set<MismatchKey>& mismatches) {
    entries = DerivativeComparison<P>(mechanism, derivatives, of, arithmetic, mismatches).compare(derivative);
  };
  const std::set<MismatchKey> mismatches = at_all_points(options, mechanism.quaternions(), compare);
  const FunctionDegrees own = function_degrees(derivatives), function = function_degrees(of);
  // A derivative of N / D has the numerator N' D - N D' over D², times a weight and a rate.
  const double degree = 2 * (function.numerator + function.denominator) + 2;
  const double angles = drawn_angles(derivatives, mechanism) + drawn_angles(of, mechanism);
  return finished(derivatives, mismatches, entries,
                  std::max(root_factor(derivatives), root_factor(of)) *
                      in_drawn_values(degree + own.numerator + own.denominator, angles, 0),
                  options);
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
  return fmt::format(
      "{} entries equal at {} points modulo {} primes; degree at most {:.3g}; wrong with probability below 2^{:.0f}",
      entries, points, primes, degree_bound, std::ceil(failure_log2));
}

}  // namespace flatdyn
