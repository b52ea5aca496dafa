#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Host code under the compiler's checks, in build-address and build-thread: bad accesses, leaks and undefined behaviour
# in the unit tests, the tests of other people's OpenCL and the property tests; races in those of other people's OpenCL,
# where engines work in several threads.
# Takes about as long as three builds. The last line is "N passed, N failed".
# usage: sanitize.sh [address|thread]...    (both if none is named; needs what test.sh installs)
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
suppressed=$root/tools/sanitize
passed=0 failed=0

build() {
  cmake -S . -B "build-$1" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O1 -DCDSM_SANITIZE="$1" \
    -DCDSM_PYTHON=OFF >/dev/null
  cmake --build "build-$1" --target "${@:2}"
}

# check KIND PROGRAM FILTER
check() {
  if "build-$1/tests/$2" --gtest_brief=1 --gtest_filter="$3"; then
    passed=$((passed + 1))
  else
    echo "failed: $2 under the checks of '$1'"
    failed=$((failed + 1))
  fi
}

check_address() {
  build address unit_tests opencl_tests property_tests
  check address unit_tests '*'
  check address opencl_tests '*'
  check address property_tests '*'
  if [ -d build-address/tests/vtk ]; then  # VTK is there
    build address vtk_tests
    check address vtk/vtk_tests '*'
  fi
}

check_thread() {
  build thread opencl_tests
  check thread opencl_tests '*'
}

# PoCL alone: other drivers are unloaded before leaks are listed, and theirs then have no name
export OCL_ICD_VENDORS=${OCL_ICD_VENDORS:-pocl.icd}
export ASAN_OPTIONS=detect_leaks=1
export LSAN_OPTIONS=suppressions=$suppressed/leaks.txt:print_suppressions=0
export UBSAN_OPTIONS=print_stacktrace=1
export TSAN_OPTIONS=suppressions=$suppressed/threads.txt:halt_on_error=0

[ $# -gt 0 ] || set -- address thread
for kind; do
  case $kind in
    address | thread) ;;
    *) echo "error: there is no check '$kind', must be address or thread" >&2 && exit 1 ;;
  esac
done
for kind; do "check_$kind"; done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
