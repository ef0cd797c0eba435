// SPDX-License-Identifier: GPL-2.0-or-later
// Functions → the files of a language.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "code/emit/emit_options.hpp"
#include "code/emit/page_dialect.hpp"
#include "code/lower/stages.hpp"
#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// The name of the files without their endings.
std::string file_name(const Mechanism& mechanism, const EmitOptions& options);

// The texts of dialect.files(), in their order. Deterministic.
std::vector<std::string> emitted(const PageDialect& dialect, const Mechanism& mechanism,
                                 const std::vector<Function>& functions, const EmitOptions& options,
                                 const std::optional<Stages>& stages = std::nullopt);

// The texts of the functions alone.
std::vector<FunctionText> function_texts(const PageDialect& dialect, const Mechanism& mechanism,
                                         const std::vector<Function>& functions, const EmitOptions& options);

}  // namespace flatdyn
