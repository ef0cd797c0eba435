// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/verify/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "base/diagnostics/table.hpp"
#include "functions/exact_proof.hpp"
#include "proof/verify/compiled.hpp"
#include "proof/verify/properties.hpp"
#include "robot/model/angles.hpp"
#include "robot/model/inertia_bound.hpp"
#include "truth/reference/graph_evaluator.hpp"

namespace flatdyn {
namespace {

// Bounds the difference after 50-digit sums: the mechanism's constants are rationals within 1e-40 of the written ones.
constexpr double kGraphTolerance = 1e-35;
// The same where tanh is a rational function within 2e-17 of it (graph/rational_tanh.hpp).
constexpr double kSmoothFrictionTolerance = 1e-14;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Subject {
  const Function& function;
  std::size_t index;
};

class Comparison {
 public:
  Comparison(const Robot& robot, const Mechanism& mechanism, const std::vector<Function>& functions,
             const VerifyOptions& options)
      : mechanism_(mechanism),
        expected_(robot, mechanism, options.seed),
        compiled_(mechanism, functions),
        random_(expected_.with_closed_loops(
            with_parameters(random_states(mechanism, options.states, options.seed), expected_.symbols()))),
        edge_(with_parameters(edge_states(mechanism), expected_.symbols())) {
    draw_own_arguments(random_, functions, options.seed);
    draw_own_arguments(edge_, functions, options.seed);
  }

  void compare(const Subject& subject, FunctionReport& report) const {
    const Function& function = subject.function;
    const Expected expected = expected_.of(function);
    GraphEvaluator<Real50> graph(function);
    std::vector<double> generated, generated_at_edges, reference;
    const std::size_t count = affordable_states(function, random_.empty() ? 1 : random_[0].q.size(), random_.size());
    // If evaluation is expensive, about as many edge states as random ones are used.
    constexpr std::size_t kFewestEdges = 4;
    const std::size_t stride = std::max<std::size_t>(1, edge_.size() / std::max(count, kFewestEdges));
    for (std::size_t k = 0; k < count + (edge_.size() + stride - 1) / stride; ++k) {
      const bool is_edge = k >= count;
      // The function gets the whole state, as from its users: it must not read inputs that it does not depend on.
      const State& given = is_edge ? edge_[(k - count) * stride] : random_[k];
      const State state = state_for(function, given);
      if (!expected.is_regular(state)) continue;
      const auto kept = [&function](const auto& values) { return kept_values(function, values); };
      const std::vector<double> written = compiled_.call(subject.index, given);
      if (says_that_pivots_are_lost(function, written)) {
        ++report.refused;
        continue;
      }
      const std::vector<Real50> truth = kept(expected.exact(state));
      const std::vector<double> scale = kept(expected.scale(state));
      const auto from_graph = graph(with_unit_quaternions(mechanism_, widened<Real50>(given)));
      report.graph_error =
          std::max(report.graph_error, from_graph ? relative_difference(kept(*from_graph), truth, scale) : kInfinity);
      const double error = writes_too_much(function, written) ? kInfinity : scaled_error(kept(written), truth, scale);
      if (is_edge) {
        generated_at_edges.push_back(error / angle_rounding(state));
      } else {
        generated.push_back(error);
        reference.push_back(scaled_error(kept(expected.rounded(state)), truth, scale));
      }
    }
    report.generated = summary(generated);
    report.at_edges = summary(generated_at_edges);
    report.reference = summary(reference);
  }

  const std::vector<State>& random() const { return random_; }

 private:
  static double relative_difference(const std::vector<Real50>& a, const std::vector<Real50>& b,
                                    const std::vector<double>& scale) {
    double largest = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
      const double difference = Real50(abs(a[k] - b[k])).convert_to<double>();
      if (!(difference >= 0)) return kInfinity;
      largest = std::max(largest, scale[k] > 0 ? difference / scale[k] : difference);
    }
    return largest;
  }

  static bool says_that_pivots_are_lost(const Function& function, const std::vector<double>& written) {
    return compares_pivots(function) &&
           std::all_of(written.begin(), written.end(), [](double entry) { return std::isnan(entry); });
  }

  // Whether the function writes entries that are left out; they were set to NaN before.
  static bool writes_too_much(const Function& function, const std::vector<double>& written) {
    std::size_t k = 0;
    for (const Output& output : function.outputs) {
      for (std::size_t e = 0; e < output.entries.size(); ++e, ++k) {
        if (output.leaves_out(e) && !std::isnan(written[k])) return true;
      }
    }
    return false;
  }

  // Emitted code may add the angles of parallel joints; the sum's last place is worth this many last places of an angle
  // below 1.
  static double angle_rounding(const State& state) {
    double sum = 1;
    for (const double q : state.q) sum += std::abs(q);
    return sum;
  }

  const Mechanism& mechanism_;
  ExpectedValues expected_;
  CompiledFunctions compiled_;
  std::vector<State> random_, edge_;
};

std::string short_number(double value) { return fmt::format("{:.2g}", value); }

}  // namespace

