// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/stress/stress.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "base/diagnostics/nearest.hpp"
#include "functions/deviation/extreme_states.hpp"
#include "laboratory/bench/calls.hpp"
#include "laboratory/bench/same_bits.hpp"
#include "laboratory/stress/program.hpp"
#include "laboratory/stress/worst_state.hpp"
#include "robot/input/csv/names.hpp"
#include "robot/model/angles.hpp"

namespace flatdyn {
namespace {

// The number of random states per batch, so that memory does not grow in a long run.
constexpr int kChunk = 10'000;
// The number of states of each kind that are checked again in 50 digits, and of states next to each.
constexpr std::size_t kRecheckedStates = 3;
constexpr int kNeighbours = 24;
constexpr std::size_t kMostPoints = 400;
// The least error attributed to the reference: one rounding of the terms.
constexpr double kChanceRatio = 1;
constexpr double kLongDoubleServes = 64;
constexpr const char* kEdge = "edge";

int bin_of(double scaled) {
  if (!(scaled > 0)) return 0;
  const double bin = std::floor(2 * (std::log2(scaled) + 8));
  return static_cast<int>(std::clamp(bin, 0.0, kStressBins - 1.0));
}

// The state and some that differ from it by a millionth: their rounding errors are different ones of the same kind.
std::vector<State> neighbours_of(const State& state, unsigned seed) {
  std::mt19937_64 engine(seed);
  const auto part = [&engine] { return (static_cast<double>(engine() >> 11) * 0x1p-52 - 1) * 0x1p-20; };
  std::vector<State> all = {state};
  for (int k = 0; k < kNeighbours; ++k) {
    State next = state;
    for (const InputKind kind : kMotionKinds) {
      for (double& x : next.of(kind)) x += x * part();
    }
    all.push_back(std::move(next));
  }
  return all;
}

struct Suspect {
  State state;
  double error = 0;
};

// Collects the worst few of many states.
class Suspects {
 public:
  void add(const State& state, double error) {
    if (all_.size() == kRecheckedStates && error <= all_.back().error) return;
    all_.push_back({state, error});
    std::stable_sort(all_.begin(), all_.end(), [](const Suspect& a, const Suspect& b) { return a.error > b.error; });
    if (all_.size() > kRecheckedStates) all_.pop_back();
  }
  const std::vector<Suspect>& all() const { return all_; }

 private:
  std::vector<Suspect> all_;
};

// The stress run of one function in one scalar.
class StressRun {
 public:
  StressRun(const Function& function, RoundingErrorMeter meter, std::vector<StressCall> calls,
            const StressOptions& options)
      : meter_(std::move(meter)), calls_(std::move(calls)), options_(options), entries_(entry_count(function)) {
    row_.function = function.name;
    row_.inputs = function.inputs;
    for (const StressCall& call : calls_) row_.variants.emplace_back(call.variant.name, 0);
    row_.histogram.resize(kStressBins);
  }

  void random(const std::vector<State>& states) {
    for (const State& state : states) {
      const std::optional<RoundingError> error = at(state);
      ++row_.states;
      if (!error) continue;
      scaled_.push_back(static_cast<float>(error->scaled));
      ++row_.histogram[static_cast<std::size_t>(bin_of(error->scaled))];
      random_.add(state, error->scaled);
    }
  }

  void edges(const std::vector<State>& states) {
    for (const State& state : states) {
      const std::optional<RoundingError> error = at(state);
      if (!error) continue;
      row_.edge = std::max(row_.edge, error->scaled);
      edges_.add(state, error->scaled);
    }
  }

  StressRow finish(const std::vector<State>& pool, const std::string& scalar) {
    row_.scalar = scalar;
    if (!scaled_.empty()) row_.random = summary({scaled_.begin(), scaled_.end()});
    const auto scaled_error_at = [this](const State& state) {
      const std::optional<RoundingError> error = worst_variant(state).error;
      return error ? error->scaled : 0.0;
    };
    const SearchedState searched = worst_state(scaled_error_at, pool, options_.evaluations, options_.seed);
    look_at("searched", searched.state);
    for (const Suspect& each : random_.all()) look_at("random", each.state);
    for (const Suspect& each : edges_.all()) look_at(kEdge, each.state);
    row_.passed = row_.worst.error.scaled <= options_.bound && row_.lost.ratio <= options_.ratio;
    return std::move(row_);
  }

