// SPDX-License-Identifier: GPL-2.0-or-later
// The checks at the end of a function whose result may mean nothing:
//
//   bool valid = D_1 > Scalar(0.0);                                a pivot
//   valid &= D_2 > Scalar(0.0);
//   valid &= Scalar(0.0) * qdd[3] < Scalar(1.0);                  an entry of an output: neither infinite nor NaN
//   for (int k = 0; k < 7; ++k) valid &= Scalar(0.0) * qdd[k] < Scalar(1.0);
//   for (const Scalar& pivot : pivots) valid &= pivot > Scalar(0.0);
//
// In C and JavaScript the loops have braces, and the last one counts.
#include <fmt/format.h>

#include "readback/text_reader.hpp"

namespace flatdyn {

// Reads the rest of "bool valid = true;" or "bool valid = D_1 > Scalar(0.0);".
void TextReader::begin_conditions() {
  const std::string name = take();
  if (name != kValid) fail("an unknown variable of checks");
  refuse_known(name);
  expect("=");
  if (!accept_always()) condition();
  expect(";");
  checks_ = name;
}

// Reads "true", or ~(arm_lanes_mask){0} of vectors.
bool TextReader::accept_always() {
  if (!notation_.has_lanes) return accept("true");
  if (!accept("~")) return false;
  expect("(");
  expect(notation_.condition);
  expect_all({")", "{", "0", "}"});
  return true;
}

// Reads "valid &= D_2 > Scalar(0.0);".
void TextReader::go_on_with_conditions() {
  expect(checks_);
  expect(notation_.and_also);
  if (begins_check_of_entry()) {
    check_of_entry(0, 0, false);
  } else {
    condition();
  }
  expect(";");
}

void TextReader::condition() {
  lines_.validity_conditions.push_back(sum());
  expect(">");
  zero();
}

// Reads "Scalar(0.0)" or "0.0f", of this number.
void TextReader::literal_of(const std::string& wanted) {
  if (notation_.is_cpp) {
    expect_all({"Scalar", "(", wanted.c_str(), ")"});
  } else if (notation_.has_lanes) {
    expect(notation_.scalar + "_all");
    expect_all({"(", (notation_.constants == "float" ? wanted + "f" : wanted).c_str(), ")"});
  } else {
    expect(notation_.constants == "float" ? wanted + "f" : wanted);
  }
}

void TextReader::zero() { literal_of("0.0"); }

// Whether "Scalar(0.0) * qdd[" follows, of an output. Sums do not read outputs.
bool TextReader::begins_check_of_entry() const {
  const std::size_t factor = notation_.is_cpp || notation_.has_lanes ? 4 : 1;
  return word(factor) == "*" && is_output(word(factor + 1)) && word(factor + 2) == "[";
}

// Reads "Scalar(0.0) * qdd[3] < Scalar(1.0)", or with the counter k as the index, which goes from `first` to before
// `end`.
void TextReader::check_of_entry(int first, int end, bool is_counted) {
  zero();
  expect("*");
  const std::string output = take();
  expect("[");
  if (is_counted) {
    expect("k");
  } else {
    first = index();
    end = first + 1;
  }
  expect_all({"]", "<"});
  literal_of("1.0");
  for (int k = first; k < end; ++k) {
    written_entry(output, k);
    if (!finite_.emplace(output, k).second) fail("a check made twice");
  }
}

void TextReader::loop_of_checks() {
  if (checks_.empty()) fail("no variable of checks");
  expect("(");
  if (notation_.is_cpp && is("const")) {
    all_pivots();
  } else {
    counted_checks();
  }
}

// Reads the rest of for (const Scalar& pivot : pivots) valid &= pivot > Scalar(0.0);
void TextReader::all_pivots() {
  expect_all({"const", "Scalar", "&", "pivot", ":", "pivots", ")"});
  expect(checks_);
  expect_all({"&=", "pivot", ">"});
  zero();
  expect(";");
  require_full_use("pivots");
  for (const auto& [index, pivot] : arrays_["pivots"].entries) lines_.validity_conditions.push_back(pivot);
}

// Reads the rest of for (int k = 0; k < 7; ++k) { valid &= pivots[k] > 0.0f; }, or the same over an output's entries.
void TextReader::counted_checks() {
  expect_all({notation_.counter, "k", "="});
  const int first = index();
  expect_all({";", "k", "<"});
  const int end = index();
  expect_all({";", "++", "k", ")"});
  if (!notation_.is_cpp) expect("{");
  expect(checks_);
  expect(notation_.and_also);
  if (begins_check_of_entry()) {
    constexpr int kMostEntries = 1'000'000;
    if (end <= first || end > kMostEntries) fail("another number of entries");
    check_of_entry(first, end, true);
  } else {
    expect_all({"pivots", "[", "k", "]", ">"});
    zero();
    require_full_use("pivots");
    const std::map<int, int>& pivots = arrays_["pivots"].entries;
    if (first != 0 || end != static_cast<int>(pivots.size())) fail("another number of pivots");
    for (const auto& [index, pivot] : pivots) lines_.validity_conditions.push_back(pivot);
  }
  expect(";");
  if (!notation_.is_cpp) expect("}");
}

// Every entry that is written is checked to be finite.
void TextReader::require_all_checked() const {
  for (const std::string& output : outputs_) {
    for (const auto& [entry, value] : arrays_.at(output).entries) {
      if (finite_.count({output, entry}) == 0) fail(fmt::format("{}[{}] is not checked", output, entry));
    }
  }
}

}  // namespace flatdyn
