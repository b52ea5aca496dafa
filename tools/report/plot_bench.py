#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws what `cdsm bench SUITE --json FILE` measured, a PNG for each suite.

usage: plot_bench.py RESULTS.json... -o FOLDER    (writes FOLDER/bench_SUITE.png)

Colours are those of Okabe and Ito, which the colour-blind tell apart; in black and white, markers and dashes do: filled
markers and full lines are measured here, open markers and dashes are the thesis."""
import argparse
import json
import pathlib
import sys

try:
    import matplotlib
except ImportError:
    sys.exit("plot_bench.py: needs Matplotlib (Debian: apt-get install python3-matplotlib)")
matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

BLACK, ORANGE, SKY, GREEN, BLUE, RED = "#000000", "#E69F00", "#56B4E9", "#009E73", "#0072B2", "#D55E00"
COLOURS = (BLUE, RED, GREEN, ORANGE, SKY, BLACK)
MARKERS = "os^Dv*"
STYLE = {
    "font.size": 9, "axes.titlesize": 9.5, "legend.fontsize": 8, "axes.spines.top": False, "axes.spines.right": False,
    "axes.grid": True, "grid.color": "#dddddd", "grid.linewidth": 0.6, "axes.axisbelow": True, "lines.linewidth": 1.6,
    "lines.markersize": 5, "legend.frameon": False,
}
OF_ROW = "relative to the row's smallest in the thesis"


def powers(text):
    """256^2 as it is printed."""
    return text.replace("^2", "²").replace(" x ", "×")


def table_of(results, name):
    return next(table for table in results["tables"] if table["name"] == name)


def row_of(table, label):
    return next(row for row in table["rows"] if row["label"] == label)


def panels(count, width=9.0, height=3.2):
    figure, axes = pyplot.subplots(1, count, figsize=(width, height), squeeze=False)
    return figure, list(axes[0])


def both_lines(axis, x, row, key, number, label):
    """Ours and the thesis's values of a row: `key` is "" for values, "_ratio" for ratios."""
    colour, marker = COLOURS[number], MARKERS[number]
    axis.plot(x, row["ours" + key], color=colour, marker=marker, label=label)
    if row["thesis" + key]:
        axis.plot(x, row["thesis" + key], color=colour, marker=marker, linestyle="--", markerfacecolor="white")


def key_of_lines(axis, source="thesis"):
    """Says what full and dashed lines are, beside the labels there are."""
    axis.plot([], [], color="#666666", label="here")
    axis.plot([], [], color="#666666", linestyle="--", label=source)


def ticks(axis, labels):
    axis.set_xticks(range(len(labels)), [powers(label) for label in labels])
    axis.margins(x=0.08)


def plot_map_size(results):
    tables = [table for table in results["tables"] if table["name"] != "unshadowed"]
    names = [table["title"].split(": ", 1)[1].split(";")[0].replace(" (thesis: 3D textures)", "") for table in tables]
    figure, axes = panels(3)
    for axis, label in zip(axes, ("building maps", "frame, not filtered", "frame, filtered")):
        for number, table in enumerate(tables):
            both_lines(axis, range(3), row_of(table, label), "_ratio", number, names[number])
        ticks(axis, [f"{one}\n{four}" for one, four in zip(tables[0]["columns"], tables[1]["columns"])])
        axis.set_title(label)
        axis.set_ylim(bottom=0)
    axes[0].set_ylabel("relative to a frame without shadows")
    key_of_lines(axes[0])
    figure.legend(*axes[0].get_legend_handles_labels(), loc="lower center", ncols=6, columnspacing=1.2)
    figure.tight_layout(rect=(0, 0.09, 1, 1))
    return figure


def plot_variants(results):
    """Times in both kinds of memory and nodes, against a parameter: volume-size and tolerance."""
    *times, nodes = results["tables"]
    figure, axes = panels(3)
    for axis, label in zip(axes, ("building maps", "frame, filtered")):
        for number, (table, memory) in enumerate(zip(times, ("atlas", "chunked"))):
            both_lines(axis, range(len(table["columns"])), row_of(table, label), "_ratio", number, memory)
        axis.set_title(label)
    both_lines(axes[2], range(len(nodes["columns"])), row_of(nodes, "nodes per texel, mean"), "", 2, "mean")
    axes[2].set_title("nodes per texel, mean")
    for axis in axes:
        ticks(axis, [column.replace("x", "×\n", 1) for column in nodes["columns"]])
        axis.set_xlabel(nodes["parameter"])
        axis.set_ylim(bottom=0)
    axes[0].set_ylabel(OF_ROW)
    axes[0].yaxis.label.set_size(8)
    key_of_lines(axes[0])
    axes[0].legend(loc="lower left")
    figure.tight_layout()
    return figure


