#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Counts the tests of a ctest run: count_tests.py REPORT.xml (ctest --output-junit).

An entry that says how many cases it ran (GoogleTest, run_robust.py, a line "N passed, N failed") counts as these, any
other as one. Prints the failed and skipped entries and, as the last line, "N passed, N failed". Exit status 0 if none
failed."""
import re
import sys
import xml.etree.ElementTree

LAST = re.MULTILINE


def cases_of(output):
    """(passed, failed) as an entry's own output tells them; None if it does not."""
    ran = re.findall(r"^\[=+\] (\d+) tests? from .* ran\.", output, LAST)
    if ran:
        passed = re.findall(r"^\[  PASSED  \] (\d+) tests?\.", output, LAST)
        failed = re.findall(r"^\[  FAILED  \] (\d+) tests?, listed below", output, LAST)
        return sum(map(int, passed)), sum(map(int, failed))
    robust = re.findall(r"^(\d+) cases of bad and good input, (\d+) failures$", output, LAST)
    if robust:
        cases, failures = map(int, robust[-1])
        return max(cases - failures, 0), failures
    own = re.findall(r"^(\d+) passed, (\d+) failed$", output, LAST)
    return tuple(map(int, own[-1])) if own else None


def is_skipped(entry):
    """True for what is switched off or found nothing to test on; a missing program is no reason."""
    reason = entry.find("skipped")
    return entry.get("status") == "disabled" or reason is not None and reason.get("message", "").startswith("SKIP_")


def count(entry):
    """(passed, failed) of one <testcase>: an entry that failed counts as a failure whatever it printed."""
    if is_skipped(entry):
        return 0, 0
    succeeded = entry.get("status") == "run"
    passed, failed = cases_of(entry.findtext("system-out") or "") or (int(succeeded), 0)
    return passed, failed if succeeded else max(failed, 1)


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: count_tests.py REPORT.xml")
    try:
        entries = list(xml.etree.ElementTree.parse(sys.argv[1]).getroot().iter("testcase"))
    except (OSError, xml.etree.ElementTree.ParseError) as error:
        print(f"error: {sys.argv[1]}: no report of a test run: {error}", file=sys.stderr)
        print("0 passed, 1 failed")
        sys.exit(1)
    counts = {entry.get("name"): count(entry) for entry in entries}
    for name, (passed, failed) in counts.items():
        if failed or not passed:
            print(f"{'failed' if failed else 'skipped'}: {name}")
    passed, failed = (sum(column) for column in zip(*counts.values())) if counts else (0, 1)
    print(f"{passed} passed, {failed} failed")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
