# SPDX-License-Identifier: GPL-2.0-or-later
"""The header's own sines and cosines: their statements are carried out in the certified arithmetic, and compared with
exact values and with the scripts for Gappa; what those take for granted of polynomials is proven in rational numbers."""

import math
import re
import struct
from fractions import Fraction

import mpmath

from certificate_check.arithmetic import rounded_to
from certificate_check.known import section

LANES = {"double": "Doubles", "float": "Floats"}
RANGE = {"double": 1e5, "float": 6400.0}
STEP_OF_QUADRANTS = {"double": 1.5 * 2**52, "float": 1.5 * 2**23}
QUARTER_TURNS = {"double": float.fromhex("0x1.45f306dc9c883p-1"), "float": float.fromhex("0x1.45f306p-1")}
# The bits of a number, and what is added to those of `turns`.
BITS = {"double": ("d", "Q", 0x4000000000001), "float": ("f", "I", 0x200001)}
LITERAL = re.compile(r"-?0x[0-9a-f.]+p[+-]\d+f?|-?\b\d+\.\d+(?:e[+-]\d+)?f?|\b1\b")
LARGEST_REMAINDER = Fraction(786, 1000)
PIECES = 64  # of the polynomials' range
PROOFS = ("reduction", "sine", "cosine", "cosine_near_1")


class Number:
    """A number of the scalar; every operation rounds. Of floats it rounds twice, which changes nothing: a double has
    more than twice their digits."""

    def __init__(self, scalar, value):
        self.scalar, self.value = scalar, rounded_to(scalar, value)

    def __add__(self, other):
        return Number(self.scalar, self.value + other.value)

    def __sub__(self, other):
        return Number(self.scalar, self.value - other.value)

    def __mul__(self, other):
        return Number(self.scalar, self.value * other.value)


class Polynomial:
    """An exact polynomial in z; the first coefficient is the constant."""

    def __init__(self, coefficients):
        self.coefficients = list(coefficients)

    def __add__(self, other):
        length = max(len(self.coefficients), len(other.coefficients))
        padded = [each.coefficients + [0] * (length - len(each.coefficients)) for each in (self, other)]
        return Polynomial(map(sum, zip(*padded)))

    def __mul__(self, other):
        result = [Fraction(0)] * (len(self.coefficients) + len(other.coefficients) - 1)
        for i, a in enumerate(self.coefficients):
            for j, b in enumerate(other.coefficients):
                result[i + j] += a * b
        return Polynomial(result)

    def __sub__(self, other):
        return self + other * Polynomial([-1])

    def bound(self, low, high):
        """A bound of its size from `low` to `high`: the largest of its coefficients in Bernstein's basis there."""
        shifted = Polynomial([0])
        for coefficient in reversed(self.coefficients):
            shifted = shifted * Polynomial([low, high - low]) + Polynomial([coefficient])
        own, degree = shifted.coefficients, len(shifted.coefficients) - 1
        return max(abs(sum(own[i] * math.comb(k, i) / Fraction(math.comb(degree, i)) for i in range(k + 1)))
                   for k in range(degree + 1))


def in_python(expression):
    return LITERAL.sub(lambda found: f"number('{found[0]}')", expression)


def value_of(literal):
    return float.fromhex(literal.rstrip("f")) if "x" in literal else float(literal.rstrip("f"))


def followed(statements, values):
    """Carries out the statements whose names have values."""
    for name, code in statements:
        if all(used in values for used in code.co_names):
            values[name] = eval(code, {"__builtins__": {}}, values)
    return values


def body(scalar):
    """The statements of sine_and_cosine() that are sums and products: of the known text, which is the header's."""
    text = re.sub(r"(?<=[*(=+-] )- (?=\d)", "-", " ".join(section("sines", {})))  # signs of numbers
    begin = f"sine_and_cosine ( const {LANES[scalar]} & x , {LANES[scalar]} & sine , {LANES[scalar]} & cosine ) noexcept {{"
    statements = text.split(begin)[1].split("}")[0].split(" ;")
    return [each.strip() for each in statements if each.strip().startswith(f"const {LANES[scalar]} ")]


def in_exact_arithmetic(statements, scalar):
    """Constants, and the polynomials p and k of z that are made of them."""
    values = {"number": lambda literal: Polynomial([Fraction(rounded_to(scalar, value_of(literal)))]),
              "z": Polynomial([0, 1]), "zz": Polynomial([0, 0, 1])}
    return followed([each for each in statements if re.fullmatch(r"[pkSC]\d?", each[0])], values)


class Sines:
    """The statements of sine_and_cosine() for one scalar."""

    def __init__(self, scalar):
        self.scalar, self.statements = scalar, []
        for statement in body(scalar):
            for definition in statement.removeprefix(f"const {LANES[scalar]} ").split(" , "):
                name, expression = definition.split(" = ")
                self.statements.append((name, compile(in_python(expression), name, "eval")))

    def number(self, literal):
        return Number(self.scalar, value_of(literal))

    def values(self, x):
        number, step = Number(self.scalar, x), Number(self.scalar, STEP_OF_QUADRANTS[self.scalar])
        turns = number * Number(self.scalar, QUARTER_TURNS[self.scalar]) + step
        form, integer, added = BITS[self.scalar]
        bits = struct.unpack(integer, struct.pack(form, turns.value))[0] + added
        next_turns = Number(self.scalar, struct.unpack(form, struct.pack(integer, bits))[0])
        n = next_turns - Number(self.scalar, step.value / 6 * 7 + 1)
        return followed(self.statements, {"number": self.number, "x": number, "turns": turns, "n": n})

    def polynomials(self):
        """p and k of z, in exact arithmetic."""
        values = in_exact_arithmetic(self.statements, self.scalar)
        return values["p"], values["k"]

    def __call__(self, x):
        values = self.values(x)
        quadrant = int(values["turns"].value - STEP_OF_QUADRANTS[self.scalar])
        sine, cosine = values["s"].value, values["c"].value
        if quadrant & 1:
            sine, cosine = cosine, sine
        return -sine if quadrant & 2 else sine, -cosine if (quadrant + 1) & 2 else cosine


