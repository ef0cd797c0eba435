# SPDX-License-Identifier: GPL-2.0-or-later
"""The generated header that a certificate is about: its hash, limits and functions."""

import ast
import hashlib
import math
import re

from certificate_check.expressions import parsed, value_of

HEADER_FUNCTION = re.compile(
    r"((?:^//[^\n]*\n)+)template <[^\n]*>\nstatic inline \w+ (\w+)\([^;]*?noexcept \{\n(.*?)^\}\n", re.M | re.S)
FUSED = "constexpr MultiplyAdd<Scalar> fma{}"
NO_OPERATIONS = (FUSED, "Scalar sine[", "Scalar angle[", "angles(", "sin_cos(", "static_assert(")
LIMITS = {"q": ["position_lower", "position_upper"], "qd": ["velocity_limit"], "qdd": ["acceleration_limit"],
          "tau": ["effort_limit"], "v": ["velocity_limit"], "a": ["acceleration_limit"]}
OF_BASE = 6  # entries of v, a and tau before the joints', with a floating base

def definitions(statement):
    """The definitions in a statement, "a = x, b = fma(x, y, z)"."""
    return re.split(r", (?=\w+ = )", statement)


class HeaderFunction:
    """A function of the header: the names of its outputs, and its statements, as names and the tree of their value."""

    def __init__(self, comment, name, body):
        self.name, self.statements, self.literals = name, [], {}
        self.outputs = re.findall(r"^// Returns (\w+):", comment, re.M)
        for output, size in re.findall(r"^//   (\w+)\[(\d+)\] +out ", comment, re.M):
            self.outputs += [f"{output}[{k}]" for k in range(int(size))]
        if self.outputs:
            self.read(body)

    def read(self, body):
        self.check_sines(body)
        for statement in " ".join(body.split()).replace("detail::", "").split(";"):
            statement = statement.strip().removeprefix("const Scalar ")
            if not statement or statement.startswith(NO_OPERATIONS):
                continue
            if statement.startswith("return "):
                statement = f"{self.outputs[0]} = {statement[7:]}"
            for one in definitions(statement):
                *targets, expression = one.split(" = ")
                self.statements.append((targets, self.tree(expression)))

    def check_sines(self, body):
        """Requires that the sines and cosines of q, or of the angles by which joints turn, are asked for as used."""
        used = sorted({int(index) for index in re.findall(r"\b(?:sine|cosine)\[(\d+)\]", body)})
        asked = re.findall(r"\bsin_cos\(([^;]*)\);", body)
        array = "angle" if "angles(q, angle);" in body else "q"
        wanted = [f"{array}, Joints<{', '.join(map(str, used))}>(), sine, cosine"] if used else []
        if [" ".join(each.split()) for each in asked] != wanted:
            raise ValueError(f"{self.name} asks for other sines and cosines than it uses")

    def tree(self, text):
        """An expression with the scripts' names of arguments, and with names for literals."""
        def literal(found):
            return self.literals.setdefault(found[1], f"literal_{len(self.literals)}")

        def argument(found):
            return f"{ {'sine': 's', 'cosine': 'c'}.get(found[1], found[1]) }_{int(found[2]) + 1}"

        return parsed(re.sub(r"\b(\w+)\[(\d+)\]", argument, re.sub(r"Scalar\(([\d.e-]+)\)", literal, text)))

    def zeros(self):
        """The entries that are written as 0."""
        zero = self.literals.get("0.0")
        return {name for targets, tree in self.statements if ast.unparse(tree) == zero for name in targets}

    def computed(self, sine):
        """The tree of the angle of a sine such as s_4, unless it is the position of a joint itself."""
        entry = f"angle[{int(sine[2:]) - 1}]"
        trees = [tree for targets, tree in self.statements if entry in targets and not isinstance(tree, ast.Name)]
        return trees[0] if trees else None

    def with_literals(self, leaves, arithmetic):
        return {**leaves, **{name: arithmetic.constant(text) for text, name in self.literals.items()}}

    def evaluate(self, leaves, arithmetic):
        values = self.with_literals(leaves, arithmetic)
        for targets, tree in self.statements:
            values.update(dict.fromkeys(targets, value_of(tree, values, arithmetic)))
        return values


class Header:
    """The header that was certified: its hash, the limits of its joints, and its functions."""

    def __init__(self, file):
        self.text = text = file.read_text()
        self.hash = "sha1:" + hashlib.sha1(file.read_bytes()).hexdigest()
        self.limits = {}
        for name, entries in re.findall(r"constexpr Real (\w+)\[joint_count\] = \{(.*?)\};", text, re.S):
            texts = re.findall(r"Real\((.*?)\)", entries)
            self.limits[name] = [abs(float(text.replace("HUGE_VAL", "inf"))) for text in texts]
        self.angles = HeaderFunction("", "angles", "")
        for body in re.findall(r"void angles\([^;]*?noexcept \{\n(.*?)^\}\n", text, re.M | re.S):
            self.angles.read(body)
        functions = [HeaderFunction(*found.groups()) for found in HEADER_FUNCTION.finditer(text)]
        self.functions = {function.name: function for function in functions if function.outputs}

    def limit(self, argument):
        """The largest size of an argument such as qd_2, or nothing if the header has none."""
        kind, _, index = argument.partition("_")
        if not index.isdigit():
            return None
        joint = int(index) - 1 - (OF_BASE if kind in ("v", "a") else 0)
        if joint < 0:
            return None
        sizes = [self.limits[name][joint] for name in LIMITS.get(kind, []) if name in self.limits]
        return max(sizes) if sizes and max(sizes) < math.inf else None
