// SPDX-License-Identifier: GPL-2.0-or-later
// Code of one language or form, whatever else the options say.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "code/languages/emit.hpp"

namespace flatdyn::testing {

struct HeaderAndSource {
  std::string header, source;
};

inline HeaderAndSource two_files(const Mechanism& mechanism, const std::vector<Function>& functions,
                                 const EmitOptions& options, const std::optional<Stages>& stages = std::nullopt) {
  const std::vector<GeneratedFile> files = emit_code(mechanism, functions, options, stages);
  return {files.at(0).text, files.at(1).text};
}

inline HeaderAndSource emit_c(const Mechanism& mechanism, const std::vector<Function>& functions, EmitOptions options) {
  options.language = "c";
  return two_files(mechanism, functions, options);
}

inline HeaderAndSource emit_pair(const Mechanism& mechanism, const std::vector<Function>& functions,
                                 EmitOptions options, const std::optional<Stages>& stages) {
  options.form = Form::pair;
  return two_files(mechanism, functions, options, stages);
}

inline std::string emit_javascript(const Mechanism& mechanism, const std::vector<Function>& functions,
                                   EmitOptions options = {}) {
  options.language = "javascript";
  return emit_code(mechanism, functions, options).front().text;
}

}  // namespace flatdyn::testing