bool VerifyReport::passed() const {
  return as_read.holds &&
         std::all_of(functions.begin(), functions.end(), [](const FunctionReport& f) { return f.passed; }) &&
         std::all_of(properties.begin(), properties.end(), [](const Property& p) { return p.passed; });
}

VerifyReport verify(const Robot& robot, const Mechanism& mechanism, const std::vector<Function>& functions,
                    const VerifyOptions& options, Progress& progress) {
  VerifyReport report;
  report.as_read = prove_as_read(robot, mechanism);
  progress.step("compiling the emitted code");
  const double bound = options.bound * largest_angle_factor(mechanism);
  const bool is_smooth = std::any_of(mechanism.bodies.begin(), mechanism.bodies.end(),
                                     [](const Body& body) { return body.dry.is_smooth(); });
  const double graph_bound = is_smooth ? kSmoothFrictionTolerance : kGraphTolerance;
  const Comparison comparison(robot, mechanism, functions, options);
  for (std::size_t k = 0; k < functions.size(); ++k) {
    FunctionReport row;
    row.function = functions[k].name;
    progress.step("verifying " + row.function);
    const ExactResult exact = prove_exactly(mechanism, functions[k], {.most_points = kEnoughPoints});
    row.proven = exact.equal;
    report.failure_log2 = std::max(report.failure_log2, exact.failure_log2);
    comparison.compare({functions[k], k}, row);
    row.passed =
        row.proven && row.graph_error < graph_bound && row.generated.largest <= bound && row.at_edges.largest <= bound;
    report.functions.push_back(row);
  }
  report.properties =
      check_properties(functions, comparison.random(), largest_angle_factor(mechanism),
                       {scaled_inertia_bound(mechanism), positions_of_inertia_bound(mechanism)}, &mechanism);
  return report;
}

std::string to_text(const VerifyReport& report) {
  std::vector<std::vector<std::string>> rows = {
      {"function", "exactly", "50 digits", "double: max", "p99", "edge", "reference: max", "p99", ""}};
  for (const FunctionReport& f : report.functions) {
    rows.push_back({f.function, f.proven ? "equal" : "DIFFERS", short_number(f.graph_error),
                    short_number(f.generated.largest), short_number(f.generated.percentile_99),
                    short_number(f.at_edges.largest), short_number(f.reference.largest),
                    short_number(f.reference.percentile_99), f.passed ? "ok" : "FAILED"});
  }
  std::string text = aligned_table(rows);
  text += report.failure_log2 > kWeakLog2
              ? "\nexactly: against the Lagrangian modulo primes, at random points; degrees are too large to bound the "
                "probability that a wrong function passes\n"
              : fmt::format(
                    "\nexactly: against the Lagrangian modulo primes; a wrong function passes with probability "
                    "below 2^{:.0f}\n",
                    report.failure_log2);
  text += fmt::format("the Lagrangian: {} the robot as read: {}\n", report.as_read.holds ? "that of" : "NOT that of",
                      report.as_read.summary());
  text += "50 digits: largest relative difference from the recursive Newton-Euler reference\n";
  text +=
      "double: scaled errors of the compiled code, in units of the last place of the terms' magnitude\n"
      "edge: the largest at edge states, angles up to a thousand turns, divided by 1 + the sum of all angles\n\n";
  for (const FunctionReport& f : report.functions) {
    if (f.refused == 0) continue;
    text +=
        fmt::format("{} returns false at {} of the states, where a pivot is lost in rounding\n", f.function, f.refused);
  }
  for (const Property& p : report.properties)
    text += fmt::format("{}: {} ({})\n", p.passed ? "ok" : "FAILED", p.name, p.measured);
  return text;
}

nlohmann::ordered_json to_json(const VerifyReport& report) {
  nlohmann::ordered_json json = {{"passed", report.passed()}, {"failure_log2", report.failure_log2}};
  json["robot_as_read"] = {{"holds", report.as_read.holds},
                           {"numbers", report.as_read.numbers},
                           {"digits", report.as_read.digits()},
                           {"difference", report.as_read.difference}};
  json["functions"] = nlohmann::ordered_json::array();
  for (const FunctionReport& f : report.functions) {
    json["functions"].push_back({{"name", f.function},
                                 {"proven", f.proven},
                                 {"graph_error", f.graph_error},
                                 {"max", f.generated.largest},
                                 {"p99", f.generated.percentile_99},
                                 {"edge_max", f.at_edges.largest},
                                 {"reference_max", f.reference.largest},
                                 {"reference_p99", f.reference.percentile_99},
                                 {"refused", f.refused},
                                 {"passed", f.passed}});
  }
  json["properties"] = nlohmann::ordered_json::array();
  for (const Property& p : report.properties) {
    json["properties"].push_back({{"name", p.name}, {"measured", p.measured}, {"passed", p.passed}});
  }
  return json;
}

}  // namespace flatdyn
