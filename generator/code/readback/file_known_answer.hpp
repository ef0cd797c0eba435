// SPDX-License-Identifier: GPL-2.0-or-later
// The statements by which rounding_is_as_written() calls every function at a known state, as they have to be. They are
// written down here once more, not taken from the printer.
#pragma once

#include <string>
#include <vector>

#include "code/readback/file_reader.hpp"

namespace flatdyn {

struct KnownCall {
  const FileFunction* function = nullptr;
  std::string name;                    // in the text
  std::vector<std::string> arguments;  // in order; those of outputs are empty
};

// An array of the known state, and its seed.
struct KnownInput {
  std::string name;
  int length = 0, seed = 0;
};
// Those that the functions read, in the order of their seeds.
std::vector<KnownInput> known_inputs(const FileContents& contents);
inline constexpr int kSeedOfTangents = 16;  // that of sines and cosines

struct KnownAnswerWords {
  std::string scalar, prefix, parameters, given;  // as in patterns; `given` is empty where functions take arrays
  bool asks_sines = false;                        // whether any function needs sines or cosines
};

// The declarations, the numbers of the state, and the calls.
std::string known_answer_pattern(const FileContents& contents, const std::vector<KnownCall>& calls,
                                 const KnownAnswerWords& words);

// The hashes of the polynomial sines and cosines at eight angles, as they have to be.
inline constexpr const char *kRightDoubleSines = "0x7b037ac8b2e0683c", *kRightFloatSines = "0x803948b6889bcc50";

// Whether this is the constant of a hash: "0x" and 16 digits, unsigned. A wrong one makes the answer false.
bool is_hash(const std::string& token);

}  // namespace flatdyn
