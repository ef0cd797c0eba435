// SPDX-License-Identifier: GPL-2.0-or-later
// Work in processes of its own, for libraries that several threads cannot use at a time.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace flatdyn {

// The number of processors that this process may use.
std::size_t processor_count();

// Computes a text for each task in several processes, which begin with the memory of this one as it is. The texts come
// by task; one whose process threw or was killed is missing. Each process takes the next task when it is done with one.
std::vector<std::optional<std::string>> computed_apart(std::size_t tasks, std::size_t processes,
                                                       const std::function<std::string(std::size_t)>& compute);

}  // namespace flatdyn