class Proof:
    """A script for Gappa about sines: its definitions, and its hypothesis about the polynomial."""

    def __init__(self, file):
        text = re.sub(r"#.*", "", file.read_text())
        self.name, definitions = file.name, text[:text.index("{")]
        self.statements = []
        for name, expression in re.findall(r"^(\w+) (?:rnd)?= ([^;]+);", definitions, re.M):
            plain = re.sub(r"\brnd\(", "(", expression).strip()
            self.statements.append((name, compile(in_python(plain), name, "eval")))
        self.assumed, self.missing = (self.bound_of(what, text) for what in (r"M - [SC]", "missing"))

    @staticmethod
    def bound_of(what, text):
        """The bound in |what| <= 1.9e-16 or 1b-53, if it is there."""
        found = re.search(rf"\|{what}\| <= ([\d.e-]+)(?:b(-?\d+))?", text)
        return Fraction(found[1]) * Fraction(2) ** int(found[2] or 0) if found else None

    def values(self, given, number):
        return followed(self.statements, {**given, "number": number})


def angles_to_try(scalar, count, source):
    """Angles of all sizes, and those next to multiples of a quarter turn, where digits cancel."""
    for _ in range(count):
        yield rounded_to(scalar, source.uniform(-1, 1) * RANGE[scalar] * 2.0**-source.randrange(0, 20))
        multiple = source.randrange(0, int(RANGE[scalar] * 2 / 3.1415927)) + source.choice([0, 0.5])
        yield rounded_to(scalar, float(multiple * mpmath.pi / 2))


def largest_error(sines, angles):
    """The largest error of a sine or cosine, and the angle."""
    worst = 0.0, 0.0
    for angle in angles:
        for computed, exact in zip(sines(angle), (mpmath.sin(angle), mpmath.cos(angle))):
            worst = max(worst, (float(abs(computed - exact)), angle))
    return worst


def taylor(first):
    """The series of sine (first: 3) or cosine (2) in z, from the term with that power of r on."""
    return Polynomial([Fraction((-1) ** (first // 2 + i), math.factorial(first + 2 * i)) for i in range(8)])


def error_of(polynomial, first, size_of_missing):
    """How far M is from a sine or cosine of r - missing."""
    difference, most = polynomial - taylor(first), 0
    square = LARGEST_REMAINDER**2
    for piece in range(PIECES):
        low, high = square * piece / PIECES, square * (piece + 1) / PIECES
        most = max(most, difference.bound(low, high) * high ** (first // 2) * (LARGEST_REMAINDER if first == 3 else 1))
    tail = LARGEST_REMAINDER ** (first + 16) / math.factorial(first + 16)
    # sin(r - missing) has -cos(r) missing, and M -(1 - r^2 / 2) missing; cos(r - missing) has sin(r) missing, and M
    # r missing.
    slope = LARGEST_REMAINDER**4 / 24 if first == 3 else LARGEST_REMAINDER**3 / 6
    return most + tail + slope * size_of_missing + size_of_missing**2 / 2


def faults_of_proofs(sines, folder, angles):
    """Where the scripts for Gappa are not about these statements, or take for granted what does not hold."""
    proofs = {name: Proof(folder / f"sines.{name}.g") for name in PROOFS}
    for angle in angles:
        values = sines.values(angle)
        for proof in proofs.values():
            given = {"x": values["x"], "n": values["n"], "r_": values["r"], "missing_": values["missing"]}
            if proof.assumed is None:
                del given["r_"], given["missing_"]
            for name, value in proof.values(given, sines.number).items():
                if name in ("r", "missing", "z", "p", "k", "s", "c") and value.value != values[name].value:
                    yield f"{proof.name} is not about the header's {name} at {angle!r}"
                    return
    polynomials = dict(zip("pk", sines.polynomials()))
    for proof in proofs.values():
        values = in_exact_arithmetic(proof.statements, sines.scalar)
        for name in set(values) & set(polynomials):
            if values[name].coefficients != polynomials[name].coefficients:
                yield f"{proof.name} is about another polynomial {name} than the header's"
    if len({proof.missing for proof in proofs.values()}) != 1:
        yield "the scripts about sines differ in how large the missing part of an angle is"
    for name, polynomial, first in zip(("sine", "cosine"), polynomials.values(), (3, 2)):
        # The sine subtracts p; the cosine has 1 - z / 2 before k.
        of_z = polynomial * Polynomial([-1]) if first == 3 else (
            polynomial * Polynomial([0, 1]) - Polynomial([Fraction(1, 2)]))
        error = error_of(of_z, first, proofs[name].missing)
        if not error <= proofs[name].assumed:
            yield f"{proofs[name].name} takes {float(proofs[name].assumed):.3g} for an error of {float(error):.3g}"


def faults(header, scalar, error, folder, states, source):
    """What is wrong with the header's own sines, if it has any. `error`: how far off a certificate lets them be."""
    if not header.has_sines:
        return
    sines = Sines(scalar)
    found, angle = largest_error(sines, angles_to_try(scalar, states, source))
    print(f"sines: errors of up to {100 * found / error:.3g} % of what is stated, at {2 * states} angles")
    if found > error:
        yield f"a sine of {angle!r} is off by {found:.6g}, more than {error:.6g}"
    yield from faults_of_proofs(sines, folder, angles_to_try(scalar, max(1, states // 10), source))
