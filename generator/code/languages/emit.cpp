// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/emit.hpp"

#include "code/emit/name_space.hpp"
#include "code/emit/page_writer.hpp"
#include "code/languages/c/dialect.hpp"
#include "code/languages/c/lanes_dialect.hpp"
#include "code/languages/cpp/dialect.hpp"
#include "code/languages/cpp/pair.hpp"
#include "code/languages/known_answers.hpp"
#include "code/languages/language_table.hpp"
#include "code/languages/readers.hpp"

namespace flatdyn {
namespace {

HeaderAndSource two_files(const std::vector<std::string>& texts) { return {texts.at(0), texts.at(1)}; }

// The texts with their known answers, if the dialect has any; they are computed from the text as it is read.
std::vector<std::string> with_answers(const PageDialect& dialect, const AnyLanguageReader& reader,
                                      const Mechanism& mechanism, const std::vector<Function>& functions,
                                      const EmitOptions& options, const std::optional<Stages>& stages = std::nullopt) {
  std::vector<std::string> texts = emitted(dialect, mechanism, functions, options, stages);
  if (dialect.has_known_answer()) fill_in_known_answers(mechanism, functions, reader, texts);
  return texts;
}

CDialect c_dialect_of(const Mechanism& mechanism, const EmitOptions& options) {
  return {options.scalar, namespace_of(mechanism.name, options.name_space)};
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

std::string emit_cpp(const Mechanism& mechanism, const std::vector<Function>& functions, const EmitOptions& options,
                     const std::optional<Stages>& stages) {
  return with_answers(CppDialect(), cpp_reader(), mechanism, functions, options, stages).front();
}

HeaderAndSource emit_cpp_pair(const Mechanism& mechanism, const std::vector<Function>& functions,
                              const EmitOptions& options, const std::optional<Stages>& stages) {
  return two_files(
      with_answers(CppDialect(compiled_scalars(options)), cpp_reader(), mechanism, functions, options, stages));
}

HeaderAndSource emit_c(const Mechanism& mechanism, const std::vector<Function>& functions, const EmitOptions& options) {
  return two_files(
      with_answers(c_dialect_of(mechanism, options), c_reader(options.scalar), mechanism, functions, options));
}

std::vector<StraightCall> straight_calls(const Mechanism& mechanism, const std::vector<Function>& functions,
                                         const EmitOptions& options) {
  std::vector<StraightCall> calls;
  for (const FunctionText& text : function_texts(c_dialect_of(mechanism, options), mechanism, functions, options)) {
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

std::string emit_c_batch(const Mechanism& mechanism, const std::vector<Function>& functions,
                         const EmitOptions& options) {
  const LanesDialect lanes(options.scalar, namespace_of(mechanism.name, options.name_space));
  return emitted(lanes, mechanism, functions, options).front();
}

std::string emit_javascript_types(const Mechanism& mechanism, const std::vector<Function>& functions,
                                  const EmitOptions& options) {
  return emitted(JavascriptDialect(JavascriptForm::types, options.sines), mechanism, functions, options).front();
}

std::string emit_javascript(const Mechanism& mechanism, const std::vector<Function>& functions,
                            const EmitOptions& options, JavascriptForm form) {
  return emitted(JavascriptDialect(form, options.sines), mechanism, functions, options).front();
}

}  // namespace flatdyn
