#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Bad input through the command line: run_robust.py PATH_OF_CDSM

Each case of cases.py runs in a folder of its own, every other one with an earlier output in it. Expected are the exit
status, one line on stderr that begins with "error: " and holds the case's text, nothing on stdout, and a folder that
is afterwards as it was before. Exit status 0 when all cases pass; each failure is printed with what came instead."""
import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True  # leaves no __pycache__ among the sources
import cases  # noqa: E402

TIMEOUT_SECONDS = 120
EARLIER = b"an earlier result"


def snapshot(folder):
    """All files below the folder with their bytes."""
    return {str(p.relative_to(folder)): p.read_bytes() for p in sorted(folder.rglob("*")) if p.is_file()}


def run(tool, arguments, folder):
    """Exit status, stdout, stderr; a hang is a status of its own, a crash a negative one."""
    try:
        done = subprocess.run([tool] + arguments, cwd=folder, capture_output=True, timeout=TIMEOUT_SECONDS)
    except subprocess.TimeoutExpired:
        return "hang", "", ""
    return done.returncode, done.stdout.decode(errors="replace"), done.stderr.decode(errors="replace")


def problems_of_refusal(case, status, out, err, before, after):
    """What is wrong with how a bad input was refused, as sentences."""
    problems = []
    if status != case.status:
        problems.append(f"exit status {status}, expected {case.status}")
    if not err.startswith("error: ") or err.count("\n") != 1 or not err.endswith("\n"):
        problems.append("stderr is not one line that begins with 'error: '")
    if case.text not in err:
        problems.append(f"stderr lacks '{case.text}'")
    if out:
        problems.append("something came on stdout")
    problems += [f"{name} was left behind" for name in after if name not in before]
    problems += [f"{name} was changed or removed" for name in before if after.get(name) != before[name]]
    return problems + (["stderr was: " + err.strip()] if problems else [])


def problems_of_success(case, status, err, after):
    """What is wrong with a run that should have worked."""
    problems = [f"{name} is missing" for name in case.outputs if after.get(name, EARLIER) == EARLIER]
    problems += [f"{name} was left behind" for name in after if name.endswith(".tmp")]
    if status != 0 or err:
        problems.append(f"exit status {status}, stderr: {err.strip()}")
    return problems


def check(tool, case, with_earlier):
    """Runs a case in a fresh folder; what went wrong, as sentences."""
    with tempfile.TemporaryDirectory(prefix="cdsm_robust_") as name:
        folder = pathlib.Path(name)
        case.prepare(folder)
        if with_earlier:
            for output in cases.OUTPUTS:
                (folder / output).write_bytes(EARLIER)
        before = snapshot(folder)
        status, out, err = run(tool, case.arguments, folder)
        after = snapshot(folder)
    if case.status == 0:
        return problems_of_success(case, status, err, after)
    return problems_of_refusal(case, status, out, err, before, after)


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: run_robust.py PATH_OF_CDSM")
    tool = str(pathlib.Path(sys.argv[1]).resolve())
    failures = 0
    for number, case in enumerate(cases.CASES):
        with_earlier = number % 2 == 1
        problems = check(tool, case, with_earlier)
        failures += bool(problems)
        for problem in problems:
            print(f"{case.name}{' (with earlier output)' if with_earlier else ''}: {problem}")
    print(f"{len(cases.CASES)} cases of bad and good input, {failures} failures")
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
