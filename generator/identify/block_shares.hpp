// SPDX-License-Identifier: GPL-2.0-or-later
// Which lines of logs belong to which part of N.
#pragma once

#include <cstddef>
#include <vector>

namespace flatdyn {

inline constexpr long kBlock = 65536;

// Logs in blocks of kBlock lines; the next block goes to the part that has the fewest lines so far. So no part has more
// than one block more than another, of one long log and of many short ones, and every process that counts the lines of
// all logs comes to the same.
class BlockShares {
 public:
  BlockShares() : BlockShares(1, 1) {}
  // `part`: whose lines are asked for, 1 … parts.
  BlockShares(int part, int parts) : part_(part - 1), lines_(static_cast<std::size_t>(parts), 0) {}

  bool is_whole() const { return lines_.size() == 1; }
  // Of the log that is being read, counted from 0. Blocks before that of `line` are full.
  bool owns(long line) { return line >= 0 && (is_whole() || owner_of_block(line / kBlock) == part_); }
  // How long the log turned out to be. The next lines are those of another one.
  void end_log(long lines);

 private:
  int owner_of_block(long block);

  int part_;
  std::vector<long> lines_;  // of each part, with all blocks of this log taken for full
  std::vector<int> owners_;  // of the blocks of this log
};

}  // namespace flatdyn
