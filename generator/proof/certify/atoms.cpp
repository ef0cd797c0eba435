// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/certify/atoms.hpp"

#include <algorithm>

namespace flatdyn {

int Atoms::numbered(Atom atom) {
  const std::tuple key(atom.kind, atom.a, atom.b, atom.joint, atom.is_cosine);
  const auto [found, is_new] = number_.emplace(key, static_cast<int>(atoms_.size()));
  if (!is_new) return found->second;
  using Kind = Atom::Kind;
  if (atom.kind == Kind::given || atom.kind == Kind::result) atom.rank = {atom.a, 0};
  if (atom.kind == Kind::turned) atom.rank = {rank(atom.a).first, rank(atom.a).second + 1};
  if (atom.kind == Kind::product) {
    const std::pair a = rank(atom.a), b = rank(atom.b);
    atom.rank = {std::max(a.first, b.first), a.second + b.second + 1};
  }
  atoms_.push_back(atom);
  return found->second;
}

int Atoms::product(int a, int b) {
  if (a == kOne) return b;
  if (b == kOne) return a;
  for (const auto& [x, y] : {std::pair(a, b), std::pair(b, a)}) {
    Atom turned = (*this)[x];
    if (turned.kind != Atom::Kind::turned) continue;
    turned.a = product(turned.a, y);
    return numbered(turned);
  }
  return numbered({Atom::Kind::product, std::min(a, b), std::max(a, b)});
}

bool Atoms::is_purely_trigonometric(int atom) const {
  const Atom& of = (*this)[atom];
  return of.kind == Atom::Kind::one || (of.kind == Atom::Kind::turned && is_purely_trigonometric(of.a));
}

bool Atoms::have_no_joint_in_common(int a, int b) const {
  for (int x = a; x != kOne; x = (*this)[x].a) {
    for (int y = b; y != kOne; y = (*this)[y].a) {
      if ((*this)[x].joint == (*this)[y].joint) return false;
    }
  }
  return true;
}

}  // namespace flatdyn
