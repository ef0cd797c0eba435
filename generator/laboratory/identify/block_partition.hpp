// SPDX-License-Identifier: GPL-2.0-or-later
// The lines that each of the N parts of an identification folds.
#pragma once

#include <cstddef>
#include <vector>

namespace flatdyn {

inline constexpr long kBlock = 65536;

// Deals the lines of logs out in blocks of kBlock lines: the next block goes to the part that has the fewest lines so
// far. So the parts differ by one block at most, with one long log as with many short ones, and every process that
// counts the lines of all logs finds the same shares.
class BlockPartition {
 public:
  BlockPartition() : BlockPartition(1, 1) {}
  // `part`: the part whose lines are asked for, 1 … parts.
  BlockPartition(int part, int parts) : part_(part - 1), lines_(static_cast<std::size_t>(parts), 0) {}

  bool is_whole() const { return lines_.size() == 1; }
  // Whether line `line` of the current log, counted from 0, belongs to the part. The blocks before it must be full.
  bool owns(long line) { return line >= 0 && (is_whole() || owner_of_block(line / kBlock) == part_); }
  // Ends the current log, which has `lines` lines. The next lines are those of another one.
  void end_log(long lines);

 private:
  int owner_of_block(long block);

  int part_;
  std::vector<long> lines_;  // lines of each part; the blocks of this log count as full
  std::vector<int> owners_;  // the part that owns each block of this log
};

}  // namespace flatdyn
