// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/emit/joints.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/table.hpp"
#include "code/emit/literals.hpp"
#include "code/emit/writer.hpp"
#include "robot/model/field_mechanism.hpp"

namespace flatdyn {

namespace {

constexpr LimitColumn kLimitKinds[] = {
    {"lower", "position_lower", "Smallest position, rad or m", true, &Limits::lower},
    {"upper", "position_upper", "Largest position, rad or m", false, &Limits::upper},
    {"speed", "velocity_limit", "Largest speed, rad/s or m/s", false, &Limits::velocity},
    {"acceleration", "acceleration_limit", "Largest acceleration, rad/s^2 or m/s^2", false, &Limits::acceleration},
    {"effort", "effort_limit", "Largest torque or force, N m or N", false, &Limits::effort},
};

// A literal as plain decimal, without the ".0" that only compilers need.
std::string plain(std::string literal) {
  if (literal.size() > 2 && literal.compare(literal.size() - 2, 2, ".0") == 0) literal.resize(literal.size() - 2);
  return literal;
}

std::optional<Rational> limit_of(const Body& body, const LimitColumn& kind) {
  const std::optional<Value>& limit = body.limits.*(kind.value);
  return limit ? rational_of(limit->number) : std::nullopt;
}

std::string type_of(const Body& body) {
  if (body.spherical > 0) return "spherical";
  return body.prismatic ? "prismatic" : body.continuous ? "continuous" : "revolute";
}

// The entry of qd, or of v, from which entry p of q is integrated; dependent joints have none.
std::string rate_text(const Mechanism& mechanism, int p) {
  const auto found = std::find(mechanism.independent.begin(), mechanism.independent.end(), p);
  if (found == mechanism.independent.end()) return "-";
  return std::to_string(mechanism.base_bodies() + (found - mechanism.independent.begin()));
}

// The entries of v of the joint of entry p of q: "2", or "2..4" with w of a spherical joint.
std::string velocities_text(const Mechanism& mechanism, int p) {
  const int body = mechanism.body_at(p);
  if (!mechanism.is_of_quaternion(p)) return std::to_string(body);
  return mechanism.quaternion_of(body) == p ? fmt::format("{}..{}", body, body + 2) : "";
}

}  // namespace

std::vector<LimitColumn> limits_given(const Mechanism& mechanism) {
  std::vector<LimitColumn> given;
  for (const LimitColumn& kind : kLimitKinds) {
    const bool any = std::any_of(mechanism.joints().begin(), mechanism.joints().end(),
                                 [&kind](const Body& body) { return limit_of(body, kind).has_value(); });
    if (any) given.push_back(kind);
  }
  return given;
}

std::optional<Rational> rational_of(const Number& number) {
  constexpr int kDigits = 40;  // digits of Pi and roots: enough for the nearest double
  if (has_symbols(number)) return std::nullopt;
  const Number exact = is_rational(number) ? number : exact_decimal(to_decimal(number, kDigits));
  return to_rational(exact);
}

std::vector<code::TableEntry> limit_entries(const Mechanism& mechanism, const LimitColumn& kind) {
  std::vector<code::TableEntry> entries;
  for (const Body& body : mechanism.joints()) {
    const std::optional<Rational> limit = limit_of(body, kind);
    entries.push_back(limit ? code::TableEntry(*limit) : code::Infinity{kind.is_lower});
  }
  return entries;
}

std::vector<std::string> joint_table(const Mechanism& mechanism) {
  const std::vector<LimitColumn> limits = limits_given(mechanism);
  std::vector<std::vector<std::string>> rows = {{"index", "joint", "moves link", "type", "unit"}};
  if (mechanism.has_spherical_joints()) rows[0] = {"q", "v", "joint", "moves link", "type", "unit"};
  if (mechanism.has_loops()) {
    rows[0] = {"q", mechanism.floating_base ? "v" : "qd", "joint", "moves link", "type", "unit"};
  }
  for (const LimitColumn& kind : limits) rows[0].push_back(kind.column);
  for (int p = 0; p < mechanism.position_count(); ++p) {
    const Body& body = mechanism.joint_at(p);
    std::vector<std::string> row = {std::to_string(p)};
    if (mechanism.has_loops()) row.push_back(rate_text(mechanism, p));
    if (mechanism.has_spherical_joints()) row.push_back(velocities_text(mechanism, p));
    for (const std::string& text : {comment_text(mechanism.position_name(p)), comment_text(body.link), type_of(body)}) {
      row.push_back(text);
    }
    row.emplace_back(body.prismatic ? "m" : body.spherical > 0 ? "1" : "rad");
    for (const LimitColumn& kind : limits) {
      const std::optional<Rational> limit = limit_of(body, kind);
      row.push_back(limit ? plain(decimal_literal(*limit)) : "none");
    }
    rows.push_back(row);
  }
  return aligned_lines(rows);
}

}  // namespace flatdyn
