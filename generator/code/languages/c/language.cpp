// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/c/language.hpp"

#include "code/emit/name_space.hpp"
#include "code/languages/c/lanes_dialect.hpp"
#include "code/languages/c/read.hpp"

namespace flatdyn {

LanguageRow c_language() {
  LanguageRow row{.option = "c", .name = "C"};
  row.description = "a C99 header and source in one scalar";
  row.endings = {".h", ".c"};
  row.has_given_variants = true;
  row.has_scalar = row.has_namespace = row.has_fma = true;
  row.is_compiled_by_host = row.is_called_by_python = row.is_for_firmware = true;
  row.dialect = [](const Mechanism& mechanism, const EmitOptions& options) -> std::unique_ptr<const PageDialect> {
    return std::make_unique<CDialect>(options.scalar, namespace_of(mechanism.name, options.name_space));
  };
  row.batch = [](const Mechanism& mechanism, const EmitOptions& options) -> std::unique_ptr<const PageDialect> {
    return std::make_unique<LanesDialect>(options.scalar, namespace_of(mechanism.name, options.name_space));
  };
  row.reader = [](const EmitOptions& options) { return c_reader(options.scalar); };
  row.batch_reader = [](const EmitOptions& options) { return lanes_reader(options.scalar); };
  return row;
}

}  // namespace flatdyn
