# SPDX-License-Identifier: GPL-2.0-or-later
"""The generated header that a certificate is about: its hash, limits and functions. It is read from the first token to
the last one; what flatdyn does not write for a certificate is refused with its line."""

import hashlib
import math
import re

from certificate_check.header_function import CHECK, ORDER, TAKEN, HeaderFunction
from certificate_check.known import WORDS
from certificate_check.reader import Reader
from certificate_check.tokens import tokens_of

COUNTS = ("joint_count", "position_count", "velocity_count", "angle_count")
NAMES = {"joint_names": "joint_count", "position_names": "position_count"}
LIMITS = {"q": ["position_lower", "position_upper"], "qd": ["velocity_limit"], "v": ["velocity_limit"],
          "qdd": ["acceleration_limit"], "a": ["acceleration_limit"], "tau": ["effort_limit"]}
TABLES = ("position_lower", "position_upper", "velocity_limit", "acceleration_limit", "effort_limit")
OF_QUATERNION, OF_ROTATION = (".qw", ".qx", ".qy", ".qz"), (".wx", ".wy", ".wz")
NUMBER = re.compile(r"\d+\.\d+(?:e[+-]?\d+)?|\d+e[+-]?\d+", re.A)
LENGTHS = {"h_e": 6, "g_b": 3}
OWN_LENGTHS = ("weights", "direction")  # each function says how long they are


