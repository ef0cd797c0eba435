// SPDX-License-Identifier: GPL-2.0-or-later
// Reading C back.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "code/readback/language_reader.hpp"

namespace flatdyn {

class CReader : public LanguageReader {
 public:
  // `number`: the type of its numbers, "double" or "float".
  explicit CReader(std::string number) : number_(std::move(number)) {}

  // A header and its source, or the functions over arrays of states.
  ScannedText scan(const std::vector<Token>& tokens) const override;
  std::string scalar(const ScannedText&) const override { return number_; }
  std::string constants() const override { return number_; }
  std::unique_ptr<BodyParser> body_parser(const EmittedText& text) const override;
  void read_file(const EmittedText& text, const FileContents& contents) const override;

 protected:
  const std::string& number() const { return number_; }

 private:
  std::string number_;
};

// `scalar`: of its numbers, "double" or "float".
AnyLanguageReader c_reader(const std::string& scalar);
// C over states, behind the header.
AnyLanguageReader lanes_reader(const std::string& scalar);

}  // namespace flatdyn
