#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compiles every kernel file in its variants with clang, as OpenCL C 1.2: kernels.py, in the repository root.

Joins includes as host/src/device/kernel_source.cpp does and generates the volume slots as
host/src/build/volume_slots.cpp does. A file is compiled for each value of what its text mentions: technique, memory
strategy, format of nodes, voxel type, batch size, buffers or images, volumes of a scene; of all their combinations,
enough for each two values to meet. Prints the warnings; exit status 1 if any."""
import concurrent.futures
import functools
import itertools
import os
import pathlib
import re
import subprocess
import sys

KERNELS = pathlib.Path("kernels")
# Functions of joined .clh files that one entry does not call are no mistake.
CLANG = ["clang", "-x", "cl", "-cl-std=CL1.2", "-Xclang", "-finclude-default-header", "-fsyntax-only", "-Wall",
         "-Werror", "-Wno-unused-function", "-fno-caret-diagnostics", "-"]
SLOTS_FILE = "generated/volume_slots.clh"
SLOTS = [(), ("uchar",), ("uchar", "short", "float")]
IMAGE_SCALES = {"uchar": "255.0f", "short": "65535.0f", "float": "1.0f"}
# Macro of the generated file, function that reads buffers (suffix: voxel type), images, value without volumes.
FETCHES = [
    ("CDSM_VOLUME_VALUES", "value", "imageValue", "0.0f"),
    ("CDSM_VOLUME_BATCHES", "values", "imageValues", "(floatN)(0.0f)"),
    ("CDSM_VOLUME_GRADIENTS", "gradient", "imageGradient", "(float4)(0.0f)"),
    ("CDSM_VOLUME_CELLS", "cell", "imageCell", "(float8)(0.0f)"),
]


def files_with(folder, text):
    """Quoted paths of the .clh files of a folder that hold some text."""
    paths = sorted((KERNELS / folder).glob("*.clh"))
    return [f'"{path.relative_to(KERNELS)}"' for path in paths if text in path.read_text()]


# What a text may mention, and the values to try; None: not defined.
CHOICES = {
    "CDSM_TECHNIQUE": files_with("technique", "#define CDSM_TECHNIQUE_PARAMS"),
    "CDSM_CACHE": files_with("cache", "#define CDSM_LIGHT_PARAMS"),
    "CDSM_MARCH": files_with("build", "void beginMarch("),
    "CDSM_STOP": files_with("build", "void beginStop("),
    "CDSM_PRIMITIVE": files_with("build", "Coverage coverageOf("),
    "CDSM_SPECTRUM": files_with("spectrum", "Spectrum;"),
    "CDSM_SPHERES": ["0", "1"],
    "CDSM_MEMORY": files_with("memory", "texelNodes(") + ['"../tests/strategies/counted.clh"'],
    "CDSM_NODE_FORMAT": files_with("memory", "storeNode(__global"),
    "CDSM_VOXEL": ["uchar", "char", "ushort", "short", "float"],
    "CDSM_BATCH": ["4", "8"],
    "CDSM_TILE_CHUNKS": ["120"],
    "CDSM_FETCH_IMAGE": [None, "1"],
    SLOTS_FILE: SLOTS,
}


def volume_slots(types, images):
    """The generated file for volumes of these types."""
    names = [f"volume{i}" for i in range(len(types))]
    params = [f", __read_only image3d_t {name}" if images else f", __global const {voxel}* {name}"
              for name, voxel in zip(names, types)]
    out = ["#define CDSM_VOLUME_PARAMS " + "".join(params),
           "#define CDSM_VOLUME_ARGS " + "".join(f", {name}" for name in names)]
    for macro, from_buffer, from_image, of_none in FETCHES:
        calls = [f"{from_image}({name}, {IMAGE_SCALES[voxel]}, p)" if images
                 else f"{from_buffer}_{voxel}({name}, size, p)"
                 for name, voxel in zip(names, types)]
        labels = [f"case {i}" for i in range(len(calls) - 1)] + ["default"]
        cases = " ".join(f"{label}: return {call};" for label, call in zip(labels, calls))
        out.append(f"#define {macro} " + (f"switch (slot) {{ {cases} }}" if types else f"return {of_none};"))
    return "\n".join(out) + "\n"


@functools.lru_cache(maxsize=None)
def included_by(path):
    """What the include lines of a file name: quoted paths and macros."""
    return re.findall(r'^#include\s+("[^"]+"|CDSM_\w+)', (KERNELS / path).read_text(), re.MULTILINE)


@functools.lru_cache(maxsize=None)
def mentioned_by(path):
    """Choices that the text of a file mentions."""
    text = (KERNELS / path).read_text()
    return {name for name in CHOICES if re.search(rf"\b{re.escape(name)}\b(?!\.)", text)}


def reached(path, variant, seen):
    """Adds the file and all that it includes, as far as it is chosen."""
    if path in seen:
        return
    seen.add(path)
    for target in included_by(path) if path != SLOTS_FILE else ():
        quoted = target if target[0] == '"' else variant.get(target)
        if quoted:
            reached(quoted.strip('"'), variant, seen)


def join(path, variant, seen):
    """The text of a kernel file with its includes, each file once; an include of a name not chosen yet is left out."""
    if path in seen:
        return ""
    seen.add(path)
    if path == SLOTS_FILE:
        text = volume_slots(variant.get(path) or (), variant.get("CDSM_FETCH_IMAGE"))
    else:
        text = (KERNELS / path).read_text()
    out = [f'#line 1 "kernels/{path}"']
    for number, line in enumerate(text.splitlines(), 1):
        target = re.match(r'#include\s+("[^"]+"|CDSM_\w+)', line)
        if not target:
            out.append("" if line.startswith("#pragma once") else line)
            continue
        quoted = target.group(1) if target.group(1)[0] == '"' else variant.get(target.group(1))
        if quoted:
            out += [join(quoted.strip('"'), variant, seen), f'#line {number + 1} "kernels/{path}"']
    return "\n".join(out)


def variants(entry, chosen=None):
    """All assignments of the choices that the joined text of an entry mentions; what it mentions may depend on them."""
    chosen = chosen or {}
    seen = set()
    reached(entry, chosen, seen)
    mentioned = set().union(*(mentioned_by(path) for path in seen - {SLOTS_FILE}))
    wanted = [name for name in CHOICES if name not in chosen and (name in seen or name in mentioned)]
    includes = [name for name in wanted
                if name in ("CDSM_SPECTRUM", "CDSM_CACHE", "CDSM_TECHNIQUE", "CDSM_MARCH", "CDSM_STOP",
                            "CDSM_PRIMITIVE", "CDSM_MEMORY", "CDSM_NODE_FORMAT")]
    if not wanted:
        yield chosen
        return
    names = includes[:1] or wanted
    for values in itertools.product(*(CHOICES[name] for name in names)):
        yield from variants(entry, {**chosen, **dict(zip(names, values))})


def pairwise(candidates):
    """As many of the variants as it takes for each two values that meet in one of them to meet in one that is left."""
    met, left = set(), []
    for variant in candidates:
        pairs = set(itertools.combinations(sorted(map(repr, variant.items())), 2)) or {repr(variant)}
        if not pairs <= met:
            met |= pairs
            left.append(variant)
    return left


def check(entry, variant):
    """Lines of what clang says of one variant."""
    defines = "".join(f"#define {name} {value}\n" for name, value in variant.items()
                      if isinstance(value, str) and not value.startswith('"'))
    text = defines + join(entry, variant, set()) + "\n"
    done = subprocess.run(CLANG, input=text, capture_output=True, text=True)
    lines = [line for line in done.stderr.splitlines() if re.search(r"(error|warning): ", line)]
    return lines or ([f"{entry}: clang failed: {done.stderr.strip()}"] if done.returncode else [])


def main():
    entries = [str(path.relative_to(KERNELS)) for path in sorted(KERNELS.rglob("*.cl"))]
    jobs = [(entry, variant) for entry in entries for variant in pairwise(variants(entry))]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        results = list(pool.map(lambda job: check(*job), jobs))
    where = {}  # what clang says: the jobs of which it says so
    for job, lines in zip(jobs, results):
        for line in dict.fromkeys(lines):
            where.setdefault(line, []).append(job)
    for line, among in where.items():
        print(f"{line}\n  in {len(among)} of {len(jobs)} variants, first {among[0][0]} with {among[0][1]}")
    if not where:
        print(f"{len(jobs)} variants of {len(entries)} kernel files compile without a warning")
    sys.exit(1 if where else 0)


if __name__ == "__main__":
    main()
