// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/emit/partial_output.hpp"

#include <algorithm>

#include "functions/scene/entries.hpp"

namespace flatdyn {

std::vector<std::string> partial_output_rule(const std::vector<Function>& functions, bool inputs_come_first) {
  const std::string next = inputs_come_first ? " All inputs are read before anything is written:" : "";
  if (std::all_of(functions.begin(), functions.end(), is_whole)) {
    return {"Every entry of an output is written, zeros too." + next};
  }
  return {"Arrays have their full length, but entries that nobody asked for are left as they are: the",
          "comment of the function says which are written." + next};
}

std::string partial_output_text(const Function& function, const std::vector<ArrayArgument>& outputs) {
  std::string text;
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    Output output = function.outputs[k];
    if (output.left_out.empty()) continue;
    output.name = outputs[k].name;
    text += output.is_written() ? " Written: " + written_entries(output) + ", and nothing else of " + output.name + "."
                                : " Of " + output.name + " nothing is written.";
  }
  return text;
}

}  // namespace flatdyn
