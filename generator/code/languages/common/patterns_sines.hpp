// SPDX-License-Identifier: GPL-2.0-or-later
// The arithmetic of sines by polynomials, as it has to be in every language. It is written down here once more, not
// taken from the templates. Patterns have holes ($…$), which a language fills with its words.
#pragma once

#include <map>
#include <string>

namespace flatdyn {

// The words of a language.
struct SinesStyle {
  bool is_float = false;
  std::string let;             // what begins a definition: "const double"
  std::string next_let = ",";  // what stands between definitions of one group; "; let" where each is a statement
  std::string suffix{};        // of literals: "f"
  std::string one = "1.0";
  bool has_hexadecimals = true;
  std::string cosine_polynomial = "k";
};

// The types of a function that moves the bits of its numbers by memcpy, and how it writes that.
struct BitsOfSines {
  std::string number, bits;                      // "double", "uint64_t"
  bool is_initialised = true;                    // whether its variables are zero at first
  std::string memcpy = "memcpy", address = "&";  // of what it writes
};

// The words for the holes of the patterns below.
std::map<std::string, std::string> sines_holes(const SinesStyle& style);

// From x and n, its number of quarter turns, to r and `missing`.
std::string reduction_pattern(bool is_float);
// z and what else both polynomials need; each polynomial; and the sine and the cosine that are made of it.
std::string squares_pattern(bool is_float);
std::string sine_polynomial_pattern(bool is_float);
std::string cosine_polynomial_pattern(bool is_float);
std::string sine_pattern(bool is_float);
std::string cosine_pattern(bool is_float);
// All of these, and both values in variables s and c.
std::string polynomials_pattern(bool is_float);
// The statements of such a function.
std::string sines_by_bits_pattern(bool is_float, const BitsOfSines& words);

}  // namespace flatdyn
