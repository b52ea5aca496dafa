# SPDX-License-Identifier: Apache-2.0
"""What the jobs share: running a program in an environment of its own, skipping, failing."""
import os
import subprocess
import sys

SKIPPED = 77  # the tests' SKIP_RETURN_CODE


def skip(why):
    print("skipped: " + why)
    sys.exit(SKIPPED)


def fail(why):
    print("failed: " + why)
    sys.exit(1)


def run(command, timeout, **variables):
    """Exit status and output, both streams together; a status of None means that the time was up."""
    environment = dict(os.environ, **variables)
    try:
        done = subprocess.run([str(part) for part in command], env=environment, timeout=timeout,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    except subprocess.TimeoutExpired as error:
        return None, (error.stdout or b"").decode(errors="replace")
    return done.returncode, done.stdout.decode(errors="replace")
