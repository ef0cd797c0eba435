// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/units.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <stdexcept>

#include "robot/model/unit_plausibility.hpp"

namespace flatdyn {
namespace {

constexpr double kLong = 20;    // m
constexpr double kHeavy = 1e3;  // kg; robots of tons, such as cranes, may be long

// The sum of the terms of an expression that have no symbols.
Number constant_term(const Number& value) {
  const Number expanded = value.expand();
  if (!GiNaC::is_a<GiNaC::add>(expanded)) return has_symbols(expanded) ? Number(0) : expanded;
  Number sum = 0;
  for (const Number& term : expanded) {
    if (!has_symbols(term)) sum += term;
  }
  return sum;
}

double known_mass(const Robot& robot) {
  double total = 0;
  for (const Link& link : robot.links) {
    for (const Inertial& inertial : link.inertials) {
      if (!has_symbols(inertial.mass.number)) total += nearest_double(inertial.mass.number);
    }
  }
  return total;
}

std::string hint_for_millimetres(const LongLength& length) {
  if (length.has_key) return "if so, write lengths = \"mm\" at the top of the file";
  return fmt::format("if so, write {:.9g}: lengths are in metres", nearest_double(length.metres) / 1000);
}

// The trace of an inertia tensor is twice the mass times the square of how far, on average, it is from the point.
void warn_of_inertia(const Link& link, const Inertial& inertial, Diagnostics& diagnostics) {
  const Number trace = inertial.tensor[0][0] + inertial.tensor[1][1] + inertial.tensor[2][2];
  if (has_symbols(trace) || has_symbols(inertial.mass.number) || vanishes(inertial.mass.number)) return;
  const double radius = std::sqrt(std::abs(nearest_double(trace / inertial.mass.number) / 2));
  if (radius <= kLong) return;
  diagnostics.warning(
      inertial.place,
      fmt::format("link \"{}\": its inertia is that of a body of {:.3g} m beside {:.6g} kg; were kg mm^2 "
                  "meant?",
                  link.name, 2 * radius, nearest_double(inertial.mass.number)),
      "if so, divide by 1e6: moments of inertia are in kg m^2, also in a file in millimetres", kLengthWarnings);
}

// The first of a joint's two limits that is odd; nullptr if none is.
template <class IsOdd>
const Value* odd_limit(const Limits& limits, const IsOdd& is_odd) {
  for (const std::optional<Value>* limit : {&limits.upper, &limits.lower}) {
    if (*limit && is_odd((*limit)->number)) return &**limit;
  }
  return nullptr;
}

std::string hint_for_limit(const Value& limit, const Robot& robot) {
  const std::string without_end = "; if it turns without end, it needs no limit";
  if (limit.place.file == robot.scene.file) return degrees_hint(limit.number) + without_end;
  if (kind_of(limit.place.file) == FileKind::toml) return degrees_hint(limit.number);
  return "if so, write " + radians_text(limit.number, AngleText::decimal) + without_end + " but type=\"continuous\"";
}

void warn_of_angular_limits(const Robot& robot, Diagnostics& diagnostics) {
  for (const Joint& joint : robot.joints) {
    const bool turns = joint.type == JointType::revolute || joint.type == JointType::continuous;
    const Value* limit = turns ? odd_limit(joint.limits, limit_may_be_degrees) : nullptr;
    if (limit == nullptr) continue;
    diagnostics.warning(limit->place,
                        fmt::format("joint \"{}\", limit: {}", joint.name, degrees_question(limit->number)),
                        hint_for_limit(*limit, robot), kLimitWarnings);
  }
}

// 1000 and other powers of ten, and what is beyond, are written for "no limit".
bool is_long_stroke(const Number& limit) {
  constexpr double kBeyond = 1e4;
  const double size = std::abs(nearest_double(limit)), decades = std::log10(size);
  return size > kLong && size < kBeyond && decades != std::round(decades);
}

void warn_of_strokes(const Robot& robot, Diagnostics& diagnostics) {
  for (const Joint& joint : robot.joints) {
    const bool slides = joint.type == JointType::prismatic;
    const Value* limit = slides ? odd_limit(joint.limits, is_long_stroke) : nullptr;
    if (limit == nullptr) continue;
    const bool has_key = kind_of(limit->place.file) == FileKind::toml && limit->place.file != robot.scene.file;
    const std::string what = fmt::format("joint \"{}\", limit", joint.name);
    diagnostics.warning(
        limit->place, fmt::format("{}: {:.6g} m is far; were millimetres meant?", what, nearest_double(limit->number)),
        hint_for_millimetres({limit->number, {limit->place, what}, has_key}), kLengthWarnings);
  }
}

}  // namespace

std::optional<std::string> number_of_degrees(const std::string& text) {
  constexpr std::string_view kUnit = "deg", kBlanks = " \t";
  const std::size_t last = text.find_last_not_of(kBlanks);
  const std::string whole = last == std::string::npos ? "" : text.substr(0, last + 1);
  if (!whole.ends_with(kUnit)) return std::nullopt;
  const std::string before = whole.substr(0, whole.size() - kUnit.size());
  const std::size_t end = before.find_last_not_of(kBlanks);
  if (end == std::string::npos) return std::nullopt;
  // A letter before it makes it part of a name.
  const char c = before[end];
  const bool is_name = end + 1 == before.size() && (std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_');
  const bool is_factor = c == '*' || c == '/' || c == '+' || c == '-';
  if (is_name || is_factor) return std::nullopt;
  return before.substr(0, end + 1);
}

bool is_decimal_text(const std::string& text) {
  try {
    exact_decimal(text);
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

Number in_metres(const Number& written, const Units& units, const Spot& spot, Diagnostics& diagnostics) {
  constexpr int kPerMetre = 1000;
  if (!units.millimetres) return written;
  if (!has_symbols(written)) return written / kPerMetre;
  if (!vanishes(constant_term(written))) {
    diagnostics.error(spot.place,
                      spot.what + ": a number is added to a symbol in a file in millimetres, but symbols are in metres",
                      "give the number a symbol of its own, or write the file in metres");
  }
  return written;
}

Number in_radians(const Number& written, const Units& units, const Spot& spot, Diagnostics& diagnostics) {
  constexpr int kHalfTurn = 180;
  if (!units.degrees || has_symbols(written)) return written;
  if (written.has(GiNaC::Pi)) {
    diagnostics.error(spot.place, spot.what + ": an expression with pi in a file in degrees: which are meant?",
                      "write degrees without pi (pi/2 is 90), or leave angles = \"deg\" out");
  }
  return written * GiNaC::Pi / kHalfTurn;
}

Number decimal_angle(const Number& decimal, std::string_view written, const Units& units, const Spot& spot,
                     ReadContext& context) {
  constexpr int kDigits = 80, kTwelfth = 15;
  if (!units.degrees) return snapped_angle(decimal, written, spot, context);
  const Number exact = in_radians(decimal, units, spot, context.diagnostics);
  if ((decimal / kTwelfth).info(GiNaC::info_flags::integer)) return exact;
  const Number rational = exact_decimal(to_decimal(exact, kDigits));
  const std::size_t rounded = context.rounded_angles.size();
  const Number snapped = snapped_angle(rational, written, spot, context);
  context.rounded_angles.resize(rounded);  // the text's digits are of degrees
  return snapped.is_equal(rational) ? exact : snapped;
}

void warn_of_degrees(const Number& angle, const Spot& spot, const std::string& hint, Diagnostics& diagnostics) {
  diagnostics.warning(spot.place, spot.what + ": " + degrees_question(angle), hint, kAngleWarnings);
}

Number rate_in_si(const Number& written, const Body& joint, const Units& units, const Spot& spot,
                  Diagnostics& diagnostics) {
  return joint.prismatic ? written : in_radians(written, units, spot, diagnostics);
}

Number position_in_si(const Number& written, const Body& joint, const Units& units, const Spot& spot,
                      Diagnostics& diagnostics) {
  const bool is_odd = !joint.prismatic && !units.degrees && may_be_degrees(written, joint.limits, joint.continuous);
  if (is_odd) warn_of_degrees(written, spot, degrees_hint(written), diagnostics);
  return rate_in_si(written, joint, units, spot, diagnostics);
}

void note_length(const Number& metres, const Spot& spot, const Units& units, ReadContext& context) {
  if (has_symbols(metres) || std::abs(nearest_double(metres)) <= kLong) return;
  context.long_lengths.push_back({metres, spot, units.has_keys});
}

void warn_of_units(const Robot& robot, ReadContext& context) {
  warn_of_angular_limits(robot, context.diagnostics);
  const double mass = known_mass(robot);
  if (mass >= kHeavy) return;
  const std::string beside = mass > 0 ? fmt::format(" beside {:.3g} kg in all", mass) : "";
  for (const LongLength& length : context.long_lengths) {
    context.diagnostics.warning(length.spot.place,
                                fmt::format("{}: {:.6g} m is long{}; were millimetres meant?", length.spot.what,
                                            nearest_double(length.metres), beside),
                                hint_for_millimetres(length), kLengthWarnings);
  }
  warn_of_strokes(robot, context.diagnostics);
  for (const Link& link : robot.links) {
    for (const Inertial& inertial : link.inertials) warn_of_inertia(link, inertial, context.diagnostics);
  }
}

}  // namespace flatdyn
