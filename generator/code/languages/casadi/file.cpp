// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/casadi/file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <set>

#include "base/diagnostics/diagnostics.hpp"
#include "base/diagnostics/version.hpp"
#include "code/emit/page.hpp"
#include "code/emit/page_writer.hpp"
#include "code/emit/sections.hpp"
#include "code/emit/writer.hpp"
#include "code/languages/c/language.hpp"
#include "code/languages/casadi/interface.hpp"
#include "templates.hpp"

namespace flatdyn {
namespace {

using kainjow::mustache::data;

// Without the vectoriser of basic blocks, which slows long ones down (docs/benchmark.md).
constexpr const char* kLibrary =
    "cc -O3 -march=native -mtune=generic -fno-tree-slp-vectorize -shared -fPIC {0}.c {0}_casadi.c -o lib{0}.so -lm";

// "q[7]", "B[7x7]", "C[7x7, 42 stored]".
std::string text_of(const CasadiArgument& argument) {
  const Sparsity& shape = argument.sparsity;
  const std::string size = shape.cols == 1 ? std::to_string(shape.rows) : fmt::format("{}x{}", shape.rows, shape.cols);
  const bool is_full = shape.count() == shape.rows * shape.cols;
  return fmt::format("{}[{}{}]", argument.name, size, is_full ? "" : fmt::format(", {} stored", shape.count()));
}

std::string list_of_arguments(const std::vector<CasadiArgument>& arguments) {
  std::vector<std::string> texts;
  for (const CasadiArgument& each : arguments) texts.push_back(text_of(each));
  return fmt::format("({})", fmt::join(texts, ", "));
}

// The sparsity patterns of a file, each with a name.
class Patterns {
 public:
  std::string name_of(const Sparsity& sparsity) {
    const std::vector<int> numbers = sparsity.compressed();
    const auto found = std::find(all_.begin(), all_.end(), numbers);
    const auto number = found - all_.begin();
    if (found == all_.end()) all_.push_back(numbers);
    return fmt::format("s{}", number);
  }

  std::string definitions() const {
    std::string text;
    for (std::size_t k = 0; k < all_.size(); ++k) {
      std::vector<std::string> numbers;
      for (const int number : all_[k]) numbers.push_back(std::to_string(number));
      text += list_line(fmt::format("static const casadi_int s{}[] = {{", k), numbers, "};", 0);
    }
    return without_newline(text);
  }

 private:
  std::vector<std::vector<int>> all_;
};

// A call of a function of the C form; numbers that CasADi's arguments and results have no place for are in w.
class Call {
 public:
  Call(const CasadiFunction& function, const FunctionText* text, const std::string& parameters_type)
      : function_(function), text_(text) {
    if (text == nullptr) return;
    add_parameters(parameters_type);
    for (std::size_t k = 0; k < function.arguments.size(); ++k) {
      add_argument(function.arguments[k], function.code->inputs[k]);
    }
    for (std::size_t k = 0; k < function.outputs.size(); ++k) {
      const int count = function.outputs[k].sparsity.count();
      if (count > 0) arguments_.push_back(fmt::format("wanted(res[{}], {})", k, place_in_w(taken(count))));
    }
  }

  int numbers() const { return numbers_; }

  // The statements of the body.
  std::string body() const {
    std::string text = "  (void)iw;\n  (void)mem;\n";
    if (text_ == nullptr) return "  (void)arg;\n  (void)res;\n  (void)w;\n" + text + "  return 0;\n";
    if (!reads_arguments_) text = "  (void)arg;\n" + text;
    text += statements_;
    const bool can_fail = text_->returns == "bool";
    text += list_line((can_fail ? "return " : "") + text_->name + "(", arguments_, can_fail ? ") ? 0 : 1;" : ");",
                      kStatementIndent);
    return text + (can_fail ? "" : "  return 0;\n");
  }

 private:
  // The first of some numbers in w that nothing else takes.
  int taken(int count) {
    const int first = numbers_;
    numbers_ += count;
    return first;
  }

  static std::string place_in_w(int number) { return number == 0 ? "w" : fmt::format("w + {}", number); }

  void add_parameters(const std::string& type) {
    if (function_.parameters < 0) return;
    reads_arguments_ = true;
    statements_ += fmt::format("  {} parameters;\n", type);
    statements_ += fmt::format("  memcpy(&parameters, given(arg[{}]), sizeof parameters);\n", function_.parameters);
    arguments_.emplace_back("&parameters");
  }

  void add_argument(const AssembledArray& array, InputKind kind) {
    if (array.length == 0) {
      arguments_.emplace_back("zeros");
      return;
    }
    reads_arguments_ = true;
    if (array.is_argument()) {
      arguments_.push_back(fmt::format("given(arg[{}])", array.pieces.front().argument));
      return;
    }
    const std::string name = argument_row(kind).name;
    statements_ += fmt::format("  casadi_real* const {} = {};\n", name, place_in_w(taken(array.length)));
    int place = 0;
    for (const AssembledArray::Piece& piece : array.pieces) {
      if (piece.place > place) add_copy(name, place, "0", piece.place - place);
      add_copy(name, piece.place, fmt::format("arg[{}]", piece.argument), piece.length);
      place = piece.place + piece.length;
    }
    if (place < array.length) add_copy(name, place, "0", array.length - place);
    arguments_.push_back(name);
  }
  void add_copy(const std::string& to, int place, const std::string& from, int length) {
    statements_ += fmt::format("  memcpy({}{}, given({}), {} * sizeof(casadi_real));\n", to,
                               place == 0 ? "" : fmt::format(" + {}", place), from, length);
  }

