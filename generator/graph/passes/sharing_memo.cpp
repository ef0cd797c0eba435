// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/passes/sharing_memo.hpp"

#include <algorithm>
#include <utility>

namespace flatdyn {
namespace {

bool has_same_names(const Graph& a, const Graph& b) {
  for (NodeId id = 0; id < a.size(); ++id) {
    const std::string *first = a.name(id), *second = b.name(id);
    if ((first == nullptr) != (second == nullptr) || (first != nullptr && *first != *second)) return false;
  }
  return true;
}

}  // namespace

bool has_same_nodes(const Function& a, const Function& b) {
  if (a.graph.size() != b.graph.size()) return false;
  for (NodeId id = 0; id < a.graph.size(); ++id) {
    if (a.graph[id] != b.graph[id]) return false;
  }
  return roots(a) == roots(b);
}

std::optional<Function> SharingMemo::find(const Function& function) const {
  const auto found = std::find_if(entries_.rbegin(), entries_.rend(), [&](const Entry& entry) {
    return has_same_nodes(entry.function, function) && has_same_names(entry.function.graph, function.graph);
  });
  if (found == entries_.rend()) return std::nullopt;
  return with_graph(function, found->result, found->image);
}

void SharingMemo::add(const Function& function, const Function& result) {
  constexpr std::size_t kMostNodes = 400'000;  // some 80 MB
  std::vector<NodeId> image(static_cast<std::size_t>(function.graph.size()), -1);
  const std::vector<NodeId> before = roots(function), after = roots(result);
  for (std::size_t k = 0; k < before.size(); ++k) image[static_cast<std::size_t>(before[k])] = after[k];
  entries_.push_back({function, result.graph, std::move(image)});
  nodes_ += entries_.back().size();
  while (nodes_ > kMostNodes && entries_.size() > 1) {
    nodes_ -= entries_.front().size();
    entries_.pop_front();
  }
}

}  // namespace flatdyn
