// SPDX-License-Identifier: GPL-2.0-or-later
// The steps and the noise of a log's channels, from short runs of samples spread over all of it. Parts of a log find
// the same, whichever lines they own.
#pragma once

#include <filesystem>
#include <vector>

#include "laboratory/identify/channel_noise.hpp"
#include "laboratory/identify/log_layout.hpp"
#include "laboratory/identify/sample_clock.hpp"

namespace flatdyn {

// How a channel changes that is differentiated twice, LogLayout::positions_of_all(): the distance from the least to the
// largest, and the mean squares of acceleration and speed over 0.1 s (as much as a run has) without what noise makes of
// them, 0 at least; rad or m, and seconds.
struct PositionRange {
  int channel = 0;
  double size = 0, acceleration_square = 0, speed_square = 0;
};

struct LogSurvey {
  // By channel. `typical`: half of the runs have no more, by typical_noise(). `all` is that of all runs together.
  std::vector<ChannelNoise> all, typical;
  bool moves = false;  // whether any rate is not zero; true for logs without rates
  std::vector<PositionRange> ranges;
  double duration = 0;  // from the first to the last sample looked at, s
};

// Samples that cannot be read are left out.
LogSurvey survey(const std::filesystem::path& log, const LogHeading& heading, const SampleClock& clock);

}  // namespace flatdyn