def plot_objects(results):
    tables, exponents = results["tables"][:2], table_of(results, "exponents")
    figure, axes = panels(2, 8.0, 3.6)
    for column, (axis, table) in enumerate(zip(axes, tables)):
        x = [int(name) for name in table["columns"]]
        for number, row in enumerate(table["rows"]):
            exponent = row_of(exponents, row["label"])["ours"][column]
            axis.plot(x, row["ours"], color=COLOURS[number], marker=MARKERS[number],
                      label=f"{row['label']}: n$^{{{exponent:.2f}}}$")
        axis.set(xscale="log", yscale="log", title=table["name"], xlabel="teacups n")
        axis.set_xticks(x, x)
        axis.minorticks_off()
        axis.legend(loc="upper left")
    axes[0].set_ylabel("milliseconds")
    low = min(axis.get_ylim()[0] for axis in axes)
    high = max(axis.get_ylim()[1] for axis in axes)
    for axis in axes:
        axis.set_ylim(low, 30 * high)  # room for the legend
    figure.tight_layout()
    return figure


def plot_chunks(results):
    figure, axes = pyplot.subplots(1, 2, figsize=(9.0, 3.6), sharey=True, gridspec_kw={"width_ratios": (12, 8)})
    for axis, table, key, title in zip(axes, results["tables"], ("ours", "thesis"), ("here", "thesis, Table 5.11")):
        used, wasted = table["rows"][0][key], table["rows"][1][key]
        x = range(len(used))
        axis.bar(x, used, color=BLUE, label="used")
        axis.bar(x, wasted, bottom=used, color=ORANGE, hatch="///", edgecolor="white", linewidth=0, label="wasted")
        slant = 40 if key == "ours" else 0
        axis.set_xticks(x, table["columns"], rotation=slant, ha="right" if slant else "center")
        axis.grid(axis="x", visible=False)
        axis.set_title(title)
    axes[0].set_ylabel("room for 64 nodes in each 8 × 8 texels")
    axes[1].legend(loc="upper center")
    figure.tight_layout()
    return figure


def plot_gallery(results):
    table = results["tables"][0]
    rates = row_of(table, "frames per second, average")["ours"]
    figure, (axis,) = panels(1, 6.5, 3.8)
    bars = axis.barh(table["columns"], rates, color=BLUE)
    axis.bar_label(bars, [f"{rate:.0f}" if rate >= 10 else f"{rate:.2g}" for rate in rates], padding=3)
    axis.invert_yaxis()
    axis.grid(axis="y", visible=False)
    axis.margins(x=0.12)
    axis.set_xlabel("frames per second while the camera moves")
    figure.tight_layout()
    return figure


def bar_pairs(axis, table, labels, names):
    """Two bars for each column of a table."""
    for number, (label, name) in enumerate(zip(labels, names)):
        x = [column + 0.38 * (number - 0.5) for column in range(len(table["columns"]))]
        axis.bar(x, row_of(table, label)["ours"], 0.36, color=(ORANGE, BLUE)[number], hatch=("///", "")[number],
                 edgecolor="white", linewidth=0, label=name)
    ticks(axis, table["columns"])
    axis.grid(axis="x", visible=False)
    axis.set_xlabel(table["parameter"])
    axis.set_ylim(top=1.25 * axis.get_ylim()[1])
    axis.legend(loc="upper right")


def plot_clustering(results):
    error, frame, cpu = (table_of(results, name) for name in ("error", "frame", "cpu"))
    labels = [row["label"] for row in error["rows"][:2]]
    figure, axes = panels(3)
    bar_pairs(axes[0], error, labels, [powers(label.split(", RMS")[0].replace("clusters, ", "")) for label in labels])
    axes[0].set(title="error of shadows, RMS")
    bar_pairs(axes[1], frame, ("one map", "four clusters"), ("one map", "four clusters"))
    axes[1].set(title="frame, maps built before, ms")
    row = cpu["rows"][0]
    x = [int(name) for name in cpu["columns"]]
    axes[2].plot(x, row["ours"], color=BLUE, marker="o", label="here")
    axes[2].plot(x, row["wanted"], color=BLACK, linestyle=":", label="wanted: below")
    axes[2].set(title="clustering on the CPU, ms", xlabel="objects", ylim=(0, None), xticks=x)
    axes[2].legend(loc="center left")
    figure.tight_layout()
    return figure


def plot_memory(results):
    """The first scene at its first size: room, and lookups in no order, of each strategy in both formats."""
    table = results["tables"][1]
    names = [column.split(", ") for column in table["columns"]]
    strategies = list(dict.fromkeys(strategy for strategy, _ in names))
    figure, axes = panels(2, 9.0, 3.4)
    for axis, label in zip(axes, ("reserved", "a million lookups anywhere")):
        row = row_of(table, label)
        for number, form in enumerate(dict.fromkeys(form for _, form in names)):
            values = [value or 0 for value, (_, of) in zip(row["ours"], names) if of == form]
            bars = axis.bar([x + 0.4 * (number - 0.5) for x in range(len(values))], values, 0.38, label=form,
                            color=(ORANGE, BLUE)[number], hatch=("///", "")[number], edgecolor="white", linewidth=0)
            axis.bar_label(bars, [f"{value:.3g}" for value in values], fontsize=7, padding=1)
        ticks(axis, strategies)
        axis.grid(axis="x", visible=False)
        axis.set(title=f"{label}, {row['unit']}")
    axes[0].set(yscale="log")
    axes[0].legend(loc="upper center")
    figure.suptitle(powers(table["title"]), fontsize=9)
    figure.tight_layout()
    return figure


