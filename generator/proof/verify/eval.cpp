// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/verify/eval.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>

#include "code/lower/arguments.hpp"
#include "flatdyn/reference/closed_loops.hpp"
#include "functions/deviation/derivative_reference.hpp"
#include "functions/function_table.hpp"
#include "robot/input/csv/base_gravity.hpp"
#include "robot/input/csv/positions.hpp"
#include "robot/input/csv/text.hpp"
#include "robot/model/loop_closure.hpp"
#include "truth/reference/graph_evaluator.hpp"
#include "truth/reference/operational_values.hpp"

namespace flatdyn {
namespace {

// The place of each input in the table: a column, or none.
class Columns {
 public:
  Columns(const Mechanism& mechanism, CsvHeading& heading, const std::vector<Input>& inputs, const Function& function)
      : mechanism_(mechanism) {
    for (const Input& input : inputs) add(input.kind, heading, function);
    if (mechanism.has_loops()) add(InputKind::q, heading, function);
    if (sources_.count(InputKind::g_b) > 0) find_orientation(heading);
  }

  // The columns of a floating base's quaternion, w, x, y and z, where they determine gravity in base axes instead of
  // g_b's own columns; else none.
  const std::vector<CsvSource>& orientation() const { return orientation_; }
  bool has(const Input& input) const { return find(input) || (input.kind == InputKind::g_b && !orientation_.empty()); }

  std::vector<std::string> names_of(const Input& input) const {
    const auto k = static_cast<std::size_t>(input.index);
    const CsvQuantity quantity = quantity_of(input.kind);
    std::vector<std::string> names = {column_name(input, mechanism_)};
    const bool is_of_base = !base_name_of(quantity, input.index, mechanism_).empty();
    if (is_of_base || input.kind == InputKind::parameter || is_of_function(input.kind)) return names;
    const std::string stem = stem_of(quantity);
    static constexpr const char* kForceNames[] = {"fx", "fy", "fz", "mx", "my", "mz"};
    names.push_back(input.kind == InputKind::h_e ? kForceNames[k]
                                                 : stem + "_" + entry_name_of(quantity, input.index, mechanism_));
    return names;
  }

  const std::optional<CsvSource>& find(const Input& input) const {
    static const std::optional<CsvSource> none;
    const auto found = sources_.find(input.kind);
    return found == sources_.end() ? none : found->second[static_cast<std::size_t>(input.index)];
  }

  // The columns of the positions, by entry of q; none for an entry that the function does not read.
  std::vector<std::optional<CsvSource>> positions() const {
    const auto found = sources_.find(InputKind::q);
    return found == sources_.end() ? std::vector<std::optional<CsvSource>>() : found->second;
  }

  std::vector<CsvSource> sources() const {
    std::vector<CsvSource> all;
    for (const auto& [kind, sources] : sources_) {
      for (const std::optional<CsvSource>& source : sources) {
        if (source) all.push_back(*source);
      }
    }
    all.insert(all.end(), orientation_.begin(), orientation_.end());
    return all;
  }

 private:
  void add(InputKind kind, CsvHeading& heading, const Function& function) {
    if (sources_.count(kind) > 0) return;
    const CsvQuantity quantity = quantity_of(kind);
    const int length = own_length(function, argument_row(kind).length);
    sources_[kind] = is_of_function(kind) ? heading.find(quantity, length) : heading.find(quantity);
  }

  void find_orientation(CsvHeading& heading) {
    const std::vector<std::optional<CsvSource>>& g_b = sources_[InputKind::g_b];
    const auto is_there = [](const std::optional<CsvSource>& each) { return each.has_value(); };
    const Vec3& g_0 = mechanism_.gravity;
    if (std::any_of(g_b.begin(), g_b.end(), is_there) || std::any_of(g_0.begin(), g_0.end(), has_symbols)) return;
    orientation_ = base_orientation(heading);
  }

