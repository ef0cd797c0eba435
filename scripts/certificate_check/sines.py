# SPDX-License-Identifier: GPL-2.0-or-later
"""The header's own sines and cosines: their statements are carried out in the certified arithmetic, and compared with
exact values and with the scripts for Gappa; what those take for granted of polynomials is proven in rational numbers."""

import math
import re
import struct
from fractions import Fraction

import mpmath

from certificate_check.arithmetic import rounded_to

TEXT = r"""
template <int... joint>
struct Joints {
  static constexpr int flatdyn_interface = 1;
};
struct LibrarySinCos {
  template <class Scalar, int... joint>
  void operator()(const Scalar* q, Joints<joint...>, Scalar* s, Scalar* c) const noexcept {
    using std::cos;
    using std::sin;
    ((s[joint] = sin(q[joint]), c[joint] = cos(q[joint])), ...);
  }
};
namespace detail {
#if defined(__GNUC__) && (defined(__SSE2__) || defined(__aarch64__))
#ifdef __AVX__
constexpr int bytes_of_doubles = 32;
#else
constexpr int bytes_of_doubles = 16;
#endif
typedef double Doubles __attribute__((vector_size(bytes_of_doubles)));
typedef uint64_t BitsOfDoubles __attribute__((vector_size(bytes_of_doubles)));
typedef float Floats __attribute__((vector_size(16)));
typedef uint32_t BitsOfFloats __attribute__((vector_size(16)));
#define GUARD_IN_LANES
#else
typedef double Doubles;
typedef uint64_t BitsOfDoubles;
typedef float Floats;
typedef uint32_t BitsOfFloats;
#endif
template <class = void>
static inline void sine_and_cosine(const Doubles& x, Doubles& sine, Doubles& cosine) noexcept {
  const Doubles turns = x * 0x1.45f306dc9c883p-1 + 0x1.8p+52;
  BitsOfDoubles quadrant, bits_of_s, bits_of_c;
  memcpy(&quadrant, &turns, sizeof(turns));
  const BitsOfDoubles next = quadrant + 0x4000000000001u;
  Doubles n;
  memcpy(&n, &next, sizeof(next));
  n -= 0x1.c000000000001p+52;
{doubles}
  memcpy(&bits_of_s, &s, sizeof(s));
  memcpy(&bits_of_c, &c, sizeof(c));
  const BitsOfDoubles exchange = (bits_of_s ^ bits_of_c) & (0u - (quadrant & 1u));
  bits_of_s ^= exchange ^ ((quadrant & 2u) << 62);
  bits_of_c ^= exchange ^ ((next & 2u) << 62);
  memcpy(&sine, &bits_of_s, sizeof(s));
  memcpy(&cosine, &bits_of_c, sizeof(c));
}
template <class = void>
static inline void sine_and_cosine(const Floats& x, Floats& sine, Floats& cosine) noexcept {
  const Floats turns = x * 0x1.45f306p-1f + 0x1.8p+23f;
  BitsOfFloats quadrant, bits_of_s, bits_of_c;
  memcpy(&quadrant, &turns, sizeof(turns));
  const BitsOfFloats next = quadrant + 0x200001u;
  Floats n;
  memcpy(&n, &next, sizeof(next));
  n -= 0x1.c00002p+23f;
{floats}
  memcpy(&bits_of_s, &s, sizeof(s));
  memcpy(&bits_of_c, &c, sizeof(c));
  const BitsOfFloats exchange = (bits_of_s ^ bits_of_c) & (0u - (quadrant & 1u));
  bits_of_s ^= exchange ^ ((quadrant & 2u) << 30);
  bits_of_c ^= exchange ^ ((next & 2u) << 30);
  memcpy(&sine, &bits_of_s, sizeof(s));
  memcpy(&cosine, &bits_of_c, sizeof(c));
}
template <class Lanes, class Scalar>
static inline Scalar evaluate(Lanes squares, const Scalar* q, const int* joints, int count,
    Scalar* s, Scalar* c) noexcept {
#ifdef GUARD_IN_LANES
  constexpr int lanes = sizeof(Lanes) / sizeof(Scalar);
#pragma GCC unroll 4
  for (int first = 0; first < count; first += lanes) {
    Lanes x = squares, sine, cosine;
#pragma GCC unroll 4
    for (int k = 0; k < lanes; ++k) x[k] = q[joints[first + k < count ? first + k : count - 1]];
    sine_and_cosine(x, sine, cosine);
    squares += x * x;
#pragma GCC unroll 4
    for (int k = 0; k < lanes; ++k) {
      const int joint = joints[first + k < count ? first + k : count - 1];
      s[joint] = sine[k];
      c[joint] = cosine[k];
    }
  }
  Scalar sum = squares[0];
#pragma GCC unroll 4
  for (int k = 1; k < lanes; ++k) sum += squares[k];
  return sum;
#else
  for (int k = 0; k < count; ++k) {
    const Scalar x = q[joints[k]];
    sine_and_cosine(x, s[joints[k]], c[joints[k]]);
    squares += x * x;
  }
  return squares;
#endif
}
template <class Scalar>
[[gnu::noinline, gnu::cold]] static void ask_library(Scalar most, const Scalar* q,
    const int* joints, int count, Scalar* s, Scalar* c) noexcept {
  for (int k = 0; k < count; ++k) {
    const Scalar x = q[joints[k]];
    if (x <= most && x >= -most) continue;
    s[joints[k]] = std::sin(x);
    c[joints[k]] = std::cos(x);
  }
}
template <int... joint>
static inline void sines_and_cosines(const double* q, Joints<joint...>, double* s,
    double* c) noexcept {
  static constexpr int joints[] = {joint...};
  constexpr int count = sizeof...(joint);
  constexpr double most = 1e5;
  const double squares = evaluate(Doubles{}, q, joints, count, s, c);
  if (!(squares <= most * most)) ask_library(most, q, joints, count, s, c);
}
template <int... joint>
static inline void sines_and_cosines(const float* q, Joints<joint...>, float* s,
    float* c) noexcept {
  static constexpr int joints[] = {joint...};
  constexpr int count = sizeof...(joint);
  constexpr float most = 6400.0f;
  const float squares = evaluate(Floats{}, q, joints, count, s, c);
  if (!(squares <= most * most)) ask_library(most, q, joints, count, s, c);
}
template <class Scalar, int... joint>
static inline void sines_and_cosines(const Scalar* q, Joints<joint...> all, Scalar* s,
    Scalar* c) noexcept {
  LibrarySinCos()(q, all, s, c);
}
}
struct PolynomialSinCos {
  template <class Scalar, int... joint>
  [[gnu::always_inline]] void operator()(const Scalar* q, Joints<joint...> all, Scalar* s,
      Scalar* c) const noexcept {
    detail::sines_and_cosines(q, all, s, c);
  }
};
template <class Scalar>
struct GivenSinCos {
  const Scalar* sine;
  const Scalar* cosine;
  template <int... joint>
  void operator()(const Scalar*, Joints<joint...>, Scalar* s, Scalar* c) const noexcept {
    ((s[joint] = sine[joint], c[joint] = cosine[joint]), ...);
  }
};
using DefaultSinCos = PolynomialSinCos;
"""
DEFAULT = "using DefaultSinCos = PolynomialSinCos;"
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


