// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/block_partition.hpp"

#include <algorithm>

namespace flatdyn {

int BlockPartition::owner_of_block(long block) {
  const auto index = static_cast<std::size_t>(block);
  while (owners_.size() <= index) {
    const auto fewest = std::min_element(lines_.begin(), lines_.end());
    *fewest += kBlock;
    owners_.push_back(static_cast<int>(fewest - lines_.begin()));
  }
  return owners_[index];
}

void BlockPartition::end_log(long lines) {
  for (const int owner : owners_) {
    const long held = std::clamp(lines, 0L, kBlock);
    lines_[static_cast<std::size_t>(owner)] += held - kBlock;
    lines -= held;
  }
  owners_.clear();
}

}  // namespace flatdyn
