// SPDX-License-Identifier: GPL-2.0-or-later
// The statements of one function, executed symbolically one operation after the other. Nothing is skipped: a statement
// in a place where it is not written is refused. An entry of an output is written once, inputs are read before that,
// results are returned at the end.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "code/readback/body_parser.hpp"
#include "code/readback/emitted_text.hpp"
#include "code/statement.hpp"

namespace flatdyn {

class Execution {
 public:
  Execution(const EmittedText& text, const ScannedFunction& written, const Function& like);

  // Throws Failure(bug) if an entry of an output is not written once, unless a scene leaves it out.
  StraightLine run();

 private:
  // A function returns nothing, the result of its checks, a value, or a stage.
  enum class Ending { none, checked, value, stage };

  struct Array {
    int length = -1;             // -1: not known
    std::map<int, int> entries;  // the operations that were written last, by index
  };

  // The state of the function that is carried out.
  struct Frame {
    const ScannedFunction* function = nullptr;
    std::map<std::string, int> variables;
    std::set<std::string> locals;  // arrays and stages
    bool has_checks = false;
    Ending ending = Ending::none;
  };

  [[noreturn]] void fail(const std::string& what) const;

  // Statements.
  Ending carry_out(const ScannedFunction& function);
  Ending wanted_ending(const std::string& returns) const;
  void execute(const code::Define& define);
  void execute(const code::Declare& declare);
  void execute(const code::DeclareStage& stage);
  void execute(const code::Store& store);
  void execute(const code::StoreZeros& zeros);
  void execute(const code::FillSines& fill);
  void execute(const code::Check& check);
  void execute(const code::CheckFinite& check);
  void execute(const code::CheckPositive& check);
  void execute(const code::CallPart& call);
  void execute(const code::Return& give_back);
  void execute(const code::Ignore& ignore);
  void execute(const code::UseLanes& use);
  void execute(const code::Gather& gather);
  void execute(const code::DefineLanes& define);

  // Arrays and what may be named where.
  bool is_in_part() const { return frame_.function != &written_; }
  void declare(const std::string& name, int length);
  void write(const std::string& array, int entry, int value);
  int length_of(InputKind kind) const;
  bool is_visible(const std::string& name) const;
  void refuse_known(const std::string& name) const;
  bool is_input(const std::string& array) const;
  bool is_output(const std::string& array) const;
  int field(const std::string& structure, const std::string& name) const;
  void require_full_use(const char* array) const;
  std::vector<int> entries_of(const Output& output, const std::string& name) const;
  void ask_for_sine(const std::string& angles, int k);
  void fill_computed(const code::FillSines& fill);
  int angle_at(int operation) const;
  void check_entry(const std::string& output, int entry);
  void require_all_checked() const;

  // Expressions: the operation whose value they have.
  int value(const code::Expression& expression);
  int value_of(const code::Literal& literal);
  int value_of(const code::Variable& variable);
  int value_of(const code::Element& element);
  int value_of(const code::Number& number);
  int value_of(const code::Parameter& parameter);
  int value_of(const code::Field& field);
  int value_of(const code::WrittenEntry& entry);
  int value_of(const code::Sum& sum);
  int value_of(const code::Product& product);
  int value_of(const code::Quotient& quotient);
  int value_of(const code::Negation& negation);
  int value_of(const code::Call& call);
  int input(Input input);
  int written_entry(const std::string& name, int entry) const;
  int scalar(const code::Expression& expression);

  static constexpr const char* kReturned = "returned";  // the entry of this array is the value returned
  static constexpr int kNoLane = -1;                    // a scalar is read
  static constexpr int kPosition = -1;                  // stands for an angle that is an entry of q

  const EmittedText& text_;
  const ScannedFunction& written_;
  const Function& like_;
  std::unique_ptr<BodyParser> parser_;
  std::vector<std::string> outputs_;  // names of the arrays that are the outputs
  StraightLine lines_;
  std::map<std::string, Array> arrays_;
  std::set<const ScannedFunction*> carried_out_;
  std::size_t token_ = 0;                         // of the statement that is executed
  bool has_written_ = false;                      // whether an entry of an output is written
  std::set<int> angles_asked_, angles_read_;      // whose sine and cosine are computed, and read
  std::set<std::pair<std::string, int>> finite_;  // entries that are checked to be finite

  std::set<int> types_of_limbs_;                   // their lanes
  std::map<std::string, std::vector<int>> limbs_;  // variables, with an operation for each lane
  int lane_ = kNoLane, lanes_ = 0, limbs_named_ = 0;

  Frame frame_;
};

}  // namespace flatdyn
