# SPDX-License-Identifier: GPL-2.0-or-later
"""The scripts for Gappa beside a certificate, and the operations of a function that they hold."""

import math
import re

from certificate_check.arithmetic import PLAIN
from certificate_check.expressions import backwards, names_in, parsed, value_of

FORMULA = re.compile(r"\s*(?:@rnd = (\S+ \S+);)?((?:\s*k\d+ = rnd\(\S+\);)*)\s*\{(.*)->(.*)\}\s*", re.S)
NUMBER = r"(\d[\d.]*(?:e[-+]?\d+|b-?\d+)?)"
BOUNDED = re.compile(rf"\s*(.+) in \[-{NUMBER}, {NUMBER}\]\s*", re.S)

def number(text):
    """A number of a script: 1b-53 is 2^-53."""
    mantissa, _, exponent = text.partition("b")
    return math.ldexp(float(mantissa), int(exponent)) if exponent else float(text)


class Script:
    """A script for Gappa: definitions of constants, and hypotheses and goals, each a pair of expression and bound."""

    def __init__(self, file):
        self.file, text = file, file.read_text()
        found = FORMULA.fullmatch(re.sub(r"#.*", "", text))
        if not found:
            raise ValueError(f"{file.name} is no formula of hypotheses and goals")
        self.format = found[1]
        self.constants = dict(re.findall(r"(k\d+) = rnd\((\S+)\);", found[2]))
        self.hypotheses, self.goals = self.pairs(found[3]), self.pairs(found[4])
        self.results = re.findall(r"# (x\d+)$", text, re.M)  # the names of the hypotheses' expressions

    def pairs(self, conjunction):
        pairs = []
        for part in conjunction.split("/\\"):
            found = BOUNDED.fullmatch(part)
            if not found or found[2] != found[3]:
                raise ValueError(f"{self.file.name}: \"{part.strip()}\" bounds no size")
            pairs.append((found[1], number(found[2])))
        return pairs


class Operations:
    """The operations of a function, in order, from its scripts of roundings, with the errors that these prove."""

    def __init__(self, folder, function):
        self.names, self.trees, self.bounds, self.errors, self.scripts = [], [], [], {}, []
        files = sorted(folder.glob(f"{function}.roundings_*.g"), key=lambda f: int(f.stem.rsplit("_", 1)[1]))
        for file in files:
            script = Script(file)
            self.scripts.append(script)
            if not len(script.results) == len(script.hypotheses) == len(script.goals):
                raise ValueError(f"{file.name}: a result has no name, or no goal")
            for name, (expression, bound), (goal, error) in zip(script.results, script.hypotheses, script.goals):
                if goal != f"rnd({expression}) - ({expression})" or name in self.errors:
                    raise ValueError(f"{file.name}: {name} has another goal, or two")
                self.names.append(name)
                self.trees.append(parsed(expression))
                self.bounds.append(bound)
                self.errors[name] = error

    def require(self, known, outputs):
        """Fails if an operation or output reads a result that is not there."""
        known = set(known)
        for name, tree in list(zip(self.names, self.trees)) + [(output.name, output.tree) for output in outputs]:
            missing = sorted(names_in(tree) - known)
            if missing:
                raise ValueError(f"{name} reads {', '.join(missing)}, of which no script says anything")
            known.add(name)

    def evaluate(self, leaves, arithmetic):
        values = dict(leaves)
        for name, tree in zip(self.names, self.trees):
            values[name] = arithmetic.rounded(value_of(tree, values, arithmetic))
        return values

    def derivatives(self, of, values, arithmetic=PLAIN):
        """The derivatives of an expression by all results and leaves."""
        by = {}
        backwards(of, 1, values, by, arithmetic)
        for name, tree in zip(reversed(self.names), reversed(self.trees)):
            if name in by:
                backwards(tree, by[name], values, by, arithmetic)
        return by
