#!/usr/bin/python3
# Copyright (c) 2026 The Point_set_skeletonization_3 authors.
# SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

"""Draws a skeleton over its cloud, from the front and in three-quarter view.

Usage: draw_skeleton.py SKELETON.ply POINTS.xyz PICTURE.png
"""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d.art3d import Line3DCollection

MAX_DOTS = 8000  # more of them hide the skeleton
COMPONENT_COLOURS = ["#1b5e9e", "#2e8b57", "#7b4fa3", "#a0632d", "#00838f", "#5d6d1e"]
JUNCTION_COLOUR = "#d62728"
END_COLOUR = "#1f9bff"
VIEWS = [(0, 0), (20, 45)]  # elevation and azimuth in degrees


def read_skeleton(filename):
    """Vertices (n, 3) and edges (m, 2) of a .ply written by skeletonize_point_set."""
    with open(filename, encoding="ascii") as file:
        sizes = {}
        for line in file:
            words = line.split()
            if words[0] == "element":
                sizes[words[1]] = int(words[2])
            if words[0] == "end_header":
                break
        numbers = [line.split() for line in file]
    vertices = np.array([row[:3] for row in numbers[: sizes["vertex"]]], float).reshape(-1, 3)
    edges = np.array(numbers[sizes["vertex"] :], int).reshape(-1, 2)
    return vertices, edges


def components(size, edges):
    """The number of the component of every vertex."""
    label = np.arange(size)
    changed = True
    while changed:
        before = label.copy()
        for i, j in edges:
            label[i] = label[j] = min(label[i], label[j])
        changed = (label != before).any()
    return np.unique(label, return_inverse=True)[1]


def upright(points):
    """The axes in the order depth, width, height: a model stands on its longest side."""
    order = np.argsort(np.ptp(points, axis=0), kind="stable")
    return order


def draw_view(axes, points, vertices, edges):
    # matplotlib's 3D plots sort by depth per artist; the skeleton always goes on top of the cloud.
    axes.computed_zorder = False
    axes.scatter(*points.T, s=1.5, c="#b9bec4", alpha=0.5, linewidths=0, zorder=1)
    label = components(len(vertices), edges)
    colours = [COMPONENT_COLOURS[label[i] % len(COMPONENT_COLOURS)] for i, _ in edges]
    axes.add_collection3d(
        Line3DCollection(vertices[edges], colors=colours, linewidths=2.6, capstyle="round", zorder=2)
    )
    degree = np.bincount(edges.ravel(), minlength=len(vertices))
    for chosen, colour in [(degree == 1, END_COLOUR), (degree >= 3, JUNCTION_COLOUR)]:
        axes.scatter(*vertices[chosen].T, s=26, c=colour, edgecolors="white", linewidths=0.7,
                     depthshade=False, zorder=3)


def draw(vertices, edges, points, filename):
    axis_order = upright(points)
    points, vertices = points[:, axis_order], vertices[:, axis_order]
    dots = points[:: max(1, len(points) // MAX_DOTS)]
    low, high = points.min(axis=0), points.max(axis=0)
    figure = plt.figure(figsize=(12, 6), dpi=100)
    for i, (elevation, azimuth) in enumerate(VIEWS):
        axes = figure.add_axes([0.5 * i, 0, 0.5, 1], projection="3d", proj_type="ortho")
        draw_view(axes, dots, vertices, edges)
        for limit, a, b in zip((axes.set_xlim, axes.set_ylim, axes.set_zlim), low, high):
            limit(a, b)
        axes.set_box_aspect(high - low, zoom=1.25)
        axes.view_init(elevation, azimuth)
        axes.set_axis_off()
    figure.savefig(filename)


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    vertices, edges = read_skeleton(sys.argv[1])
    points = np.loadtxt(sys.argv[2], ndmin=2)[:, :3]
    draw(vertices, edges, points, sys.argv[3])


if __name__ == "__main__":
    main()