  const Mechanism& mechanism_;
  std::map<InputKind, std::vector<std::optional<CsvSource>>> sources_;
  std::vector<CsvSource> orientation_;
};

std::vector<std::string> all_columns(const Output& output) {
  if (output.layout == Layout::scalar) return {output.name};
  std::vector<std::string> names;
  for (int i = 1; i <= output.rows; ++i) {
    if (output.layout == Layout::vector) {
      names.push_back(fmt::format("{}_{}", output.name, i));
    } else if (output.layout == Layout::matrix) {
      for (int j = 1; j <= output.cols; ++j) names.push_back(fmt::format("{}_{}_{}", output.name, i, j));
    } else {
      for (int k = 1; k <= output.rows; ++k) {
        for (int j = 1; j <= k; ++j) names.push_back(fmt::format("{}_{}_{}_{}", output.name, i, j, k));
      }
    }
  }
  return names;
}

// The names of the columns for the entries that are not left out.
std::vector<std::string> output_columns(const Output& output) {
  const std::vector<std::string> all = all_columns(output);
  std::vector<std::string> kept;
  for (std::size_t e = 0; e < all.size(); ++e) {
    if (!output.leaves_out(e)) kept.push_back(all[e]);
  }
  return kept;
}

// The inputs that the graph reads, or all that the function is documented to take: the reference reads them all.
std::vector<Input> inputs_of(const Mechanism& mechanism, const Function& function, bool all) {
  if (!all) return inputs_read(function);
  std::vector<Input> inputs;
  for (const InputKind kind : function.inputs) {
    if (kind == InputKind::parameter) continue;  // they are added below
    if (is_velocity(kind) && function.at_rest) continue;
    const int length = input_argument(kind, JointCounts(mechanism), function).length;
    for (int i = 0; i < length; ++i) inputs.push_back({kind, i});
  }
  for (std::size_t k = 0; k < mechanism.symbols.size(); ++k)
    inputs.push_back({InputKind::parameter, static_cast<int>(k)});
  return inputs;
}

std::string text_of(double value, int digits) {
  constexpr int kShortest = 17;
  return digits >= kShortest ? fmt::format("{}", value) : fmt::format("{:.{}g}", value, digits);
}
std::string text_of(const Real50& value, int digits) { return value.str(digits); }

// Evaluates the function line by line of the table, in S.
template <class S>
class Evaluator {
 public:
  Evaluator(const Robot& robot, const Mechanism& mechanism, const Function& function, const EvalOptions& options)
      : robot_(robot), mechanism_(mechanism), function_(function), options_(options), graph_(function) {}

  // The values of one line; nullopt if a condition of the function does not hold.
  std::optional<std::vector<std::string>> operator()(const Columns& columns, const std::vector<Input>& inputs,
                                                     const std::vector<std::string>& entries) {
    const StateOf<S> state = state_of(columns, inputs, entries);
    const auto values = options_.reference ? from_reference(state) : graph_(state);
    if (!values) return std::nullopt;
    std::vector<std::string> texts;
    for (const S& value : kept_values(function_, *values)) texts.push_back(text_of(value, options_.digits));
    return texts;
  }

 private:
  // The state of one line. Inputs that are not read stay 0.
  StateOf<S> state_of(const Columns& columns, const std::vector<Input>& inputs,
                      const std::vector<std::string>& entries) {
    const std::vector<S> zero(static_cast<std::size_t>(mechanism_.size()), S(0));
    StateOf<S> state;
    state.q.assign(static_cast<std::size_t>(mechanism_.position_count()), S(0));
    state.qd = state.qdd = state.tau = state.qd_r = state.qdd_r = state.qd_end = zero;
    if (mechanism_.floating_base) state.g_b.assign(3, S(0));
    state.parameters.assign(mechanism_.symbols.size(), S(0));
    state.pi_b.assign(static_cast<std::size_t>(function_.base_parameters), S(0));
    state.weights.assign(static_cast<std::size_t>(function_.own.length), S(0));
    state.direction = state.weights;
    symbols_.assign(mechanism_.symbols.size(), 0);
    for (const Input& input : inputs) {
      const std::optional<CsvSource>& source = columns.find(input);
      if (!source) continue;  // gravity, which the orientation determines
      const Number value = exact_decimal(entries[source->column]) * source->factor;
      const auto index = static_cast<std::size_t>(input.index);
      state.of(input.kind)[index] = to_scalar<S>(value, {});
      if (input.kind == InputKind::parameter) symbols_[index] = value;
    }
    if (!columns.orientation().empty()) set_gravity(columns.orientation(), entries, state);
    return state;
  }

  // Gravity in base axes from the base's quaternion.
  void set_gravity(const std::vector<CsvSource>& orientation, const std::vector<std::string>& entries,
                   StateOf<S>& state) const {
    std::array<S, 4> quaternion;
    std::array<S, 3> g_0;
    for (std::size_t k = 0; k < 4; ++k) {
      quaternion[k] = to_scalar<S>(exact_decimal(entries[orientation[k].column]), {});
    }
    for (std::size_t k = 0; k < 3; ++k) g_0[k] = to_scalar<S>(mechanism_.gravity[k], {});
    const std::array<S, 3> g_b = gravity_in_base_axes(quaternion, g_0);
    state.g_b.assign(g_b.begin(), g_b.end());
  }

