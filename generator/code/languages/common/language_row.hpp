// SPDX-License-Identifier: GPL-2.0-or-later
// A row says of a language all that code outside of its folder asks for: what it has, its dialect and its reader.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "code/emit/page_dialect.hpp"
#include "code/readback/language_reader.hpp"

namespace flatdyn {

struct LanguageRow {
  const char *option = "", *name = "";  // the value of --language, "c++", and for people, "C++"
  const char* description = "";         // "a C++17 header"
  // The endings of its files after their name, ".h" and ".c"; and of files that some options add.
  std::vector<std::string> endings{}, more_endings{};
  std::unique_ptr<const PageDialect> (*dialect)(const Mechanism& mechanism, const EmitOptions& options) = nullptr;
  AnyLanguageReader (*reader)(const EmitOptions& options) = nullptr;
  bool has_pair = false;             // header and source on request
  bool has_stages = false;           // structures that keep what functions have in common
  bool has_scalar = false;           // float in addition to double
  bool has_namespace = false;        // or a prefix of names
  bool has_fma = false;              // fused multiply-adds
  bool has_lanes = false;            // limbs in the lanes of vectors
  bool has_conventions = false;      // headers in other programs' conventions
  bool has_parts = true;             // long functions in parts
  bool has_kernels = false;          // functions divided among kernels
  bool has_types_apart = false;      // a file of types for editors
  bool has_given_variants = false;   // functions of their own that take sines and cosines
  bool is_compiled_by_host = false;  // by the C or C++ compiler of the machine
  bool is_called_by_python = false;  // by a module that is written beside it
  bool is_for_firmware = false;      // with a folder that a microcontroller builds and tests it with
  bool runs_in_pages = false;        // of the web

  bool is_one_file() const { return endings.size() == 1; }
};

}  // namespace flatdyn
