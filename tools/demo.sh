#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# From a fresh Debian 12 to the demo's picture: installs what is missing, builds, renders to build/demo.png. Run again
# it does what is left to do. Arguments go to `cdsm render`, e.g. --device 1:0.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/tools/packages.sh"
source "$root/tools/build.sh"

scene=$root/scenes/demo/demo.toml
image=$root/build/demo.png

# True if the picture is missing or older than the tool or a file of the scenes.
is_outdated() { [ ! -f "$image" ] || [ -n "$(find "$root/build/cdsm" "$root/scenes" -type f -newer "$image")" ]; }

build_packages | install_packages
configure -DCDSM_TESTS=OFF
build cdsm-tool

if [ $# -gt 0 ] || [ -n "${CDSM_DEVICE:-}" ] || is_outdated; then
  echo "Rendering $scene"
  seconds=$SECONDS
  "$root/build/cdsm" render "$scene" -o "$image" "$@"
  echo "Rendered in $((SECONDS - seconds)) s"
else
  echo "Nothing to render: the picture is newer than the tool and the scenes"
fi
echo "The picture: $image"
