# SPDX-License-Identifier: GPL-2.0-or-later
"""The header's rounding_is_as_written(): that it calls all functions at the known state, and expects the right results.
The text before that is compared word by word when the header is read."""

import re
import struct
from fractions import Fraction

from certificate_check.arithmetic import as_written, rounded_to
from certificate_check.known import section
from certificate_check.sines import Sines
from certificate_check.tokens import tokens_of

NAME = "rounding_is_as_written"
SEEDS = {"q": 1, "qd": 2, "qdd": 3, "tau": 4, "h_e": 5, "qd_r": 7, "qdd_r": 8, "pi_b": 9, "g_b": 10, "v": 11, "a": 12,
         "v_r": 13, "a_r": 14, "weights": 15, "direction": 17}
SEED_OF_TANGENTS = 16
HASH_OF_NOTHING = 14695981039346656037
VERDICT = re.compile(r"return hash == \( is_float \? (0x[0-9a-f]{16})u : (0x[0-9a-f]{16})u \) ;")
WORD = 2**64 - 1


def filled(count, seed):
    numbers = []
    for _ in range(count):
        seed = (seed * 1664525 + 1013904223) % 2**32
        numbers.append(Fraction((seed >> 8) - 8388608, 8388608))
    return numbers


def sines_of(tangents, rounded):
    for k, t in enumerate(tangents):
        square = rounded(t * t)
        divisor = rounded(1 + square)
        yield f"s_{k + 1}", rounded(rounded(2 * t) / divisor)
        yield f"c_{k + 1}", rounded(rounded(1 - square) / divisor)


def hash_of(numbers, scalar, value):
    number_as, bits_as = ("<f", "<I") if scalar == "float" else ("<d", "<Q")
    for number in numbers:
        bits = struct.unpack(bits_as, struct.pack(number_as, rounded_to(scalar, number)))[0]
        value = (value ^ bits) * 1099511628211 & WORD
        value ^= value >> 32
    return value


def sizes_of_results(function):
    """The number of entries of each result."""
    written = {name: sum(output.startswith(name + "[") for output in function.outputs) for name in function.results}
    sizes = []
    for name in function.results:
        size = 1
        for length in function.shapes.get(name, [written[name]]):
            size *= length
        sizes.append(size)
    return sizes or [1]


class KnownState:
    """The state at which all functions are called: its arrays, the calls, and the hash of the results."""

    def __init__(self, header):
        self.header, self.functions = header, list(header.functions.values())
        self.asks_sines = any(function.asked is not None for function in self.functions)
        read = {name for function in self.functions for name in self.arrays_of(function)}
        self.lengths = {name: header.length_of(name) for name in sorted(read, key=SEEDS.get)}
        self.angles = next(header.constants[name] for name in ("angle_count", "position_count", "joint_count")
                           if name in header.constants)

    def arrays_of(self, function):
        """The names of the arrays that a function takes. Those that have none in functions without a shape, as they have
        no entries, are named where the function is called."""
        if None not in function.arrays:
            return function.arrays
        found = re.search(rf"\b{function.name} \( ([\w ,+]*) \) ;", " ".join(self.header.calls))
        names = re.findall(r"\w+", found[1])[:len(function.arrays)] if found else []
        if any(name not in (None, other) for name, other in zip(function.arrays, names)) or not set(names) <= set(SEEDS):
            raise ValueError(f"{NAME}() calls {function.name} with other arguments than it has")
        function.arrays = names
        return names

    def text(self):
        """The statements that there should be, up to the one that returns the answer."""
        sizes = {function.name: sizes_of_results(function) for function in self.functions}
        arrays = [f"{name}[{max(length, 1)}]" for name, length in self.lengths.items()]
        fills = [f"detail::fill({name}, {length}, seed + {SEEDS[name]}u);" for name, length in self.lengths.items()]
        if self.asks_sines:
            arrays += [f"{name}[{max(self.angles, 1)}]" for name in ("sine", "cosine")]
            fills.append(f"detail::fill_sines(sine, cosine, {self.angles}, seed + {SEED_OF_TANGENTS}u);")
            fills.append("const GivenSinCos<Scalar> given = {sine, cosine};")
        arrays.append(f"result[{max(sum(each) for each in sizes.values())}]")
        calls = [self.call(function, sizes[function.name]) for function in self.functions]
        return f"Scalar {', '.join(arrays)}; {' '.join(fills)} {' '.join(calls)}"

    @staticmethod
    def call(function, sizes):
        arguments, offset = list(function.arrays), 0
        for size in sizes if function.results else []:
            arguments.append(f"result + {offset}" if offset else "result")
            offset += size
        if function.asked is not None:
            arguments.append("given")
        begin = "result[0] = " if function.gives_number else ""
        before = f"detail::fill(result, {sum(sizes)}, 0u); " if function.leaves_out else ""
        return (f"{before}{begin}{function.name}({', '.join(arguments)}); "
                f"hash = detail::hash_of(result, {sum(sizes)}, hash);")

    def hash(self, scalar):
        arithmetic = as_written(scalar, True)
        leaves = {f"{name}_{k + 1}": number for name, length in self.lengths.items()
                  for k, number in enumerate(filled(length, SEEDS[name]))}
        if self.asks_sines:
            leaves.update(sines_of(filled(self.angles, SEED_OF_TANGENTS), arithmetic.rounded))
        value = HASH_OF_NOTHING
        for function in self.functions:
            values, sizes = function.evaluate(leaves, arithmetic), sizes_of_results(function)
            names = [f"{name}[{k}]" for name, size in zip(function.results, sizes) for k in range(size)]
            results = filled(sum(sizes), 0)
            for k, name in enumerate(names or function.outputs):
                results[k] = values.get(name, results[k])
            value = hash_of(results, scalar, value)
        return value


