#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes what `cdsm bench SUITE --json FILE` measured into a page, as Markdown tables.

usage: bench_tables.py RESULTS.json... --page docs/benchmarks.md

Between <!-- bench SUITE --> and <!-- end SUITE --> comes that suite's tables, between <!-- bench machine --> and
<!-- end machine --> the device. What else the page says stays."""
import argparse
import datetime
import json
import pathlib
import re
import sys

MOST_COLUMNS = 7  # wider tables are turned, so that their columns become lines


def number(value):
    """Three significant digits, or all of those before the point; a dash where there is no figure."""
    if value is None:
        return "–"
    return f"{value:.0f}" if abs(value) >= 100 else f"{value:.3g}"


def powers(text):
    return text.replace("^2", "²").replace(" x ", " × ")


def cells(values, ratios, unit):
    """Ratios come first, with what they were made of behind them."""
    if not ratios:
        return [number(value) for value in values]
    return [f"{number(ratio)} ({number(value)} {unit})" for value, ratio in zip(values, ratios)]


def lines_of(row, source):
    """The lines of a table that a row becomes: a label and cells each."""
    ratio = bool(row["ours_ratio"])
    name = row["label"] if ratio or not row["unit"] else f"{row['label']}, {row['unit']}"
    if row["ours"]:
        yield powers(name), cells(row["ours"], row["ours_ratio"], row["unit"])
    if row["thesis"]:
        label = f"– {source}" if row["ours"] else name
        yield label, cells(row["thesis"], row["thesis_ratio"], row["unit"])
    if row["wanted"]:
        yield "– wanted", [number(value) for value in row["wanted"]]


def markdown(lines):
    yield "| " + " | ".join(lines[0]) + " |"
    yield "|" + " --- |" * len(lines[0])
    for line in lines[1:]:
        yield "| " + " | ".join(line) + " |"


def table_text(table):
    lines = [[table["parameter"]] + [powers(column) for column in table["columns"]]]
    lines += [[label] + values for row in table["rows"] for label, values in lines_of(row, table["source"])]
    if len(table["columns"]) > MOST_COLUMNS:
        lines = [list(line) for line in zip(*lines)]
    notes = "".join(f"\n\n{note}" for note in table["notes"])
    return f"**{powers(table['title'])}**\n\n" + "\n".join(markdown(lines)) + notes


def suite_text(results):
    return "\n\n".join(table_text(table) for table in results["tables"])


def machine_text(results):
    device = results["device"]
    return (f"Taken on {datetime.date.today().isoformat()}: {device['name']}, {device['compute_units']} cores, "
            f"{device['version']}; medians of {results['runs']} runs.")


def replaced(page, name, text):
    """The page with another text between the marks of that name."""
    marks = re.compile(rf"(<!-- bench {name} -->\n).*?(<!-- end {name} -->)", re.DOTALL)
    if not marks.search(page):
        sys.exit(f"bench_tables.py: the page has no '<!-- bench {name} -->' with '<!-- end {name} -->' behind it")
    return marks.sub(lambda match: match.group(1) + text + "\n" + match.group(2), page)


def main():
    parser = argparse.ArgumentParser(description="Writes what 'cdsm bench SUITE --json FILE' measured into a page.")
    parser.add_argument("results", nargs="+", type=pathlib.Path, metavar="RESULTS.json")
    parser.add_argument("--page", type=pathlib.Path, required=True)
    options = parser.parse_args()
    page = options.page.read_text()
    for path in options.results:
        results = json.loads(path.read_text())
        page = replaced(page, results["suite"], suite_text(results))
    page = replaced(page, "machine", machine_text(results))
    options.page.write_text(page)
    print(options.page)


if __name__ == "__main__":
    main()
