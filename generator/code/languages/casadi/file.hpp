// SPDX-License-Identifier: GPL-2.0-or-later
// The file with CasADi's interface, which calls the C form.
#pragma once

#include <string>
#include <vector>

#include "code/emit/emit_options.hpp"
#include "code/emit/generated_file.hpp"
#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// `functions`: as they are derived, whose CasADi forms are those of code/languages/casadi/interface.hpp.
std::vector<GeneratedFile> casadi_files(const Mechanism& mechanism, const std::vector<Function>& functions,
                                        const EmitOptions& options);

}  // namespace flatdyn