 private:
  struct Judged {
    std::optional<RoundingError> error;  // none: the function has no value here, or all variants report that
    std::size_t variant = 0;
    std::vector<double> by_variant;
  };

  template <class Wide>
  Judged judged(const State& given, const EntryTruth<Wide>& truth) {
    Judged result;
    VariantResult called{{}, std::vector<double>(entries_)};
    std::optional<VariantResult> plain;
    for (std::size_t v = 0; v < calls_.size(); ++v) {
      result.by_variant.push_back(0);
      called.variant = calls_[v].variant.name;
      called.holds = evaluate(calls_[v], given, called.values);
      if (has_plain_bits(calls_[v].variant)) {
        if (!plain) plain = called;
        check_same_bits(row_.function, *plain, called);
      }
      if (!called.holds) continue;
      const RoundingError error = meter_.error(called.values, truth);
      result.by_variant.back() = error.scaled;
      if (result.error && error.scaled <= result.error->scaled) continue;
      result.error = error;
      result.variant = v;
    }
    return result;
  }

  Judged worst_variant(const State& state) {
    const State given = meter_.given(state);
    const auto truth = meter_.truth(given);
    return truth ? judged(given, *truth) : Judged{};
  }

  std::optional<RoundingError> at(const State& state) {
    ++row_.tried;
    const Judged found = worst_variant(state);
    if (!found.error) {
      ++row_.refused;
      return std::nullopt;
    }
    for (std::size_t v = 0; v < found.by_variant.size(); ++v) {
      row_.variants[v].second = std::max(row_.variants[v].second, found.by_variant[v]);
    }
    if (row_.points.size() < kMostPoints) row_.points.push_back(*found.error);
    return found.error;
  }

  void look_at(const std::string& where, const State& state) {
    const State given = meter_.given(state);
    const Judged found = judged(given, meter_.exact_truth(given));
    if (!found.error) return;
    StressFinding finding{where, calls_[found.variant].variant.name, given, *found.error};
    compare_with_reference(finding, calls_[found.variant]);
    row_.points.push_back(finding.error);
    const bool is_within_limits = where != kEdge;
    if (is_within_limits && (row_.worst.where.empty() || finding.error.scaled > row_.worst.error.scaled)) {
      row_.worst = finding;
    }
    if (row_.lost.where.empty() || finding.ratio > row_.lost.ratio) row_.lost = finding;
  }

  void compare_with_reference(StressFinding& finding, const StressCall& call) {
    finding.near = finding.error.scaled;
    for (const State& state : neighbours_of(finding.state, options_.seed)) {
      const State given = meter_.given(state);
      // Where the code loses much, so does its graph in long double.
      if (finding.error.scaled > kLongDoubleServes) {
        compare_with_reference(finding, call, given, meter_.exact_truth(given));
      } else if (const auto truth = meter_.truth(given)) {
        compare_with_reference(finding, call, given, *truth);
      }
    }
    // If both are infinite, an entry that should be zero is not, in both.
    finding.ratio = finding.near == finding.reference ? 1 : finding.near / std::max(finding.reference, kChanceRatio);
  }

  template <class Wide>
  void compare_with_reference(StressFinding& finding, const StressCall& call, const State& given,
                              const EntryTruth<Wide>& truth) const {
    std::vector<double> out(entries_);
    if (!evaluate(call, given, out)) return;
    finding.near = std::max(finding.near, meter_.error(out, truth).scaled);
    finding.reference = std::max(finding.reference, meter_.error(meter_.reference(given), truth).scaled);
  }

  RoundingErrorMeter meter_;
  std::vector<StressCall> calls_;
  StressOptions options_;
  std::size_t entries_;
  StressRow row_;
  std::vector<float> scaled_;
  Suspects random_, edges_;
};

// The states of a robot, with values of its free symbols and base parameters.
class StressStates {
 public:
  StressStates(const Mechanism& mechanism, const ExpectedValues& expected, const std::vector<Function>& functions,
               unsigned seed)
      : mechanism_(mechanism), expected_(expected), functions_(functions), seed_(seed) {}

  // Random states with closed loops. States near singular ones are dropped; if all are, loops are left open.
  std::vector<State> random(int count, int chunk) const {
    const std::vector<State> drawn = random_states(mechanism_, count, seed_ + static_cast<unsigned>(chunk));
    const std::vector<State> closed = expected_.with_closed_loops(drawn);
    return completed(closed.empty() ? drawn : closed);
  }
  // Extreme states, including those of `verify`. Loops are open there: functions have values all the same.
  std::vector<State> edges(int count) const {
    std::vector<State> states = edge_states(mechanism_);
    const std::vector<State> more = extreme_states(mechanism_, count, seed_);
    states.insert(states.end(), more.begin(), more.end());
    return completed(std::move(states));
  }

