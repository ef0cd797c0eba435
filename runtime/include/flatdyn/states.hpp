// SPDX-License-Identifier: BSD-3-Clause
// Where the arguments of many states lie in memory, for flatdyn/batch.hpp:
//
//   tiles    in_tiles<7>(q), out_tiles<49>(B)      entry i of state k at [k / 8][i][k % 8]; float: [k / 16][i][k % 16]
//   columns  in<7>(q, stride), out<49>(B, stride)  entry i of state k at [i][k], that is at i * stride + k
//
// Tiles are the fast ones: whatever a few states need lies together. Each is a cache line of every entry, and the last
// one has its full length, too: an array of tiles has tiles_length<double, 7>(n) numbers. (A second template argument
// makes tiles of more states: in_tiles<7, 64>(q).) Columns are slow where their stride is a multiple of a large power
// of two, since all of them then fall into the same few lines of the cache; padded_stride<double>(n) is a stride that
// avoids it.
//
// Matrices have zeros that do not depend on the state, and some are symmetric. Packed outputs leave these entries out:
//
//   using Kept = flatdyn::SymmetricEntries<panda::inertia_matrix_nonzero>;  // or NonzeroEntries<…> of any matrix
//   std::vector<double> B(flatdyn::tiles_length<double, Kept>(n));
//   const auto packed = flatdyn::out_tiles<Kept>(B.data());                 // or flatdyn::out<Kept>(B.data(), stride)
//   flatdyn::for_each_state<double>(n, …, packed);
//   packed.at(7 * i + j, k)                                                 // entry (i, j) of state k, if it is kept
//
// Kept::count is how many entries are kept. They are in their order, those of a symmetric matrix from the diagonal on:
// Kept::entry_at(place) is the entry at a place, Kept::place(entry) the place of an entry; -1 if it is always zero.
#pragma once

#include <cstddef>

namespace flatdyn {

// The number of states in a tile of T if nothing is said: a cache line.
template <class T>
inline constexpr std::size_t kTile = 64 / sizeof(T);

// All entries of an argument.
template <int entries>
struct AllEntries {
  static constexpr int length = entries;
  static constexpr int count = entries;
  static constexpr int entry_at(int place) noexcept { return place; }
  static constexpr int place(int entry) noexcept { return entry; }
};

namespace detail {

template <class Entry>
constexpr int length_of(const Entry& table) noexcept {
  return static_cast<int>(sizeof(table) / sizeof(table[0]));
}

constexpr int side_of(int length) noexcept {
  int side = 0;
  while (side * side < length) ++side;
  return side;
}

// The entries that a table of structural zeros has left, row by row; of symmetric matrices those on and above the
// diagonal.
template <const auto& nonzero, bool is_symmetric>
class KeptEntries {
 public:
  static constexpr int length = length_of(nonzero);

 private:
  static constexpr int side = side_of(length);
  static_assert(!is_symmetric || side * side == length, "a symmetric matrix has as many rows as columns");

  static constexpr bool is_kept(int entry) noexcept {
    return nonzero[entry] && (!is_symmetric || entry / side <= entry % side);
  }

  struct Order {
    int count = 0;
    int entry_at[sizeof(nonzero) / sizeof(nonzero[0])] = {};
    int place[sizeof(nonzero) / sizeof(nonzero[0])] = {};

    constexpr Order() noexcept {
      for (int entry = 0; entry < length; ++entry) {
        place[entry] = is_kept(entry) ? count : -1;
        if (is_kept(entry)) entry_at[count++] = entry;
      }
    }
  };
  static constexpr Order order = {};

