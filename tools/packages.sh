# SPDX-License-Identifier: Apache-2.0
# The Debian 12 packages that cdsm needs, each with its reason, and how to install those that are missing.
# Sourced by demo.sh and test.sh. docs/dependencies.md says why these libraries and no others.

build_packages() {
  cat <<'LIST'
g++                     compiles the C++17 sources
cmake                   configures the build
ninja-build             builds with all cores
ocl-icd-opencl-dev      OpenCL headers and the loader that finds every installed driver
opencl-clhpp-headers    the C++ binding <CL/opencl.hpp>
pocl-opencl-icd         OpenCL on the CPU, so that no GPU is needed
libglm-dev              vectors and matrices of the public headers
libopenimageio-dev      writes PNG and EXR images
libimath-dev            half floats in OpenImageIO's headers
libassimp-dev           reads OBJ, PLY, STL and glTF meshes
libteem-dev             reads NRRD volumes
libnifti-dev            reads NIfTI volumes
libopenvdb-dev          reads OpenVDB volumes
libgdcm-dev             decodes slices of DICOM series
gemmi-dev               reads PDB and mmCIF molecules, headers alone
tao-pegtl-dev           the parser in gemmi's headers
libjxl-dev              judges how different images look, for cdsm compare
libpugixml-dev          reads VTK image data and XML presets
libboost-dev            Boost.Geometry: convex hulls of the clustering
zlib1g-dev              inflates compressed volumes
libtomlplusplus-dev     reads scene files
libcli11-dev            parses the command line
nlohmann-json3-dev      writes statistics, checks glTF files
LIST
}

test_packages() {
  cat <<'LIST'
libgtest-dev            unit, property and kernel tests
python3                 tests through the command line, lint
clang                   checks every variant of the kernels
clang-format            checks the layout of the C++ sources
oclgrind                runs kernels under an interpreter that finds races and stray accesses
openimageio-tools       flattens the deep EXR files that are written
openexr                 looks at them, too
doxygen                 reads the public headers
pkg-config              builds a program that uses the installed library
pybind11-dev            builds the Python module
python3-dev             Python's headers, for it
python3-numpy           its arrays
mesa-opencl-icd         a second OpenCL implementation, one that reads images
LIST
}

# Those of the named packages that are not installed, one per line.
missing_packages() {
  local name
  for name in "$@"; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$name" 2>/dev/null)" = installed ] || echo "$name"
  done
}

# Runs a command as root, without ever asking for a password.
as_root() {
  if [ "$(id -u)" = 0 ]; then "$@"; else sudo -n "$@"; fi
}

# What keeps this machine from installing packages; nothing if it can.
why_no_install() {
  if ! command -v apt-get >/dev/null; then
    echo "there is no apt-get here"
  elif [ "$(id -u)" != 0 ] && ! sudo -n true 2>/dev/null; then
    echo "this user is neither root nor may use sudo without a password"
  fi
}

# Reads a list as above from standard input and installs what is missing of it. CDSM_PACKAGES=skip trusts the machine.
install_packages() {
  [ "${CDSM_PACKAGES:-}" != skip ] || return 0
  local missing reason
  missing=$(missing_packages $(awk '{ print $1 }') | tr '\n' ' ')
  missing=${missing% }
  [ -n "$missing" ] || return 0
  reason=$(why_no_install)
  if [ -n "$reason" ]; then
    echo "error: $reason; install these Debian packages, or their like and set CDSM_PACKAGES=skip: $missing" >&2
    return 1
  fi
  echo "Installing with apt-get: $missing"
  local apt=(env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Acquire::Retries=3 -o DPkg::Lock::Timeout=300
             -o Dpkg::Use-Pty=0)
  as_root "${apt[@]}" update </dev/null || echo "warning: apt-get update failed, going on with the lists there are" >&2
  if ! as_root "${apt[@]}" install -y --no-install-recommends $missing </dev/null >/dev/null; then
    echo "error: apt-get could not install: $missing" >&2
    return 1
  fi
}
