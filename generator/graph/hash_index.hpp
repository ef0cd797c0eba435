// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace flatdyn {

inline std::uint64_t mixed_bits(std::uint64_t bits) {
  bits *= 0x9e3779b97f4a7c15ULL;
  return bits ^ (bits >> 32);
}

inline std::uint64_t pair_key(std::int32_t a, std::int32_t b) {
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32) | static_cast<std::uint32_t>(b);
}

// The numbers of items by the hashes of the items, which are kept elsewhere: an open hash table of numbers >= 0.
class HashIndex {
 public:
  // The number with this hash for which is_same(number) holds; `next`, which is added, if there is no such number.
  template <class IsSame>
  std::int32_t find_or_add(std::uint64_t hash, std::int32_t next, const IsSame& is_same) {
    if (2 * (count_ + 1) > slots_.size()) grow();
    const auto tag = static_cast<std::uint32_t>(hash);
    for (std::size_t k = tag & mask();; k = (k + 1) & mask()) {
      Slot& slot = slots_[k];
      if (slot.number < 0) {
        slot = {tag, next};
        ++count_;
        return next;
      }
      if (slot.tag == tag && is_same(slot.number)) return slot.number;
    }
  }

 private:
  struct Slot {
    std::uint32_t tag = 0;  // the low bits of the hash
    std::int32_t number = -1;
  };

  std::size_t mask() const { return slots_.size() - 1; }

  void grow() {
    const std::vector<Slot> before = std::move(slots_);
    slots_.assign(before.empty() ? 16 : 2 * before.size(), {});
    for (const Slot& slot : before) {
      if (slot.number < 0) continue;
      std::size_t k = slot.tag & mask();
      while (slots_[k].number >= 0) k = (k + 1) & mask();
      slots_[k] = slot;
    }
  }

  std::vector<Slot> slots_;  // as many as a power of two
  std::size_t count_ = 0;
};

}  // namespace flatdyn