 public:
  static constexpr int count = order.count;
  static constexpr int entry_at(int place) noexcept { return order.entry_at[place]; }
  static constexpr int place(int entry) noexcept {
    const bool is_mirrored = is_symmetric && entry / side > entry % side;
    return order.place[is_mirrored ? entry % side * side + entry / side : entry];
  }
};

}  // namespace detail

// The entries of a matrix that are not zero at every state; `nonzero` is a table of the generated header, such as
// panda::coriolis_matrix_nonzero.
template <const auto& nonzero>
struct NonzeroEntries : detail::KeptEntries<nonzero, false> {};

// The same of a symmetric matrix, such as panda::inertia_matrix_nonzero, without those below the diagonal. The place of
// an entry below it is that of its mirror image.
template <const auto& nonzero>
struct SymmetricEntries : detail::KeptEntries<nonzero, true> {};

// Entry i of state k is at first[place(i) * stride + k].
template <class Set, class T>
struct Columns {
  using Entries = Set;
  using Number = T;
  static constexpr std::size_t together = 0;  // states in a row: any number

  T* first;
  std::size_t stride;  // at least the number of states

  T* at_place(int place, std::size_t state) const noexcept {
    return first + static_cast<std::size_t>(place) * stride + state;
  }
  // A stored entry.
  T& at(int entry, std::size_t state) const noexcept { return *at_place(Entries::place(entry), state); }
  // The states from this one on.
  Columns from(std::size_t state) const noexcept { return {first + state, stride}; }
};

// Entry i of state k is at first[(k / together * count + place(i)) * together + k % together].
template <class Set, std::size_t states, class T>
struct Tiles {
  using Entries = Set;
  using Number = T;
  static constexpr std::size_t together = states;

  T* first;

  T* at_place(int place, std::size_t state) const noexcept {
    constexpr std::size_t count = Entries::count;
    return first + (state / states * count + static_cast<std::size_t>(place)) * states + state % states;
  }
  // A stored entry.
  T& at(int entry, std::size_t state) const noexcept { return *at_place(Entries::place(entry), state); }
  // The states from this one on, the first one of a tile.
  Tiles from(std::size_t state) const noexcept { return {at_place(0, state)}; }
};

template <int entries, class T>
Columns<AllEntries<entries>, const T> in(const T* first, std::size_t stride) noexcept {
  return {first, stride};
}

template <int entries, class T>
Columns<AllEntries<entries>, T> out(T* first, std::size_t stride) noexcept {
  return {first, stride};
}

template <class Entries, class T>
Columns<Entries, T> out(T* first, std::size_t stride) noexcept {
  return {first, stride};
}

namespace detail {

template <class T>
constexpr std::size_t states_of_tile(std::size_t wanted) noexcept {
  return wanted == 0 ? kTile<T> : wanted;
}

}  // namespace detail

template <int entries, std::size_t states = 0, class T>
Tiles<AllEntries<entries>, detail::states_of_tile<T>(states), const T> in_tiles(const T* first) noexcept {
  return {first};
}

template <int entries, std::size_t states = 0, class T>
Tiles<AllEntries<entries>, detail::states_of_tile<T>(states), T> out_tiles(T* first) noexcept {
  return {first};
}

template <class Entries, std::size_t states = 0, class T>
Tiles<Entries, detail::states_of_tile<T>(states), T> out_tiles(T* first) noexcept {
  return {first};
}

// How many numbers of type T the tiles of n states have.
template <class T, class Entries, std::size_t states = 0>
constexpr std::size_t tiles_length(std::size_t n) noexcept {
  constexpr std::size_t together = detail::states_of_tile<T>(states);
  return (n + together - 1) / together * together * static_cast<std::size_t>(Entries::count);
}

template <class T, int entries, std::size_t states = 0>
constexpr std::size_t tiles_length(std::size_t n) noexcept {
  return tiles_length<T, AllEntries<entries>, states>(n);
}

// A stride for columns of n states: a whole and odd number of cache lines, so that columns begin at lines and are
// spread over all sets of a cache.
template <class T>
constexpr std::size_t padded_stride(std::size_t n) noexcept {
  constexpr std::size_t line = 64 / sizeof(T);
  return ((n + line - 1) / line | 1) * line;
}

}  // namespace flatdyn
