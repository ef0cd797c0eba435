// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/field_mechanism.hpp"

#include <sstream>

namespace flatdyn {

void cannot_map(const Number& a) {
  std::ostringstream text;
  text << "not a rational expression in the free symbols, their sines and cosines: " << a;
  throw Failure(ExitCode::unsupported, text.str());
}

Rational to_rational(const Number& a) {
  if (!is_rational(a)) cannot_map(a);
  const GiNaC::numeric value = GiNaC::ex_to<GiNaC::numeric>(a);
  if (value.is_equal(0) || value.is_equal(1)) return value.to_int();  // most numbers of a mechanism are 0 or 1
  std::ostringstream text;
  text << value.numer() << '/' << value.denom();
  return Rational(text.str());
}

int index_of(const Number& symbol, const std::vector<FreeSymbol>& symbols) {
  for (std::size_t k = 0; k < symbols.size(); ++k) {
    if (symbols[k].symbol.is_equal(GiNaC::ex_to<GiNaC::basic>(symbol))) return static_cast<int>(k);
  }
  std::ostringstream text;
  text << "symbol " << symbol << " is none of the robot's";
  throw Failure(ExitCode::bug, text.str());
}

NodeId linear_angle(const Number& angle, const std::vector<FreeSymbol>& symbols, Graph& graph) {
  const Number expanded = angle.expand();
  Rational constant = 0;
  std::vector<Term> terms;
  const auto add = [&](const Number& term) {
    if (GiNaC::is_a<GiNaC::numeric>(term)) {
      constant += to_rational(term);
      return;
    }
    const bool scaled = GiNaC::is_a<GiNaC::mul>(term) && term.nops() == 2;
    const Number symbol = scaled ? term.op(0) : term;
    if (!GiNaC::is_a<GiNaC::symbol>(symbol)) cannot_map(angle);
    const NodeId node = graph.input({InputKind::parameter, index_of(symbol, symbols)});
    terms.push_back({scaled ? to_rational(term.op(1)) : Rational(1), node});
  };
  if (GiNaC::is_a<GiNaC::add>(expanded)) {
    for (const Number& term : expanded) add(term);
  } else {
    add(expanded);
  }
  return graph.sum(std::move(terms), constant);
}

}  // namespace flatdyn
