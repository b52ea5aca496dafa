// SPDX-License-Identifier: Apache-2.0
// Exclusive prefix sums of uint arrays in two levels: sums of blocks, then each block from its offset.
// Order of work items cannot reach the result: every sum is over integers in a fixed range.

#define CDSM_SCAN_BLOCK 1024

/// A work item per block: its sum.
__kernel void scanBlockSums(uint count, __global const uint* values, __global ulong* blockSums) {
  uint first = (uint)get_global_id(0) * CDSM_SCAN_BLOCK;
  if (first >= count) return;
  uint last = min(first + CDSM_SCAN_BLOCK, count);
  ulong sum = 0;
  for (uint i = first; i < last; ++i) sum += values[i];
  blockSums[get_global_id(0)] = sum;
}

/// One work item: offsets of the blocks in place, and behind them the total, in 64 bits for the host to check.
__kernel void scanBlocks(uint blockCount, __global ulong* blockSums) {
  ulong sum = 0;
  for (uint i = 0; i < blockCount; ++i) {
    ulong value = blockSums[i];
    blockSums[i] = sum;
    sum += value;
  }
  blockSums[blockCount] = sum;
}

/// A work item per block: the sums of its values; `sums` has count + 1 entries, the last is the total.
__kernel void scanValues(uint count, __global const uint* values, __global const ulong* blockSums,
                         __global uint* sums) {
  uint first = (uint)get_global_id(0) * CDSM_SCAN_BLOCK;
  if (first >= count) return;
  uint last = min(first + CDSM_SCAN_BLOCK, count);
  uint sum = (uint)blockSums[get_global_id(0)];
  for (uint i = first; i < last; ++i) {
    sums[i] = sum;
    sum += values[i];
  }
  if (last == count) sums[count] = sum;
}
