// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/emit/argument_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/table.hpp"
#include "code/emit/writer.hpp"
#include "code/lower/arguments.hpp"

namespace flatdyn {

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
