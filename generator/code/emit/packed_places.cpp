// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/emit/packed_places.hpp"

#include <map>

namespace flatdyn {

std::vector<int> packed_places(const Output& output, const Graph& graph) {
  std::vector<int> places;
  std::map<NodeId, int> taken;
  for (std::size_t k = 0; k < output.entries.size(); ++k) {
    const NodeId entry = output.entries[k];
    if (output.leaves_out(k) || graph.is_zero(entry)) {
      places.push_back(-1);
    } else {
      places.push_back(taken.emplace(entry, static_cast<int>(taken.size())).first->second);
    }
  }
  return places;
}

bool is_identity(const std::vector<int>& places) {
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (places[k] != static_cast<int>(k)) return false;
  }
  return true;
}

}  // namespace flatdyn
