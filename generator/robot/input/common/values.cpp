// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/values.hpp"

#include "robot/input/common/quaternion.hpp"
#include "robot/input/common/spelling.hpp"
#include "robot/input/common/words.hpp"

namespace flatdyn {

namespace {

std::string count_text(std::size_t least, std::size_t most) {
  const std::string count = std::to_string(least);
  return least == most ? count + (most == 1 ? " number is" : " numbers are")
                       : count + " to " + std::to_string(most) + " numbers are";
}

}  // namespace

std::optional<Number> decimal_in(const FileText& text, Diagnostics& diagnostics) {
  return checked_decimal(single_word(text.text), text.spot, diagnostics);
}

Value value_in(const FileText& text, Diagnostics& diagnostics) {
  return {decimal_in(text, diagnostics).value_or(0), text.spot.place};
}

std::optional<FileNumbers> numbers_in(const FileText& text, std::size_t least, std::size_t most,
                                      Diagnostics& diagnostics, const std::string& hint) {
  FileNumbers found{{}, words_of(text.text), text.spot};
  if (found.written.size() < least || found.written.size() > most) {
    diagnostics.error(
        text.spot.place,
        text.spot.what + ": " + count_text(least, most) + " expected, not \"" + joined_words(found.written) + "\"",
        hint);
    return std::nullopt;
  }
  for (const std::string& word : found.written) {
    const std::optional<Number> number = checked_decimal(word, text.spot, diagnostics);
    if (!number) return std::nullopt;
    found.numbers.push_back(*number);
  }
  return found;
}

Vec3 as_vector(const std::vector<Number>& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

std::optional<Vec3> vector_in(const FileText& text, Diagnostics& diagnostics) {
  const std::optional<FileNumbers> found = numbers_in(text, 3, 3, diagnostics, "separate them by blanks: \"0 0 0.5\"");
  return found ? std::optional(as_vector(found->numbers)) : std::nullopt;
}

std::optional<bool> flag_in(const FileText& text, Diagnostics& diagnostics, const std::string& hint) {
  const std::string word = folded_name(single_word(text.text));
  if (word == "true" || word == "1") return true;
  if (word == "false" || word == "0") return false;
  diagnostics.error(text.spot.place, text.spot.what + ": \"" + text.text + "\" is neither true nor false", hint);
  return std::nullopt;
}

std::optional<Value> limit_in(const FileText& text, Bound bound, Diagnostics& diagnostics) {
  const std::string word = single_word(text.text);
  if (is_infinite_limit(word)) {
    check_infinite_limit(word, bound, text.spot, diagnostics);
    return std::nullopt;
  }
  const std::optional<Number> number = decimal_in(text, diagnostics);
  return number ? std::optional(Value{*number, text.spot.place}) : std::nullopt;
}

std::optional<Vec3> rpy_in(const std::vector<Number>& xyzw, const FileText& text, ReadContext& context,
                           const std::string& place_of_it) {
  const Quaternion q = {xyzw[0], xyzw[1], xyzw[2], xyzw[3]};
  // Files have units to as many digits as are printed; what is much longer or shorter is no rotation that is meant.
  if (magnitude(squared_norm(q) - 1) > magnitude(exact_decimal("1e-2"))) {
    context.diagnostics.error(text.spot.place, text.spot.what + ": this is not a unit quaternion",
                              "write x y z w with a sum of squares of 1" + place_of_it + ": 0 0 0 1 turns nothing");
    return std::nullopt;
  }
  // A pitch that is so near to a quarter turn is snapped to it.
  const bool snaps = !context.options.snap_tolerance.is_zero();
  Vec3 rpy = rpy_of(q, snaps ? exact_decimal("1e-12") : Number(0));
  for (Number& angle : rpy) angle = snapped_angle(angle, text.text, text.spot, context);
  return rpy;
}

}  // namespace flatdyn