def plot_techniques(results):
    table = table_of(results, "ours")
    figure, (axis,) = panels(1, 6.5, 3.8)
    for number, label in enumerate(("light moved", "camera moved")):
        y = [place + 0.38 * (number - 0.5) for place in range(len(table["columns"]))]
        bars = axis.barh(y, row_of(table, label)["ours_ratio"], 0.36, color=(ORANGE, BLUE)[number], label=label,
                         hatch=("///", "")[number], edgecolor="white", linewidth=0)
        axis.bar_label(bars, fmt="%.3g", padding=3, fontsize=7)
    axis.set_yticks(range(len(table["columns"])), table["columns"])
    axis.invert_yaxis()
    axis.grid(axis="y", visible=False)
    axis.set(xscale="log", xlabel="frame, relative to one without shadows")
    axis.margins(x=0.12)
    axis.legend(loc="lower right")
    figure.tight_layout()
    return figure


def plot_demo(results):
    table = results["tables"][0]
    figure, (axis,) = panels(1, 6.5, 3.4)
    names = ("frame without shadows", "frame with shadows", "building the map", "frame with shadow rays")
    for number, name in enumerate(names):
        x = [column + 0.2 * (number - 1.5) for column in range(len(table["columns"]))]
        axis.bar(x, row_of(table, name)["ours"], 0.18, color=(SKY, BLUE, GREEN, ORANGE)[number], label=name,
                 hatch=("", "", "...", "///")[number], edgecolor="white", linewidth=0)
    ticks(axis, table["columns"])
    axis.set(yscale="log", ylabel="milliseconds")
    axis.grid(axis="x", visible=False)
    axis.legend(loc="upper center", bbox_to_anchor=(0.5, 1.22), ncols=2)
    figure.tight_layout()
    return figure


def plot_stochastic(results):
    *times, _, noise = results["tables"]
    figure, axes = panels(3)
    for axis, table, title in zip(axes, times, ("building maps", "frame")):
        for number, row in enumerate(table["rows"][:2]):
            both_lines(axis, range(len(table["columns"])), row, "", number, row["label"])
        ticks(axis, table["columns"])
        axis.set(title=title, ylim=(0, None))
    axes[0].set_ylabel("stochastic, relative to the others")
    key_of_lines(axes[0], times[0]["source"])
    axes[0].legend(loc="lower left")
    bar_pairs(axes[2], noise, ("as published", "stratified"), ("as published", "stratified"))
    axes[2].set(title="noise of a pixel")
    figure.tight_layout()
    return figure


def plot_query(results):
    table = results["tables"][0]
    figure, (axis,) = panels(1, 4.5, 3.2)
    bar_pairs(axis, table, ("host arrays, at least", "bare kernel"), ("from arrays of the host", "bare kernel"))
    axis.set_ylabel("million points / s")
    figure.tight_layout()
    return figure


def plot_spheres(results):
    ratios, times = results["tables"]
    counts = row_of(times, "spheres")["ours"]
    figure, (axis,) = panels(1, 6.5, 3.6)
    for number, row in enumerate(ratios["rows"]):
        axis.plot(range(len(counts)), row["ours"], color=COLOURS[number], marker=MARKERS[number], label=row["label"])
    axis.plot(range(len(counts)), ratios["rows"][0]["wanted"], color=BLACK, linestyle=":", label="paper, about; wanted")
    ticks(axis, [f"{name}\n{count:.0f}" for name, count in zip(ratios["columns"], counts)])
    axis.set(ylabel="frame / frame by local lighting alone", ylim=(0, None))
    axis.legend(loc="lower left")
    figure.tight_layout()
    return figure


PLOTS = {
    "demo": plot_demo, "map-size": plot_map_size, "volume-size": plot_variants, "tolerance": plot_variants,
    "objects": plot_objects, "chunks": plot_chunks, "gallery": plot_gallery, "clustering": plot_clustering,
    "memory": plot_memory, "techniques": plot_techniques,
    "query": plot_query, "stochastic": plot_stochastic, "spheres": plot_spheres,
}


def main():
    parser = argparse.ArgumentParser(description="Draws what 'cdsm bench SUITE --json FILE' measured.")
    parser.add_argument("results", nargs="+", type=pathlib.Path, metavar="RESULTS.json")
    parser.add_argument("-o", dest="folder", type=pathlib.Path, required=True, help="where bench_SUITE.png go")
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    with pyplot.rc_context(STYLE):
        for path in options.results:
            results = json.loads(path.read_text())
            image = options.folder / f"bench_{results['suite'].replace('-', '_')}.png"
            figure = PLOTS[results["suite"]](results)
            figure.savefig(image, dpi=110, metadata={"Software": None})
            pyplot.close(figure)
            print(image)


if __name__ == "__main__":
    main()
