// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/derivative_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace flatdyn {
namespace {

// The name of an argument, and how many directions it has.
struct ArgumentOfRow {
  const char* name;
  Extent directions;
};

ArgumentOfRow argument_of_row(InputKind argument) {
  switch (argument) {
    case InputKind::h_e:
      return {argument_row(argument).name, Extent::six};
    case InputKind::g_b:
      return {argument_row(argument).name, Extent::three};
    case InputKind::pi_b:
      return {argument_row(argument).name, Extent::base_parameters};
    case InputKind::parameter:
      return {"parameters", Extent::symbols};
    default:
      return {argument_row(argument).name, Extent::joints};
  }
}

bool has_derivatives(const FunctionRow& row) { return !row.inputs.empty() && !row.traits.needs_loops; }

bool has_weights(Derivative derivative) {
  return derivative == Derivative::vector_times_jacobian || derivative == Derivative::contracted_hessian;
}

}  // namespace

const char* DerivativeRows::kept(std::string text) { return texts_.emplace_back(std::move(text)).c_str(); }

std::vector<OutputRow> DerivativeRows::outputs_of(const FunctionRow& of, Derivative derivative) {
  std::vector<InputKind> arguments = of.inputs;
  arguments.push_back(InputKind::parameter);
  std::vector<OutputRow> outputs;
  const auto add = [&outputs](const char* name, Layout layout, Extent rows, Extent cols) {
    outputs.push_back({name, layout, rows, cols, OutputQuantity::derivative});
  };
  switch (derivative) {
    case Derivative::none:
      break;
    case Derivative::jacobian_times_vector:
      for (OutputRow output : of.outputs) {
        output.name = kept(std::string("d") + output.name);
        outputs.push_back(output);
      }
      break;
    case Derivative::vector_times_jacobian:
      for (const InputKind each : arguments) {
        const ArgumentOfRow by = argument_of_row(each);
        add(kept(std::string(by.name) + "_bar"), Layout::vector, by.directions, Extent::one);
      }
      break;
    case Derivative::jacobian:
      for (const OutputRow& output : of.outputs) {
        for (const InputKind each : arguments) {
          const ArgumentOfRow by = argument_of_row(each);
          add(kept(fmt::format("d{}_d{}", output.name, by.name)), Layout::matrix, output.rows, by.directions);
        }
      }
      break;
    case Derivative::contracted_hessian:
      for (auto a = arguments.begin(); a != arguments.end(); ++a) {
        for (auto b = a; b != arguments.end(); ++b) {
          const ArgumentOfRow by_a = argument_of_row(*a), by_b = argument_of_row(*b);
          add(kept(fmt::format("H_{}_{}", by_a.name, by_b.name)), Layout::matrix, by_a.directions, by_b.directions);
        }
      }
      break;
  }
  return outputs;
}

FunctionRow DerivativeRows::row_of(const FunctionRow& of, Derivative derivative) {
  FunctionRow row = of;
  row.name = kept(prefix_of(derivative) + ":" + of.name);
  row.equation = "";
  if (has_weights(derivative)) row.inputs.push_back(InputKind::weights);
  if (derivative == Derivative::jacobian_times_vector) row.inputs.push_back(InputKind::direction);
  row.outputs = outputs_of(of, derivative);
  row.derivation.closed_form = nullptr;
  row.definition = {};
  row.reference = {};
  row.traits.on_request = true;
  row.traits.is_all_or_nothing = false;  // entries are compared one by one
  row.derivative = derivative;
  row.differentiated = &of;
  return row;
}

DerivativeRows::DerivativeRows(const std::vector<FunctionRow>& rows) {
  for (const FunctionRow& row : rows) {
    if (!has_derivatives(row)) continue;
    for (const Derivative derivative : kDerivatives) rows_.push_back(row_of(row, derivative));
  }
}

const FunctionRow* DerivativeRows::find(Derivative derivative, const std::string& stem) const {
  const auto found = std::find_if(rows_.begin(), rows_.end(), [&](const FunctionRow& row) {
    return row.derivative == derivative && stem == row.differentiated->name;
  });
  return found == rows_.end() ? nullptr : &*found;
}

}  // namespace flatdyn