def faults_of_sines():
    """Where sines_are_right() expects other bits than those of the polynomials."""
    fixed = " ".join(section("rounding_of_sines", {}))
    wanted = re.search(r"sizeof \( float \) \? (0x[0-9a-f]+)u : (0x[0-9a-f]+)u", fixed)
    angles = [float(text) for text in re.findall(r"Scalar \( ([\d.]+) \)", re.search(r"angles \[ 8 \] = {(.*?)}", fixed)[1])]
    for scalar, expected in zip(("float", "double"), wanted.groups()):
        sines, cosines = zip(*map(Sines(scalar), angles))
        if hash_of(cosines, scalar, hash_of(sines, scalar, HASH_OF_NOTHING)) != int(expected, 16):
            yield f"sines_are_right() expects other bits in {scalar} than those of the header's polynomials"


def faults_of_sizes(header):
    """Where results have other entries than there is room for, or a table of zeros says another thing."""
    for function in header.functions.values():
        sizes = sizes_of_results(function)
        if len(function.outputs) > sum(sizes) or (len(function.outputs) < sum(sizes) and not function.leaves_out):
            yield f"{function.name} writes {len(function.outputs)} entries, and its results have {sum(sizes)}"
        matrices = [(name, size) for name, size in zip(function.results, sizes) if len(function.shapes.get(name, [])) == 2]
        zeros, tables = function.zeros(), function.tables
        wanted = [[int(f"{name}[{k}]" in function.outputs and f"{name}[{k}]" not in zeros) for k in range(size)]
                  for name, size in matrices]
        if function.shapes and [entries for _, entries in tables] != wanted:
            yield f"the header's tables of zeros are not those of {function.name}"
        if any(not re.fullmatch(rf"{function.name}(_\w+)?_nonzero(_\d+)?", name) for name, _ in tables):
            yield f"{function.name} has tables of another name"


def faults(header):
    """What is wrong with the header's rounding_is_as_written()."""
    yield from faults_of_sizes(header)
    if header.has_sines:
        yield from faults_of_sines()
    state = KnownState(header)
    text, wanted = header.calls, tokens_of(state.text())
    found = VERDICT.fullmatch(" ".join(text[len(wanted):]))
    if text[:len(wanted)] != wanted or not found:
        yield f"{NAME}() is not the one that flatdyn writes"
    elif [int(group, 16) for group in found.groups()] != [state.hash("float"), state.hash("double")]:
        yield f"{NAME}() expects other results than those of the header's functions"
