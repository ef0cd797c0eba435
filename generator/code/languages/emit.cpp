// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/emit.hpp"

#include "code/emit/name_space.hpp"
#include "code/emit/page_writer.hpp"
#include "code/languages/known_answers.hpp"
#include "code/languages/language_table.hpp"
#include "code/languages/readers.hpp"

namespace flatdyn {
namespace {

// The texts with their known answers, if the dialect has any; they are computed from the text as it is read.
std::vector<std::string> with_answers(const PageDialect& dialect, const AnyLanguageReader& reader,
                                      const Mechanism& mechanism, const std::vector<Function>& functions,
                                      const EmitOptions& options, const std::optional<Stages>& stages) {
  std::vector<std::string> texts = emitted(dialect, mechanism, functions, options, stages);
  if (dialect.has_known_answer()) fill_in_known_answers(mechanism, functions, reader, texts);
  return texts;
}

std::string emitted_by(DialectOf* dialect, const Mechanism& mechanism, const std::vector<Function>& functions,
                       const EmitOptions& options) {
  return emitted(*dialect(mechanism, options), mechanism, functions, options).front();
}

EmitOptions in_header(EmitOptions options) {
  options.language = EmitOptions().language;
  options.form = Form::header;
  return options;
}

}  // namespace

std::unique_ptr<const PageDialect> dialect_of(const Mechanism& mechanism, const EmitOptions& options) {
  return language_row(options.language).dialect(mechanism, options);
}

AnyLanguageReader reader_of(const EmitOptions& options) { return language_row(options.language).reader(options); }

std::vector<GeneratedFile> emit_code(const Mechanism& mechanism, const std::vector<Function>& functions,
                                     const EmitOptions& options, const std::optional<Stages>& stages) {
  const std::unique_ptr<const PageDialect> dialect = dialect_of(mechanism, options);
  const std::vector<std::string> texts =
      with_answers(*dialect, reader_of(options), mechanism, functions, options, stages);
  const std::vector<FileTemplate> templates = dialect->files();
  std::vector<GeneratedFile> files;
  for (std::size_t k = 0; k < texts.size(); ++k) {
    files.push_back({file_name(mechanism, options) + templates[k].ending, texts[k]});
  }
  return files;
}

std::string header_name(const Mechanism& mechanism, const EmitOptions& options) {
  return file_name(mechanism, options) + dialect_of(mechanism, options)->files().front().ending;
}

std::string emit_header(const Mechanism& mechanism, const std::vector<Function>& functions, const EmitOptions& options,
                        const std::optional<Stages>& stages) {
  return emit_code(mechanism, functions, in_header(options), stages).front().text;
}

AnyLanguageReader header_reader() { return reader_of({}); }

AnyLanguageReader batch_reader(const EmitOptions& options) {
  return language_row(options.language).batch_reader(options);
}

std::string emit_types(const Mechanism& mechanism, const std::vector<Function>& functions, const EmitOptions& options) {
  return emitted_by(language_row(options.language).types, mechanism, functions, options);
}

std::string emit_batch(const Mechanism& mechanism, const std::vector<Function>& functions, const EmitOptions& options) {
  return emitted_by(language_row(options.language).batch, mechanism, functions, options);
}

EmitOptions page_script_options() {
  EmitOptions options;
  options.language = language_with([](const LanguageRow& row) { return row.page_script != nullptr; }).option;
  return options;
}

std::string emit_page_script(const Mechanism& mechanism, const std::vector<Function>& functions) {
  const EmitOptions options = page_script_options();
  return emitted_by(language_row(options.language).page_script, mechanism, functions, options);
}

std::vector<StraightCall> straight_calls(const Mechanism& mechanism, const std::vector<Function>& functions,
                                         const EmitOptions& options) {
  std::vector<StraightCall> calls;
  for (const FunctionText& text : function_texts(*dialect_of(mechanism, options), mechanism, functions, options)) {
    if (text.sin_cos_variant) {
      calls.push_back({text.sin_cos_variant->name, text.sin_cos_variant->arguments});
      continue;
    }
    StraightCall call{text.name, {}};
    if (!mechanism.symbols.empty()) call.arguments.emplace_back("parameters");
    for (const auto* arrays : {&text.inputs, &text.outputs}) {
      for (const ArrayArgument& array : *arrays) call.arguments.push_back(array.name);
    }
    calls.push_back(std::move(call));
  }
  return calls;
}

}  // namespace flatdyn
