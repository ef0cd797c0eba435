// SPDX-License-Identifier: GPL-2.0-or-later
// The files of emitted C: a header and its source.
#pragma once

#include <set>

#include "code/readback/file_known_answer.hpp"
#include "code/readback/file_reader.hpp"

namespace flatdyn {

class CFile : public FileReader {
 public:
  CFile(const EmittedText& text, const FileContents& contents);

 protected:
  void file() override;
  void take_real(double wanted) override;
  void header();
  // Takes the parts of a function, the function, and before it the one that takes its sines and cosines.
  void definitions(const FileFunction& function, const char* linkage);
  void angles();

  // Finds the beginning of names in the text of the first count.
  void find_prefix();
  std::string count_name(const std::string& name) const;
  std::string prefixed(const std::string& name) const { return prefix_ + name; }
  virtual std::string condition_type() const { return "bool"; }

  bool has_lengths_ = true;            // whether arrays are declared with their lengths
  std::string scalar_;                 // of variables
  std::string prefix_;                 // of names
  std::string prefix_of_definitions_;  // of functions that are defined here

 private:
  void source();
  void sines();
  void known_answer();
  KnownCall known_call(const FileFunction& function) const;
  const ScannedFunction& scanned(const FileFunction& function) const;
  void count(const char* name, int value);
  void counts();
  std::string type_of(const FileTable& table) const;
  std::string length_of(const FileTable& table) const;
  void declare(const FileTable& table);
  void define(const FileTable& table);
  void parameters();
  void declarations(const FileFunction& function);
  bool follows_part(const std::string& owner) const;
  void part(const FileFunction& function, const ScannedFunction& asking);
  void parameter_list(const FileFunction& function, const ScannedFunction* body, bool takes_sines);
  void parameter(const EmittedParameter& parameter, const ScannedFunction* body, bool& is_first,
                 const ScannedFunction* given = nullptr);
  void length_of_sines(const ScannedFunction& given);
  int last_sine_read(const ScannedFunction& function, std::set<std::string>& parts) const;
  void require_used(const ScannedFunction& body, const std::string& name) const;
  const ScannedFunction* given_of(const FileFunction& function) const;
  std::string returns_of(const FileFunction& function) const;

  bool has_math_ = false, has_sign_ = false, has_excess_ = false, has_fma_ = false, has_sines_ = false;
  bool has_limits_missing_ = false;  // a table has HUGE_VAL, which <math.h> defines
};

}  // namespace flatdyn
