// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/rust/language.hpp"

#include "code/languages/rust/dialect.hpp"
#include "code/languages/rust/read.hpp"

namespace flatdyn {

LanguageRow rust_language() {
  LanguageRow row{.option = "rust", .name = "Rust"};
  row.description = "a Rust crate in one scalar";
  row.endings = {"/src/lib.rs", "/Cargo.toml"};
  row.has_given_variants = true;
  row.has_scalar = row.has_fma = true;
  row.dialect = [](const Mechanism&, const EmitOptions& options) -> std::unique_ptr<const PageDialect> {
    return std::make_unique<RustDialect>(options);
  };
  row.reader = [](const EmitOptions& options) { return rust_reader(options.scalar); };
  return row;
}

}  // namespace flatdyn
