// SPDX-License-Identifier: GPL-2.0-or-later
// Reading JavaScript back. It does not say which parameters are outputs, nor what a function returns.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "code/readback/language_reader.hpp"

namespace flatdyn {

class JavascriptReader : public LanguageReader {
 public:
  ScannedText scan(const std::vector<Token>& tokens) const override;
  std::string scalar(const ScannedText&) const override { return "number"; }
  bool names_types() const override { return false; }
  std::unique_ptr<BodyParser> body_parser(const EmittedText& text) const override;
  void read_file(const EmittedText& text, const FileContents& contents) const override;
};

AnyLanguageReader javascript_reader();

}  // namespace flatdyn
