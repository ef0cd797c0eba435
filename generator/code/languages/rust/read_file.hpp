// SPDX-License-Identifier: GPL-2.0-or-later
// The files of an emitted crate: its source, and behind it its manifest.
#pragma once

#include <string>
#include <vector>

#include "code/readback/file_reader.hpp"

namespace flatdyn {

class RustFile : public FileReader {
 public:
  RustFile(const EmittedText& text, const FileContents& contents);

 private:
  void file() override;
  void fill_words_of_scalar();
  void constants();
  void count(const char* name, int value);
  void table(const FileTable& table);
  void take_real(double wanted) override;
  void take_flag(bool wanted) override;
  void parameters();
  void helpers();
  void sines();
  void angles();
  void known_answer();
  void require_helpers() const;

  void function(const FileFunction& function);
  void part(const FileFunction& function, const ScannedFunction& asking);
  void signature(const FileFunction& function, const std::string& name, bool takes_sines, const ScannedFunction& body);
  const ScannedFunction* given_of(const FileFunction& function) const;
  void require_used(const ScannedFunction& body, const std::string& name) const;
  std::string type_of_shared(const std::string& array, const ScannedFunction* given,
                             const ScannedFunction& asking) const;
  void known_parameters();
  void known_call(const FileFunction& function);
  const ScannedFunction& scanned(const std::string& name) const;

  bool is_float() const { return contents_.scalar == "float"; }
  std::string array_type(int length, bool is_output = false) const;

  std::string real_;
  bool is_without_std_ = false, has_sign_ = false, has_sqrt_ = false, has_fma_ = false, has_sines_ = false;
};

}  // namespace flatdyn