 private:
  std::vector<State> completed(std::vector<State> states) const {
    states = with_parameters(std::move(states), expected_.symbols());
    draw_own_arguments(states, functions_, seed_);
    return states;
  }

  const Mechanism& mechanism_;
  const ExpectedValues& expected_;
  const std::vector<Function>& functions_;
  unsigned seed_;
};

// The number of states that is affordable: fewer if one costs many recursions. Float and double cost a small share of
// 50 digits.
int affordable(const Function& function, const Mechanism& mechanism, int wanted) {
  constexpr std::size_t kCheaper = 50;
  if (!costs_many_recursions(function)) return wanted;
  const auto joints = static_cast<std::size_t>(mechanism.size());
  const std::size_t most = kCheaper * affordable_states(function, joints, static_cast<std::size_t>(wanted));
  return static_cast<int>(std::min<std::size_t>(most, static_cast<std::size_t>(wanted)));
}

std::vector<std::string> columns_of(const Function& function, const Mechanism& mechanism, const State& like) {
  std::vector<std::string> columns;
  for (const InputKind kind : function.inputs) {
    if (kind == InputKind::parameter) continue;
    for (int i = 0; i < static_cast<int>(like.of(kind).size()); ++i) {
      columns.push_back(column_name({kind, i}, mechanism));
    }
  }
  return columns;
}

StressRow row_of(const Function& function, const StressProgram& program, std::size_t k, const std::string& scalar,
                 const ExpectedValues& expected, const StressStates& source, const Mechanism& mechanism,
                 StressOptions options) {
  options.evaluations = affordable(function, mechanism, options.evaluations);
  options.bound *= largest_angle_factor(mechanism);
  options.edges = affordable(function, mechanism, options.edges);
  StressRun run(function, RoundingErrorMeter(function, expected.of(function), scalar), program.calls(k, scalar),
                options);
  int left = affordable(function, mechanism, options.states);
  std::vector<State> pool = source.random(std::min(left, kChunk), 0);
  for (int chunk = 0; left > 0; left -= kChunk, ++chunk) {
    run.random(chunk == 0 ? pool : source.random(std::min(left, kChunk), chunk));
  }
  run.edges(source.edges(options.edges));
  StressRow row = run.finish(pool, scalar);
  row.columns = columns_of(function, mechanism, pool.front());
  return row;
}

void check_variants(const std::vector<std::string>& wanted) {
  const std::vector<std::string> known = stress_variant_names();
  for (const std::string& name : wanted) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    throw Failure(FailureKind::usage, "no variant named \"" + name + "\"", hint_for_unknown(name, known, "variants"));
  }
}

}  // namespace

std::vector<std::string> stress_variant_names() {
  std::vector<std::string> names;
  for (const BenchVariant& variant : stress_variants()) names.emplace_back(variant.name);
  return names;
}

double stress_bin_start(int bin) { return std::exp2(0.5 * bin - 8); }

bool StressReport::passed() const {
  return std::all_of(rows.begin(), rows.end(), [](const StressRow& row) { return row.passed; });
}

StressReport stress(const Robot& robot, const Mechanism& mechanism, const std::vector<Function>& functions,
                    const StressOptions& options, Progress& progress) {
  check_variants(options.variants);
  const ExpectedValues expected(robot, mechanism, options.seed);
  const StressStates source(mechanism, expected, functions, options.seed);
  progress.step("compiling all variants of " + mechanism.name);
  const StressProgram program(mechanism, functions, source.random(1, 0).front(), options.variants);
  StressReport report{mechanism.name, options, {}, {}, {}};
  for (const FreeSymbol& each : mechanism.symbols) report.symbols.push_back(each.name);
  if (!program.has_xsimd()) report.left_out.emplace_back("batch, together: they need xsimd (libxsimd-dev)");
  for (std::size_t k = 0; k < functions.size(); ++k) {
    for (const char* scalar : {"double", "float"}) {
      progress.step("stressing " + functions[k].name + " of " + mechanism.name + " in " + scalar);
      if (program.calls(k, scalar).empty()) continue;
      report.rows.push_back(row_of(functions[k], program, k, scalar, expected, source, mechanism, options));
    }
  }
  return report;
}

}  // namespace flatdyn
