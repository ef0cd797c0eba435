# SPDX-License-Identifier: GPL-2.0-or-later
"""A position among the tokens of a header. Nothing is passed over: what is there has to be what is expected."""

from certificate_check.known import section
from certificate_check.tokens import Unknown, tokens_of


class Reader:
    def __init__(self, tokens):
        self.tokens, self.at, self.holes = tokens, 0, {}

    def fail(self, what):
        line = self.tokens[min(self.at, len(self.tokens) - 1)].line if self.tokens else 0
        raise Unknown(line, what)

    def word(self, ahead=0):
        return self.tokens[self.at + ahead] if self.at + ahead < len(self.tokens) else ""

    def take(self):
        if self.at >= len(self.tokens):
            self.fail("it ends")
        self.at += 1
        return self.tokens[self.at - 1]

    def take_name(self):
        name = self.take()
        if not name.is_word:
            self.at -= 1
            self.fail(f"a name expected instead of \"{name}\"")
        return str(name)

    def take_count(self):
        text = self.take()
        if not text.isdigit() or (len(text) > 1 and text[0] == "0") or len(text) > 6:
            self.at -= 1
            self.fail(f"a whole number expected instead of \"{text}\"")
        return int(text)

    def follows(self, tokens):
        return self.tokens[self.at:self.at + len(tokens)] == tokens

    def expect_tokens(self, tokens):
        for token in tokens:
            if self.word() != token:
                self.fail(f"\"{token}\" expected instead of \"{self.word()}\"")
            self.at += 1

    def expect(self, text):
        self.expect_tokens(tokens_of(text))

    def accept(self, text):
        tokens = tokens_of(text)
        if not self.follows(tokens):
            return False
        self.at += len(tokens)
        return True

    def expect_section(self, name):
        """Takes text that is the same for all robots; fails at the first token that is another one."""
        self.expect_tokens(section(name, self.holes))

    def accept_section(self, name, begin):
        """Takes a section if its first tokens are there; then the others have to follow."""
        if not self.follows(tokens_of(begin)):
            return False
        self.expect_section(name)
        return True

    def up_to(self, end):
        """Takes the tokens before the next `end`, and it."""
        begin = self.at
        while self.take() != end:
            pass
        return self.tokens[begin:self.at - 1]
