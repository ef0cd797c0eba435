// SPDX-License-Identifier: GPL-2.0-or-later
// Functions of a robot, made once and printed in every language and form, and the proof of such a text.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "code/languages/readers.hpp"
#include "functions/planning/make_functions.hpp"
#include "proof/verify/held_code.hpp"
#include "proof/verify/proof.hpp"
#include "support/emitted_forms.hpp"

namespace flatdyn::testing {

class PrintedCode {
 public:
  PrintedCode(LoadedRobot model, const std::vector<std::string>& names, const std::vector<std::string>& staged = {})
      : model_(std::move(model)) {
    PipelineOptions options;
    options.functions = names;
    Progress quiet(true);
    Diagnostics findings;
    functions_ = functions_of(make_functions(model_, options, quiet, findings));
    if (!staged.empty()) stages_ = stages_of(make_fusion(model_, staged, quiet).fusion);
  }

  PrintedCode(LoadedRobot model, std::vector<Function> functions)
      : model_(std::move(model)), functions_(std::move(functions)) {}

  // All files, one after the other. Only C++ has stages.
  std::string text(const EmitOptions& options) const {
    std::string all;
    for (const GeneratedFile& file : emit_code(model_.mechanism, functions_, options, stages_in(options))) {
      all += file.text;
    }
    return all;
  }

  void prove(const std::string& text, const EmitOptions& options) const {
    const EmittedText read(text, reader_of(options));
    prove_text(read, {model_.mechanism, functions_, stages_in(options), options});
  }

  // Compares a text that is held with `own` of the same options.
  HeldReport compare(const std::string& held, const std::string& own, const EmitOptions& options) const {
    const EmittedText read(own, reader_of(options));
    const std::optional<Stages> stages = stages_in(options);
    return compare_held(held, read, {model_.mechanism, functions_, stages, options}, 1);
  }

  // The C form's header, and the functions over arrays of states.
  std::string text_over_states(const EmitOptions& options) const {
    return emit_c(model_.mechanism, functions_, options).header + emit_batch(model_.mechanism, functions_, options);
  }

  void prove_over_states(const std::string& text, const EmitOptions& options) const {
    prove_batch("", text, {model_.mechanism, functions_, std::nullopt, options});
  }

  const LoadedRobot& model() const { return model_; }
  const std::vector<Function>& functions() const { return functions_; }

 private:
  std::optional<Stages> stages_in(const EmitOptions& options) const {
    return options.language == "c++" ? stages_ : std::nullopt;
  }

  LoadedRobot model_;
  std::vector<Function> functions_;
  std::optional<Stages> stages_;
};

// Options by language and form: "c++", "pair", "javascript", "cuda", "rust", "c", and in C "float" and, over states,
// "lanes" of doubles.
inline EmitOptions form_of(const std::string& name, int most_lines = 0) {
  EmitOptions options;
  options.most_lines = most_lines;
  if (name == "pair") {
    options.form = Form::pair;
    options.more_scalars = {"float"};
  } else if (name == "cuda" || name == "javascript" || name == "rust") {
    options.language = name;
  } else if (name == "c" || name == "float" || name == "lanes") {
    options.language = "c";
    options.scalar = name == "float" ? "float" : "double";
  }
  return options;
}

}  // namespace flatdyn::testing
