# SPDX-License-Identifier: Apache-2.0
# Configures and builds into build/. Sourced by demo.sh and test.sh, which set `root`, the repository.

# Compilers at a time: a core each, and about 1 GiB of memory each.
build_jobs() {
  local cores gibibytes
  cores=$(nproc)
  gibibytes=$(awk '/^MemAvailable/ { print int($2 / 1048576) }' /proc/meminfo)
  [ "$gibibytes" -ge 1 ] || gibibytes=1
  echo $((cores < gibibytes ? cores : gibibytes))
}

# configure OPTION...: options of a new build folder; one that was configured before keeps its own.
configure() {
  [ ! -f "$root/build/build.ninja" ] || return 0
  echo "Configuring $root/build"
  cmake -S "$root" -B "$root/build" -G Ninja -DCMAKE_BUILD_TYPE=Release "$@" >/dev/null
}

# build [TARGET]: everything, or one target.
build() {
  echo "Building with $(build_jobs) jobs"
  cmake --build "$root/build" --parallel "$(build_jobs)" ${1:+--target "$1"}
}
