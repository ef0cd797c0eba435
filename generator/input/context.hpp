// SPDX-License-Identifier: GPL-2.0-or-later
// What the readers share while one robot is read: the options, the list of findings, symbols, snapped angles.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostics.hpp"
#include "input/reader.hpp"
#include "input/symbol_table.hpp"
#include "model/robot.hpp"

namespace flatdyn {

// A name that refers to a link or joint, and where it is said.
struct Reference {
  std::string name;
  Place place;
};

struct ReadContext {
  const ReadOptions& options;
  Diagnostics& diagnostics;
  SymbolTable symbols;
  std::vector<Snap> snaps;
  std::size_t angles_near = 0;         // to a multiple of pi/12, so far
  std::vector<Reference> held_joints;  // that the options or the file want held at q = 0
};

// What a number stands for in messages, and where it is: `joint "shoulder", origin rpy`.
struct Spot {
  Place place;
  std::string what;
};

// The number of a decimal as written. nullopt and a diagnostic if it is none, not finite, too long or too large.
std::optional<Number> checked_decimal(std::string_view text, const Spot& spot, Diagnostics& diagnostics);

// A decimal angle: the exact multiple of pi/12 if it is within the tolerance of one, which is then recorded, else
// the decimal as it is. `written` is the text that `angle` was read from.
Number snapped_angle(const Number& angle, std::string_view written, const Spot& spot, ReadContext& context);

// The largest magnitude of a number in a robot file: products and squares of such numbers stay within double.
Number largest_number();

// The text of a file. Throws Failure(io) if it cannot be read; nullopt and a diagnostic if it is larger than 64 MB.
std::optional<std::string> file_text(const std::string& path, Diagnostics& diagnostics);

}  // namespace flatdyn
