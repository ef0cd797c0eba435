// SPDX-License-Identifier: GPL-2.0-or-later
// The differences between the languages of emitted code, as questions; languages/ has the answers, a file per language.
// Names of variables, the order of statements and the shape of expressions are common to all, so that all forms compute
// the same bits. No other file of this folder asks which language it is (`ctest -R Layout`).
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "code/emit/writer.hpp"
#include "code/lower/scope.hpp"
#include "code/table.hpp"
#include "graph/rational.hpp"

namespace flatdyn {

struct FunctionText;
struct HeaderScope;
struct UndeclaredFunction;

// The type of vectors with a number of each limb, followed by the number of lanes: "Limbs4".
inline constexpr const char* kLimbs = "Limbs";

// Answers that are given here are those of most languages with the syntax of C.
class Dialect {
 public:
  // `scalar`: the type of variables; `prefix`: the beginning of names at file scope.
  Dialect(std::string scalar, std::string prefix) : scalar_(std::move(scalar)), prefix_(std::move(prefix)) {}
  virtual ~Dialect() = default;
  Dialect(const Dialect&) = delete;
  Dialect& operator=(const Dialect&) = delete;

  // The type of variables: "Scalar", "float"; "number", which appears in JavaScript's comments.
  const std::string& scalar() const { return scalar_; }
  // A name at file or namespace scope: "gravity", "panda_gravity", for lanes "panda_lanes_gravity".
  std::string global(const std::string& name) const { return prefix_ + name; }
  // The name of a count: "joint_count", "PANDA_JOINT_COUNT".
  virtual std::string count_name(const std::string& name) const { return name; }
  // Reserved words that variables must avoid in addition to those of C++.
  virtual std::vector<std::string> reserved() const = 0;

  // Words that the names of free symbols, as members of a structure, must avoid in addition to those of C++.
  virtual std::vector<std::string> reserved_members() const { return {}; }
  // The columns by which statements are indented.
  virtual std::size_t indent() const { return kStatementIndent; }

  // Whether a literal is enclosed, "Scalar(-0.25)", so that its sign never meets another one.
  virtual bool encloses_literals() const { return false; }
  // A literal: "Scalar(0.0825)", "0.0825f". Throws Failure(input) if the scalar's range is too small for it.
  virtual std::string literal(const Rational& value) const = 0;
  // A literal in an array of constants: "Real(0.0825)", "0.0825f"; and "Real(-HUGE_VAL)", "-HUGE_VALF".
  virtual std::string real_literal(const Rational& value) const { return literal(value); }
  virtual std::string infinity(bool negative) const = 0;
  // A quoted string constant.
  virtual std::string text(const std::string& value) const;

  // A call of the sign: "detail::sign(x)", "panda_sign(x)", "Math.sign(x)".
  virtual std::string sign(const std::string& of) const = 0;
  // A call of the square root: "detail::sqrt(x)", "sqrtf(x)", "Math.sqrt(x)".
  virtual std::string sqrt(const std::string& of) const = 0;
  // A fused multiply-add, a b + c rounded once: "fma(a, b, c)", "panda_fma(a, b, c)". Only C++ and C are asked.
  virtual std::string fused(const std::string& a, const std::string& b, const std::string& c) const;
  // The statement before the first one in a function; empty if there is none.
  virtual std::string fused_begin() const { return ""; }
  // The value of a free symbol of the robot: "parameters.m_1", "parameters->m_1".
  virtual std::string parameter(const std::string& member) const { return "parameters." + member; }

  // The answers that statements of functions depend on.
  virtual LanguageTraits traits() const { return {}; }

  // A sine or cosine that is evaluated by itself. `function`: "sin" or "cos"; `angle`: "q[2]".
  virtual std::string angle_function(const std::string& function, const std::string& angle) const;
  // The statements that fill arrays of sines and cosines.
  virtual std::string filled_sines(const code::FillSines& fill) const;
  // Whether a function that needs sines and cosines has a variant with a name of its own that takes them as arguments.
  virtual bool has_given_variants() const { return false; }

  // Declarations of function arguments. Inputs are never `restrict`: one array may serve as several of them.
  // `length`: of the array, which few languages write.
  virtual std::string input(const std::string& name, std::size_t length) const;   // "const Scalar* q"
  virtual std::string output(const std::string& name, std::size_t length) const;  // "Scalar* tau"
  virtual std::string parameters_argument() const = 0;               // "const Parameters<Scalar>& parameters"
  virtual std::string number_output(const std::string& name) const;  // "Scalar& result", an array of one in C
  // An argument of a call of another function of the file.
  virtual std::string passed(const code::Argument& argument) const { return argument.name; }
  virtual std::string number_definition(const std::string& name) const { return array(name, "1"); }  // in C++ "result"
  virtual std::string number_use(const std::string& name) const { return name + "[0]"; }             // in C++ "result"
  // The type of a stage, "Motion<Scalar>", and the stage of a function that is a member of it. Only languages that have
  // stages are asked.
  virtual std::string stage_type(const std::string& stage) const { return stage; }
  virtual std::string own_stage() const { return ""; }
  // An entry of an output that an earlier kernel has written: "detail::stored(tau, 3)".
  virtual std::string written_entry(const std::string& output, int entry) const;

