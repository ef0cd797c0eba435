// SPDX-License-Identifier: GPL-2.0-or-later
// Texts of a file → values, with errors that say where they stand. How a format finds the text of a value is its own.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/input/common/context.hpp"

namespace flatdyn {

struct FileText {
  std::string text;
  Spot spot;
};

// The decimal of a text of one word; nullopt and an error if it is none.
std::optional<Number> decimal_in(const FileText& text, Diagnostics& diagnostics);
// The same with its place, 0 where there is an error.
Value value_in(const FileText& text, Diagnostics& diagnostics);

struct FileNumbers {
  std::vector<Number> numbers;
  std::vector<std::string> written;  // number by number
  Spot spot;
};
// Decimals with blanks between them, `least` to `most` of them; nullopt and an error if they are others. hint: what to
// write.
std::optional<FileNumbers> numbers_in(const FileText& text, std::size_t least, std::size_t most,
                                      Diagnostics& diagnostics, const std::string& hint = "separate them by blanks");
std::optional<Vec3> vector_in(const FileText& text, Diagnostics& diagnostics);
Vec3 as_vector(const std::vector<Number>& numbers);

// true, 1, false or 0 in any letters; nullopt and an error for other words.
std::optional<bool> flag_in(const FileText& text, Diagnostics& diagnostics,
                            const std::string& hint = "write true or false");

// A limit; nullopt where it is infinite, which means none, and with an error where it is no number.
std::optional<Value> limit_in(const FileText& text, Bound bound, Diagnostics& diagnostics);

// roll, pitch, yaw of a unit quaternion, snapped; nullopt and an error if it is not of length 1.
// place_of_it: " behind the position", for the hint.
std::optional<Vec3> rpy_in(const std::vector<Number>& xyzw, const FileText& text, ReadContext& context,
                           const std::string& place_of_it = {});

}  // namespace flatdyn
