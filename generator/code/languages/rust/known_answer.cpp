// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/rust/known_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/diagnostics/diagnostics.hpp"
#include "code/emit/known_answer.hpp"
#include "code/emit/writer.hpp"
#include "code/lower/arguments.hpp"

namespace flatdyn {
namespace {

class RustAnswer {
 public:
  RustAnswer(const CodeContent& content, std::size_t indent) : content_(content), indent_(indent) {}

  std::string statements() {
    refuse_two_lengths();
    const KnownState state = known_state(content_);
    for (const KnownArray& each : state.arrays) {
      declare(each.name, each.length);
      add(fmt::format("fill(&mut {}, black_box({}));", each.name, seed_of(each.kind)));
    }
    if (state.angles > 0) {
      for (const char* name : {"sine", "cosine"}) declare(name, state.angles);
      add(fmt::format("fill_sines(&mut sine, &mut cosine, black_box({}));", kTangentSeed));
    }
    parameters();
    for (std::size_t k = 0; k < content_.texts.size(); ++k) {
      if (!computes_angles(content_.functions[k])) call(content_.functions[k], content_.texts[k]);
    }
    return std::move(text_);
  }

 private:
  void add(const std::string& statement) { text_ += code_line(statement, indent_); }
  void declare(const std::string& name, std::size_t length) {
    add(fmt::format("let mut {} = [0.0; {}];", name, length));
  }

  // The self test calls all functions with the same arrays, which have one length in Rust.
  void refuse_two_lengths() const {
    std::map<InputKind, const Function*> first;
    for (const Function& function : content_.functions) {
      for (const InputKind kind : function.inputs) {
        if (argument_row(kind).length != ArgumentLength::own) continue;
        const auto found = first.emplace(kind, &function).first;
        if (found->second->own.length == function.own.length) continue;
        throw Failure(FailureKind::unsupported,
                      fmt::format("--language rust: {} and {} take {} of different lengths", found->second->name,
                                  function.name, argument_row(kind).name),
                      "generate them as crates of their own");
      }
    }
  }

  void parameters() {
    const std::vector<std::string>& names = content_.scope.parameters;
    if (names.empty()) return;
    std::vector<std::string> members;
    for (std::size_t k = 0; k < names.size(); ++k) members.push_back(fmt::format("{}: {}[{}]", names[k], kSymbols, k));
    text_ += list_line("let parameters = Parameters { ", members, " };", indent_);
  }

  // Calls the function; entries that a scene leaves out are not written, and go on from one output to the next.
  void call(const Function& function, const FunctionText& text) {
    const std::vector<ArrayArgument>& outputs = text.outputs;
    const auto result = [&](std::size_t k) { return outputs.size() < 2 ? "result" : fmt::format("result_{}", k + 1); };
    for (std::size_t k = 0; k < outputs.size(); ++k) {
      declare(result(k), outputs[k].length);
      if (is_whole(function)) continue;
      const bool is_first = k == 0, is_last = k + 1 == outputs.size();
      add(fmt::format("{}fill(&mut {}, {});", is_last ? "" : "let next = ", result(k), is_first ? "0" : "next"));
    }
    std::vector<std::string> arguments;
    const std::string& name = text.sin_cos_variant ? text.sin_cos_variant->name : text.name;
    if (text.sin_cos_variant) {
      const auto& all = text.sin_cos_variant->arguments;
      arguments.assign(all.begin(), all.end() - static_cast<std::ptrdiff_t>(outputs.size()));
    } else {
      if (!content_.scope.parameters.empty()) arguments.emplace_back("parameters");
      for (const ArrayArgument& input : text.inputs) arguments.push_back(input.name);
    }
    for (std::string& argument : arguments) argument.insert(0, "&");
    for (std::size_t k = 0; k < outputs.size(); ++k) arguments.push_back("&mut " + result(k));
    const bool returns_verdict = !returns_value(function) && !function.validity_conditions.empty();
    const bool is_number = returns_value(function);
    text_ += list_line((is_number         ? "let result = ["
                        : returns_verdict ? "let _ = "
                                          : "") +
                           name + "(",
                       arguments, is_number ? ")];" : ");", indent_);
    for (std::size_t k = 0; k < std::max<std::size_t>(outputs.size(), 1); ++k) {
      add(fmt::format("hash = hash_of(&{}, hash);", result(k)));
    }
  }

  const CodeContent& content_;
  std::size_t indent_;
  std::string text_;
};

}  // namespace

std::string rust_known_answer(const CodeContent& content, std::size_t indent) {
  const bool calls_none = std::all_of(content.functions.begin(), content.functions.end(), computes_angles);
  return calls_none ? "" : RustAnswer(content, indent).statements();
}

}  // namespace flatdyn
