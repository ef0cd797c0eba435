# SPDX-License-Identifier: GPL-2.0-or-later
"""The outputs of a certified function: their bounds, and the errors that these add up."""

import ast
import math

from certificate_check.expressions import parsed, summands
from certificate_check.gappa_scripts import Script

class Group:
    """Errors that reach an output alike, or whose derivatives are the components of a vector."""

    def __init__(self, components, bound):
        self.components, self.bound = components, bound

    def names(self):
        return [name for alike in self.components for name in alike]

    def size(self, by):
        return math.sqrt(sum(max(abs(by.get(name, 0.0)) for name in alike) ** 2 for alike in self.components))


class Output:
    """An output of a function: what the certificate says of it, and what its script adds up."""

    def __init__(self, row, folder, function, name_of):
        self.name, self.bound, self.seen = row["output"], row["bound"], row["seen"]
        self.names = [self.name] + row["also"]
        self.tree = parsed(row["result"])
        self.groups, self.errors, self.sum = [], [], 0.0  # errors: pairs of name and bound
        self.file = folder / (f"{function}." + self.name.replace("[", "_").replace("]", "") + ".g")
        if self.file.exists():
            self.read(Script(self.file), name_of)

    def read(self, script, name_of):
        bounds = dict(script.hypotheses)
        (goal, self.sum), *others = script.goals
        if others or script.constants or len(bounds) < len(script.hypotheses):
            raise ValueError(f"{self.file.name}: a name is defined twice, or there are several goals")
        for term in summands(parsed(goal)):
            components = [[part.id for part in alike] for alike in self.components(term)]
            unknown = [r for alike in components for r in alike if r not in name_of]
            if unknown:
                raise ValueError(f"{self.file.name} adds {unknown[0]}, of which no other script says anything")
            self.groups.append(Group([[name_of[r] for r in alike] for alike in components], bounds[term.left.id]))
            self.errors += [(name_of[r], bounds[r]) for alike in components for r in alike]

    @staticmethod
    def components(term):
        """The sums of errors of a term: a5 * r5, a5 * (r5 + r6), a5 * sqrt(r5 * r5 + (r6 + r7) * (r6 + r7))."""
        if not (isinstance(term, ast.BinOp) and isinstance(term.op, ast.Mult) and isinstance(term.left, ast.Name)):
            raise ValueError(f"{ast.unparse(term)} is not a derivative times errors")
        if not isinstance(term.right, ast.Call):
            return [summands(term.right)]
        squares = summands(term.right.args[0])
        if ast.unparse(term.right.func) != "sqrt" or any(ast.dump(s.left) != ast.dump(s.right) for s in squares):
            raise ValueError(f"{ast.unparse(term)} is not a derivative times a length")
        return [summands(square.left) for square in squares]

    def faults(self, required, off):
        """What is wrong with its sum. `required`: the least bounds of the errors that have to be in it, by name; `off`:
        by how much errors that are seen can be off themselves."""
        counted = [name for name, _ in self.errors]
        for name in sorted(set(required) - set(counted)):
            yield f"{self.name} depends on {name}, whose error is missing in {self.file.name}"
        for name in sorted(name for name in set(counted) if counted.count(name) > 1):
            yield f"{self.file.name} counts the error of {name} more than once"
        for name, error in self.errors:
            if not error >= required.get(name, 0.0):
                yield f"{self.file.name} assumes an error of {name} of {error:.6g}, but it can be {required[name]:.6g}"
        if not self.sum <= self.bound:
            yield f"{self.file.name} has {self.sum:.6g} as bound of {self.name}, the certificate has {self.bound:.6g}"
        if not self.seen <= self.bound + off:
            yield f"an error of {self.name} was seen that is larger than its bound"
