# SPDX-License-Identifier: GPL-2.0-or-later
"""A certified function: what contradicts itself in its certificate, and a search for states that refute it."""

import math

import mpmath

from certificate_check.arithmetic import (EXACT, PLAIN, PRIME, as_written, certified, in_field, ratio, rounded_to,
                                          rounded_to_float)
from certificate_check.expressions import value_of
from certificate_check.gappa_scripts import Operations
from certificate_check.header_function import name_in_header
from certificate_check.leaves import angle_of, error_of_constant, exact_constant, is_constant, is_sine
from certificate_check.outputs import Output

STATES_OF_TEXT = 40  # states at which header and scripts are compared
REFERENCE = {"double": 53 + 9, "float": 24 + 27}  # bits of the results with which flatdyn compares, but for two
FORMAT = {"double": "float<ieee_64, ne>", "float": "float<ieee_32, ne>"}

class Function:
    """A function as the certificate and its scripts have it, and as the header does."""

    def __init__(self, row, folder, certificate, header):
        self.name, self.scalar, self.leaves = row["name"], certificate["scalar"], row["leaves"]
        self.header = header.functions.get(name_in_header(self.name))
        if not self.header:
            raise ValueError(f"the header has no function {self.name}")
        self.header.name_results(row)
        self.operations = Operations(folder, self.name)
        name_of = {f"r{leaf['operation']}": leaf["name"] for leaf in self.leaves}
        name_of.update({"r" + name[1:]: name for name in self.operations.names})
        self.outputs = [Output(output, folder, self.name, name_of) for output in row["outputs"]]
        known = {name for output in self.outputs for name in output.names} | self.header.zeros()
        missing = sorted(set(self.header.outputs) - known)
        if missing:
            raise ValueError(f"{self.name} has no bound of {', '.join(missing)}")
        self.operations.require([leaf["name"] for leaf in self.leaves], self.outputs)
        self.sizes = self.stated_sizes()
        self.errors = self.least_errors(certificate["trigonometry_error"])
        self.worst = {}  # by hypothesis: the largest ratio to what it says, and the state

    def faults(self, header, source):
        """What does not fit together, without regard of how large results and derivatives are."""
        meanings = {leaf["name"]: leaf["meaning"] for leaf in self.leaves}
        for script in self.operations.scripts:
            if script.format != FORMAT[self.scalar]:
                yield f"{script.file.name} is not about {self.scalar}"
            for name, text in script.constants.items():
                if text != meanings.get(name):
                    yield f"{name} is {text} in {script.file.name}, but {meanings.get(name)} in the certificate"
        for leaf in self.leaves:
            limit = header.limit(leaf["name"]) if "limit" in leaf else None
            if limit is not None and not rounded_to(self.scalar, limit) <= leaf["limit"]:
                yield f"the certificate assumes a smaller limit of {leaf['name']} than the header states, {limit:.6g}"
        for output in self.outputs:
            size = abs(value_of(output.tree, self.sizes, PLAIN))
            yield from output.faults(self.required(output, source), math.ldexp(size, -REFERENCE[self.scalar]))
        states = [self.random_state(source) for _ in range(STATES_OF_TEXT)]
        for name in sorted({name for state in states for name in self.differences(state, header.angles)}):
            yield f"{name} of the header is another number than that of the scripts"

    def differences(self, state, angles):
        """The outputs, angles and operations whose bits differ between header and scripts."""
        sizes = set()
        arithmetic, text = as_written(self.scalar, False), as_written(self.scalar, True, sizes)
        leaves = self.values_of_leaves(state, arithmetic, False)
        values, written = self.operations.evaluate(leaves, arithmetic), self.header.evaluate(leaves, text)
        for output in self.outputs:
            value = value_of(output.tree, values, arithmetic)
            yield from (name for name in output.names if written[name] != value)
        for leaf in filter(is_sine, self.leaves):
            stated, computed = angle_of(leaf), angles.computed(leaf["name"])
            if stated and computed:
                angle = value_of(computed, angles.with_literals(leaves, text), text)
                is_same = angle == value_of(stated, values, arithmetic)
            else:
                is_same = stated is computed is None
            if not is_same:
                yield f"the angle of {leaf['name']}"
        yield from (name for name in self.operations.names if abs(values[name]) not in sizes and values[name] != 0)

    def stated_sizes(self):
        """By name: how large leaves and results are."""
        sizes = {leaf["name"]: leaf.get("limit", 1.0) for leaf in self.leaves}
        sizes.update((leaf["name"], abs(float(leaf["meaning"]))) for leaf in self.leaves if is_constant(leaf))
        sizes.update(zip(self.operations.names, self.operations.bounds))
        return sizes

    def least_errors(self, of_sines):
        """By name: the least bound of the error that a leaf or result makes itself."""
        errors = dict(self.operations.errors)
        errors.update((leaf["name"], error_of_constant(leaf, self.scalar)) for leaf in self.leaves if is_constant(leaf))
        for leaf in self.leaves:
            if not is_sine(leaf):
                continue
            angle = angle_of(leaf)
            by = self.operations.derivatives(angle, self.sizes) if angle else {}
            of_angle = sum(abs(derivative) * errors.get(name, 0.0) for name, derivative in by.items())
            errors[leaf["name"]] = of_sines + of_angle
        return errors

    def required(self, output, source):
        """By name: the errors that reach the output."""
        field = in_field(self.scalar)
        values = self.operations.evaluate(self.leaves_in_field(source), field)
        derivatives = self.operations.derivatives(output.tree, values, field)
        required = {name: self.errors.get(name, 0.0) for name, by in derivatives.items() if by}
        if not output.file.exists() and any(required.values()):
            raise FileNotFoundError(f"{output.file.name} is missing: {output.name} can have an error")
        return {name: error for name, error in required.items() if error > 0}

    def random_state(self, source):
        fast = source.random() < 0.5
        state = {}
        for leaf in self.leaves:
            if "limit" in leaf:
                size = source.choice([-1, 1]) if fast else source.uniform(-1, 1)
                state[leaf["name"]] = size * leaf["limit"]
            elif is_sine(leaf):
                state.setdefault("angle_" + leaf["name"][2:], source.uniform(-math.pi, math.pi))
        return state

    def near(self, state, source):
        """A state beside another one: one number is drawn anew, or an angle turned a little."""
        result = dict(state)
        name = source.choice(sorted(state)) if state else None
        if name is None:
            return result
        if name.startswith("angle_"):
            result[name] += source.gauss(0, 0.3)
        else:
            limit = next(leaf["limit"] for leaf in self.leaves if leaf["name"] == name)
            result[name] = source.choice([-limit, limit, source.uniform(-limit, limit)])
        return result

    def values_of_leaves(self, state, arithmetic, is_exact):
        values = {}
        for leaf in self.leaves:
            name = leaf["name"]
            if "limit" in leaf:
                value = rounded_to_float(state[name]) if self.scalar == "float" else state[name]
                values[name] = arithmetic.constant(value)
            elif is_sine(leaf):
                angle = mpmath.mpf(state["angle_" + name[2:]])
                value = mpmath.sin(angle) if name[0] == "s" else mpmath.cos(angle)
                values[name] = value if is_exact else arithmetic.rounded(float(value))
        for leaf in self.leaves:
            name = leaf["name"]
            if is_constant(leaf):
                values[name] = exact_constant(leaf) if is_exact else arithmetic.constant(leaf["meaning"])
            elif leaf["meaning"].startswith("sign("):
                x = values[leaf["meaning"][5:-1]]
                values[name] = (x > 0) - (x < 0)
        return values

    def leaves_in_field(self, source):
        field, values = in_field(self.scalar), {}
        tangents = {leaf["name"][2:]: source.randrange(PRIME) for leaf in self.leaves}  # of half of each angle
        for leaf in self.leaves:
            name = leaf["name"]
            if is_sine(leaf):
                t = tangents[name[2:]]
                values[name] = (2 * t if name[0] == "s" else 1 - t * t) * pow(1 + t * t, -1, PRIME) % PRIME
            elif is_constant(leaf):
                values[name] = field.constant(leaf["meaning"])
            else:
                values[name] = source.randrange(PRIME) if "limit" in leaf else source.choice([-1, 1])
        return values

    def ratios(self, state):
        """By hypothesis: the size at this state over the size that it states."""
        values = self.operations.evaluate(self.values_of_leaves(state, PLAIN, False), PLAIN)
        for name, bound in zip(self.operations.names, self.operations.bounds):
            yield f"the size of {name}", ratio(abs(values[name]), bound)
        for output in self.outputs:
            by = self.operations.derivatives(output.tree, values)
            for group in output.groups:
                names = ", ".join(group.names())
                yield f"the derivative of {output.name} by {names}", ratio(group.size(by), group.bound)

    def search(self, states, source):
        for _ in range(states):
            self.note(self.random_state(source))
        hardest = sorted(self.worst, key=lambda what: -self.worst[what][0])[:10]
        for what in hardest:
            for _ in range(max(1, states // 20)):
                self.note(self.near(self.worst[what][1], source))

    def note(self, state):
        for what, share in self.ratios(state):
            if share > self.worst.get(what, (-1, None))[0]:
                self.worst[what] = (share, state)

    def error_ratios(self, states, source):
        """By output: the largest error over its bound."""
        worst = {output.name: 0.0 for output in self.outputs}
        arithmetic = certified(self.scalar)
        for _ in range(states):
            state = self.random_state(source)
            rounded = self.operations.evaluate(self.values_of_leaves(state, arithmetic, False), arithmetic)
            exact = self.operations.evaluate(self.values_of_leaves(state, EXACT, True), EXACT)
            for output in self.outputs:
                error = abs(mpmath.mpf(value_of(output.tree, rounded, arithmetic)) -
                            value_of(output.tree, exact, EXACT))
                worst[output.name] = max(worst[output.name], ratio(float(error), output.bound))
        return worst
