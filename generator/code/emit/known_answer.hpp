// SPDX-License-Identifier: GPL-2.0-or-later
// The call of every function at one known state, by which emitted code finds out whether it is executed as it is
// written: the bits of all results make a hash, which the text states. All numbers of the state are exact in float, and
// sines and cosines are made of them, so that nothing depends on a library. Functions that take sines of angles which
// they compute are left out.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "code/emit/page_dialect.hpp"

namespace flatdyn {

// These stand in the text, before they are filled in, for the 16 digits of the hash of its results in double and in
// float.
inline constexpr const char *kDoubleAnswer = "0xknown_in_double_", *kFloatAnswer = "0xknown_in_float__";

// The hashes of the polynomial sines and cosines at eight angles.
inline constexpr const char *kDoubleSines = "0x7b037ac8b2e0683c", *kFloatSines = "0x803948b6889bcc50";

// Seeds of the numbers in an argument, and of the tangents of half angles.
inline constexpr std::uint32_t kTangentSeed = 16;
constexpr std::uint32_t seed_of(InputKind kind) {
  const auto seed = static_cast<std::uint32_t>(kind) + 1;
  return seed < kTangentSeed ? seed : seed + 1;
}

inline constexpr const char* kSymbols = "symbol";  // the array of the robot's free symbols

// The known state: arrays of inputs, and the calls whose results are hashed.
struct KnownArray {
  std::string name;
  InputKind kind;  // decides its seed
  std::size_t length = 0;
};
struct KnownState {
  std::vector<KnownArray> arrays;
  std::size_t angles = 0;        // with sines and cosines; 0: no function asks for them
  std::size_t most_results = 0;  // of any function
};
KnownState known_state(const CodeContent& content);

// The words in which languages with pointers differ.
struct AnswerStyle {
  std::string scalar;                           // "Scalar", "float"
  std::string prefix;                           // of functions that fill arrays and hash them: "detail::", "arm_"
  std::string parameters, parameters_argument;  // "Parameters<Scalar>", and "parameters", or "&parameters" in C
  std::string given;  // "GivenSinCos<Scalar>"; empty where functions have variants that take arrays
};

// The statements that go from `seed` to `hash`, which are declared before.
std::string known_answer_statements(const CodeContent& content, const AnswerStyle& style);

}  // namespace flatdyn