  // Declarations of local variables: the beginning, "const Scalar ", "const "; and an array, or a single number, that
  // is filled later: "Scalar ", and "kept[7]", in JavaScript "kept = new Float64Array(7)".
  virtual std::string constant() const { return "const " + scalar_ + " "; }
  virtual std::string arrays() const { return scalar_ + " "; }
  virtual std::string array(const std::string& name, const std::string& length) const;
  // The statements that declare variables, from their beginning and the rest of each: "const Scalar a = b, c = d;".
  virtual std::string declarations(const std::string& begin, const std::vector<std::string>& rests) const;
  // The statement that stores a value in all places, and the one that ends a function with its result.
  virtual std::string stored(const std::vector<std::string>& places, const std::string& value) const;
  // The statement that stores zeros in entries of an array from `first` to before `end`. Only languages that store them
  // together are asked.
  virtual std::string stored_zeros(const std::string& array, std::size_t first, std::size_t end) const;
  virtual std::string returned(const std::string& value) const { return "return " + value + ";"; }
  // The text before a call of a function of the file, and after its arguments.
  virtual std::string call_begin(bool is_returned) const { return is_returned ? "return " : ""; }
  virtual std::string call_end([[maybe_unused]] bool is_returned) const { return ");"; }
  // The statement that mentions a parameter that is not read, where compilers warn of it: "(void)qd;".
  virtual std::string ignored(const std::string& name) const { return "(void)" + name + ";"; }
  // The statement that introduces vectors with a number of each limb that have this many lanes.
  virtual std::string limbs_definition([[maybe_unused]] int lanes) const { return ""; }
  virtual std::string condition_type() const { return "bool"; }
  virtual std::string always() const { return "true"; }
  virtual std::string conditions_begin() const { return condition_type() + " valid = "; }
  virtual std::string conditions_continue() const { return "valid &= "; }

  // The beginning of a function that only functions of the same file call, up to its parameters; the lines before it,
  // and the text after the parameters.
  virtual std::string part_begin(const std::string& name) const = 0;                   // "void f_part_1("
  virtual std::string before_part() const { return ""; }                               // "template <class Scalar>\n"
  virtual std::string function_end() const { return ") {"; }                           // ") noexcept {"
  virtual std::string part_call(const std::string& name) const { return name + "("; }  // "detail::f_part_1("

  // Completes the text of a function, of which all but the declaration is written: its parameters, and what precedes or
  // follows from them.
  virtual void declare(FunctionText& text, const UndeclaredFunction& function) const = 0;

  // Definitions and declarations as lines; names are as emitted.
  virtual std::string count_definition(const std::string& name, int value) const = 0;
  std::string definition(const code::Table& table) const;
  // Whether constants are declared in one file and defined in another; counts are then defined where arrays are
  // declared.
  virtual bool declares_constants_apart() const { return false; }
  virtual std::string declaration(const code::Table& table) const;  // empty if they are not declared apart
  // The condition that a number is finite. NaN compares false, and zero times x is zero if x is finite, and else not a
  // number.
  virtual std::string finite(const std::string& number) const;
  // The checks that entries of an array from `first` to before `end` are finite, and that all of its entries are
  // positive, in loops: for (int k = 0; k < 7; ++k) { valid &= 0 * tau[k] < 1; }
  virtual std::string check_finite(const std::string& array, std::size_t first, std::size_t end) const;
  virtual std::string check_positive(const std::string& array, std::size_t length) const;
  // The call that makes a value that is positive if a rounded sum is above its first term. nullopt: the value is the
  // sum less the term, which no flag of the language's compilers may reorder to the second term.
  virtual std::optional<std::string> excess(const std::string& sum, const std::string& term) const;

 protected:
  // "inline constexpr bool x[joint_count] = {", "};"
  virtual std::string definition_begin(const code::Table& table) const = 0;
  virtual std::string definition_end() const { return "};"; }
  // An entry of a table: that of a flag is 0 or 1 in most languages.
  std::string entry(const code::TableEntry& entry) const;
  virtual std::string flag(bool is_set) const { return is_set ? "1" : "0"; }
  // A loop of checks of what the counter counts from `first` to before `end`.
  virtual std::string check_loop(std::size_t first, std::size_t end, const std::string& check) const;
  virtual const char* counter_type() const { return "int"; }

 private:
  std::string scalar_, prefix_;
};

}  // namespace flatdyn
