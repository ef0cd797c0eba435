// SPDX-License-Identifier: GPL-2.0-or-later
// Values of URDF attributes, each with its line. URDF has decimals only: no expressions, no symbols.
#pragma once

#include <tinyxml2.h>

#include <optional>
#include <string>

#include "input/context.hpp"

namespace flatdyn {

class UrdfValues {
 public:
  UrdfValues(std::string file, ReadContext& context) : file_(std::move(file)), context_(context) {}

  Place place(const tinyxml2::XMLElement& element) const { return {file_, element.GetLineNum()}; }

  // The attribute, "" and an error if it is missing or empty; an error if it is not UTF-8.
  std::string required_text(const tinyxml2::XMLElement& element, const char* attribute, const std::string& what) const;

  // The number of an attribute; nullopt if it is not there, 0 and an error if it is no number.
  std::optional<Value> number(const tinyxml2::XMLElement& element, const char* attribute,
                              const std::string& what) const;
  // The same, an error if it is not there.
  Value required_number(const tinyxml2::XMLElement& element, const char* attribute, const std::string& what) const;

  // An angle, 0 if it is not there; near a multiple of pi/12 it is that.
  Number angle(const tinyxml2::XMLElement& element, const char* attribute, const std::string& what) const;

  // The number that is the text of an element: <mechanicalReduction>100</mechanicalReduction>.
  Number number_of_text(const tinyxml2::XMLElement& element, const std::string& what) const;

  // A limit: infinite means none.
  std::optional<Value> limit(const tinyxml2::XMLElement& element, const char* attribute, Bound bound,
                             const std::string& what) const;

  // Three numbers; `fallback` if the attribute is not there.
  Vec3 vector(const tinyxml2::XMLElement& element, const char* attribute, const std::string& what,
              const Vec3& fallback) const;

  // <origin xyz rpy> of an element that may have one: xyz, then Rz(yaw) Ry(pitch) Rx(roll).
  Pose origin(const tinyxml2::XMLElement& parent, const std::string& what) const;

  ReadContext& context() const { return context_; }

 private:
  // Snapped, and asked about where it may be in degrees.
  Number angle_of(const Number& decimal, const std::string& written, const Spot& spot) const;
  Vec3 angles(const tinyxml2::XMLElement& element, const char* attribute, const std::string& what) const;

  std::string file_;
  ReadContext& context_;
};

// The displacements of URDF's xyz and rpy; zero ones are left out.
Pose pose_from_xyz_rpy(const Vec3& xyz, const Vec3& rpy, const Place& place);

}  // namespace flatdyn
