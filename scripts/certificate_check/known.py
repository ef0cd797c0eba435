# SPDX-License-Identifier: GPL-2.0-or-later
"""The text of headers that is the same for all robots: known_text.txt, section by section."""

import pathlib
import re

from certificate_check.tokens import Token, tokens_of

HOLES = re.compile(r"\b(GUARD|NAMESPACE|REAL)(?=\b|_IN_LANES)")


def sections_of(text):
    """By name: the tokens of a section."""
    parts = re.split(r"^//@ (\w+)\n", text, flags=re.M)[1:]
    return {name: tokens_of(section) for name, section in zip(parts[::2], parts[1::2])}


SECTIONS = sections_of(pathlib.Path(__file__).with_name("known_text.txt").read_text())
KEYWORDS = """alignas alignof and and_eq asm auto bitand bitor bool break case catch char class compl const constexpr
 continue decltype default delete do double else enum explicit export extern false float for friend goto if inline int
 long mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected public register return short
 signed sizeof static static_assert struct switch template this throw true try typedef typename union unsigned using
 virtual void volatile while xor xor_eq""".split()
# Names that a function of a header cannot have, because the text around the functions gives them a meaning.
WORDS = {str(token) for tokens in SECTIONS.values() for token in tokens if token.is_word} | set(KEYWORDS) | {"functions"}


def section(name, holes):
    """The tokens of a section, with what `holes` says in place of GUARD and the others, if it says anything."""
    return [HOLES.sub(lambda found: holes.get(found[1], found[1]), token) for token in SECTIONS[name]]
