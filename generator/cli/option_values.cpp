// SPDX-License-Identifier: GPL-2.0-or-later
#include "cli/option_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "base/diagnostics/characters.hpp"
#include "robot/input/common/expression.hpp"
#include "robot/input/common/name_list.hpp"
#include "robot/input/common/units.hpp"
#include "robot/input/scene_frames.hpp"

namespace flatdyn {
namespace {

// Whether the number is within the range of robot files.
bool is_reasonable(const GiNaC::numeric& number) {
  const GiNaC::numeric largest = GiNaC::numeric(10).power(30), magnitude = GiNaC::abs(number);
  return number.is_zero() || (magnitude <= largest && magnitude * largest >= 1);
}

Number decimal_option(const std::string& option, const std::string& text) {
  try {
    const Number number = exact_decimal(text);
    if (is_reasonable(GiNaC::ex_to<GiNaC::numeric>(number))) return number;
  } catch (const std::invalid_argument&) {
  }
  throw Failure(FailureKind::usage,
                fmt::format("{}: \"{}\" is not a decimal number between 1e-30 and 1e30", option, text),
                "write it with digits, as in 0.25 or 1e-4");
}

Vec3 vector_option(const std::string& option, const std::string& text) {
  std::vector<Number> entries;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) entries.push_back(decimal_option(option, part));
  if (entries.size() != 3 || text.back() == ',') {
    throw Failure(FailureKind::usage, fmt::format("{}: \"{}\" is not three numbers", option, text),
                  "write it as 0,0,-9.81");
  }
  return {entries[0], entries[1], entries[2]};
}

Number expression_option(const std::string& option, const std::string& text) {
  const auto no_symbol = [](std::string_view name, std::size_t column) -> Number {
    throw ExpressionError("\"" + std::string(name) + "\" is a symbol, which only a file may have", column);
  };
  try {
    const Number value = parse_expression(text, no_symbol);
    if (is_reasonable(GiNaC::ex_to<GiNaC::numeric>(value.evalf()))) return value;
    throw Failure(FailureKind::usage, fmt::format("{}: \"{}\" is not between 1e-30 and 1e30", option, text));
  } catch (const ExpressionError& error) {
    throw Failure(FailureKind::usage, fmt::format("{}: \"{}\": {}", option, text, error.what()),
                  "write a number or an expression such as pi/2");
  }
}

// Parses "JOINT", "JOINT=POSITION" or "JOINT=ANGLEdeg".
JointPosition fixed_option(const std::string& text) {
  const std::size_t sign = text.rfind('=');
  if (sign == std::string::npos) return {text};
  JointPosition lock{text.substr(0, sign), 0, text.substr(sign + 1)};
  const std::optional<std::string> degrees = number_of_degrees(lock.written);
  const std::string number = degrees.value_or(lock.written);
  lock.in_degrees = degrees.has_value();
  lock.is_decimal = is_decimal_text(number);
  lock.position = lock.is_decimal ? decimal_option("--fix", number) : expression_option("--fix", number);
  return lock;
}

// Sets entry k of a frame's pose, x to yaw. An angle may be in degrees: 90deg.
void set_entry(const std::string& text, std::size_t k, SceneFrame& frame) {
  constexpr int kHalfTurn = 180;
  const std::size_t angle = k - frame.xyz.size();  // if it is one
  const std::optional<std::string> degrees = k < frame.xyz.size() ? std::nullopt : number_of_degrees(text);
  const std::string written = degrees.value_or(text);
  const bool is_decimal = is_decimal_text(written);
  const Number number = is_decimal ? decimal_option("--frame", written) : expression_option("--frame", written);
  if (k < frame.xyz.size()) {
    frame.xyz[k] = number;
  } else if (degrees) {
    frame.rpy[angle] = number * GiNaC::Pi / kHalfTurn;
  } else {
    frame.rpy[angle] = number;
    if (is_decimal) frame.decimals[angle] = written;
  }
}

}  // namespace

