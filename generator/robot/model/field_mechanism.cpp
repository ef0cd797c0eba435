// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/field_mechanism.hpp"

#include <cln/integer.h>
#include <cln/rational.h>

#include <sstream>
#include <vector>

namespace flatdyn {

void cannot_map(const Number& a) {
  std::ostringstream text;
  text << "not a rational expression in the free symbols, their sines and cosines: " << a;
  throw Failure(FailureKind::unsupported, text.str());
}

namespace {

constexpr unsigned kWordBits = 64;

bool fits_word(const cln::cl_I& value) { return cln::integer_length(value) < kWordBits; }

Rational::Integer to_integer(const cln::cl_I& value) {
  if (fits_word(value)) return cln::cl_I_to_long(value);
  const cln::cl_I size = cln::abs(value);
  std::vector<unsigned long> words;
  for (unsigned begin = 0; begin < cln::integer_length(size); begin += kWordBits) {
    words.push_back(cln::cl_I_to_ulong(cln::ldb(size, cln::cl_byte(kWordBits, begin))));
  }
  Rational::Integer result;
  constexpr int kLeastFirst = -1, kNative = 0;
  mpz_import(result.get_mpz_t(), words.size(), kLeastFirst, sizeof(words[0]), kNative, 0, words.data());
  return cln::minusp(value) ? Rational::Integer(-result) : result;
}

// The number of `count` words from word `begin` on. Halving keeps the shifts short.
cln::cl_I from_words(const mpz_t value, std::size_t begin, std::size_t count) {
  if (count == 0) return 0;
  if (count == 1) return cln::cl_I(mpz_getlimbn(value, static_cast<mp_size_t>(begin)));
  const std::size_t low = count / 2;
  return cln::ash(from_words(value, begin + low, count - low), static_cast<long>(low * kWordBits)) +
         from_words(value, begin, low);
}

cln::cl_I from_integer(const Rational::Integer& value) {
  const cln::cl_I size = from_words(value.get_mpz_t(), 0, mpz_size(value.get_mpz_t()));
  return value < 0 ? -size : size;
}

}  // namespace

Number to_number(const Rational& a) {
  return GiNaC::numeric(cln::cl_N(from_integer(numerator(a)) / from_integer(denominator(a))));
}

Rational to_rational(const Number& a) {
  if (!is_rational(a)) cannot_map(a);
  const auto fraction = cln::the<cln::cl_RA>(GiNaC::ex_to<GiNaC::numeric>(a).to_cl_N());
  const cln::cl_I above = cln::numerator(fraction), below = cln::denominator(fraction);
  if (fits_word(above) && fits_word(below)) return Rational(cln::cl_I_to_long(above), cln::cl_I_to_long(below));
  return Rational(to_integer(above), to_integer(below));
}

int index_of(const Number& symbol, const std::vector<FreeSymbol>& symbols) {
  for (std::size_t k = 0; k < symbols.size(); ++k) {
    if (symbols[k].symbol.is_equal(GiNaC::ex_to<GiNaC::basic>(symbol))) return static_cast<int>(k);
  }
  std::ostringstream text;
  text << "symbol " << symbol << " is none of the robot's";
  throw Failure(FailureKind::bug, text.str());
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
