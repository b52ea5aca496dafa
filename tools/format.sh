#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Formats the C++ sources as .clang-format says; with --check it lists what it would change, and fails.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

folders=(host tests examples python vtk)
mapfile -t files < <(find "${folders[@]}" \( -name '*.cpp' -o -name '*.hpp' -o -name '*.h' \) -print | sort)
if [ "${1:-}" = --check ]; then
  said=$(clang-format --dry-run "${files[@]}" 2>&1 |
    sed -n 's/^\([^: ]*\):[0-9]*:[0-9]*: warning: code should be.*/\1/p' | uniq -c)
  [ -z "$said" ] || { echo "places to format, by file:" && echo "$said" && exit 1; }
  echo "${#files[@]} files are laid out as .clang-format says"
else
  clang-format -i "${files[@]}"
fi
