// SPDX-License-Identifier: GPL-2.0-or-later
// The reading of a file as far as all languages have it in common: patterns with holes, tables, bodies of functions.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "code/readback/file_contents.hpp"
#include "code/readback/token_cursor.hpp"

namespace flatdyn {

class FileReader : protected TokenCursor {
 public:
  virtual ~FileReader() = default;
  FileReader(const FileReader&) = delete;
  FileReader& operator=(const FileReader&) = delete;

  // Reads the whole text.
  void run();

 protected:
  FileReader(const EmittedText& text, const FileContents& contents);

  virtual void file() = 0;

  // Patterns are text of the language with holes: "$real$ joint_count". A directive takes a line of its own.
  void fill(const std::string& hole, const std::string& text) { holes_[hole] = text; }
  void fill(const std::map<std::string, std::string>& holes) {
    for (const auto& [hole, text] : holes) fill(hole, text);
  }
  void expect(const std::string& pattern);
  bool accept(const std::string& pattern);
  bool follows(const std::string& pattern) const;

  const std::string& take();
  // Takes a name that is `wanted`, or `wanted` with a number that distinguishes it from another one.
  std::string take_name_like(const std::string& wanted);
  void require_name_like(const std::string& wanted, const std::string& name) const;
  // Takes a text, a whole number or a real one, and compares it.
  void take_text(const std::string& wanted);
  void take_number(const FileTable& table, double wanted);
  virtual void take_real(double wanted) = 0;
  virtual void take_flag(bool wanted);  // 0 or 1, unless the language has words for them
  double take_literal(char suffix);
  // Takes the entries of a table up to its end, separated by commas.
  void take_entries(const FileTable& table, const char* end);

  // Whether these tokens follow one another anywhere in the functions that are read.
  bool uses(const std::vector<std::string>& words) const;
  // Throws unless a helper is there where it is used, and only there.
  void require_helper(const char* helper, bool is_there, bool is_used) const;

  // The next function of EmittedText::functions().
  const ScannedFunction& next_function();
  // The names that the function that was read last gives its outputs.
  std::vector<std::string> names_of_outputs_read() const;
  // The names that the next function gives its outputs.
  std::vector<std::string> names_of_outputs(const FileFunction& function) const;
  // Takes the statements of a function, or of a part, of this name, and the brace at its end.
  void take_body(const ScannedFunction& function);
  void take_part_body(const std::string& name);
  bool names(const ScannedFunction& function, const std::string& name) const;
  // Whether the token is a member of a struct, such as a free symbol among the parameters, whose name may be any.
  bool is_member(std::size_t at) const;

  // The arrays that parts share for sines and cosines of angles that the function computes, round by round.
  std::vector<std::string> arrays_of_sine_rounds() const;
  // Takes the parameters of a part, which are some of these, in their order, and the bracket at their end.
  void take_parameters_of_part(const std::vector<std::string>& patterns);

  // Whether sines and cosines are polynomials of the text's own, not those of the library.
  bool has_polynomials() const { return contents_.sines == Sines::polynomials; }

  const EmittedText& text_;
  const FileContents& contents_;

 private:
  std::vector<Token> tokens_of_pattern(const std::string& pattern) const;
  void require_all_parts_called() const;
  void note_called(const ScannedFunction& function, std::set<std::string>& called) const;

  std::map<std::string, std::string> holes_;
  std::size_t functions_read_ = 0;
  std::set<std::string> parts_read_;
};

// The parameters of a function, in order: their names in the text and what they are.
struct EmittedParameter {
  enum class Kind { parameters, input, output } kind = Kind::input;
  std::string name;  // as it should be
  int length = 0;
  int columns = 0;  // of an output that is a matrix; else 0
  bool is_written = true;
  bool is_number = false;  // an output that is no array
};

// Whether the function returns its only output.
bool returns_number(const Function& function);

std::vector<EmittedParameter> parameters_of(const FileFunction& function, const FileContents& contents);

}  // namespace flatdyn
