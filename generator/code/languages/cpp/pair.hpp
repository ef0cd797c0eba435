// SPDX-License-Identifier: GPL-2.0-or-later
// The sections that only a C++ header with a source has.
#pragma once

#include <kainjow/mustache.hpp>
#include <string>
#include <vector>

#include "code/emit/emit_options.hpp"
#include "code/emit/function_text.hpp"
#include "code/emit/stage_text.hpp"

namespace flatdyn {

// The scalars that the source is compiled for, in the order of the options. Throws Failure(usage) for one that is
// unknown or named twice.
std::vector<std::string> compiled_scalars(const EmitOptions& options);

// Fills in the names of both files, and the header's text about what is compiled.
void write_pair(kainjow::mustache::data& page, const std::string& header, const std::string& source,
                const std::vector<std::string>& scalars);

// Explicit instantiations: "template void gravity(const double* q, double* g);" for the source, and the same with
// "extern" for the header. Adding a function adds to both.
struct Instantiations {
  std::vector<std::string> declared, defined;

  void add(const FunctionText& text);
  void add(const std::vector<StageText>& stages, const std::vector<std::string>& scalars);
  void add_rounding(const std::vector<std::string>& scalars);  // for rounding_is_as_written()
};

}  // namespace flatdyn
