// SPDX-License-Identifier: GPL-2.0-or-later
// Reading C++ back.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "code/readback/language_reader.hpp"

namespace flatdyn {

class CppReader : public LanguageReader {
 public:
  // A header, followed by its source if there is one.
  ScannedText scan(const std::vector<Token>& tokens) const override;
  std::string scalar(const ScannedText&) const override { return "Scalar"; }
  std::unique_ptr<BodyParser> body_parser(const EmittedText& text) const override;
  void read_file(const EmittedText& text, const FileContents& contents) const override;
};

AnyLanguageReader cpp_reader();

}  // namespace flatdyn