Number snap_option(const std::string& text) {
  const Number tolerance = decimal_option("--snap", text);
  const GiNaC::numeric value = GiNaC::ex_to<GiNaC::numeric>(tolerance);
  if (value >= 0 && value <= GiNaC::numeric(65, 1000)) return tolerance;
  throw Failure(FailureKind::usage, fmt::format("--snap: {} rad is no tolerance for angles", text),
                "0 for none, at most 0.065");
}

Vec3 gravity_option(const std::string& text) {
  return text == "off" ? zero_vector() : vector_option("--gravity", text);
}

SceneFrame frame_option(const std::string& text) {
  constexpr std::size_t kOfPosition = 3, kOfPose = 6;
  const std::size_t sign = text.find('='), comma = text.find(',', sign);
  std::vector<std::string> numbers;
  std::istringstream rest(comma == std::string::npos ? "" : text.substr(comma + 1));
  for (std::string part; std::getline(rest, part, ',');) numbers.push_back(part);
  const bool is_complete = sign != std::string::npos && sign > 0 && comma > sign + 1 && text.back() != ',';
  if (!is_complete || (numbers.size() != kOfPosition && numbers.size() != kOfPose)) {
    throw Failure(FailureKind::usage, fmt::format("--frame: \"{}\" is no frame", text),
                  "write NAME=LINK,X,Y,Z in m, and ROLL,PITCH,YAW in rad behind them: tool=hand,0,0,0.1,0,0,pi/2, or "
                  "0,0,90deg");
  }
  const std::string name(trimmed(std::string_view(text).substr(0, sign))),
      link(trimmed(std::string_view(text).substr(sign + 1, comma - sign - 1)));
  SceneFrame frame{name, {link, {}}};
  if (const std::string problem = problem_of_frame_name(frame.name); !problem.empty()) {
    throw Failure(FailureKind::usage, fmt::format("--frame: \"{}\": {}", text, problem),
                  "write it as tool or left tool");
  }
  for (std::size_t k = 0; k < numbers.size(); ++k) set_entry(numbers[k], k, frame);
  return frame;
}

std::vector<JointPosition> fixed_options(const std::vector<std::string>& texts) {
  std::vector<JointPosition> all;
  for (const std::string& text : texts) {
    const JointPosition lock = fixed_option(text);
    const auto before =
        std::find_if(all.begin(), all.end(), [&lock](const JointPosition& each) { return each.joint == lock.joint; });
    if (before == all.end()) {
      all.push_back(lock);
    } else if (!vanishes(before->position - lock.position) || before->in_degrees != lock.in_degrees) {
      throw Failure(
          FailureKind::usage,
          fmt::format("--fix: joint \"{}\" is held at {} and at {}", lock.joint, before->written, lock.written),
          "give it one position");
    }
  }
  return all;
}

ErrorBudget error_budget_option(const std::string& text) {
  const std::optional<ErrorBudget> budget = error_budget(text);
  if (!budget) {
    throw Failure(FailureKind::usage, fmt::format("--error-budget: \"{}\" is no error budget", text), kErrorBudgetHint);
  }
  return *budget;
}

SearchLimit search_option(const std::string& text) {
  const std::optional<SearchLimit> limit = search_limit(text);
  if (!limit) throw Failure(FailureKind::usage, fmt::format("--search: \"{}\" is no limit", text), kSearchLimitHint);
  return *limit;
}

std::string file_name_fault(const std::string& text) {
  if (text.empty() || text.find('/') != std::string::npos) {
    return "\"" + text + "\" is no name of a file: write it without folder, which is -o's";
  }
  const bool is_safe =
      text.front() != '-' && std::none_of(text.begin(), text.end(), [](char c) {
        return static_cast<unsigned char>(c) < ' ' || std::string_view("\"'\\$`").find(c) != std::string_view::npos;
      });
  return is_safe ? "" : "a name of files has no quotes, no \\, $ and `, no control characters, and no - in front";
}

}  // namespace flatdyn
