// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/scene/entries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "base/diagnostics/diagnostics.hpp"
#include "base/diagnostics/nearest.hpp"
#include "functions/function_table.hpp"

namespace flatdyn {
namespace {

[[noreturn]] void refuse(const std::string& what, const std::string& hint) {
  throw Failure(FailureKind::input, what, hint);
}

struct Range {
  int first = 0, last = 0;
};

// The size of each index of an output.
std::vector<int> dimensions(const Output& output) {
  switch (output.layout) {
    case Layout::scalar:
      return {};
    case Layout::vector:
    case Layout::fields:
      return {output.rows};
    case Layout::matrix:
      return {output.rows, output.cols};
    case Layout::christoffel:
      return {output.rows, output.rows, output.rows};
  }
  return {};
}

// The things that an index counts, from the function's row: joints, axes, directions of the task, …
Extent counted(const Function& function, const Output& output, std::size_t dimension) {
  if (output.layout == Layout::christoffel) return Extent::joints;
  for (const OutputRow& row : row_of(function).outputs) {
    if (output.name == row.name) return dimension == 0 ? row.rows : row.cols;
  }
  return Extent::one;
}

// The names of the joints that an index counts; none where it counts something else.
std::vector<std::string> names_counted(const Mechanism& mechanism, Extent extent) {
  if (extent == Extent::joints) return mechanism.joint_names();
  return extent == Extent::positions ? mechanism.position_names() : std::vector<std::string>();
}

std::size_t place_of(const Output& output, const std::vector<int>& indices) {
  int place = indices.empty() ? 0 : indices[0];
  if (output.layout == Layout::matrix) place = indices[0] * output.cols + indices[1];
  if (output.layout == Layout::christoffel) {
    const auto [j, k] = std::minmax(indices[1], indices[2]);
    place = indices[0] * output.cols + k * (k + 1) / 2 + j;
  }
  return static_cast<std::size_t>(place);
}

// The parts "tau" and "0..2" of "tau[0..2]".
struct NameAndIndices {
  std::string name;
  std::vector<std::string> indices;
};

NameAndIndices parts_of(const std::string& text) {
  const std::size_t open = text.find('[');
  NameAndIndices parts{text.substr(0, open), {}};
  for (std::size_t at = open; at < text.size();) {
    const std::size_t close = text.find(']', at);
    if (text[at] != '[' || close == std::string::npos) {
      refuse("\"" + text + "\" is no entry of an output", "write it as tau[0..2] or B[0][1]");
    }
    parts.indices.push_back(text.substr(at + 1, close - at - 1));
    at = close + 1;
  }
  return parts;
}

class IndexReader {
 public:
  IndexReader(const Mechanism& mechanism, const Function& function, const Output& output, std::size_t dimension)
      : output_(output),
        joints_(names_counted(mechanism, counted(function, output, dimension))),
        size_(dimensions(output)[dimension]) {}

  Range range(const std::string& text) const {
    const std::size_t dots = text.find("..");
    if (dots == std::string::npos) return {index(text), index(text)};
    const Range result{index(text.substr(0, dots)), index(text.substr(dots + 2))};
    if (result.first > result.last) refuse("the range \"" + text + "\" is empty", "write the smaller index first");
    return result;
  }

 private:
  int index(const std::string& text) const {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc{} && end == text.data() + text.size()) {
      if (value >= 0 && value < size_) return value;
      refuse(fmt::format("there is no index {} of {}", value, output_.name),
             fmt::format("indices here go from 0 to {}", size_ - 1));
    }
    return index_of_joint(text);
  }

  int index_of_joint(const std::string& name) const {
    if (joints_.empty()) {
      refuse(fmt::format("\"{}\" is no index of {}", name, output_.name), fmt::format("write 0 to {}", size_ - 1));
    }
    const auto found = std::find(joints_.begin(), joints_.end(), name);
    if (found != joints_.end()) return static_cast<int>(found - joints_.begin());
    refuse("there is no joint \"" + name + "\" that moves", hint_for_unknown(name, joints_, "joints"));
  }

  const Output& output_;
  std::vector<std::string> joints_;  // by index
  int size_;
};

std::size_t output_of(const Function& function, const std::string& name) {
  std::vector<std::string> known;
  for (std::size_t k = 0; k < function.outputs.size(); ++k) {
    if (function.outputs[k].name == name) return k;
    known.push_back(function.outputs[k].name);
  }
  refuse("there is no output \"" + name + "\"", hint_for_unknown(name, known, "outputs"));
}

void add_entries(const Output& output, const std::vector<Range>& ranges, std::vector<int>& indices,
                 std::vector<std::size_t>& entries) {
  if (indices.size() == ranges.size()) {
    entries.push_back(place_of(output, indices));
    return;
  }
  const Range range = ranges[indices.size()];
  for (int i = range.first; i <= range.last; ++i) {
    indices.push_back(i);
    add_entries(output, ranges, indices, entries);
    indices.pop_back();
  }
}

// The runs "[0..2]", "[5]" of the entries from `begin` on that are not left out.
std::vector<std::string> runs_of(const Output& output, std::size_t begin, std::size_t count) {
  std::vector<std::string> runs;
  for (std::size_t first = 0, last = 0; first < count; first = last + 1) {
    last = first;
    if (output.leaves_out(begin + first)) continue;
    while (last + 1 < count && !output.leaves_out(begin + last + 1)) ++last;
    runs.push_back(last == first ? fmt::format("[{}]", first) : fmt::format("[{}..{}]", first, last));
  }
  return runs;
}

void add_all(const std::string& stem, const std::vector<std::string>& runs, std::string& text) {
  for (const std::string& run : runs) text += (text.empty() ? "" : ", ") + stem + run;
}

}  // namespace

EntrySelection selected_entries(const Function& function, const Mechanism& mechanism, const std::string& text) {
  const NameAndIndices parts = parts_of(text);
  EntrySelection selection{output_of(function, parts.name), {}};
  const Output& output = function.outputs[selection.output];
  const std::vector<int> sizes = dimensions(output);
  if (parts.indices.size() > sizes.size()) {
    refuse(fmt::format("{} has {} and not {} indices", output.name, sizes.size(), parts.indices.size()),
           "leave out what is too much");
  }
  std::vector<Range> ranges;
  for (std::size_t d = 0; d < sizes.size(); ++d) {
    const bool is_given = d < parts.indices.size();
    ranges.push_back(is_given ? IndexReader(mechanism, function, output, d).range(parts.indices[d])
                              : Range{0, sizes[d] - 1});
  }
  std::vector<int> indices;
  add_entries(output, ranges, indices, selection.entries);
  return selection;
}

std::string written_entries(const Output& output) {
  std::string text;
  if (output.layout != Layout::matrix) {
    add_all(output.name, runs_of(output, 0, output.entries.size()), text);
    return text;
  }
  const auto columns = static_cast<std::size_t>(output.cols), rows = static_cast<std::size_t>(output.rows);
  for (std::size_t first = 0, last = 0; first < rows; first = last + 1) {  // rows that have the same runs
    last = first;
    const std::vector<std::string> runs = runs_of(output, first * columns, columns);
    while (last + 1 < rows && runs_of(output, (last + 1) * columns, columns) == runs) ++last;
    const std::string row = first == last ? std::to_string(first) : fmt::format("{}..{}", first, last);
    add_all(fmt::format("{}[{}]", output.name, row), runs, text);
  }
  return text;
}

}  // namespace flatdyn
