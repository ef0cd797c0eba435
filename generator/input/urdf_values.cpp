// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/urdf_values.hpp"

#include <array>
#include <sstream>
#include <vector>

#include "input/units.hpp"
#include "input/utf8.hpp"
#include "model/unit_doubts.hpp"

namespace flatdyn {

namespace {

using tinyxml2::XMLElement;

std::vector<std::string> words_of(const char* text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::string trimmed(const char* text) {
  const std::vector<std::string> words = words_of(text);
  return words.size() == 1 ? words[0] : std::string(text);
}

// Some files write 1e308 for infinite.
bool is_infinite(std::string_view text) {
  constexpr int kBeyond = 30;
  std::string_view word = text;
  if (!word.empty() && (word[0] == '+' || word[0] == '-')) word.remove_prefix(1);
  if (word == "inf" || word == "INF" || word == "Inf" || word == "infinity" || word == "Infinity") return true;
  try {
    const auto magnitude = GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(exact_decimal(text)));
    return magnitude >= GiNaC::pow(GiNaC::numeric(10), kBeyond);
  } catch (const std::invalid_argument&) {
    return false;  // no number at all: said by number()
  }
}

}  // namespace

std::string UrdfValues::required_text(const XMLElement& element, const char* attribute, const std::string& what) const {
  const char* text = element.Attribute(attribute);
  if (text != nullptr && !is_utf8(text)) {
    context_.diagnostics.error(place(element), what + ": " + attribute + " is not UTF-8",
                               "save the file as UTF-8 (iconv -t UTF-8), or write the name in ASCII");
    return text;
  }
  if (text != nullptr && *text != '\0') return text;
  context_.diagnostics.error(place(element), what + ": <" + element.Name() + "> has no attribute \"" + attribute + "\"",
                             std::string("write <") + element.Name() + " " + attribute + "=\"...\">");
  return "";
}

std::optional<Value> UrdfValues::number(const XMLElement& element, const char* attribute,
                                        const std::string& what) const {
  const char* text = element.Attribute(attribute);
  if (text == nullptr) return std::nullopt;
  const Spot spot{place(element), what + ", " + attribute};
  return Value{checked_decimal(trimmed(text), spot, context_.diagnostics).value_or(0), spot.place};
}

Value UrdfValues::required_number(const XMLElement& element, const char* attribute, const std::string& what) const {
  if (const std::optional<Value> value = number(element, attribute, what)) return *value;
  required_text(element, attribute, what);
  return {0, place(element)};
}

Number UrdfValues::angle(const XMLElement& element, const char* attribute, const std::string& what) const {
  const char* text = element.Attribute(attribute);
  if (text == nullptr) return 0;
  const Spot spot{place(element), what + ", " + attribute};
  const std::optional<Number> value = checked_decimal(trimmed(text), spot, context_.diagnostics);
  return value ? angle_of(*value, trimmed(text), spot) : Number(0);
}

Number UrdfValues::number_of_text(const XMLElement& element, const std::string& what) const {
  const char* text = element.GetText();
  return checked_decimal(text == nullptr ? "" : trimmed(text), {place(element), what}, context_.diagnostics)
      .value_or(0);
}

std::optional<Value> UrdfValues::limit(const XMLElement& element, const char* attribute, Bound bound,
                                       const std::string& what) const {
  const char* text = element.Attribute(attribute);
  if (text == nullptr) return std::nullopt;
  const Spot spot{place(element), what + ", " + attribute};
  if (is_infinite(trimmed(text))) {
    check_infinite_limit(trimmed(text), bound, spot, context_.diagnostics);
    return std::nullopt;
  }
  const std::optional<Number> value = checked_decimal(trimmed(text), spot, context_.diagnostics);
  return value ? std::optional<Value>({*value, spot.place}) : std::nullopt;
}

Vec3 UrdfValues::vector(const XMLElement& element, const char* attribute, const std::string& what,
                        const Vec3& fallback) const {
  const char* text = element.Attribute(attribute);
  if (text == nullptr) return fallback;
  const std::vector<std::string> words = words_of(text);
  if (words.size() != 3) {
    context_.diagnostics.error(place(element),
                               what + ", " + attribute + ": three numbers are expected, not \"" + text + "\"",
                               "separate them by blanks: \"0 0 0.5\"");
    return fallback;
  }
  Vec3 values;
  const Spot spot{place(element), what + ", " + attribute};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::optional<Number> value = checked_decimal(words[i], spot, context_.diagnostics);
    if (!value) return fallback;
    values[i] = *value;
  }
  return values;
}

Vec3 UrdfValues::angles(const XMLElement& element, const char* attribute, const std::string& what) const {
  const Vec3 decimals = vector(element, attribute, what, zero_vector());
  const char* text = element.Attribute(attribute);
  if (text == nullptr) return decimals;
  const std::vector<std::string> words = words_of(text);
  if (words.size() != 3) return decimals;
  Vec3 values;
  const Spot spot{place(element), what + ", " + attribute};
  for (std::size_t i = 0; i < 3; ++i) values[i] = angle_of(decimals[i], words[i], spot);
  return values;
}

Number UrdfValues::angle_of(const Number& decimal, const std::string& written, const Spot& spot) const {
  const Number angle = snapped_angle(decimal, written, spot, context_);
  if (may_be_degrees(angle)) {
    const std::string hint = "if so, write " + radians_text(decimal, AngleText::decimal) + ": URDF has radians";
    ask_for_degrees(angle, spot, hint, context_.diagnostics);
  }
  return angle;
}

Pose UrdfValues::origin(const XMLElement& parent, const std::string& what) const {
  const XMLElement* element = parent.FirstChildElement("origin");
  if (element == nullptr) return {{}, place(parent)};
  const std::string where = what + ", origin";
  if (element->Attribute("quat_xyzw") != nullptr || element->Attribute("quat_wxyz") != nullptr) {
    context_.diagnostics.unsupported(place(*element), where + ": a quaternion is not supported", "write rpy instead");
  }
  // One after the other: compilers differ in the order in which they evaluate arguments, and diagnostics would with
  // them.
  const Vec3 xyz = vector(*element, "xyz", where, zero_vector());
  for (const Number& length : xyz) note_length(length, {place(*element), where + ", xyz"}, {}, context_);
  const Vec3 rpy = angles(*element, "rpy", where);
  return pose_from_xyz_rpy(xyz, rpy, place(*element));
}

Pose pose_from_xyz_rpy(const Vec3& xyz, const Vec3& rpy, const Place& place) {
  using Kind = Displacement::Kind;
  Pose pose{{}, place};
  if (!xyz[0].is_zero() || !xyz[1].is_zero() || !xyz[2].is_zero()) {
    pose.displacements.push_back({Kind::translation, xyz, 0});
  }
  const std::array<std::pair<Kind, Number>, 3> rotations = {
      {{Kind::rotation_z, rpy[2]}, {Kind::rotation_y, rpy[1]}, {Kind::rotation_x, rpy[0]}}};
  for (const auto& [kind, angle] : rotations) {
    if (!angle.is_zero()) pose.displacements.push_back({kind, zero_vector(), angle});
  }
  return pose;
}

}  // namespace flatdyn
