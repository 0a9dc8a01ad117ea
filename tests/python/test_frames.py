# SPDX-License-Identifier: GPL-2.0-or-later
"""Frames as arrays."""
import gc
import math
import subprocess
import unittest

import numpy as np

import mikromakro
from program import GOOD, PROGRAM, Case, dumps


class Frames(Case):
    def test_holds_what_the_dump_holds(self):
        first, second = mikromakro.frames(**GOOD)
        self.assertEqual((first.step, second.step, first.index, second.index), (100, 200, 0, 1))
        self.assertTrue(math.isnan(first.time))
        self.assertEqual(first.box.tolist(), [[-5, 5], [-5, 5]])
        self.assertEqual(first.periodic, (False, False))
        discs, contacts = first.particles, first.contacts
        self.assertEqual(discs["id"].tolist(), [7, 3, 20, 12])
        self.assertEqual(discs[1].tolist(), (3, 1, 1.9, 0.0, 0.5, 0.5, -1.0, -0.5, 0.2))
        self.assertEqual([contacts[name].tolist() for name in ("id1", "id2", "index1", "index2")],
                         [[7, 12, 7], [3, 3, 0], [0, 3, 0], [1, 1, -1]])
        self.assertEqual(contacts["overlap"].tolist(), [0.1, 0.025, 0.02])
        self.assertEqual(contacts["fx"].tolist(), [-10, 5, 2])
        self.assertIn("4 discs, 3 contacts", repr(first))

    def test_the_same_from_a_snapshot(self):
        subprocess.run([PROGRAM, "convert", "--particles", GOOD["particles"], "--contacts", GOOD["contacts"], "--timestep", "0.25",
                        "--out", self.path("run.h5")], check=True)
        for frame, dumped in zip(mikromakro.frames(self.path("run.h5")), mikromakro.frames(**GOOD)):
            np.testing.assert_array_equal(frame.particles, dumped.particles)
            for name in frame.contacts.dtype.names:
                np.testing.assert_array_equal(frame.contacts[name], dumped.contacts[name])
            self.assertEqual(frame.time, 0.25 * frame.step)

    def test_views_outlive_the_frame(self):
        kept = []
        for frame in mikromakro.frames(**dumps(self.folder, 5, float)):
            self.assertIs(frame.particles.base, frame)
            kept.append(frame.particles["vy"])
        del frame
        gc.collect()
        self.assertEqual([array.tolist() for array in kept], [[float(i)] * 3 for i in range(5)])
        with self.assertRaises(ValueError):
            kept[0][0] = 1

    def test_what_is_not_there_is_nan(self):
        (frame,) = mikromakro.frames(particles=GOOD["particles"], particle_columns="id,type,x,y,-,radius,-,-,-,-", frames=0)
        self.assertTrue(np.isnan(frame.particles["vx"]).all())
        self.assertFalse(frame.contacts_known)

    def test_selection_and_several_runs(self):
        self.assertEqual([frame.step for frame in mikromakro.frames(**GOOD, frames="-1")], [200])
        runs = list(mikromakro.frames(particles=[[GOOD["particles"]], [GOOD["contacts"].replace("contacts", "box_particles")]]))
        self.assertEqual({frame.run for frame in runs}, {0, 1})
        with self.assertRaisesRegex(mikromakro.Error, "no frame is selected"):
            next(mikromakro.frames(**GOOD, steps="5:6"))

    def test_sums_over_contacts(self):
        frame = next(mikromakro.frames(**GOOD))
        # contacts 7-3, 12-3, 7-wall; discs 7, 3, 20, 12
        self.assertEqual(frame.sum_over_contacts(np.ones(3)).tolist(), [2, 2, 0, 1])
        fx = frame.contacts["fx"]
        self.assertEqual(frame.sum_over_contacts(fx, -fx).tolist(), [-8, 5, 0, 5])
        with self.assertRaisesRegex(ValueError, "3 contacts"):
            frame.sum_over_contacts([1, 2])

    def test_two_at_a_time_and_left_behind(self):
        files = dumps(self.folder, 5)
        a, b = mikromakro.frames(**files), mikromakro.frames(**files)
        self.assertEqual([next(a).step, next(b).step, next(a).step], [0, 0, 1])
        del a
        self.assertEqual(len(list(b)), 4)


if __name__ == "__main__":
    unittest.main()
