// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/temperature_survey.hpp"

#include <algorithm>
#include <cmath>

#include "laboratory/identify/log_reader.hpp"

namespace flatdyn {

std::vector<bool> even_temperatures(const std::vector<std::filesystem::path>& logs, const Mechanism& mechanism,
                                    const StreamOptions& options, double at) {
  constexpr int kLines = 100;                 // of each log
  constexpr double kLeast = 1, kShare = 0.1;  // standard deviation, K; of the distance
  const auto n = static_cast<Eigen::Index>(mechanism.joints().size());
  Eigen::ArrayXd sums = Eigen::ArrayXd::Zero(n), squares = sums;
  double count = 0;
  for (const std::filesystem::path& log : logs) {
    Diagnostics unheard;
    LogReader reader(log, mechanism, {options.torques, true}, unheard, options.rate.value_or(0));
    if (unheard.has_errors()) continue;
    std::vector<double> channels(static_cast<std::size_t>(reader.layout().channels()));
    for (int k = 0; k < kLines; ++k) {
      reader.jump(static_cast<double>(k) / kLines);
      if (!reader.next(channels.data())) continue;
      const Eigen::Map<const Eigen::ArrayXd> here(channels.data() + reader.layout().temperatures(), n);
      sums += here - at;
      squares += (here - at).square();
      ++count;
    }
  }
  std::vector<bool> even;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double mean = sums[i] / count, deviation = std::sqrt(std::max(0.0, squares[i] / count - mean * mean));
    even.push_back(count > 0 && deviation < std::max(kLeast, kShare * std::abs(mean)));
  }
  return even;
}

}  // namespace flatdyn
