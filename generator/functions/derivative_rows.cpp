// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/derivative_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "derivation/differentiation/tangents.hpp"

namespace flatdyn {
namespace {

// The number of directions of an argument.
Extent directions_of(InputKind argument) {
  switch (argument) {
    case InputKind::h_e:
      return Extent::six;
    case InputKind::g_b:
      return Extent::three;
    case InputKind::pi_b:
      return Extent::base_parameters;
    case InputKind::h:
      return Extent::one;
    case InputKind::parameter:
      return Extent::symbols;
    default:
      return Extent::joints;
  }
}

// Those of the derivatives of steps would be second derivatives of long functions.
bool has_derivatives(const FunctionRow& row) {
  return !row.inputs.empty() && !std::string(row.name).starts_with("step_derivatives:");
}

bool has_weights(Derivative derivative) {
  return derivative == Derivative::vector_times_jacobian || derivative == Derivative::contracted_hessian;
}

}  // namespace

const char* DerivativeRows::kept(std::string text) { return texts_.emplace_back(std::move(text)).c_str(); }

std::vector<OutputRow> DerivativeRows::outputs_of(const FunctionRow& of, Derivative derivative) {
  std::vector<OutputRow> differentiated = of.outputs;
  if (std::string(differentiated.back().name) == kCondition) differentiated.pop_back();
  std::vector<InputKind> arguments = of.inputs;
  arguments.push_back(InputKind::parameter);
  std::vector<OutputRow> outputs;
  const auto add = [&outputs](const char* name, Layout layout, Extent rows, Extent cols,
                              bool of_floating_base = false) {
    outputs.push_back({name, layout, rows, cols, OutputQuantity::derivative, of_floating_base});
  };
  switch (derivative) {
    case Derivative::none:
      break;
    case Derivative::jacobian_times_vector:
      for (OutputRow output : differentiated) {
        output.name = kept(std::string("d") + output.name);
        outputs.push_back(output);
      }
      break;
    case Derivative::vector_times_jacobian:
      for (const InputKind each : arguments) {
        add(kept(name_of({each}) + "_bar"), Layout::vector, directions_of(each), Extent::one);
      }
      break;
    case Derivative::jacobian:
      for (const OutputRow& output : differentiated) {
        for (const InputKind each : arguments) {
          add(kept(fmt::format("d{}_d{}", output.name, name_of({each}))), Layout::matrix, output.rows,
              directions_of(each), output.of_floating_base);
        }
      }
      break;
    case Derivative::contracted_hessian:
      for (auto a = arguments.begin(); a != arguments.end(); ++a) {
        for (auto b = a; b != arguments.end(); ++b) {
          add(kept(name_of_second_derivatives({*a}, {*b})), Layout::matrix, directions_of(*a), directions_of(*b));
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