  // The reference's values; nullopt where the task is singular, or a loop, for any function, as the reference needs
  // the loops' motion.
  std::optional<std::vector<S>> from_reference(const StateOf<S>& state) {
    // The robot's numbers change only with its symbols.
    if (!reference_ || !symbols_.empty()) {
      reference_ = robot_for_function(function_, robot_, reference_robot<S>(robot_, symbols_));
      const bool is_product = row_of(function_).differentiated != nullptr;
      expected_ = is_product
                      ? by_differences()
                      : row_of(function_).reference.template over<S>()({mechanism_, *reference_, symbols_}, function_);
    }
    const reference::VectorX<S> q = vector_of(state.q);
    if (mechanism_.has_loops() && !(reference::loop_regularity(*reference_, q) > S(reference::kSingularLoop))) {
      return std::nullopt;
    }
    if (!function_.task.empty() && !has_inverse(*reference_, q, function_.task)) return std::nullopt;
    std::vector<S> values = expected_(state);
    if (row_of(function_).traits.has_gaps && values.front() != values.front()) return std::nullopt;
    // The last entry is the condition of what is inverted.
    const bool has_condition = function_.outputs.back().name == kCondition && !function_.inverted.empty() &&
                               row_of(function_).differentiated == nullptr;
    if (has_condition && !(values.back() > std::numeric_limits<S>::epsilon())) return std::nullopt;
    return values;
  }

  ReferenceFunction<S> by_differences() const {
    const auto reference = std::make_shared<DerivativeReference>(robot_, mechanism_, symbols_, function_);
    return [reference](const StateOf<S>& state) {
      if constexpr (std::is_same_v<S, Real50>) {
        return reference->exact(state);
      } else {
        std::vector<S> values;
        for (const Real50& value : reference->exact(widened<Real50>(state))) {
          values.push_back(value.template convert_to<S>());
        }
        return values;
      }
    };
  }

