# SPDX-License-Identifier: GPL-2.0-or-later
"""A function of a header: its arguments, and its statements as names and the tree of their value. Every statement is one
of the few that flatdyn writes, at a place where it may stand."""

import ast
import math
import re

from certificate_check.expressions import parsed, value_of
from certificate_check.tokens import tokens_of

CHECK = "static_assert(detail::Interface::checked<Scalar>());"
FUSED = "constexpr detail::MultiplyAdd<Scalar> fma{};"
LEAVES = {"sine": "s", "cosine": "c"}
ORDER = ["q", "g_b", "qd", "v", "qdd", "a", "qd_r", "v_r", "qdd_r", "a_r", "tau", "h_e", "pi_b", "weights", "direction"]
TAKEN = {"fma", "sine", "cosine", "angle", "sin_cos", "Scalar", "SinCos", "Joints", "detail"}


def name_in_header(function):
    """The C++ name of a function of the certificate: "jacobian_hand" for "jacobian:hand"."""
    return re.sub(r"[^A-Za-z0-9_]", "_", function)


class HeaderFunction:
    """`arrays`: the names of its arguments that are arrays, nothing for one that has no name. `outputs`: the entries that
    it writes, in order, and `size` how many its arguments have room for."""

    def __init__(self, name, counts, arrays=(), results=(), gives_number=False):
        self.name, self.counts = name, counts
        self.arrays, self.results, self.gives_number = list(arrays), list(results), gives_number
        self.statements, self.literals, self.outputs, self.shapes = [], {}, [], {}
        self.locals, self.made, self.asked, self.reads = set(), {}, None, set()
        self.tables, self.leaves_out = [], False

    # Reading.

    def read(self, reader):
        """Reads the statements up to the brace at the end."""
        while not reader.accept("}"):
            self.statement(reader)
        written = {name for targets, _ in self.statements for name in targets}
        for array in self.results:
            indices = sorted(int(name[len(array) + 1:-1]) for name in written if name.startswith(array + "["))
            self.outputs += [f"{array}[{k}]" for k in indices]
        if self.gives_number:
            if "returned" not in written:
                reader.fail(f"{self.name} returns nothing")
            self.outputs.append("returned")
        self.check_sines(reader)

    def statement(self, reader):
        if "returned" in self.outputs_so_far():
            reader.fail("a statement behind the result")
        if reader.word() == "const":
            reader.expect("const Scalar")
            self.definitions(reader)
        elif reader.word() == "Scalar":
            reader.expect("Scalar")
            self.declarations(reader)
        elif reader.accept(FUSED):
            self.make("fma", 0, reader)
        elif reader.accept("detail::angles(q, angle);"):
            self.fill_angles(reader)
        elif reader.word() == "sin_cos":
            self.ask(reader)
        elif reader.accept("detail::Zeros::store<"):
            self.stored_zeros(reader)
        elif reader.accept("return"):
            if not self.gives_number:
                reader.fail(f"{self.name} returns a value")
            self.add(["returned"], reader.up_to(";"), reader)
        else:
            self.assignment(reader)

    def outputs_so_far(self):
        return self.statements[-1][0] if self.statements else []

    def make(self, name, length, reader):
        if name in self.made:
            reader.fail(f"{name} is there twice")
        self.made[name] = length

    def definitions(self, reader):
        """Reads "x = fma(a, b, c), y = d;"."""
        tokens, depth, part = reader.up_to(";"), 0, []
        for token in tokens + [","]:
            depth += {"(": 1, ")": -1}.get(token, 0)
            if token == "," and depth == 0:
                self.definition(part, reader)
                part = []
            else:
                part.append(token)

    def definition(self, tokens, reader):
        if len(tokens) < 3 or tokens[1] != "=" or not tokens[0].is_word:
            reader.fail("a definition expected")
        name = str(tokens[0])
        is_known = name in self.locals or name in TAKEN or name in self.counts or name in self.arrays + self.results
        if is_known or name[0] == "_" or name in ("sign", "std", "Real"):
            reader.fail(f"{name} has a meaning already")
        self.add([f"local_{name}"], tokens[2:], reader)
        self.locals.add(name)

    def declarations(self, reader):
        """Reads "sine[joint_count], cosine[joint_count];"."""
        count = next(name for name in ("angle_count", "position_count", "joint_count") if name in self.counts)
        while True:
            name = reader.take_name()
            if name not in ("angle", "sine", "cosine") or (name == "angle" and count != "angle_count"):
                reader.fail(f"an array {name} that flatdyn does not write")
            self.make(name, self.counts[count], reader)
            reader.expect(f"[{count}]")
            if not reader.accept(","):
                break
        reader.expect(";")

    def fill_angles(self, reader):
        if "angle" not in self.made or "q" not in self.arrays or "angles" in self.made:
            reader.fail("angles that are filled at another place")
        self.reads.add("q")
        self.made["angles"] = 0

    def ask(self, reader):
        """Reads "sin_cos(q, Joints<0, 1>(), sine, cosine);"."""
        array = "angle" if "angle_count" in self.counts else "q"
        is_there = "angles" in self.made if array == "angle" else "q" in self.arrays
        if not is_there or self.asked is not None or not {"sine", "cosine"} <= set(self.made):
            reader.fail("sines and cosines that are asked for at another place")
        reader.expect(f"sin_cos({array}, Joints<")
        self.asked = [reader.take_count()]
        while reader.accept(","):
            self.asked.append(reader.take_count())
        reader.expect(">(), sine, cosine);")
        if self.asked != sorted(set(self.asked)) or self.asked[-1] >= self.made["sine"]:
            reader.fail("sines of other joints than there are")

    def assignment(self, reader):
        """Reads "B[1] = B[7] = x + y;"."""
        tokens, targets = reader.up_to(";"), []
        while len(tokens) > 5 and tokens[1] == "[" and tokens[3:5] == ["]", "="]:
            array, index = tokens[0], tokens[2]
            if not index.isdigit() or str(int(index)) != index:
                reader.fail(f"{array}[{index}] is no entry of an output")
            self.add_target(targets, array, int(index), reader)
            tokens = tokens[5:]
        if not targets:
            reader.fail("no statement that flatdyn writes")
        self.add(targets, tokens, reader)

    def stored_zeros(self, reader):
        """Reads "9>(B + 3);", the rest of what stores zeros in entries that follow one another."""
        count, targets = reader.take_count(), []
        reader.expect(">(")
        array = reader.take_name()
        first = reader.take_count() if reader.accept("+") else 0
        reader.expect(");")
        for k in range(first, first + count):
            self.add_target(targets, array, k, reader)
        if not targets:
            reader.fail("no zeros that flatdyn writes")
        self.add(targets, tokens_of("Scalar(0.0)"), reader)

    def add_target(self, targets, array, index, reader):
        name = f"{array}[{index}]"
        if array not in self.results:
            reader.fail(f"{name} is no entry of an output")
        if name in targets or any(name in earlier for earlier, _ in self.statements):
            reader.fail(f"{name} is written twice")
        targets.append(name)

    def add(self, targets, tokens, reader):
        has_written = self.name != "angles" and any("[" in name for names, _ in self.statements for name in names)
        try:
            text, reads = self.in_names_of_scripts(list(tokens), reader)
            tree = parsed(text)
        except SyntaxError:
            reader.fail(f"no sum or product: {' '.join(tokens)}")
        if has_written and reads & set(self.arrays):
            reader.fail(f"{sorted(reads & set(self.arrays))[0]} is read after an output is written")
        self.reads |= reads
        self.statements.append((targets, tree))

    def in_names_of_scripts(self, tokens, reader):
        """An expression with the scripts' names of arguments, and with names for literals and variables; and the names of
        the arrays that it reads."""
        words, reads = [], set()
        while tokens:
            token = tokens.pop(0)
            if token == "Scalar":
                words.append(self.literal(tokens, reader))
            elif token == "detail" and tokens[:3] == ["::", "sign", "("]:
                del tokens[:2]
                words.append("sign")
            elif token == "fma" and tokens[:1] == ["("] and "fma" in self.made:
                words.append("fma")
            elif token.is_word and tokens[:1] == ["["]:
                words.append(self.entry(str(token), tokens, reader))
                reads.add(str(token))
            elif token.is_word:
                if token not in self.locals:
                    reader.fail(f"nothing is called {token}")
                words.append(f"local_{token}")
            elif token in ("+", "-", "*", "(", ")", ","):
                words.append(str(token))
            else:
                reader.fail(f"\"{token}\" in a sum or product")
        return " ".join(words), reads

    def literal(self, tokens, reader):
        """The name of "(-0.5)" behind Scalar."""
        sign = "-" if tokens[1:2] == ["-"] else ""
        if sign:
            tokens.pop(1)
        if len(tokens) < 3 or tokens[0] != "(" or tokens[2] != ")":
            reader.fail("a literal expected")
        text = str(tokens[1])
        is_decimal = text[0].isdigit() and set(text) <= set("0123456789.e+-") and set(text) & set(".e")
        if not is_decimal or not math.isfinite(float(text)):
            reader.fail(f"{text} is no literal that flatdyn writes")
        del tokens[:3]
        return self.literals.setdefault(sign + text, f"literal_{len(self.literals)}")

    def entry(self, array, tokens, reader):
        """The scripts' name of "[2]" behind the name of an array."""
        if len(tokens) < 3 or not tokens[1].isdigit() or str(int(tokens[1])) != tokens[1] or tokens[2] != "]":
            reader.fail(f"an index of {array} expected")
        index = int(tokens[1])
        if array in LEAVES:
            if self.asked is None or index not in self.asked:
                reader.fail(f"{array}[{index}], which nothing has computed")
        elif array not in self.arrays:
            reader.fail(f"nothing is called {array}[{index}]")
        del tokens[:3]
        return f"{LEAVES.get(array, array)}_{index + 1}"

    def check_sines(self, reader):
        """Requires that the sines and cosines that are asked for are used."""
        used = {name for _, tree in self.statements for name in names_of(tree)}
        if any(not {f"s_{k + 1}", f"c_{k + 1}"} & used for k in self.asked or []):
            reader.fail(f"{self.name} asks for other sines and cosines than it uses")

    # Values.

    def zeros(self):
        """The entries that are written as 0."""
        zero = self.literals.get("0.0")
        return {name for targets, tree in self.statements if ast.unparse(tree) == zero for name in targets}

    def name_results(self, row):
        """Calls arguments and results by their names in the certificate, which may lack a number that tells one from
        another; and requires that they are these."""
        stated = {argument["name"]: argument["lengths"] for argument in row["arguments"]}
        names = dict(zip(self.arrays + self.results, stated))
        is_same = len(stated) == len(self.arrays) + len(self.results) and all(
            name == other or re.fullmatch(rf"{re.escape(other)}_?\d+", name) for name, other in names.items())
        lengths = {names.get(name): length for name, length in self.shapes.items()}
        has_shape = all(length > 0 for lengths_of_one in stated.values() for length in lengths_of_one)
        if not is_same or (lengths != stated if has_shape else lengths):
            raise ValueError(f"{self.name} has other arguments than the certificate says")
        if self.gives_number:
            names["returned"] = next((output["output"] for output in row["outputs"]), "returned")
        renamed = {f"{name}[{k}]": f"{names[name]}[{k}]" for name in self.results for k in range(len(self.outputs))}
        renamed["returned"] = names.get("returned")
        self.outputs = [renamed[output] for output in self.outputs]
        for targets, _ in self.statements:
            targets[:] = [renamed.get(target, target) for target in targets]

    def computed(self, sine):
        """The tree of the angle of a sine such as s_4, unless it is the position of that joint itself."""
        entry = f"angle[{int(sine[2:]) - 1}]"
        trees = [tree for targets, tree in self.statements if entry in targets and ast.unparse(tree) != "q_" + sine[2:]]
        return trees[0] if trees else None

    def with_literals(self, leaves, arithmetic):
        return {**leaves, **{name: arithmetic.constant(text) for text, name in self.literals.items()}}

    def evaluate(self, leaves, arithmetic):
        values = self.with_literals(leaves, arithmetic)
        for targets, tree in self.statements:
            values.update(dict.fromkeys(targets, value_of(tree, values, arithmetic)))
        return values


def names_of(tree):
    return {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