  const CasadiFunction& function_;
  const FunctionText* text_;
  std::string statements_;
  std::vector<std::string> arguments_;
  int numbers_ = 0;
  bool reads_arguments_ = false;
};

class CasadiFile {
 public:
  CasadiFile(const Mechanism& mechanism, const std::vector<Function>& functions, const EmitOptions& options)
      : mechanism_(mechanism),
        options_(options),
        functions_(casadi_functions(mechanism, functions)),
        dialect_(c_language().dialect(mechanism, options)) {
    std::vector<Function> code;
    for (const CasadiFunction& each : functions_) {
      if (each.code) code.push_back(*each.code);
    }
    texts_ = function_texts(*dialect_, mechanism, code, options);
    refuse_equal_names();
  }

  std::string text() {
    const std::string name = file_name(mechanism_, options_);
    data page, functions(data::type::list);
    page["robot"] = comment_text(mechanism_.name);
    page["version"] = std::string(kProgramVersion);
    page["header_file"] = name + ".h";
    page["compile"] = fmt::format(fmt::runtime(kLibrary), name);
    page["example"] = functions_.front().name;
    page["library"] = fmt::format("./lib{}.so", name);
    std::size_t code = 0;
    for (const CasadiFunction& each : functions_) {
      functions << data_of(each, each.code ? &texts_[code++] : nullptr);
    }
    page["functions"] = data(functions);
    page["signatures"] = signatures();
    page["longest"] = std::to_string(longest_argument());
    page["patterns"] = patterns_.definitions();
    return rendered(templates::casadi_c, page);
  }

 private:
  // CasADi's names have no prefix, so that two of them, or one and a name of the C form, may be the same.
  void refuse_equal_names() const {
    std::set<std::string> names;
    for (const FunctionText& text : texts_) names.insert(text.name);
    for (const CasadiFunction& each : functions_) {
      if (names.insert(each.name).second) continue;
      throw Failure(FailureKind::usage,
                    fmt::format("--language casadi: two functions of the library are \"{}\"", each.name),
                    "leave one of them out, or choose another --namespace");
    }
  }

  // The arguments and results of a function.
  static std::string signature_of(const CasadiFunction& function) {
    return function.name + list_of_arguments(function.inputs) + " -> " + list_of_arguments(function.outputs);
  }

  data signatures() const {
    data lines(data::type::list);
    for (auto each = functions_.begin(); each != functions_.end();) {
      std::string text = signature_of(*each);
      const std::string name = each->name;
      std::vector<std::string> derivatives;
      while (++each != functions_.end() && each->derivative_of == name) derivatives.push_back(each->name);
      if (!derivatives.empty()) text += fmt::format("; with {}", fmt::join(derivatives, ", "));
      std::vector<std::string> wrapped = wrapped_words(text, kCommentWidth - 4);
      for (std::size_t k = 1; k < wrapped.size(); ++k) wrapped[k].insert(0, "  ");
      for (const std::string& line : wrapped) lines << data(line);
    }
    return lines;
  }

  int longest_argument() const {
    int longest = 1;
    for (const CasadiFunction& each : functions_) {
      for (const CasadiArgument& input : each.inputs) longest = std::max(longest, input.sparsity.count());
      for (const AssembledArray& array : each.arguments) longest = std::max(longest, array.length);
    }
    return longest;
  }

  // `text`: null if the function has no code.
  data data_of(const CasadiFunction& function, const FunctionText* text) {
    const Call call(function, text, dialect_->global("parameters"));
    data item("name", function.name);
    item["names_in"] = names_line(function.name, "in", function.inputs);
    item["names_out"] = names_line(function.name, "out", function.outputs);
    item["sparsity_in"] = patterns_line(function.name, "in", function.inputs);
    item["sparsity_out"] = patterns_line(function.name, "out", function.outputs);
    item["count_in"] = std::to_string(function.inputs.size());
    item["count_out"] = std::to_string(function.outputs.size());
    item["head"] = without_newline(list_line(
        fmt::format("CASADI_SYMBOL_EXPORT int {}(", function.name),
        {"const casadi_real** arg", "casadi_real** res", "casadi_int* iw", "casadi_real* w", "int mem"}, ") {", 0));
    item["undifferentiated?"] = function.undifferentiated.has_value();
    item["undifferentiated"] = std::to_string(function.undifferentiated.value_or(0));
    item["numbers"] = std::to_string(call.numbers());
    item["body"] = without_newline(call.body());
    return item;
  }

  static std::string names_line(const std::string& function, const char* side,
                                const std::vector<CasadiArgument>& arguments) {
    std::vector<std::string> names;
    for (const CasadiArgument& each : arguments) names.push_back(quoted(each.name));
    if (names.empty()) names.emplace_back("0");
    return without_newline(
        list_line(fmt::format("static const char* const {}_names_{}[] = {{", function, side), names, "};", 0));
  }

  std::string patterns_line(const std::string& function, const char* side,
                            const std::vector<CasadiArgument>& arguments) {
    std::vector<std::string> patterns;
    for (const CasadiArgument& each : arguments) patterns.push_back(patterns_.name_of(each.sparsity));
    if (patterns.empty()) patterns.emplace_back("0");
    return without_newline(list_line(
        fmt::format("static const casadi_int* const {}_patterns_{}[] = {{", function, side), patterns, "};", 0));
  }

  const Mechanism& mechanism_;
  const EmitOptions& options_;
  std::vector<CasadiFunction> functions_;
  std::unique_ptr<const PageDialect> dialect_;
  std::vector<FunctionText> texts_;
  Patterns patterns_;
};

}  // namespace

std::vector<GeneratedFile> casadi_files(const Mechanism& mechanism, const std::vector<Function>& functions,
                                        const EmitOptions& options) {
  return {{file_name(mechanism, options) + "_casadi.c", CasadiFile(mechanism, functions, options).text()}};
}

}  // namespace flatdyn
