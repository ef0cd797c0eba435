# SPDX-License-Identifier: GPL-2.0-or-later
"""The header's rounding_is_as_written(): that its text is the one below, and that it expects the right results."""

import re
import struct
from fractions import Fraction

from certificate_check.arithmetic import as_written, rounded_to
from certificate_check.sines import Sines, bodies, squeezed, uses_polynomials

TEXT = r"""
template <class Scalar>
static void fill(Scalar* x, int count, uint32_t seed) noexcept {
  for (int k = 0; k < count; ++k) {
    seed = seed * 1664525u + 1013904223u;
    x[k] = (Scalar(seed >> 8) - Scalar(8388608.0)) / Scalar(8388608.0);
  }
}
{sines}
template <class Scalar>
static void fill_sines(Scalar* sine, Scalar* cosine, int count, uint32_t seed) noexcept {
  fill(sine, count, seed);
  for (int k = 0; k < count; ++k) {
    const Scalar t = sine[k], square = t * t, divisor = Scalar(1.0) + square;
    sine[k] = Scalar(2.0) * t / divisor;
    cosine[k] = (Scalar(1.0) - square) / divisor;
  }
}
{/sines}
template <class Scalar>
static uint64_t hash_of(const Scalar* x, int count, uint64_t hash) noexcept {
  for (int k = 0; k < count; ++k) {
    const bool is_number = x[k] < Scalar(0.0) || x[k] >= Scalar(0.0);
    uint64_t bits = 0;
    if constexpr (sizeof(Scalar) == sizeof(float)) {
      uint32_t of_float = 0;
      memcpy(&of_float, x + k, sizeof(of_float));
      bits = of_float;
    } else {
      memcpy(&bits, x + k, sizeof(bits));
    }
    hash = (hash ^ (is_number ? bits : 0u)) * 1099511628211u;
    hash ^= hash >> 32;
  }
  return hash;
}
{own}
template <class Scalar>
static bool sines_are_right() noexcept {
  const volatile Scalar zero = Scalar(0.0);
  const Scalar angles[8] = {
      Scalar(0.5), Scalar(0.6875), Scalar(1.28125), Scalar(1.53125), Scalar(1.796875),
      Scalar(3.125), Scalar(10.28125), Scalar(11.125)
  };
  Scalar x[8], s[8], c[8];
  for (int k = 0; k < 8; ++k) x[k] = angles[k] + zero;
  PolynomialSinCos()(x, Joints<0, 1, 2, 3, 4, 5, 6, 7>(), s, c);
  const uint64_t hash = hash_of(c, 8, hash_of(s, 8, 14695981039346656037u));
  return hash == (sizeof(Scalar) == sizeof(float) ? 0x803948b6889bcc50u : 0x7b037ac8b2e0683cu);
}
{/own}
{library}
template <class Scalar>
static bool sines_are_right() noexcept {
  const volatile Scalar zero = Scalar(0.0);
  const Scalar angles[8] = {
      Scalar(0.5), Scalar(0.6875), Scalar(1.28125), Scalar(1.53125), Scalar(1.796875),
      Scalar(3.125), Scalar(10.28125), Scalar(11.125)
  };
  const Scalar sines[8] = {
      Scalar(0.479425538604203), Scalar(0.6346070800152693), Scalar(0.9583735057581397),
      Scalar(0.999218145922396), Scalar(0.9745528811569866), Scalar(0.016591892229347906),
      Scalar(-0.7555360776363961), Scalar(-0.9916361774750792)
  };
  const Scalar cosines[8] = {
      Scalar(0.8775825618903728), Scalar(0.7728349461524715), Scalar(0.28551746612221973),
      Scalar(0.03953601977196579), Scalar(-0.2241577164155103), Scalar(-0.9998623450816866),
      Scalar(-0.6551070411694638), Scalar(0.12906467960915324)
  };
  const Scalar places = Scalar(sizeof(Scalar) == sizeof(float) ? 8388608.0 : 4503599627370496.0);
  Scalar x[8], s[8], c[8];
  for (int k = 0; k < 8; ++k) x[k] = angles[k] + zero;
  LibrarySinCos()(x, Joints<0, 1, 2, 3, 4, 5, 6, 7>(), s, c);
  const auto is_near = [places](Scalar a, Scalar b) {
    const Scalar error = (a - b) * places, size = b < Scalar(0.0) ? -b : b;
    return error <= size && -error <= size;
  };
  bool right = true;
  for (int k = 0; k < 8; ++k) right &= is_near(s[k], sines[k]) && is_near(c[k], cosines[k]);
  return right;
}
{/library}
}
template <class Scalar = Real>
static bool rounding_is_as_written() noexcept {
  constexpr bool is_float = sizeof(Scalar) == sizeof(float);
  constexpr int method = FLT_EVAL_METHOD;
  if (method != 0 && method != 16 && (is_float || method != 1)) return false;
  const volatile Scalar u = Scalar(0.1), w = Scalar(0.7), one = Scalar(1.0), tiny = Scalar(1e-17),
      nine = Scalar(9.0), seven = Scalar(7.0), half = Scalar(0.5), zero = Scalar(0.0),
      half_a_place = is_float ? Scalar(0x1.001p-24) : Scalar(0x1.001p-53),
      smallest = is_float ? Scalar(0x1p-126) : Scalar(0x1p-1022);
  const volatile Scalar product = u * w, quotient = nine / seven, next = one + half_a_place;
  const Scalar x = one, y = tiny, nothing = zero, infinite = one / nothing, no_number = nothing / nothing;
  const auto is_zero = [](Scalar r) { return !(r < Scalar(0.0)) && !(r > Scalar(0.0)); };
  if (!is_zero(u * w - product)
      || !(next > one)
      || !is_zero((x + y) - x)
      || !is_zero((x - y) - x)
      || !is_zero(nine / Scalar(7.0) - quotient)
      || !(smallest * half > Scalar(0.0))
      || !(Scalar(1.0) / (Scalar(0.0) - nothing) > Scalar(0.0))
      || Scalar(0.0) * infinite < Scalar(1.0)
      || Scalar(0.0) * no_number < Scalar(1.0)) {
    return false;
  }
{sines}
  if (!detail::sines_are_right<Scalar>()) return false;
{/sines}
  const volatile uint32_t first = 0;
  const uint32_t seed = first;
  uint64_t hash = 14695981039346656037u;
"""
NAME = "rounding_is_as_written"
FILL = re.compile(r"detail::fill\((\w+), (\d+), (?:seed \+ )?(\d+)u\)")
FILL_SINES = re.compile(r"detail::fill_sines\(sine, cosine, (\d+), seed \+ (\d+)u\)")
CALL = re.compile(r"(?:result\[0\] = )?(\w+)\([\w, +]*\)")
DECLARATION = re.compile(r"Scalar \w+\[\d+\](, \w+\[\d+\])*|const GivenSinCos<Scalar> given = \{sine, cosine\}")
HASH = re.compile(r"hash = detail::hash_of\(result, (\d+), hash\)")
VERDICT = re.compile(r"return hash == \(is_float \? (0x[0-9a-f]+)u : (0x[0-9a-f]+)u\)")
WORD = 2**64 - 1


