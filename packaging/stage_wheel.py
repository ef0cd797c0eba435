#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""stage_wheel.py PROGRAM FOLDER: the content of a Python wheel that has the program as its only script.

The wheel is not bound to a version of Python. auditwheel then adds the libraries that the program needs; their licences
are here already, as Debian has them.
"""

import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
METADATA = """Metadata-Version: 2.1
Name: flatdyn
Version: {version}
Summary: Symbolic generator of flat code for robot dynamics: the command flatdyn
License: GPL-2.0-or-later
Keywords: robotics,dynamics,code generation,URDF,MJCF
Classifier: Environment :: Console
Classifier: Operating System :: POSIX :: Linux
Classifier: Topic :: Scientific/Engineering
Requires-Python: >=3.8
Description-Content-Type: text/markdown

{description}"""
WHEEL = """Wheel-Version: 1.0
Generator: flatdyn packaging/stage_wheel.py
Root-Is-Purelib: false
Tag: py3-none-linux_{machine}
"""


def version():
    """The version in CMakeLists.txt."""
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(flatdyn VERSION ([0-9.]+)", text)[1]


def output_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def needed_packages(program):
    """The Debian packages of the libraries that the program loads, but for those that every system has."""
    everywhere = {"libc6", "libgcc-s1", "libstdc++6"}
    packages = set()
    for library in re.findall(r"=> (/\S+)", output_of("ldd", program)):
        real = pathlib.Path(library).resolve()
        for path in (real, pathlib.Path(str(real).removeprefix("/usr"))):
            found = subprocess.run(["dpkg-query", "-S", path], capture_output=True, text=True, check=False)
            if found.returncode == 0:
                packages.add(found.stdout.split(":")[0])
                break
        else:
            sys.exit(f"stage_wheel.py: no Debian package has {real}, whose licence the wheel needs")
    return sorted(packages - everywhere)


def main(program, folder):
    name = f"flatdyn-{version()}"
    scripts, information = folder / f"{name}.data" / "scripts", folder / f"{name}.dist-info"
    licences = information / "licenses"
    for each in (scripts, licences):
        each.mkdir(parents=True)
    shutil.copy(program, scripts / "flatdyn")
    subprocess.run(["strip", scripts / "flatdyn"], check=True)
    shutil.copy(ROOT / "LICENSE", licences / "flatdyn")
    shutil.copy(ROOT / "LICENSES" / "BSD-3-Clause.txt", licences / "flatdyn-output")
    for package in needed_packages(program):
        shutil.copy(pathlib.Path("/usr/share/doc") / package / "copyright", licences / package)
    description = (ROOT / "packaging" / "wheel.md").read_text(encoding="utf-8")
    (information / "METADATA").write_text(METADATA.format(version=version(), description=description), encoding="utf-8")
    (information / "WHEEL").write_text(WHEEL.format(machine=output_of("uname", "-m").strip()), encoding="utf-8")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
