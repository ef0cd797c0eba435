// SPDX-License-Identifier: GPL-2.0-or-later
// The differences between the languages of emitted text when it is read back. Readers share nothing with the dialects
// that write it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "code/readback/body_parser.hpp"
#include "code/readback/file_contents.hpp"
#include "code/readback/scan.hpp"

namespace flatdyn {

class LanguageReader {
 public:
  virtual ~LanguageReader() = default;

  // The parts of the text. Throws Failure(bug) if the emitter cannot have written it; so do all others.
  virtual ScannedText scan(const std::vector<Token>& tokens) const = 0;
  // The type of variables, "Scalar", and that of a function's verdict, "bool", in a text of these parts.
  virtual std::string scalar(const ScannedText& found) const = 0;
  virtual std::string verdict(const ScannedText&) const { return "bool"; }
  // The type to which constants are rounded: "double" or "float".
  virtual std::string constants() const { return "double"; }
  // Whether types of parameters distinguish inputs from outputs, and functions declare what they return. Otherwise both
  // follow from the order.
  virtual bool names_types() const { return true; }

  virtual std::unique_ptr<BodyParser> body_parser(const EmittedText& text) const = 0;
  // Compares all of the text but the statements of functions with what it has to hold.
  virtual void read_file(const EmittedText& text, const FileContents& contents) const = 0;
};

}  // namespace flatdyn
