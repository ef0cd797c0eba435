// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/javascript/language.hpp"

#include "code/languages/javascript/dialect.hpp"
#include "code/languages/javascript/read.hpp"

namespace flatdyn {

LanguageRow javascript_language() {
  LanguageRow row{.option = "javascript", .name = "JavaScript"};
  row.description = "a JavaScript module";
  row.endings = {".js"};
  row.more_endings = {".d.ts"};
  row.has_types_apart = row.runs_in_pages = true;
  row.dialect = [](const Mechanism&, const EmitOptions& options) -> std::unique_ptr<const PageDialect> {
    return std::make_unique<JavascriptDialect>(JavascriptForm::module, options.sines);
  };
  row.reader = [](const EmitOptions&) { return javascript_reader(); };
  return row;
}

}  // namespace flatdyn
