// SPDX-License-Identifier: GPL-2.0-or-later
// Reading Rust back.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "code/readback/language_reader.hpp"

namespace flatdyn {

class RustReader : public LanguageReader {
 public:
  // `scalar`: of its numbers, "double" or "float".
  explicit RustReader(std::string scalar) : scalar_(std::move(scalar)) {}

  // The crate's source, followed by its manifest.
  ScannedText scan(const std::vector<Token>& tokens) const override;
  std::string scalar(const ScannedText&) const override { return scalar_ == "float" ? "f32" : "f64"; }
  std::string constants() const override { return scalar_; }
  std::unique_ptr<BodyParser> body_parser(const EmittedText& text) const override;
  void read_file(const EmittedText& text, const FileContents& contents) const override;

 private:
  std::string scalar_;
};

AnyLanguageReader rust_reader(const std::string& scalar);

}  // namespace flatdyn
