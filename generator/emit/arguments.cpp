// SPDX-License-Identifier: GPL-2.0-or-later
#include "emit/arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "diagnostics/table.hpp"
#include "emit/writer.hpp"

namespace flatdyn {

InputArgument input_argument(InputKind kind, JointCounts counts, int base_parameters) {
  const int joints = counts.joints;
  constexpr int kWrench = 6;
  switch (kind) {
    case InputKind::q:
      return {"q", counts.positions,
              std::string("joint positions, rad or m") +
                  (counts.spherical ? "; of a spherical joint a unit quaternion w, x, y, z" : "")};
    case InputKind::qd:
      return {"qd", joints, "joint velocities, rad/s or m/s"};
    case InputKind::qdd:
      return {"qdd", joints, "joint accelerations, rad/s^2 or m/s^2"};
    case InputKind::tau:
      return {"tau", joints,
              std::string(counts.floating_base ? "force and moment on the base (base axes, N, N m), then joint torques"
                                               : "joint torques or forces, N m or N") +
                  (counts.spherical ? "; of a spherical joint the moment in the child's axes" : "")};
    case InputKind::h_e:
      return {"h_e", kWrench, "force (N), then moment (N m), that the tip exerts on its environment, base frame"};
    case InputKind::g_b:
      return {"g_b", 3, "gravity in base axes, m/s^2: R^T g_0 with R from base axes to world axes"};
    case InputKind::v:
      return {"v", joints,
              std::string(counts.floating_base
                              ? "velocity of the base (linear, then angular; base axes), then of the joints"
                              : "joint velocities, rad/s or m/s") +
                  (counts.spherical ? "; of a spherical joint the angular velocity in the child's axes" : "")};
    case InputKind::a:
      return {"a", joints, "derivatives of the entries of v"};
    case InputKind::v_r:
      return {"v_r", joints, "reference velocities, with entries as those of v"};
    case InputKind::a_r:
      return {"a_r", joints, "derivatives of the entries of v_r"};
    case InputKind::qd_r:
      return {"qd_r", joints, "reference velocities, rad/s or m/s"};
    case InputKind::qdd_r:
      return {"qdd_r", joints, "reference accelerations, rad/s^2 or m/s^2"};
    case InputKind::pi_b:
      return {"pi_b", base_parameters, "base parameters, SI units; which they are is said above"};
    case InputKind::parameter:
    case InputKind::stored:
      break;
  }
  throw std::logic_error("parameters and stored values are no array arguments");
}

InputArgument input_argument(InputKind kind, JointCounts counts, const Function& function) {
  InputArgument argument = input_argument(kind, counts, function.base_parameters);
  const std::size_t colon = function.name.find(':');
  if (colon == std::string::npos) return argument;
  const std::string link = fmt::format("link \"{}\"", function.name.substr(colon + 1));
  argument.meaning = with_replaced(argument.meaning, "the tip", link);
  return argument;
}

std::string variable_of_input(const Input& input, const std::vector<std::string>& parameters) {
  if (input.kind == InputKind::parameter) return parameters.at(static_cast<std::size_t>(input.index));
  return fmt::format("{}_{}", input_argument(input.kind, 0).name, input.index + 1);
}

std::string access_of_input(const Input& input, const std::vector<std::string>& parameters, const Dialect& dialect) {
  if (input.kind == InputKind::parameter) return dialect.parameter(variable_of_input(input, parameters));
  return fmt::format("{}[{}]", input_argument(input.kind, 0).name, input.index);
}

std::string list_of_inputs(const std::vector<Input>& inputs, const std::vector<std::string>& parameters,
                           const Dialect& dialect) {
  std::string text;
  for (std::size_t first = 0, last = 0; first < inputs.size(); first = last + 1) {
    const Input& input = inputs[first];
    last = first;
    const bool in_array = input.kind != InputKind::parameter;
    while (in_array && last + 1 < inputs.size() && inputs[last + 1].kind == input.kind &&
           inputs[last + 1].index == inputs[last].index + 1) {
      ++last;
    }
    if (!text.empty()) text += ", ";
    if (last == first) {
      text += access_of_input(input, parameters, dialect);
    } else {
      text += fmt::format("{}[{}..{}]", input_argument(input.kind, 0).name, input.index, inputs[last].index);
    }
  }
  return text.empty() ? "nothing" : text;
}

std::string layout_text(const Output& output) {
  switch (output.layout) {
    case Layout::scalar:
    case Layout::vector:
    case Layout::fields:
      return "";
    case Layout::matrix:
      return fmt::format("{} x {}, row by row: entry (i, j) is {}[{} * i + j]", output.rows, output.cols, output.name,
                         output.cols);
    case Layout::christoffel:
      return fmt::format("c_ijk = c_ikj is {}[{} * i + k * (k + 1) / 2 + j] for j <= k, counted from 0", output.name,
                         output.cols);
  }
  return "";
}

bool returns_value(const Function& function) {
  return function.validity_conditions.empty() && function.outputs.size() == 1 &&
         function.outputs[0].layout == Layout::scalar;
}

std::vector<std::string> argument_lines(const std::vector<std::array<std::string, 3>>& rows) {
  constexpr std::size_t kIndent = 2, kBetween = 2;  // of each line; of columns
  std::size_t before = kIndent + 2 * kBetween;
  for (const std::size_t column : {0u, 1u}) {
    std::size_t width = 0;
    for (const auto& row : rows) width = std::max(width, row[column].size());
    before += width;
  }
  std::vector<std::vector<std::string>> wrapped;
  for (const auto& [name, direction, meaning] : rows) {
    std::vector<std::string> lines = wrapped_words(meaning, kCommentWidth - before);
    if (lines.empty()) lines.emplace_back();
    add_row(wrapped, {name, direction}, lines);
  }
  std::vector<std::string> lines;
  for (const std::string& line : aligned_lines(wrapped))
    lines.push_back(std::string(kIndent, ' ') + comment_text(line));
  return lines;
}

}  // namespace flatdyn
