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

std::vector<Output> substituted_outputs(const Function& from, const InputImage& image_of, Graph& to) {
  const std::vector<NodeId> image = substituted(from.graph, image_of, to);
  std::vector<Output> outputs = from.outputs;
  for (Output& output : outputs) {
    for (NodeId& entry : output.entries) entry = image[static_cast<std::size_t>(entry)];
  }
  return outputs;
}

}  // namespace flatdyn
