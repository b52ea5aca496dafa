# SPDX-License-Identifier: Apache-2.0
"""Periodic random fields on an N^3 grid, made in the frequency domain: turbulence for smoke, steam and fog."""
import numpy as np


def frequencies(n):
    """Wave vectors (3, n, n, n / 2 + 1), in periods per grid."""
    whole, half = np.fft.fftfreq(n, 1.0 / n), np.fft.rfftfreq(n, 1.0 / n)
    return np.stack(np.meshgrid(whole, whole, half, indexing="ij"))


def spectrum(n, slope, lowest, highest, rng, count):
    """`count` white-noise fields in the frequency domain, amplitudes falling as k^-slope between two frequencies."""
    waves = frequencies(n)
    k = np.sqrt((waves ** 2).sum(0))
    gain = np.where((k >= lowest) & (k <= highest), np.maximum(k, 1.0) ** -slope, 0.0)
    noise = np.stack([np.fft.rfftn(rng.standard_normal((n, n, n))) for _ in range(count)])
    return waves, noise * gain


def scalar(n, slope, lowest, highest, rng):
    """A field of mean 0 and deviation 1."""
    _, noise = spectrum(n, slope, lowest, highest, rng, 1)
    field = np.fft.irfftn(noise[0], (n, n, n))
    return field / field.std()


def flow(n, slope, lowest, highest, rng):
    """A velocity field without sources, (n, n, n, 3) as [z, y, x] of x, y, z; deviation 1 per component."""
    waves, noise = spectrum(n, slope, lowest, highest, rng, 3)
    along = (waves * noise).sum(0) / np.maximum((waves ** 2).sum(0), 1.0)
    noise -= waves * along
    field = np.stack([np.fft.irfftn(part, (n, n, n)) for part in noise[::-1]], -1)
    return (field / field.std()).astype(np.float32)
