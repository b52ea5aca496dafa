# SPDX-License-Identifier: Apache-2.0
"""What a call from Python costs beside what the engine does: printed, judged by whoever reads it."""
import statistics
import time
import unittest

import numpy as np

import cdsm
import scenes

POINTS = 1000000


def milliseconds(call):
    begin = time.perf_counter()
    call()
    return 1000 * (time.perf_counter() - begin)


class Overhead(unittest.TestCase):
    def test_overhead_of_a_million_points(self):
        engine = cdsm.Engine()
        engine.prepare(scenes.scene(map_size=512))
        points = np.random.default_rng(1).uniform(-1, 1, (POINTS, 3)).astype(np.float32)
        for title, out in [("new array", None), ("own array", np.empty(POINTS, np.float32))]:
            whole, inside = [], []
            for _ in range(9):
                whole.append(milliseconds(lambda: engine.transmittance("sun", points, out=out)))
                inside.append(engine.stats["time_ms"]["total"])
            ratio = statistics.median(a / b for a, b in zip(whole, inside))
            print(f"1 M points, {title}, {statistics.median(whole):.1f} ms from Python, "
                  f"{statistics.median(inside):.1f} ms by the engine, {100 * (ratio - 1):.1f} % more (wanted: <= 5)")
            self.assertGreater(ratio, 1)


if __name__ == "__main__":
    unittest.main()