def uses_polynomials(text):
    return DEFAULT in text


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


def squeezed(text):
    """A text without comments, and with single spaces."""
    return " ".join(re.sub(r"//[^\n]*", "", text).split())


def bodies(text):
    """The statements of sine_and_cosine() in double and in float; nothing if the text around them is another one."""
    pattern = re.escape(squeezed(TEXT))
    for scalar in ("doubles", "floats"):
        pattern = pattern.replace(re.escape("{" + scalar + "}"), f"(?P<{scalar}>[^{{}}]*?)")
    found = re.findall(pattern, re.sub(r"\bFLATDYN_\w+_IN_LANES\b", "GUARD_IN_LANES", squeezed(text)))
    return dict(zip(("double", "float"), found[0])) if len(found) == 1 else None


def in_exact_arithmetic(statements, scalar):
    """Constants, and the polynomials p and k of z that are made of them."""
    values = {"number": lambda literal: Polynomial([Fraction(rounded_to(scalar, value_of(literal)))]),
              "z": Polynomial([0, 1]), "zz": Polynomial([0, 0, 1])}
    return followed([each for each in statements if re.fullmatch(r"[pkSC]\d?", each[0])], values)


class Sines:
    """The statements of sine_and_cosine() for one scalar."""

    def __init__(self, body, scalar):
        lanes = LANES[scalar]
        self.scalar, self.statements = scalar, []
        for statement in body.split(";"):
            declared = statement.split()
            if declared and declared[:2] != ["const", lanes]:
                raise ValueError(f"sines: no statement that flatdyn writes: {statement.strip()}")
            for definition in " ".join(declared[2:]).split(", ") if declared else []:
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
    if not uses_polynomials(header.text):
        return
    text = bodies(header.text)
    if set(re.findall(r"class SinCos = (\w+)", header.text)) - {"DefaultSinCos"}:
        yield "a function of the header has another default source of sines"
    if text is None:
        yield "the header's own sines are not those that flatdyn writes"
        return
    sines = Sines(text[scalar], scalar)
    found, angle = largest_error(sines, angles_to_try(scalar, states, source))
    print(f"sines: errors of up to {100 * found / error:.3g} % of what is stated, at {2 * states} angles")
    if found > error:
        yield f"a sine of {angle!r} is off by {found:.6g}, more than {error:.6g}"
    yield from faults_of_proofs(sines, folder, angles_to_try(scalar, max(1, states // 10), source))
