#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Suites of `cdsm bench` on tiny scenes, and what the reports make of their figures: run_bench.py CDSM TOOLS

The scenes are one closed mesh and one volume under the names that the suites look for. Times are not judged: what is
checked is that each suite runs, which tables it has, and that all rows are as long as their tables are wide."""
import json
import pathlib
import subprocess
import sys
import tempfile

TIMEOUT_SECONDS = 120
SKIPPED_PLOTS = "needs Matplotlib"
SCENE = """
[camera]
position = [0.5, 1.0, 6.0]
[[light]]
name = "key"
position = [4.0, 4.0, 4.0]
[[material]]
name = "glass"
opacity = 0.3
[[mesh]]
name = "cup"
file = "{up}closed.obj"
material = "glass"
[[volume]]
name = "smoke"
file = "{up}grid.nrrd"
opacity = [[0.0, 0.0], [63.0, 0.5]]
color = [[0.0, 1.0, 1.0, 1.0]]
"""
SPHERES = """
[[spheres]]
name = "atoms"
file = "{up}atoms.xyz"
material = "glass"
"""
MESH = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
VOXELS = b"NRRD0004\ntype: uint8\ndimension: 3\nsizes: 4 4 4\nencoding: raw\n\n" + bytes(range(64))
SCENES = ("papers/clustering/camera_a", "papers/clustering/camera_b", "papers/clustering/camera_c",
          "papers/xray/overview", "papers/teacups/teacups_01", "bench/sparse",
          "papers/test-spheres/scene")
MOLECULES = ("1tii", "1lnl", "1aon", "nial_impact", "capsid", "million")
TABLES = {"tolerance": ["5.8", "5.9", "5.10"], "clustering": ["error", "frame", "cpu", "path"],
          "memory": ["0", "1", "2"], "techniques": ["ours", "paper", "cached"],
          "query": ["query"], "stochastic": ["weidner-3", "weidner-4", "memory", "noise"],
          "spheres": ["krone-8", "times"]}
ARGUMENTS = {"memory": ["{scenes}/papers/xray/overview.toml", "--map-sizes", "512,2048"]}
NO_FIGURE = "error, "  # rows of these labels may lack figures: functions that are not compressed fit small maps alone


def fail(why):
    print("failed: " + why)
    sys.exit(1)


def run(command):
    """Exit status and output, both streams together."""
    done = subprocess.run([str(part) for part in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          timeout=TIMEOUT_SECONDS)
    return done.returncode, done.stdout.decode(errors="replace")


def write_scenes(folder):
    (folder / "closed.obj").write_text(MESH)
    (folder / "grid.nrrd").write_bytes(VOXELS)
    (folder / "atoms.xyz").write_text("2\n\nC 0 0 0\nC 1 1 0\n")
    for name in [*SCENES, *(f"papers/molecules/{name}" for name in MOLECULES)]:
        path = folder / (name + ".toml")
        path.parent.mkdir(parents=True, exist_ok=True)
        text = SCENE + (SPHERES if "molecules" in name else "")
        path.write_text(text.format(up="../" * name.count("/")))


def check_table(table):
    for row in table["rows"]:
        for key in ("ours", "ours_ratio", "thesis", "thesis_ratio", "wanted"):
            if row[key] and len(row[key]) != len(table["columns"]):
                fail(f"{table['title']}: '{row['label']}' has {len(row[key])} in {key}, not {len(table['columns'])}")
        known = [value for value in row["ours"] if value is not None or not row["label"].startswith(NO_FIGURE)]
        if row["thesis"] and not row["ours"]:
            continue  # the paper alone has figures
        if len(row["ours"]) != len(table["columns"]) or any(value is None or value < 0 for value in known):
            fail(f"{table['title']}: '{row['label']}' has the values {row['ours']}")


def check_suite(cdsm, suite, scenes, results):
    arguments = [part.format(scenes=scenes) for part in ARGUMENTS.get(suite, [])]
    status, output = run([cdsm, "bench", suite, *arguments, "--scenes", scenes, "--runs", 1, "--scale", 0.02, "--json",
                          results])
    if status != 0:
        fail(f"bench {suite}: exit status {status}: {output}")
    tables = json.loads(results.read_text())["tables"]
    if [table["name"] for table in tables] != TABLES[suite]:
        fail(f"bench {suite} has the tables {[table['name'] for table in tables]}")
    for table in tables:
        if table["title"] not in output:
            fail(f"bench {suite} does not print '{table['title']}'")
        check_table(table)


def check_page(script, results, page):
    marks = "".join(f"<!-- bench {name} -->\nold\n<!-- end {name} -->\n" for name in ["machine", *TABLES])
    page.write_text("before\n" + marks + "after\n")
    status, output = run([sys.executable, script, *results, "--page", page])
    text = page.read_text()
    if status != 0 or "\nold\n" in text or not (text.startswith("before\n") and text.endswith("after\n")):
        fail(f"bench_tables.py: exit status {status}: {output}{text}")
    if "Table 5.8" not in text or "| 0.01 |" not in text:
        fail(f"bench_tables.py left something out: {text}")


def check_plots(script, results, folder):
    status, output = run([sys.executable, script, *results, "-o", folder])
    if SKIPPED_PLOTS in output:
        print("plots: skipped, this Python has no Matplotlib")
    elif status != 0 or len(list(folder.glob("bench_*.png"))) != len(results):
        fail(f"plot_bench.py: exit status {status}: {output}")


def main():
    cdsm, tools = sys.argv[1], pathlib.Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        write_scenes(folder)
        results = []
        for suite in TABLES:
            results.append(folder / (suite + ".json"))
            check_suite(cdsm, suite, folder, results[-1])
        check_page(tools / "bench_tables.py", results, folder / "page.md")
        check_plots(tools / "plot_bench.py", results, folder / "plots")
    print("suites run, pages and plots are made of their figures")


main()
