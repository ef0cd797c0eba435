// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/cpp/language.hpp"

#include "code/languages/cpp/convention_header.hpp"
#include "code/languages/cpp/dialect.hpp"
#include "code/languages/cpp/read.hpp"

namespace flatdyn {

LanguageRow cpp_language() {
  LanguageRow row{.option = "c++", .name = "C++"};
  row.description = "a C++17 header";
  row.endings = {".hpp"};
  row.more_endings = {".cpp"};
  row.has_pair = row.has_stages = row.has_lanes = true;
  row.has_scalar = row.has_namespace = row.has_fma = true;
  row.is_compiled_by_host = true;
  row.dialect = [](const Mechanism&, const EmitOptions& options) -> std::unique_ptr<const PageDialect> {
    return std::make_unique<CppDialect>(options);
  };
  row.reader = [](const EmitOptions&) { return cpp_reader(); };
  row.convention_header = convention_header;
  return row;
}

}  // namespace flatdyn
