# Copyright (c) 2026 The Point_set_skeletonization_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""The Python module: arrays of all kinds, what it returns, errors, progress and Ctrl-C. Usage:
PYTHONPATH=build/python check_module.py"""

import inspect
import os
import pathlib
import pickle
import signal
import tempfile
import threading
import time
import unittest

import networkx
import numpy

import point_set_skeletonization
from point_set_skeletonization import (MixtureBuilder, Skeleton, skeletonize,
                                       skeletonize_as_published)


def cross(size):
    """Three limbs that meet: a tube along z, and one along x that starts in its middle."""
    random = numpy.random.default_rng(5)
    turn, along = random.uniform(0, 2 * numpy.pi, size), random.uniform(0, 10, size)
    tube = numpy.stack([numpy.cos(turn), numpy.sin(turn), along], 1)
    side = numpy.stack([along[::2] + 0.9, 0.6 * numpy.cos(turn[::2]),
                        5 + 0.6 * numpy.sin(turn[::2])], 1)
    return numpy.concatenate([tube, side])


class ModuleTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.points = cross(8000)
        cls.skeleton = skeletonize(cls.points)

    def assert_same(self, a, b):
        for name in "vertices", "radius", "edges", "point_map":
            numpy.testing.assert_array_equal(getattr(a, name), getattr(b, name))

    def test_the_graph(self):
        s = self.skeleton
        v, e = len(s.vertices), len(s.edges)
        self.assertEqual(s.vertices.shape, (v, 3))
        self.assertEqual(s.radius.shape, (v,))
        self.assertEqual(s.edges.shape, (e, 2))
        self.assertEqual(s.point_map.shape, (len(self.points),))
        self.assertEqual(v, e + 1)
        self.assertTrue((s.edges < v).all() and (s.edges >= 0).all())
        self.assertTrue((s.point_map < v).all() and (s.point_map >= -1).all())
        degree = numpy.bincount(s.edges.ravel())
        self.assertEqual(((degree == 1).sum(), (degree == 3).sum()), (3, 1))
        known = s.point_map >= 0
        away = self.points[known] - s.vertices[s.point_map[known]]
        self.assertLess(numpy.linalg.norm(away, axis=1).max(), 3)

    def test_arrays_of_any_layout(self):
        points = self.points
        wide = numpy.zeros((2 * len(points), 5))
        wide[::2, 1:4] = points
        backwards = points[::-1, ::-1].copy()
        packed = numpy.zeros(len(points), [("flag", "u1"), ("xyz", "<f8", 3)])
        packed["xyz"] = points
        for array in (numpy.asfortranarray(points), wide[::2, 1:4], backwards[::-1, ::-1],
                      packed["xyz"], points.astype(">f8"), points.tolist()):
            self.assert_same(skeletonize(array), self.skeleton)
        before = points.copy()
        skeletonize(points)
        numpy.testing.assert_array_equal(points, before)

    def test_float32_and_integers(self):
        single = self.points.astype(numpy.float32)
        self.assert_same(skeletonize(single), skeletonize(single.astype(float)))
        whole = numpy.rint(100 * self.points).astype(int)
        self.assert_same(skeletonize(whole), skeletonize(whole.astype(float)))

    def test_threads_do_not_matter(self):
        self.assert_same(skeletonize(self.points, threads=1), self.skeleton)

    def builder_of(self, points, source=None):
        builder = MixtureBuilder([*self.points.min(0), *self.points.max(0)])
        builder.insert(points, source=source)
        return builder

    def test_moments_add_up(self):
        whole = self.builder_of(self.points)
        self.assertEqual(whole.number_of_points, len(self.points))
        self.assertGreater(whole.number_of_cells, 100)
        a, b = self.builder_of(self.points[::-3], "a"), self.builder_of(self.points[:0], "b")
        b.insert(numpy.asfortranarray(self.points[::-1][1::3]))
        b.insert(self.points[::-1][2::3].tolist())
        a.merge(pickle.loads(pickle.dumps(b)))
        self.assertEqual((a.sources, b.sources), ({"a", "b"}, {"b"}))
        with tempfile.TemporaryDirectory() as folder:
            a.save(pathlib.Path(folder) / "a.moments")
            a = MixtureBuilder.load(pathlib.Path(folder) / "a.moments")
        self.assertEqual((a.sources, a.box), ({"a", "b"}, whole.box))
        s, t = whole.skeletonize(), a.skeletonize(threads=1)
        self.assert_same(s, t)
        numpy.testing.assert_array_equal(s.vertices, self.skeleton.vertices)
        self.assertEqual(s.point_map.shape, (0,))
        self.assertEqual(len(whole.skeletonize(is_tree=True).edges), len(s.edges))
        with self.assertRaisesRegex(RuntimeError, "cancelled"):
            whole.skeletonize(progress=lambda share: False)

    def test_smallest_feature(self):
        self.assert_same(skeletonize(self.points, smallest_feature=1e-9), self.skeleton)
        s = skeletonize(self.points, smallest_feature=1)
        self.assertFalse(numpy.array_equal(s.vertices, self.skeleton.vertices))
        self.assertEqual((numpy.bincount(s.edges.ravel()) == 1).sum(), 3)
        t = self.builder_of(self.points).skeletonize(smallest_feature=1)
        numpy.testing.assert_array_equal(s.vertices, t.vertices)

    def test_wrong_moments(self):
        a = self.builder_of(self.points[:10], "a")
        with self.assertRaisesRegex(ValueError, "'a' already"):
            a.insert(self.points, source="a")
        with self.assertRaisesRegex(ValueError, "point 12 is outside the given box"):
            a.insert([self.points[0], self.points[1], [0, 0, 99]])
        self.assertEqual(a.number_of_points, 12)
        with self.assertRaisesRegex(ValueError, "'a' as well"):
            a.merge(self.builder_of([self.points[0]], "a"))
        with self.assertRaisesRegex(ValueError, "another box"):
            a.merge(MixtureBuilder([0, 0, 0, 1, 1, 1]))
        with self.assertRaisesRegex(ValueError, "another bound"):
            a.merge(MixtureBuilder(a.box, maximum_cells=2000))
        with self.assertRaisesRegex(ValueError, "no box"):
            MixtureBuilder([1, 1, 1, 0, 0, 0])
        with self.assertRaisesRegex(ValueError, "maximum_cells must be in"):
            MixtureBuilder(a.box, maximum_cells=10)
        with self.assertRaisesRegex(RuntimeError, "there is no such file"):
            MixtureBuilder.load("no such.moments")
        with self.assertRaisesRegex(RuntimeError, "nowhere"):
            a.save("nowhere/a.moments")

    def test_no_points(self):
        s = skeletonize(numpy.zeros((0, 3)))
        self.assertEqual((s.vertices.shape, s.edges.shape, s.branches), ((0, 3), (0, 2), []))

    def test_branches(self):
        s = self.skeleton
        self.assertEqual([b.order for b in s.branches].count(1), 1)
        self.assertEqual([b.parent for b in s.branches], [None, 0, 0])
        side = max(s.branches, key=lambda b: s.vertices[b.vertices[-1], 0])
        self.assertAlmostEqual(side.angle, 90, delta=5)
        self.assertAlmostEqual(side.mean_radius, 0.6, delta=0.15)
        path = s.vertices[side.vertices]
        lengths = numpy.linalg.norm(numpy.diff(path, axis=0), axis=1)
        self.assertAlmostEqual(side.length, lengths.sum(), 9)
        tip = side.vertices[-1]
        self.assertEqual(s.branches_from([tip])[0].vertices[0], tip)
        with self.assertRaisesRegex(ValueError, "root 10000 is no vertex"):
            s.branches_from([10000])

    def test_networkx(self):
        graph = self.skeleton.to_networkx()
        self.assertTrue(networkx.is_tree(graph))
        self.assertEqual(len(graph), len(self.skeleton.vertices))
        length = sum(data["length"] for _, _, data in graph.edges(data=True))
        self.assertAlmostEqual(length, sum(b.length for b in self.skeleton.branches), 9)
        v = 3
        self.assertEqual(graph.nodes[v]["radius"], self.skeleton.radius[v])

    def test_save(self):
        with tempfile.TemporaryDirectory() as folder:
            for ending in "swc", "vtp", "csv", "graphml", "dxf", "obj", "ply", "polylines.txt":
                file = pathlib.Path(folder) / f"s.{ending}"
                self.skeleton.save(file)
                self.assertGreater(file.stat().st_size, 0)
            self.assertEqual(numpy.loadtxt(f"{folder}/s.swc").shape[0], len(self.skeleton.radius))
            with self.assertRaisesRegex(RuntimeError, "s.stl': name it"):
                self.skeleton.save(f"{folder}/s.stl")

    def test_wrong_points(self):
        for points, message in [
                (numpy.zeros((5, 2)), r"shape \(n, 3\), not \(5, 2\)"),
                (numpy.zeros(3), r"not \(3\)"),
                (numpy.zeros((4, 3), complex), "real numbers, not complex"),
                (numpy.array([["a", "b", "c"]]), "real numbers"),
                ([[1, 2, 3], [4, 5]], ""),
        ]:
            with self.assertRaisesRegex(ValueError, message):
                skeletonize(points)
        for value in numpy.nan, numpy.inf:
            broken = self.points.copy()
            broken[123, 1] = value
            with self.assertRaisesRegex(ValueError, r"\b123\b.*not finite"):
                skeletonize(broken)
        with self.assertRaisesRegex(ValueError, r"maximum_cells must be in \[1000"):
            skeletonize(self.points, maximum_cells=10)
        for length in 0, -1, numpy.nan, numpy.inf:
            for run in self.builder_of(self.points).skeletonize, \
                    lambda **keywords: skeletonize(self.points, **keywords):
                with self.assertRaisesRegex(ValueError, "smallest_feature must be more than 0"):
                    run(smallest_feature=length)
        with self.assertRaisesRegex(ValueError, "threads must be at least 1"):
            skeletonize(self.points, threads=0)

    def test_progress(self):
        shares = []
        skeletonize(self.points, progress=shares.append)
        self.assertEqual(shares, sorted(shares))
        self.assertEqual((shares[0], shares[-1]), (0, 1))
        with self.assertRaisesRegex(RuntimeError, "cancelled"):
            skeletonize(self.points, progress=lambda share: False)

        def fail(share):
            raise KeyError("mine")
        with self.assertRaisesRegex(KeyError, "mine"):
            skeletonize(self.points, progress=fail)

    def test_ctrl_c_cancels(self):
        points = cross(60000)
        timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
        with self.assertRaises(KeyboardInterrupt):
            timer.start()
            start = time.monotonic()
            for _ in range(1000):  # on any machine it is still at it
                skeletonize_as_published(points, number_of_iterations=100)
        self.assertLess(time.monotonic() - start, 20)

    def test_other_threads_go_on(self):
        done = threading.Event()
        worker = threading.Thread(
            target=lambda: (skeletonize_as_published(cross(20000)), done.set()))
        worker.start()
        counted = 0
        while not done.wait(0.001):
            counted += 1
        worker.join()
        self.assertGreater(counted, 20)

    def test_as_published(self):
        s = skeletonize_as_published(self.points, number_of_iterations=5, samples=200)
        same = skeletonize_as_published(self.points, number_of_iterations=5, samples=200, mu=0.2,
                                        delta_h=0.5, alpha=2.2, levels=3, flatness=0.3,
                                        sample_flatness=0.3, alpha_min=90, b_min=5, d_max=0.15)
        self.assert_same(s, same)
        other = skeletonize_as_published(self.points, number_of_iterations=5, samples=200,
                                         random_seed=1)
        self.assertFalse(numpy.array_equal(s.vertices, other.vertices))
        with self.assertRaisesRegex(ValueError, r"mu must be in \[0, 0.5\), not 0.7"):
            skeletonize_as_published(self.points, mu=0.7)

    def test_everything_is_documented(self):
        for thing in skeletonize, skeletonize_as_published:
            self.assertTrue(inspect.getdoc(thing))
        for thing in Skeleton, MixtureBuilder:
            self.assertTrue(inspect.getdoc(thing))
            for name in dir(thing):
                if not name.startswith("_"):
                    self.assertTrue(inspect.getdoc(getattr(thing, name)), name)
        folder = pathlib.Path(point_set_skeletonization.__file__).parent
        stubs = (folder / "__init__.pyi").read_text(encoding="utf-8")
        for name in dir(Skeleton) + dir(MixtureBuilder) + point_set_skeletonization.__all__:
            if not name.startswith("_"):
                self.assertIn(name, stubs)


if __name__ == "__main__":
    unittest.main()
