#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Checks that need no build: licence lines, leftovers, long lines, direction of includes, layout, warnings in kernels.
# Prints the sizes of files and functions. The last line is "N passed, N failed"; the exit status is 0 if none failed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export PYTHONDONTWRITEBYTECODE=1
passed=0 failed=0

# check NAME COMMAND...
check() {
  echo "== $1"
  if "${@:2}"; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
}

# check_with TOOL NAME COMMAND...: left out where the tool is not installed.
check_with() {
  if command -v "$1" >/dev/null; then check "${@:2}"; else echo "== $2: skipped, $1 is not installed"; fi
}

check "licence lines, leftovers and long lines" python3 tools/lint/text.py
check "direction of includes" python3 tools/lint/includes.py
check_with clang-format "layout of C++ sources (tools/format.sh mends it)" bash tools/format.sh --check
check_with clang "kernels" python3 tools/lint/kernels.py
check "sizes" python3 tools/lint/sizes.py
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
