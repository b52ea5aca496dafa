#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Measures every suite of `cdsm bench` with build/cdsm, about 15 minutes on 2 quiet cores: figures to build/bench/,
# plots to docs/images/, tables into docs/benchmarks.md.
# usage: run_all.sh [RUNS [OPTION...]]    (5 runs for each figure; options go to `cdsm bench`, e.g. --device 1:0)
# PYTHON names a Python 3 with NumPy and Matplotlib.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
python=${PYTHON:-python3}
runs=${1:-5}
options=("${@:2}")
suites=(demo map-size volume-size tolerance objects chunks memory techniques query stochastic spheres gallery
        clustering)

[ -x build/cdsm ] || { echo "error: there is no build/cdsm; bash tools/demo.sh builds it" >&2; exit 1; }
"$python" -c "import numpy, matplotlib" || {
  echo "error: $python lacks NumPy or Matplotlib; install python3-numpy and python3-matplotlib, or set PYTHON" >&2
  exit 1
}
"$python" scenes/papers/make_data.py
[ -f scenes/bench/smoke.nrrd ] || "$python" scenes/bench/make_smoke.py

mkdir -p build/bench
results=()
for suite in "${suites[@]}"; do
  results+=("build/bench/$suite.json")
  seconds=$SECONDS
  build/cdsm bench "$suite" --runs "$runs" --json "build/bench/$suite.json" "${options[@]}" >"build/bench/$suite.txt"
  echo "$suite: $((SECONDS - seconds)) s, build/bench/$suite.txt"
done
"$python" tools/report/plot_bench.py "${results[@]}" -o docs/images
"$python" tools/report/bench_tables.py "${results[@]}" --page docs/benchmarks.md
