#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Every test: installs what is missing, builds, runs ctest (lint is one of its entries). The last line is
# "N passed, N failed"; the exit status is 0 if nothing failed.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/tools/packages.sh"
source "$root/tools/build.sh"

report=$root/build/test_report.xml

# A folder that demo.sh made has no tests yet.
with_tests() {
  grep -q '^CDSM_TESTS:BOOL=ON' "$root/build/CMakeCache.txt" ||
    cmake -S "$root" -B "$root/build" -DCDSM_TESTS=ON >/dev/null
}

prepare() {
  { build_packages && test_packages; } | install_packages &&
    configure -DCDSM_WARNINGS_AS_ERRORS=ON && with_tests && build
}

if ! prepare; then
  echo "failed: the build"
  echo "0 passed, 1 failed"
  exit 1
fi

rm -f "$report"
status=0
ctest --test-dir "$root/build" --output-on-failure --parallel "$(nproc)" --timeout 900 --output-junit "$report" \
  --test-output-size-passed 4194304 --test-output-size-failed 4194304 --test-output-truncation head || status=$?
python3 "$root/tools/count_tests.py" "$report" || status=1
exit "$status"