def expected(has_sines, has_polynomials):
    parts = {"sines": has_sines, "own": has_sines and has_polynomials, "library": has_sines and not has_polynomials}
    text = TEXT
    for part, is_there in parts.items():
        text = re.sub(rf"\{{{part}\}}(.*?)\{{/{part}\}}", r"\1" if is_there else "", text, flags=re.S)
    return squeezed(text)


def filled(count, seed):
    numbers = []
    for _ in range(count):
        seed = (seed * 1664525 + 1013904223) % 2**32
        numbers.append(Fraction((seed >> 8) - 8388608, 8388608))
    return numbers


def with_numbers(leaves, name, numbers):
    leaves.update((f"{name}_{k + 1}", number) for k, number in enumerate(numbers))


def with_sines(leaves, tangents, rounded):
    for k, t in enumerate(tangents):
        square = rounded(t * t)
        divisor = rounded(1 + square)
        leaves[f"s_{k + 1}"] = rounded(rounded(2 * t) / divisor)
        leaves[f"c_{k + 1}"] = rounded(rounded(1 - square) / divisor)


def hash_of(numbers, scalar, value):
    number_as, bits_as = ("<f", "<I") if scalar == "float" else ("<d", "<Q")
    for number in numbers:
        bits = struct.unpack(bits_as, struct.pack(number_as, rounded_to(scalar, number)))[0]
        value = (value ^ bits) * 1099511628211 & WORD
        value ^= value >> 32
    return value


