// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/kernel/derivation.hpp"

#include <gtest/gtest.h>

#include "base/diagnostics/diagnostics.hpp"

namespace flatdyn {
namespace {

TEST(Derivation, NamesAScalarOnce) {
  Derivation d({});
  const Number q = d.input(InputKind::q, 0), qd = d.input(InputKind::qd, 0);
  const Number a = d.named(2 * q + q * qd, "a"), b = d.named(q * (qd + 2), "b");
  EXPECT_TRUE(a.is_equal(b));
  EXPECT_EQ(*d.graph().name(d.node(a)), "a");
}

TEST(Derivation, LeavesNumbersSymbolsAndNegativesVisible) {
  Derivation d({});
  const Number q = d.input(InputKind::q, 0);
  EXPECT_TRUE(d.named(q - q, "zero").is_zero());
  EXPECT_TRUE(d.named(-q, "minus").is_equal(-q));
  EXPECT_TRUE(d.named(Number(3) / 7, "constant").is_equal(GiNaC::numeric(3, 7)));
}

TEST(Derivation, ANegativeOfAKnownScalarIsItsNegative) {
  Derivation d({});
  const Number q = d.input(InputKind::q, 0), qd = d.input(InputKind::qd, 0);
  const Number a = d.named(q - qd, "a"), b = d.named(qd - q, "b");
  EXPECT_TRUE((a + b).is_zero());
}

TEST(Derivation, TakesSinesCosinesAndReciprocalsOfFreeSymbols) {
  const GiNaC::symbol a("a"), alpha("alpha");
  Derivation d({a, alpha});
  const NodeId node = d.node(GiNaC::sin(alpha) / (a * a) + GiNaC::cos(alpha));
  EXPECT_EQ(d.graph()[node].op, Op::sum);
  EXPECT_THROW(d.node(GiNaC::exp(a)), Failure);
  EXPECT_THROW(d.node(GiNaC::sqrt(a)), Failure);
}

// GiNaC orders terms by address: the same sum of symbols created in another order must become the same nodes.
TEST(Derivation, DoesNotDependOnTheOrderInGiNaC) {
  std::vector<std::string> texts;
  for (int round = 0; round < 8; ++round) {
    std::vector<GiNaC::symbol> padding(static_cast<std::size_t>(round * 5));  // moves addresses and serial numbers
    const GiNaC::symbol a("a"), b("b"), c("c");
    Derivation d({a, b, c});
    d.node(GiNaC::sin(c) * a + GiNaC::cos(b) * b + GiNaC::sin(a) * c + a * b * c + GiNaC::pow(a + b, -1) * c);
    std::string text;
    for (NodeId id = 0; id < d.graph().size(); ++id) {
      text += std::to_string(static_cast<int>(d.graph()[id].op)) + ":";
      for (const NodeId operand : operands_of(d.graph()[id])) text += std::to_string(operand) + ",";
    }
    texts.push_back(text);
  }
  for (const std::string& text : texts) EXPECT_EQ(text, texts[0]);
}

}  // namespace
}  // namespace flatdyn
