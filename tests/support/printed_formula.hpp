// SPDX-License-Identifier: GPL-2.0-or-later
// Reads the formulas that `derive` prints as text: sums and products of numbers, names, powers, cos(…), sin(…), sgn(…).
// It shares nothing with what prints them.
#pragma once

#include <cctype>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

#include "graph/graph.hpp"
#include "robot/model/field_mechanism.hpp"

namespace flatdyn::testing {

class PrintedFormula {
 public:
  // `name_of`: the node that a name stands for.
  PrintedFormula(Graph& graph, std::function<NodeId(const std::string&)> name_of)
      : graph_(graph), name_of_(std::move(name_of)) {}

  // Throws std::runtime_error for text that is no formula.
  NodeId read(const std::string& text) {
    text_ = text;
    at_ = 0;
    const NodeId result = sum();
    if (at_ != text_.size()) fail("the end");
    return result;
  }
  // Whether a number was read that ends in "...", which is rounded.
  bool has_rounded_numbers() const { return rounded_; }

 private:
  [[noreturn]] void fail(const std::string& expected) const {
    throw std::runtime_error("expected " + expected + " at " + text_.substr(at_, 40));
  }
  bool take(const std::string& token) {
    if (text_.compare(at_, token.size(), token) != 0) return false;
    at_ += token.size();
    return true;
  }
  char next() const { return at_ < text_.size() ? text_[at_] : '\0'; }

  NodeId sum() {
    NodeId total = take("-") ? graph_.scaled(-1, product()) : product();
    for (;;) {
      if (take(" + ")) {
        total = graph_.sum({{1, total}, {1, product()}});
      } else if (take(" - ")) {
        total = graph_.sum({{1, total}, {-1, product()}});
      } else {
        return total;
      }
    }
  }

  NodeId product() {
    NodeId total = power();
    while (next() == ' ' && at_ + 1 < text_.size() && text_[at_ + 1] != '+' && text_[at_ + 1] != '-') {
      ++at_;
      total = graph_.product({total, power()});
    }
    return total;
  }

  NodeId power() {
    const NodeId base = factor();
    if (!take("^")) return base;
    NodeId total = base;
    for (int exponent = std::stoi(digits()); exponent > 1; --exponent) total = graph_.product({total, base});
    return total;
  }

  NodeId factor() {
    if (std::isdigit(static_cast<unsigned char>(next())) != 0) return number();
    if (take("(")) return closed(sum());
    if (take("cos(")) return graph_.cos(closed(sum()));
    if (take("sin(")) return graph_.sin(closed(sum()));
    if (take("sgn(")) return graph_.sign(closed(sum()));
    std::string name;
    while (std::isalnum(static_cast<unsigned char>(next())) != 0 || next() == '_') name += text_[at_++];
    if (name.empty()) fail("a factor");
    return name_of_(name);
  }

  NodeId closed(NodeId inside) {
    if (!take(")")) fail(")");
    return inside;
  }

  std::string digits() {
    std::string result;
    while (std::isdigit(static_cast<unsigned char>(next())) != 0) result += text_[at_++];
    if (result.empty()) fail("digits");
    return result;
  }

  // "12", "9/70", "0.425", "1.25e-05", "0.29552020666133957...".
  NodeId number() {
    std::string text = digits();
    if (take("/")) return graph_.constant(Rational(text + "/" + digits()));
    if (text_.compare(at_, 3, "...") != 0 && take(".")) text += "." + digits();
    if (take("e-")) text += "e-" + digits();
    if (take("...")) rounded_ = true;
    return graph_.constant(to_rational(exact_decimal(text)));
  }

  Graph& graph_;
  std::function<NodeId(const std::string&)> name_of_;
  std::string text_;
  std::size_t at_ = 0;
  bool rounded_ = false;
};

}  // namespace flatdyn::testing