class Header:
    """The header that was certified: its hash, its constants, and its functions."""

    def __init__(self, file):
        content = file.read_bytes()
        self.hash = "sha1:" + hashlib.sha1(content).hexdigest()
        self.name, self.constants, self.functions = file.stem, {}, {}
        self.reader = Reader(tokens_of(content.decode()))
        self.angles = HeaderFunction("angles", self.constants, ["q"], ["angle"])
        self.read()

    # Reading.

    def read(self):
        reader = self.reader
        self.begin()
        self.read_constants()
        reader.accept_section("sign", "namespace detail { template <class Scalar> static inline Scalar sign")
        reader.accept_section("zeros", "namespace detail { struct Zeros")
        reader.accept_section("multiply_add", "namespace detail { void fma")
        reader.expect_section("interface")
        self.has_sines = reader.accept_section("sines", "template <int... joint> struct Joints")
        if "angle_count" in self.constants:
            self.read_angles()
        while reader.word() == "inline" or reader.follows(tokens_of("template <class Scalar")):
            self.read_function()
        self.read_refusals()
        self.read_shapes()
        reader.expect_section("rounding")
        if self.has_sines:
            reader.expect_section("rounding_of_sines")
        reader.expect_section("rounding_begin")
        if self.has_sines:
            reader.expect_section("rounding_sines")
        reader.expect_section("rounding_state")
        self.calls = reader.up_to("return") + ["return", *reader.up_to(";"), ";"]
        reader.expect("}")
        reader.expect_section("end")
        if reader.at < len(reader.tokens):
            reader.fail(f"\"{reader.word()}\" behind the end")

    def begin(self):
        """Takes the guard, the includes, and the name of the namespace and of the scalar."""
        reader = self.reader
        guard = re.fullmatch(r"#ifndef (FLATDYN_[A-Z0-9_]+)", reader.word(), re.A)
        at = next((k for k, token in enumerate(reader.tokens) if token == "namespace"), 0)
        words = reader.tokens[at + 1:at + 7]
        if not guard or len(words) < 6:
            reader.fail("the guard of a header expected")
        reader.holes = {"GUARD": guard[1], "NAMESPACE": str(words[0]), "REAL": str(words[5])}
        if words[0].rstrip("_") != self.name.rstrip("_") or words[0] in WORDS or words[5] not in ("double", "float"):
            reader.fail(f"a namespace {words[0]} of {words[5]} in {self.name}.hpp")
        self.scalar = str(words[5])
        reader.expect_section("begin")
        if self.scalar == "double":
            reader.expect_section("doubles")
        reader.expect_section("name")

    def read_constants(self):
        reader = self.reader
        for name in COUNTS:
            if reader.accept(f"inline constexpr int {name} = "):
                self.constants[name] = reader.take_count()
                reader.expect(";")
        if "joint_count" not in self.constants:
            reader.fail("joint_count expected")
        for name, length in NAMES.items():
            self.table("const char*", name, length)
        for name in TABLES:
            self.table("Real", name, "joint_count")
        if reader.accept("inline constexpr int base_parameter_count = "):
            self.constants["base_parameter_count"] = reader.take_count()
            reader.expect(";")
            self.table("const char*", "base_parameter_names", "base_parameter_count")
            self.table("Real", "base_parameter_values", "base_parameter_count")

    def table(self, kind, name, length):
        """Takes a table of texts or numbers, if it is there."""
        reader = self.reader
        if not reader.accept(f"inline constexpr {kind} {name}[{length}] = {{"):
            return
        entries = [self.text() if kind == "const char*" else self.real()]
        while reader.accept(","):
            entries.append(self.text() if kind == "const char*" else self.real())
        reader.expect("};")
        if len(entries) != self.constants[length]:
            reader.fail(f"{name} has {len(entries)} entries")
        self.constants[name] = entries

    def text(self):
        """Takes a text, with its escapes resolved."""
        token = self.reader.take()
        if token[0] != '"':
            self.reader.fail("a text expected")
        escaped = re.compile(rb"\\([0-3][0-7][0-7]|[\"?\\])")
        content = token[1:-1].encode()
        if b"\\" in escaped.sub(b"", content):
            self.reader.fail(f"a text that is written in another way: {token}")
        return escaped.sub(lambda found: bytes([int(found[1], 8)]) if len(found[1]) == 3 else found[1], content).decode()

    def real(self):
        """Takes Real(-0.5) or Real(HUGE_VAL)."""
        reader = self.reader
        reader.expect("Real(")
        sign = -1 if reader.accept("-") else 1
        token = reader.take()
        if token != "HUGE_VAL" and not NUMBER.fullmatch(token):
            reader.fail("a number expected")
        reader.expect(")")
        return sign * (math.inf if token == "HUGE_VAL" else float(token))

    def read_angles(self):
        reader = self.reader
        reader.expect("namespace detail { template <class Scalar> static void angles(const Scalar* q, Scalar* angle) "
                      "noexcept {")
        self.angles.read(reader)
        reader.expect("}")
        if len(self.angles.outputs) != self.constants["angle_count"]:
            reader.fail("an angle that is not computed")

    def read_function(self):
        """Takes a function, and the tables in front of it that tell which of its entries are not always 0."""
        reader, tables = self.reader, []
        while reader.accept("inline constexpr bool"):
            tables.append(self.zero_table())
        asks = reader.accept("template <class Scalar, class SinCos = DefaultSinCos> static inline")
        if not asks:
            reader.expect("template <class Scalar> static inline")
        kind, name = reader.take_name(), reader.take_name()
        if kind not in ("void", "Scalar") or name in WORDS or name in self.functions or name in self.constants or (
                name[0] == "_"):
            reader.fail(f"a function {name} that flatdyn does not write")
        arrays, results = self.arguments(asks)
        reader.expect(") noexcept {" + CHECK)
        function = HeaderFunction(name, self.constants, arrays, results, kind == "Scalar")
        function.read(reader)
        if asks != (function.asked is not None):
            reader.fail(f"{name} has a source of sines that it does not ask")
        self.functions[name] = function
        function.tables = tables

    def zero_table(self):
        reader = self.reader
        name = reader.take_name()
        reader.expect("[")
        length = reader.take_count()
        reader.expect("] = {")
        entries = [reader.take_count()]
        while reader.accept(","):
            entries.append(reader.take_count())
        reader.expect("};")
        if len(entries) != length or not set(entries) <= {0, 1}:
            reader.fail(f"{name} has other entries than 0 and 1")
        return name, entries

    def arguments(self, asks):
        """Takes arguments up to their bracket; returns the names of arrays that are read, and of those that are
        written."""
        reader, arrays, results = self.reader, [], []
        reader.expect("(")
        while reader.word() != ")":
            if arrays or results:
                reader.expect(",")
            if asks and reader.accept("const SinCos& sin_cos = {}"):
                break
            is_read = reader.accept("const")
            reader.expect("Scalar*")
            name = reader.take_name() if reader.word() not in (",", ")") else None
            is_known = name in arrays + results or name in TAKEN or name in self.constants
            if (is_read and (results or name not in (*ORDER, None))) or (name is not None and is_known):
                reader.fail(f"an argument {name} that flatdyn does not write")
            (arrays if is_read else results).append(name)
        return arrays, results

    def read_refusals(self):
        """Takes the declarations that compilers find where objects stand in place of arrays."""
        self.reader.expect_section("object_arguments")
        for name in self.functions:
            self.reader.expect(f"template <class... Of> detail::IfObjects<Of...> {name}(const Of&...);")

    def read_shapes(self):
        """Takes the functions as types, which have the shapes of their arguments."""
        reader = self.reader
        if not reader.accept("namespace functions {"):
            return
        names = list(self.functions)
        while reader.accept("struct"):
            name = reader.take_name()
            if name not in names:
                reader.fail(f"a shape of {name}")
            del names[:names.index(name) + 1]
            self.shape(self.functions[name])
        reader.expect("}")

    def shape(self, function):
        reader, arrays, results = self.reader, [], []
        reader.expect("{ template <class Scalar> using Shape =")
        reader.expect("Scalar" if function.gives_number else "void")
        reader.expect("(")
        while not reader.accept(")"):
            if arrays or results:
                reader.expect(",")
            is_read = reader.accept("const")
            reader.expect("Scalar (&")
            name = reader.take_name()
            reader.expect(")")
            lengths = []
            while reader.accept("["):
                lengths.append(reader.take_count())
                reader.expect("]")
            (arrays if is_read else results).append(name)
            function.shapes[name] = lengths
        reader.expect(";")
        function.leaves_out = reader.accept("static constexpr bool leaves_out = true;")
        reader.expect("template <class... Of> [[gnu::always_inline]] auto operator()(Of&&... of) const noexcept {"
                      f"return ::NAMESPACE::{function.name}(of...); }} }};".replace("NAMESPACE",
                                                                                     reader.holes["NAMESPACE"]))
        self.name_arguments(function, arrays, results)

    def name_arguments(self, function, arrays, results):
        """Gives arguments without a name the one of the function's shape, and compares the others."""
        known = function.arrays + function.results
        named = arrays + results
        if len(arrays) != len(function.arrays) or len(results) != len(function.results) or any(
                name not in (None, other) for name, other in zip(known, named)):
            self.reader.fail(f"the shape of {function.name} has other arguments than the function")
        function.arrays, function.results = arrays, results
        if arrays != sorted(arrays, key=ORDER.index) or any(
                function.shapes[name] != [self.length_of(name)] for name in arrays if name not in OWN_LENGTHS):
            self.reader.fail(f"the arguments of {function.name} are in another order, or have other lengths")

    # What the text says.

    def length_of(self, array):
        """The number of entries of an argument; the largest of those that depend on the function."""
        if array in OWN_LENGTHS:
            return max(each.shapes[array][0] for each in self.functions.values() if array in each.shapes)
        if array in LENGTHS:
            return LENGTHS[array]
        if array == "pi_b":
            return self.constants["base_parameter_count"]
        names = ("position_count", "joint_count") if array == "q" else ("velocity_count", "joint_count")
        return next(self.constants[name] for name in names if name in self.constants)

    def joints_of_positions(self):
        """For every entry of q the joint whose limits it has, nothing for those of a quaternion."""
        joints = self.constants.get("joint_names", [])
        positions = self.constants.get("position_names", joints)
        result, j = [], 0
        while len(result) < len(positions):
            p, name = len(result), positions[len(result)].removesuffix(OF_QUATERNION[0])
            if (positions[p:p + 4] == [name + end for end in OF_QUATERNION]
                    and joints[j:j + 3] == [name + end for end in OF_ROTATION]):
                result += [None] * 4
                j += 3
            else:
                result.append(j)
                j += 1
        if j != len(joints):
            raise ValueError("the header has other positions than joints")
        return result

    def limit(self, argument):
        """The largest size of an argument such as qd_2, or nothing if the header has none."""
        kind, _, index = argument.rpartition("_")
        if kind in OWN_LENGTHS and index.isdigit():
            return 1.0
        if kind not in LIMITS or not index.isdigit():
            return None
        entry = int(index) - 1
        if kind == "q":
            joint = self.joints_of_positions()[entry]
            if joint is None:
                return 1.0
        else:
            joint = entry - (self.length_of(kind) - self.constants["joint_count"])
        if joint < 0:
            return None  # of the base, whose limits only the certificate has
        sizes = [abs(self.constants[name][joint]) for name in LIMITS[kind] if name in self.constants]
        return max(sizes) if sizes and max(sizes) < math.inf else None
