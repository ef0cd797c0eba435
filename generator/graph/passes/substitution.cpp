// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/passes/substitution.hpp"

#include "graph/passes/draft.hpp"

namespace flatdyn {

std::vector<NodeId> substituted(const Graph& from, const InputImage& image_of, Graph& to) {
  std::vector<NodeId> image;
  for (NodeId id = 0; id < from.size(); ++id) {
    const Node& node = from[id];
    const std::optional<NodeId> given = node.op == Op::input ? image_of(node.input, to) : std::nullopt;
    image.push_back(given ? *given : unfolded_node(to, node, image));
    copy_name(from, id, to, image.back());
  }
  return image;
}

}  // namespace flatdyn
