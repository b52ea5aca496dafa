// SPDX-License-Identifier: Apache-2.0
// Voxels that come from a buffer of somebody else's: the host cannot look at them.

/// first: the smallest number of a voxel that is NaN or infinite; stays if there is none.
__kernel void findNonFinite(uint count, __global const float* voxels, __global uint* first) {
  uint i = (uint)get_global_id(0);
  if (i < count && !isfinite(voxels[i])) atomic_min(first, i);
}