  const Robot& robot_;
  const Mechanism& mechanism_;
  const Function& function_;
  const EvalOptions& options_;
  GraphEvaluator<S> graph_;
  SymbolValues symbols_;
  std::optional<reference::Robot<S>> reference_;
  ReferenceFunction<S> expected_;
};

// The reason why a function has no value at a state, and a remedy.
struct Singularity {
  const char *what, *hint;
};

Singularity singularity_of(const Mechanism& mechanism, const Function& function) {
  if (mechanism.has_loops()) {
    return {"a closed loop is singular here, or the inertia matrix not positive definite",
            "leave such positions out, or let other joints be the dependent ones"};
  }
  if (row_of(function).traits.has_gaps) {
    return {"Newton's matrix has a pivot that is not positive here, or h is 0", "take a shorter step, which is not 0"};
  }
  if (row_of(function).traits.needs_contacts) {
    return {"the contacts' forces are not determined here", "leave such positions out, or take other contacts"};
  }
  if (!function.task.empty()) return {"the tip's task is singular here", "leave such positions out"};
  return {"the inertia matrix is not positive definite here, to these digits",
          "joints that move no mass need an armature; --digits 40 has more to tell with"};
}

template <class S>
void append_values(Evaluator<S> evaluation, const Columns& columns, const std::vector<Input>& inputs, CsvTable& table,
                   const std::string& file, const Singularity& singularity, Diagnostics& diagnostics) {
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    const auto values = evaluation(columns, inputs, table.rows[k]);
    if (!values) {
      diagnostics.error({file, table.lines[k]}, singularity.what, singularity.hint);
      continue;
    }
    table.rows[k].insert(table.rows[k].end(), values->begin(), values->end());
  }
}

// Warns if loops are open, as functions hold for closed loops only: a wrong sign of a dependent joint, or degrees, open
// a gap.
void warn_of_open_loops(const Robot& robot, const Mechanism& mechanism, const CsvTable& states, const Columns& columns,
                        const std::string& file, Diagnostics& diagnostics) {
  if (!mechanism.has_loops() || !mechanism.symbols.empty()) return;
  const auto reference = reference_robot<double>(robot, {});
  double most = 0;
  int line = 0;
  for (std::size_t k = 0; k < states.rows.size(); ++k) {
    Eigen::VectorXd q(mechanism.position_count());
    for (int p = 0; p < mechanism.position_count(); ++p) {
      const std::optional<CsvSource>& source = columns.find({InputKind::q, p});
      if (!source) return;  // the function does not read it
      q[p] = nearest_double(exact_value(states, k, *source));
    }
    const double gap = reference::loop_closure(reference, q).norm();
    if (!(gap > most)) continue;
    most = gap;
    line = states.lines[k];
  }
  constexpr double kClosed = 1e-6;  // m
  if (most <= kClosed) return;
  diagnostics.warning({file, line},
                      fmt::format("the loops are open here, by {:.3g} m{}: values hold where they are closed", most,
                                  aligns_axes(mechanism) ? " or rad" : ""),
                      "loop_closure and loop_step lead to positions that close them");
}

// Reports all missing columns in one message: a file made for another robot lacks many.
void say_what_is_missing(const Columns& columns, const std::vector<Input>& inputs, const Function& function,
                         const Place& heading, Diagnostics& diagnostics) {
  std::vector<std::string> missing, by_joint, hints;
  bool lacks_gravity = false;
  for (const Input& input : inputs) {
    if (columns.has(input)) continue;
    lacks_gravity = lacks_gravity || input.kind == InputKind::g_b;
    const std::vector<std::string> names = columns.names_of(input);
    missing.push_back(names.front());
    by_joint.push_back(names.back());
  }
  if (missing.empty()) return;
  const bool is_one = missing.size() == 1;
  if (missing != by_joint) {
    hints.push_back(fmt::format("by joint, {} called {}", is_one ? "it is" : "they are", fmt::join(by_joint, ", ")));
  }
  if (lacks_gravity) hints.emplace_back(kBaseGravityHint);
  diagnostics.error(heading,
                    fmt::format("{} {} {} missing; {} reads {}", is_one ? "column" : "columns",
                                fmt::join(missing, ", "), is_one ? "is" : "are", function.name, is_one ? "it" : "them"),
                    fmt::format("{}", fmt::join(hints, "; ")));
}

std::string line_of(const std::vector<std::string>& entries) {
  std::vector<std::string> written;
  for (const std::string& entry : entries) written.push_back(csv_entry(entry));
  return fmt::format("{}\n", fmt::join(written, ","));
}

}  // namespace

CsvTable evaluate_table(const Robot& robot, const Mechanism& mechanism, const Function& function,
                        const CsvTable& states, const std::string& file, const EvalOptions& options,
                        Diagnostics& diagnostics) {
  const std::vector<Input> inputs = inputs_of(mechanism, function, options.reference);
  CsvTable result = states;
  CsvHeading heading = states.heading(file, mechanism, diagnostics);
  const Columns columns(mechanism, heading, inputs, function);
  if (!diagnostics.has_errors()) {
    say_what_is_missing(columns, inputs, function, {file, states.heading_line}, diagnostics);
  }
  for (const InputKind kind : function.inputs) heading.allow_unused(quantity_of(kind));
  heading.allow_unused(CsvQuantity::time);
  heading.finish();
  check_entries(result, columns.sources(), heading, file, diagnostics);
  if (diagnostics.has_errors()) return {};
  warn_of_positions(result, columns.positions(), mechanism, file, diagnostics);
  if (!columns.orientation().empty()) {
    const std::vector<std::optional<CsvSource>> quaternion(columns.orientation().begin(), columns.orientation().end());
    warn_of_quaternion(result, quaternion, "floating base", file, diagnostics);
  }
  warn_of_open_loops(robot, mechanism, result, columns, file, diagnostics);
  for (const Output& output : function.outputs) {
    for (const std::string& name : output_columns(output)) result.columns.push_back(name);
  }
  constexpr int kDoubleDigits = 17;
  const Singularity singularity = singularity_of(mechanism, function);
  if (options.digits > kDoubleDigits) {
    append_values(Evaluator<Real50>(robot, mechanism, function, options), columns, inputs, result, file, singularity,
                  diagnostics);
  } else {
    append_values(Evaluator<double>(robot, mechanism, function, options), columns, inputs, result, file, singularity,
                  diagnostics);
  }
  if (diagnostics.has_errors()) return {};
  return result;
}

std::string to_text(const CsvTable& table) {
  std::string text = line_of(table.columns);
  for (const auto& row : table.rows) text += line_of(row);
  return text;
}

}  // namespace flatdyn
