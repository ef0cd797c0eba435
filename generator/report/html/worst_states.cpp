// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/html/worst_states.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "robot/input/common/context.hpp"

namespace flatdyn {
namespace {

using nlohmann::json;

constexpr const char* kMakeIt = "make it with: flatdyn stress ROBOT -o FOLDER, which writes FOLDER/stress.json";

// The number with two digits; null stands for infinity, which JSON lacks.
std::string two_digits(const json& number) {
  return number.is_null() ? "∞" : fmt::format("{:.2g}", number.get<double>());
}

WorstState row_of(const json& row) {
  const json& worst = row.at("worst");
  return {row.at("function").get<std::string>(), row.at("scalar").get<std::string>(),
          worst.at("found").get<std::string>(),  worst.at("variant").get<std::string>(),
          two_digits(worst.at("scaled_error")),  two_digits(worst.at("condition")),
          two_digits(worst.at("reference")),     two_digits(row.at("lost").at("ratio")),
          worst.at("state").get<std::string>(),  row.at("passed").get<bool>()};
}

// The line that contains a byte of the text, counted from 1.
int line_of(const std::string& text, std::size_t byte) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
  return 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
}

std::optional<json> parsed(const std::string& file, Diagnostics& diagnostics) {
  const std::optional<std::string> text = file_text(file, diagnostics);
  if (!text) return std::nullopt;
  try {
    return json::parse(*text);
  } catch (const json::parse_error& error) {
    diagnostics.error({file, line_of(*text, error.byte)}, "this is no JSON", kMakeIt);
    return std::nullopt;
  }
}

}  // namespace

WorstStates read_worst_states(const std::string& file, const std::string& robot, Diagnostics& diagnostics) {
  WorstStates states;
  const std::optional<json> found = parsed(file, diagnostics);
  if (!found) return states;
  try {
    const std::string of = found->at("robot").get<std::string>();
    if (of != robot) {
      diagnostics.error({file, 0}, fmt::format("it is of robot \"{}\", and the page of \"{}\"", of, robot), kMakeIt);
    }
    states.bound = two_digits(found->at("bound"));
    states.ratio = two_digits(found->at("ratio"));
    for (const json& row : found->at("rows")) states.rows.push_back(row_of(row));
  } catch (const json::exception&) {
    diagnostics.error({file, 0}, "this is no result of flatdyn stress, or it is not whole", kMakeIt);
  }
  return states;
}

}  // namespace flatdyn
