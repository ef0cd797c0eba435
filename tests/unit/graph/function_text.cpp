// SPDX-License-Identifier: GPL-2.0-or-later
#include "unit/graph/function_text.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include "graph/text.hpp"

namespace flatdyn::testing {
namespace {

// One line, cut into words; behind "; " is a comment.
struct Line {
  std::vector<std::string> words;
  std::string comment;

  explicit Line(const std::string& text) {
    const std::size_t comment_at = text.find("; ");
    if (comment_at != std::string::npos) comment = text.substr(comment_at + 2);
    std::istringstream stream(text.substr(0, comment_at));
    for (std::string word; stream >> word;) words.push_back(word);
  }
};

NodeId node_of(const std::string& word) { return static_cast<NodeId>(std::stol(word.substr(1))); }

bool is_node(const std::string& word) { return word.starts_with("%"); }

InputKind kind_of(const std::string& name) {
  for (int kind = 0; kind <= static_cast<int>(InputKind::stored); ++kind) {
    if (argument_row(static_cast<InputKind>(kind)).name == name) return static_cast<InputKind>(kind);
  }
  throw std::runtime_error("no input: " + name);
}

// "1/2 %1 - %0 + 3": terms and constants with signs between.
Node sum_of_words(const std::vector<std::string>& words) {
  Node node;
  node.op = Op::sum;
  Rational sign = 1, coefficient = 1;
  bool has_number = false;
  const auto end_constant = [&] {
    if (has_number) node.value = sign * coefficient;
    has_number = false;
    coefficient = 1;
  };
  for (std::string word : words) {
    if (word == "+" || word == "-") {
      end_constant();
      sign = word == "+" ? 1 : -1;
      continue;
    }
    if (word.starts_with("-")) {
      sign = -1;
      word = word.substr(1);
    }
    if (is_node(word)) {
      node.terms.push_back({sign * coefficient, node_of(word)});
      has_number = false;
      coefficient = 1;
    } else {
      coefficient = Rational(word);
      has_number = true;
    }
  }
  end_constant();
  return node;
}

const std::map<std::string, Op> kUnary = {
    {"sin", Op::sin}, {"cos", Op::cos}, {"sign", Op::sign}, {"sqrt", Op::sqrt}, {"tanh", Op::tanh}};

Node node_of_words(const std::vector<std::string>& words) {
  Node node;
  const std::string& first = words.at(0);
  const bool is_infix = words.size() > 1 && (words[1] == "*" || words[1] == "/");
  if (first.ends_with("]")) {
    node.op = Op::input;
    const std::size_t bracket = first.find('[');
    node.input = {kind_of(first.substr(0, bracket)), std::stoi(first.substr(bracket + 1))};
  } else if (const auto unary = kUnary.find(first); unary != kUnary.end()) {
    node.op = unary->second;
    node.operands = {node_of(words.at(1))};
  } else if (is_infix) {
    node.op = words[1] == "*" ? Op::product : Op::quotient;
    for (std::size_t k = 0; k < words.size(); k += 2) node.operands.push_back(node_of(words[k]));
  } else if (words.size() == 1 && !is_node(first) && first.find('%') == std::string::npos) {
    node.value = Rational(first);
  } else {
    node = sum_of_words(words);
  }
  return node;
}

class TextReader {
 public:
  Function read(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      if (line == "nodes:" || line == "outputs:" || line == "conditions:") {
        section_ = line;
      } else if (section_.empty()) {
        read_heading(line);
      } else {
        read_in_section(Line(line));
      }
    }
    return std::move(function_);
  }

 private:
  void read_heading(const std::string& line) {
    if (line.starts_with("function ")) {
      function_.name = line.substr(9);
      return;
    }
    const std::size_t colon = line.find(": ");
    if (colon == std::string::npos) throw std::runtime_error("no key: " + line);
    const std::string key = line.substr(2, colon - 2), value = line.substr(colon + 2);
    std::istringstream words(value);
    if (key == "summary") function_.summary = value;
    if (key == "equation") function_.equation = value;
    if (key == "base_parameters") function_.base_parameters = std::stoi(value);
    if (key == "at_rest") function_.at_rest = true;
    if (key == "inputs") {
      for (std::string word; words >> word;) function_.inputs.push_back(kind_of(word));
    }
    if (key == "task") read_task(words);
  }

  void read_task(std::istream& words) {
    std::string orientation, damping;
    words >> orientation >> damping;
    function_.task.orientation = orientation == "zyz"   ? Orientation::zyz
                                 : orientation == "rpy" ? Orientation::rpy
                                                        : Orientation::angular_velocity;
    function_.task.damping = Rational(damping);
    for (int row = 0; words >> row;) function_.task.rows.push_back(row);
  }

  void read_in_section(const Line& line) {
    if (section_ == "nodes:") {
      read_node(line);
    } else if (section_ == "outputs:") {
      read_output(line);
    } else {
      read_condition(line.words);
    }
  }

  void read_node(const Line& line) {
    std::vector<NodeId> image(static_cast<std::size_t>(function_.graph.size()));
    std::iota(image.begin(), image.end(), 0);
    const NodeId id = function_.graph.copy(node_of_words({line.words.begin() + 2, line.words.end()}), image);
    if (id != node_of(line.words[0])) throw std::runtime_error("another number of a node: " + line.words[0]);
    if (!line.comment.empty()) function_.graph.set_name(id, line.comment);
  }

  void read_output(const Line& line) {
    Output output;
    const std::vector<std::string>& words = line.words;
    static const std::vector<std::string> kLayouts = {"scalar", "vector", "matrix", "fields", "christoffel"};
    output.name = words.at(0);
    output.layout = static_cast<Layout>(std::find(kLayouts.begin(), kLayouts.end(), words.at(1)) - kLayouts.begin());
    output.rows = std::stoi(words.at(2));
    output.cols = std::stoi(words.at(3));
    const bool leaves_out = std::find(words.begin() + 4, words.end(), "-") != words.end();
    for (std::size_t k = 4; k < words.size(); ++k) {
      const bool is_left_out = words[k] == "-";
      output.entries.push_back(is_left_out ? function_.graph.constant(0) : node_of(words[k]));
      if (leaves_out) output.left_out.push_back(is_left_out);
    }
    output.meaning = line.comment;
    function_.outputs.push_back(std::move(output));
  }

  void read_condition(const std::vector<std::string>& words) {
    function_.validity_conditions.push_back(node_of(words.at(0)));
    const auto pivot = std::find(words.begin(), words.end(), "of");
    if (pivot != words.end()) function_.pivot_scales.push_back(node_of(*(pivot + 1)));
    if (words.back() == "loop") ++function_.loop_conditions;
  }

  Function function_;
  std::string section_;
};

}  // namespace

Function function_from_text(const std::string& text) { return TextReader().read(text); }

}  // namespace flatdyn::testing