class State:
    """The state at which all functions are called, and the hash of their results."""

    def __init__(self, header, scalar):
        self.header, self.scalar, self.arithmetic = header, scalar, as_written(scalar, True)
        self.leaves, self.results, self.called, self.hash = {}, [], [], 14695981039346656037

    def follow(self, statement):
        """Carries out a statement; returns whether it is one of those that should be there."""
        if found := FILL.fullmatch(statement):
            self.fill(found[1], filled(int(found[2]), int(found[3])))
        elif found := FILL_SINES.fullmatch(statement):
            with_sines(self.leaves, filled(int(found[1]), int(found[2])), self.arithmetic.rounded)
        elif found := HASH.fullmatch(statement):
            self.hash = hash_of(self.results[:int(found[1])], self.scalar, self.hash)
            return int(found[1]) == len(self.results)
        elif (found := CALL.fullmatch(statement)) and found[1] in self.header.functions:
            self.call(self.header.functions[found[1]])
        else:
            return DECLARATION.fullmatch(statement) is not None
        return True

    def fill(self, name, numbers):
        if name == "result":
            self.results = numbers
        else:
            with_numbers(self.leaves, name, numbers)

    def call(self, function):
        values = function.evaluate(self.leaves, self.arithmetic)
        before = self.results if len(self.results) == len(function.outputs) else [0] * len(function.outputs)
        self.results = [values.get(name, old) for name, old in zip(function.outputs, before)]
        self.called.append(function.name)


def hash_at_state(statements, header, scalar):
    """The hash of the results of all functions, or nothing if statements are others than they should be."""
    state = State(header, scalar)
    is_known = all([state.follow(statement) for statement in statements])
    return state.hash if is_known and state.called == list(header.functions) else None


def faults_of_sines(header, fixed):
    """Where sines_are_right() expects other bits than those of the header's polynomials."""
    wanted = re.search(r"sizeof\(float\) \? (0x[0-9a-f]+)u : (0x[0-9a-f]+)u", fixed)
    angles = [float(text) for text in re.search(r"angles\[8\] = \{(.*?)\};", fixed)[1].replace("Scalar(", "")
              .replace(")", "").split(",")]
    text = bodies(header.text)
    for scalar, expected_hash in zip(("float", "double"), wanted.groups()):
        sines, cosines = zip(*map(Sines(text[scalar], scalar), angles)) if text else ((), ())
        found = hash_of(cosines, scalar, hash_of(sines, scalar, 14695981039346656037))
        if found != int(expected_hash, 16):
            yield f"sines_are_right() expects other bits in {scalar} than those of the header's polynomials"


def faults(header, has_sines):
    """What is wrong with the header's rounding_is_as_written()."""
    has_polynomials = uses_polynomials(header.text)
    text, fixed = squeezed(header.text), expected(has_sines, has_polynomials)
    begin = text.find(fixed)
    if begin < 0 or text.count(f" {NAME}(") != 1 or text.count("#define ") != (2 if has_polynomials else 1):
        yield f"{NAME}() is not the one that flatdyn writes"
        return
    body, _, rest = text[begin + len(fixed):].partition(" }")
    *statements, verdict, _ = [statement.strip() for statement in body.split(";")]
    if has_sines and has_polynomials:
        yield from faults_of_sines(header, fixed)
    found = VERDICT.fullmatch(verdict)
    hashes = [hash_at_state(statements, header, scalar) for scalar in ("float", "double")]
    if not found or None in hashes or not re.fullmatch(r" \} #endif", rest):
        yield f"{NAME}() is not the one that flatdyn writes"
    elif [int(found[1], 16), int(found[2], 16)] != hashes:
        yield f"{NAME}() expects other results than those of the header's functions"
