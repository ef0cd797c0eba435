// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/javascript/language.hpp"

#include "code/languages/javascript/dialect.hpp"
#include "code/languages/javascript/read.hpp"

namespace flatdyn {
namespace {

template <JavascriptForm form>
std::unique_ptr<const PageDialect> made(const Mechanism&, const EmitOptions& options) {
  return std::make_unique<JavascriptDialect>(form, options.sines);
}

}  // namespace

LanguageRow javascript_language() {
  LanguageRow row{.option = "javascript", .name = "JavaScript"};
  row.description = "a JavaScript module";
  row.endings = {".js"};
  row.more_endings = {".d.ts"};
  row.dialect = made<JavascriptForm::module>;
  row.types = made<JavascriptForm::types>;
  row.page_script = made<JavascriptForm::function_body>;
  row.reader = [](const EmitOptions&) { return javascript_reader(); };
  return row;
}

}  // namespace flatdyn
