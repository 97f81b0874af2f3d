#!/usr/bin/python3
# Copyright (c) 2026 The Point_set_skeletonization_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Draws a skeleton over its cloud, from the front and in three-quarter view."""

import argparse

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection

MAX_DOTS = 12000  # more of them hide the skeleton
COMPONENT_COLOURS = ["#1b5e9e", "#2e8b57", "#7b4fa3", "#a0632d", "#00838f", "#5d6d1e"]
JUNCTION_COLOUR = "#d62728"
END_COLOUR = "#1f9bff"
CLOUD_COLOUR = "#c3c8ce"
VIEWS = [(0, 0), (40, 20)]  # degrees: turned about the vertical, then seen from above


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


def view_of(points, up, turn, tilt):
    """A matrix that projects to (right, up) on the picture; depth is the thinner other axis."""
    vertical = "xyz".index(up)
    extents = np.ptp(points, axis=0)
    depth = min((i for i in range(3) if i != vertical), key=lambda i: extents[i])
    up_axis, depth_axis = np.eye(3)[vertical], np.eye(3)[depth]
    right_axis = np.cross(up_axis, depth_axis)
    turn, tilt = np.radians([turn, tilt])
    right = np.cos(turn) * right_axis + np.sin(turn) * depth_axis
    away = np.cos(turn) * depth_axis - np.sin(turn) * right_axis
    return np.array([right, np.cos(tilt) * up_axis + np.sin(tilt) * away])


def draw_view(axes, points, vertices, edges):
    axes.scatter(*points.T, s=2.2, c=CLOUD_COLOUR, linewidths=0, zorder=1)
    label = components(len(vertices), edges)
    colours = [COMPONENT_COLOURS[label[i] % len(COMPONENT_COLOURS)] for i, _ in edges]
    axes.add_collection(
        LineCollection(vertices[edges], colors=colours, linewidths=3, capstyle="round", zorder=2)
    )
    degree = np.bincount(edges.ravel(), minlength=len(vertices))
    for chosen, colour in [(degree == 1, END_COLOUR), (degree >= 3, JUNCTION_COLOUR)]:
        axes.scatter(*vertices[chosen].T, s=42, c=colour, edgecolors="white", linewidths=0.9,
                     zorder=3)


def draw(vertices, edges, points, up, filename):
    dots = points[:: max(1, len(points) // MAX_DOTS)]
    figure = plt.figure(figsize=(12, 6), dpi=100)
    for i, (turn, tilt) in enumerate(VIEWS):
        view = view_of(points, up, turn, tilt)
        axes = figure.add_axes([0.5 * i + 0.02, 0.03, 0.46, 0.94])
        draw_view(axes, dots @ view.T, vertices @ view.T, edges)
        axes.set_aspect("equal")
        axes.set_axis_off()
    figure.savefig(filename)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("skeleton", help=".ply written by skeletonize_point_set")
    parser.add_argument("points", help=".xyz")
    parser.add_argument("picture", help=".png to write")
    parser.add_argument("--up", choices="xyz", default="z", help="the vertical axis [z]")
    arguments = parser.parse_args()
    vertices, edges = read_skeleton(arguments.skeleton)
    points = np.loadtxt(arguments.points, ndmin=2)[:, :3]
    draw(vertices, edges, points, arguments.up, arguments.picture)


if __name__ == "__main__":
    main()
