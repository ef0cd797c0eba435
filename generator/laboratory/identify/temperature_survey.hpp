// SPDX-License-Identifier: GPL-2.0-or-later
// Temperatures that tell nothing of how friction changes with them.
#pragma once

#include <filesystem>
#include <vector>

#include "laboratory/identify/motion_stream.hpp"

namespace flatdyn {

// By joint of the mechanism: whether its temperatures in all logs together are so alike that friction at `at`, °C, does
// not follow from them: they differ by less than about a kelvin, or by a small part of their distance from `at`. Some
// lines from all over the logs are looked at. A log that cannot be read tells nothing.
std::vector<bool> even_temperatures(const std::vector<std::filesystem::path>& logs, const Mechanism& mechanism,
                                    const StreamOptions& options, double at);

}  // namespace flatdyn
