# SPDX-License-Identifier: GPL-2.0-or-later
"""Long calls: progress, Ctrl-C, other threads."""
import contextlib
import io
import os
import signal
import threading
import time
import unittest

import numpy as np

import mikromakro
from program import GOOD, Case, dumps

SLOW = 0.02  # s per frame


def slow(frame):
    time.sleep(SLOW)
    return np.ones(len(frame.particles))


class Calls(Case):
    def setUp(self):
        super().setUp()
        files = dumps(self.folder, 400)
        self.keywords = {"particles": files["particles"], "rings": (1, 4, 3), "fields": mikromakro.Field(slow), "error_blocks": 0}

    def test_ctrl_c(self):
        # no Python runs meanwhile that would look for the signal by itself; 360,000 volumes take their time
        keywords = {"particles": self.keywords["particles"], "grid": (-9, 9, 600, -9, 9, 600), "fields": "velocity", "error_blocks": 0}
        begin = time.monotonic()
        mikromakro.average(**keywords, frames="0:39", threads=1)
        all_frames = 10 * (time.monotonic() - begin)
        for threads in (1, 2):
            timer = threading.Timer(all_frames / 20, os.kill, (os.getpid(), signal.SIGINT))
            timer.start()
            begin = time.monotonic()
            with self.assertRaises(KeyboardInterrupt):
                mikromakro.average(**keywords, threads=threads, out=self.path("t.csv"))
            self.assertLess(time.monotonic() - begin, all_frames / 2)
            self.assertEqual([name for name in os.listdir(self.folder) if "t.csv" in name], [])
        # and the next call works
        self.assertEqual(mikromakro.average(**GOOD, rings=(0, 4, 2)).values.shape[0], 2)

    def test_others_run_meanwhile(self):
        counted = []
        def count():
            while not done.wait(0.001):
                counted.append(1)
        done = threading.Event()
        counter = threading.Thread(target=count)
        counter.start()
        mikromakro.average(**{**self.keywords, "frames": "0:20"})
        done.set()
        counter.join()
        self.assertGreater(len(counted), 10)

    def test_two_threads_take_turns(self):
        results = []
        threads = [threading.Thread(target=lambda: results.append(mikromakro.average(**GOOD, rings=(0, 4, 2)).to_csv())) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(results), 4)
        self.assertEqual(len(set(results)), 1)

    def test_progress(self):
        seen = []
        mikromakro.average(**{**self.keywords, "frames": "0:40"}, progress=lambda part, frames: seen.append((part, frames)))
        self.assertGreater(len(seen), 3)
        self.assertEqual(seen, sorted(seen))
        self.assertTrue(all(0 <= part <= 1 for part, _ in seen))
        shown = io.StringIO()
        with contextlib.redirect_stderr(shown):
            mikromakro.average(**{**self.keywords, "frames": "0:40"}, progress=True)
        self.assertRegex(shown.getvalue(), r"\r *\d+ %, \d+ frames")
        self.assertTrue(shown.getvalue().endswith("\r"))
        for wrong in (1, "yes"):
            with self.assertRaisesRegex(TypeError, "progress: expected True, False or a function"):
                mikromakro.average(**self.keywords, progress=wrong)
        def stop(part, frames):
            raise StopAsyncIteration("enough")
        with self.assertRaisesRegex(StopAsyncIteration, "enough"):
            mikromakro.average(**self.keywords, progress=stop)


if __name__ == "__main__":
    unittest.main()
