// SPDX-License-Identifier: GPL-2.0-or-later
// The statements of one function, executed symbolically one operation after the other. Nothing is skipped: a statement
// that is not of the forms in emitted_text.hpp is refused, and so is one in a place where it is not written.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "readback/emitted_text.hpp"

namespace flatdyn {

class TextReader {
 public:
  TextReader(const EmittedText& text, const ScannedFunction& written, const Function& like);

  // Throws Failure(bug) if an entry of an output is not written once, unless a scene leaves it out.
  StraightLine read();

 private:
  // A function returns nothing, true, the result of its checks, a value, or a stage.
  enum class Ending { none, always, checked, value, stage };

  struct Array {
    int length = -1;             // -1: not known
    std::map<int, int> entries;  // the operations that were written last, by index
  };

  // Tokens.
  [[noreturn]] void fail(const std::string& what) const;
  const std::string& word(std::size_t ahead = 0) const;
  bool is(const char* text) const { return word() == text; }
  bool is_at_end() const { return at_ >= text_.tokens_.size(); }
  std::string take();
  void expect(const std::string& text);
  void expect_all(std::initializer_list<const char*> texts);
  bool accept(const char* text);
  int index();

  // Statements.
  void statement();
  void new_arrays();
  void definitions();
  void arrays();
  void array_of_numbers(const std::string& name);
  void stage();
  void unread();
  void check_of_scalar();
  void fused_operation();
  void assignment();
  std::size_t last_assignment() const;
  std::pair<std::string, int> target();
  void write(const std::string& array, int entry, int value);
  void give_back();
  Ending wanted_ending(const std::string& returns) const;

  // Arrays and what may be named where.
  void declare(const std::string& name, int length);
  const ScannedCount& count_of_sines() const;
  int length_of(InputKind kind) const;
  bool is_visible(const std::string& name) const;
  void refuse_known(const std::string& name) const;
  bool is_input(const std::string& array) const;
  bool is_output(const std::string& array) const;
  int field(const std::string& structure, const std::string& name) const;
  void require_full_use(const char* array) const;
  std::vector<int> entries_of(const Output& output, const std::string& name) const;

  // Sines and cosines.
  std::string array_of_angles() const;
  void sines_and_cosines();
  void sines_and_cosines_in_c();
  void begin_sines();
  void ask_for_sine(const std::string& angles, int k);
  int angle_at(int operation) const;

  // Calls of parts.
  void carry_out(const ScannedFunction& function);
  Ending call();
  void arguments_of(const ScannedFunction& part);

  // Conditions.
  void begin_conditions();
  bool accept_always();
  void go_on_with_conditions();
  void condition();
  bool begins_check_of_entry() const;
  void check_of_entry(int first, int end, bool is_counted);
  void loop_of_checks();
  void counted_checks();
  void all_pivots();
  void literal_of(const std::string& wanted);
  void zero();
  void require_all_checked() const;

  // Limbs that are computed together.
  void type_of_limbs();
  void limbs();
  std::vector<int> gathered_limbs(int lanes);
  std::vector<int> computed_limbs(int lanes);
  int value_of_limb(const std::vector<int>& values);
  int scalar_in_brackets();

  // Expressions.
  int sum();
  int product();
  int factor();
  int library_call();
  int sine_or_cosine();
  int same_in_all_lanes();
  int function_call(const std::string& function);
  int in_brackets();
  int multiply_add();
  int literal();
  int plain_literal();
  int named_value(const std::string& name);
  int member_of(const std::string& name);
  int entry_of(const std::string& name, int entry);
  int input(Input input);
  int stored_entry();
  int written_entry(const std::string& name, int entry) const;

  static constexpr const char* kReturned = "returned";  // the entry of this array is the value returned
  static constexpr int kNoLane = -1;                    // a scalar is read
  static constexpr int kPosition = -1;                  // stands for an angle that is an entry of q

  const EmittedText& text_;
  const EmittedNotation& notation_;
  const ScannedFunction& written_;
  const Function& like_;
  std::vector<std::string> outputs_;  // names of the arrays that are the outputs
  StraightLine lines_;
  std::map<std::string, Array> arrays_;
  std::set<const ScannedFunction*> carried_out_;
  std::size_t at_ = 0;
  int depth_ = 0;
  bool asked_for_sines_ = false, has_written_ = false;  // whether an entry of an output is written
  std::set<int> angles_asked_, angles_read_;            // whose sine and cosine are computed, and read
  std::set<std::pair<std::string, int>> finite_;        // entries that are checked to be finite

  std::map<std::string, int> types_of_limbs_;      // their lanes, by name
  std::map<std::string, std::vector<int>> limbs_;  // variables, with an operation for each lane
  int lane_ = kNoLane, lanes_ = 0, limbs_named_ = 0;

  // The state of the function that is carried out:
  const ScannedFunction* current_ = nullptr;
  std::map<std::string, int> variables_;
  std::set<std::string> locals_;  // arrays and stages
  std::string checks_;            // the variable of the checks; empty: there was none yet
  Ending ending_ = Ending::none;
};

}  // namespace flatdyn
