// SPDX-License-Identifier: GPL-2.0-or-later
// The files of emitted C++: a header, or a header and a source.
#pragma once

#include "code/readback/file_reader.hpp"

namespace flatdyn {

class CppFile : public FileReader {
 public:
  CppFile(const EmittedText& text, const FileContents& contents);

 protected:
  // Take the guard of a header, the beginning of its namespace, and close_loops(), if it is there, as this pattern
  // says.
  void guard();
  void polynomials();
  void flags();
  void name_space();
  void loops(const char* close_loops);
  void constants();
  void table(const FileTable& table);
  std::string parameter_name(const EmittedParameter& parameter, const ScannedFunction* body);
  std::string returns_of(const FileFunction& function, const std::string& scalar) const;
  std::string not_discarded(const FileFunction& function) const;
  void shape_of_array(const EmittedParameter& parameter, const std::string& name);

  bool has_sign_ = false, has_sqrt_ = false, has_excess_ = false, has_zeros_ = false, has_fma_ = false,
       has_limbs_ = false, has_sines_ = false;

 private:
  // A function that has been read, as others name it.
  struct Known {
    const FileFunction* function = nullptr;
    std::vector<std::string> outputs;  // their names in the text
    bool has_sin_cos = false;
    std::string stage;  // the stage that has it as a member
  };

  void file() override;
  void header();
  void source();
  void count(const char* name, int value);
  void take_real(double wanted) override;
  void parameters();
  void helpers();

  // Functions.
  void header_function(const FileFunction& function);
  void parts(const FileFunction& function);
  void part(const FileFunction& function);
  void definition(const FileFunction& function);
  void declaration(const FileFunction& function);
  Known parameter_list(const FileFunction& function, const ScannedFunction* body);

  // Stages.
  void stages();
  void structure(std::size_t k);
  void member(const FileFunction& function);
  std::vector<const FileFunction*> staged_functions() const;

  // The rest, after the functions.
  void refusals();
  void shapes();
  int place_of_stage(const Known& known) const;
  void shape(const Known& known, bool is_by_itself);
  void rounding();
  void rounding_helpers();
  void known_answer();
  void instances(const std::string& begin);
  void instance(const std::string& begin, const Known& known, const std::string& scalar, const std::string& source);

  bool is_pair() const { return contents_.form == Form::pair; }

  std::vector<Known> known_;   // functions by themselves and members of stages, in the order of the text
  std::vector<Known> makers_;  // functions that make stages
};

}  // namespace flatdyn
