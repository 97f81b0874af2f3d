# Copyright (c) 2026 The Point_set_skeletonization_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""The skeleton of a knot, from points to a picture, cell by cell for those who like notebooks."""

# %% Points on a tube around a trefoil knot, with a little noise.
import matplotlib.pyplot as plt
import numpy as np

from point_set_skeletonization import skeletonize

random = np.random.default_rng(1)
size = 20000
t, around = random.uniform(0, 2 * np.pi, (2, size))


def knot(t):
    return np.stack([np.sin(t) + 2 * np.sin(2 * t), np.cos(t) - 2 * np.cos(2 * t),
                     -np.sin(3 * t)], 1)


along = knot(t + 1e-4) - knot(t)
along /= np.linalg.norm(along, axis=1, keepdims=True)
u = np.cross(along, [0.0, 0.0, 1.0])
u /= np.linalg.norm(u, axis=1, keepdims=True)
v = np.cross(along, u)
points = knot(t) + 0.35 * (np.cos(around)[:, None] * u + np.sin(around)[:, None] * v)
points += random.normal(0, 0.01, points.shape)

# %% The skeleton, and what it says.
skeleton = skeletonize(points)
for branch in skeleton.branches:
    print(f"length {branch.length:.2f}, mean radius {branch.mean_radius:.3f}, "
          f"closes a cycle: {branch.closes_cycle}")

# %% A picture.
axes = plt.figure(figsize=(7, 7)).add_subplot(projection="3d")
axes.scatter(*points[::4].T, s=1, color="#b9c0c9")
for branch in skeleton.branches:
    axes.plot(*skeleton.vertices[branch.vertices].T, linewidth=3, color="#9a179b")
axes.set_box_aspect(np.ptp(points, axis=0), zoom=1.6)
axes.view_init(60, -60)
axes.set_axis_off()
plt.savefig("knot.png")

# %% A file for other programs.
skeleton.save("knot.vtp")
