// SPDX-License-Identifier: Apache-2.0
// The machine's rate of trilinear samples, the unit in which shading is measured: plain rays through a float volume,
// read from a buffer, interpolated by hand, nothing skipped, nothing else computed.

/// A work item per ray of size^2; `steps` samples each.
__kernel void sampleRays(int size, int steps, int volumeSize, __global const float* voxels, __global float* sums) {
  int ray = (int)get_global_id(0);
  if (ray >= size * size) return;
  float scale = (float)(volumeSize - 2) / (float)size, sum = 0.0f;
  float x = (float)(ray % size) * scale + 0.3f, y = (float)(ray / size) * scale + 0.3f;
  float dz = (float)(volumeSize - 2) / (float)steps;
  for (int i = 0; i < steps; ++i) {
    float z = ((float)i + 0.5f) * dz, sx = x + z * 0.001f, sy = y + z * 0.002f;
    int ix = (int)sx, iy = (int)sy, iz = (int)z;
    float fx = sx - ix, fy = sy - iy, fz = z - iz;
    __global const float* v = voxels + (iz * volumeSize + iy) * volumeSize + ix;
    float a = mix(v[0], v[1], fx), b = mix(v[volumeSize], v[volumeSize + 1], fx);
    v += volumeSize * volumeSize;
    float c = mix(v[0], v[1], fx), d = mix(v[volumeSize], v[volumeSize + 1], fx);
    sum += mix(mix(a, b, fy), mix(c, d, fy), fz);
  }
  sums[ray] = sum;
}
