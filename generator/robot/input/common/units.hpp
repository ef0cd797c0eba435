// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers of files that are written in degrees and millimetres, exactly: 90 is pi/2, 180.7 is 1807/10000. And of those
// that are not, but perhaps should say so (robot/model/unit_plausibility.hpp).
#pragma once

#include "robot/input/common/context.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// The text before a unit of degrees: "45" of "45 deg" or "45deg"; nullopt if there is no such unit.
std::optional<std::string> number_of_degrees(const std::string& text);

// Whether the text is a decimal number, which is snapped where it is an angle, and no expression.
bool is_decimal_text(const std::string& text);

// A length in m. A symbol is in m whatever the file's unit: an expression that adds a number to one is an error.
Number in_metres(const Number& written, const Units& units, const Spot& spot, Diagnostics& diagnostics);

// An angle in rad. In degrees an expression with pi is an error; a symbol is in rad whatever the file's unit.
Number in_radians(const Number& written, const Units& units, const Spot& spot, Diagnostics& diagnostics);

// The angle of a decimal, snapped (robot/input/common/context.hpp).
Number decimal_angle(const Number& decimal, std::string_view written, const Units& units, const Spot& spot,
                     ReadContext& context);

// A warning that asks whether an angle, rad, was meant in degrees. hint: what to do then.
void warn_of_degrees(const Number& angle, const Spot& spot, const std::string& hint, Diagnostics& diagnostics);

// A rate, or a position, of a joint in a motion's file with the key `angles`, in rad (m); odd positions are asked
// about.
Number rate_in_si(const Number& written, const Body& joint, const Units& units, const Spot& spot,
                  Diagnostics& diagnostics);
Number position_in_si(const Number& written, const Body& joint, const Units& units, const Spot& spot,
                      Diagnostics& diagnostics);

// Remembers a length, m, that is long for a robot: whether it is odd depends on the robot's masses.
void note_length(const Number& metres, const Spot& spot, const Units& units, ReadContext& context);

// Warnings that ask about joints' limits; and, unless the robot weighs tons, about the lengths that were noted and
// about moments of inertia.
void warn_of_units(const Robot& robot, ReadContext& context);

}  // namespace flatdyn
