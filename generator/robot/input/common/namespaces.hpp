// SPDX-License-Identifier: GPL-2.0-or-later
// Names of XML with a namespace. Programs that save a file choose prefixes of their own, such as ns0, for the addresses
// that are meant.
#pragma once

#include "robot/input/common/file_node.hpp"

namespace flatdyn {

// Gives elements and attributes the prefixes that the readers know for their namespaces' addresses ("drake:",
// "xacro:"), and none where the namespace is that of the outermost element.
void give_usual_prefixes(FileNode& root);

}  // namespace flatdyn
