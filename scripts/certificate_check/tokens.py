# SPDX-License-Identifier: GPL-2.0-or-later
"""The tokens of a header, as a C++ compiler divides it, without comments. Whatever compilers might divide in another way
is refused: lines that go on with a backslash, trigraphs, other characters than those of ASCII outside of comments."""

import re
import unicodedata

TOKEN = re.compile(r"""
  (?P<blank>[ \n]+)
| (?P<comment>//[^\n]*|/\*[ ]\w+[ ]\*/)
| (?P<word>[A-Za-z_]\w*)
| (?P<number>(?:0x[0-9a-f]+(?:\.[0-9a-f]+)?(?:p[+-]\d+)?|\d+(?:\.\d+)?(?:e[+-]?\d+)?)[uf]?)(?![\w.'])
| (?P<text>"(?:[^"\\\n]|\\[ -~])*")
| (?P<sign>\.\.\.|<<=|::|->|\+\+|--|<=|>=|==|!=|&&|\|\||<<|[-+*/&|^]=|[][(){};,<>=+*/&|^!~?:.-])
""", re.X | re.A)
DIRECTIVE = re.compile(r"[ ]*#(?:[^\n\\]|\\\n)*", re.A)


class Token(str):
    """The text of a token, with its line."""

    def __new__(cls, text, line):
        token = super().__new__(cls, text)
        token.line = line
        return token

    @property
    def is_word(self):
        return self[0].isalpha() or self[0] == "_"


class Unknown(ValueError):
    """Text that flatdyn does not write."""

    def __init__(self, line, what):
        super().__init__(f"line {line} of the header is not what flatdyn writes there: {what}")


def check_characters(text):
    for number, line in enumerate(text.split("\n"), 1):
        for character in line:
            if unicodedata.category(character) in ("Cc", "Zl", "Zp") or character == "\ufeff":
                raise Unknown(number, f"a character that no text of flatdyn has: {character!r}")


def goes_on(line):
    """Whether a compiler reads the next line as a part of this one."""
    return line.rstrip().endswith(("\\", "??/"))


def directive(text, line):
    """A directive on one line, without its comment."""
    if "??" in text or goes_on(text) or "/*" in text or ("//" in text and "\\" in text):
        raise Unknown(line, "a directive that goes on")
    joined = text.replace("\\\n", " ")
    return Token(" ".join(joined.partition("//")[0].split()), line)


def tokens_of(text):
    check_characters(text)
    tokens, at, line, at_begin_of_line = [], 0, 1, True
    while at < len(text):
        found = DIRECTIVE.match(text, at) if at_begin_of_line else None
        if found:
            tokens.append(directive(found[0], line))
        else:
            found = TOKEN.match(text, at)
            if not found:
                raise Unknown(line, f"no token: {text[at:at + 20].splitlines()[0]!r}")
            if found.lastgroup == "comment" and goes_on(found[0]):
                raise Unknown(line, "a comment that goes on")
            if found.lastgroup == "text" and ("??" in found[0] or not found[0].isascii()):
                raise Unknown(line, f"a text that is written in another way: {found[0]}")
            if found.lastgroup not in ("blank", "comment"):
                tokens.append(Token(found[0], line))
        line += found[0].count("\n")
        at = found.end()
        at_begin_of_line = found[0].endswith("\n") or (found.lastgroup == "blank" and "\n" in found[0])
    return tokens
