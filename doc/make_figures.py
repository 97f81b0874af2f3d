#!/usr/bin/python3
# Copyright (c) 2026 The Point_set_skeletonization_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Makes the figures of the manual from what our own programs compute, once these are built.
Usage: make_figures.py BUILD_FOLDER FOLDER_OF_FIGURES, for example build doc/figures"""

import pathlib
import subprocess
import sys
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import EllipseCollection, LineCollection

POINTS, CURVE, TIP, JUNCTION = "#c3c8ce", "#7a1f8a", "#1f9bff", "#d62728"
BRANCHES = plt.get_cmap("tab20").colors


class Programs:
    """What is in the build folder, run in a folder of its own."""

    def __init__(self, build, folder):
        self.build, self.folder = pathlib.Path(build).resolve(), pathlib.Path(folder)
        sys.path.append(str(self.build / "python"))

    def model(self, name):
        return str(self.build / "cgal_data/data/meshes" / f"{name}.off")

    def run(self, program, *arguments):
        subprocess.run([self.build / "examples" / program, *arguments], cwd=self.folder, check=True,
                       stdout=subprocess.DEVNULL)

    def read(self, filename):
        return np.loadtxt(self.folder / filename, ndmin=2)

    def sampled(self, name, size):
        """Points on a mesh of CGAL."""
        self.run("skeletonize_point_set", self.model(name), "--sample", str(size), "--quiet",
                 "--points", "sampled.xyz")
        return self.read("sampled.xyz")


def flat(points, turn=0.0):
    """Right and up on a picture of a model that stands along y, turned about it by degrees."""
    turn = np.radians(turn)
    points = np.asarray(points)
    return np.stack([np.cos(turn) * points[..., 0] + np.sin(turn) * points[..., 2],
                     points[..., 1]], -1)


def frame(axes, title=""):
    axes.set_aspect("equal")
    axes.set_axis_off()
    axes.set_title(title, fontsize=8 if len(title) < 24 else 6.5)


def save(figure, folder, name, dpi=110):
    figure.savefig(folder / name, dpi=dpi, bbox_inches="tight", pad_inches=0.05,
                   metadata={"Software": None})
    plt.close(figure)


def draw_cloud(axes, points, most=6000, **options):
    chosen = points[:: max(1, len(points) // most)]
    axes.scatter(*chosen.T, **{"s": 0.8, "c": POINTS, "linewidths": 0, **options})


def draw_graph(axes, vertices, edges, colour=CURVE, width=1.6):
    """The skeleton, its tips and its junctions."""
    axes.add_collection(LineCollection(vertices[edges], colors=colour, linewidths=width,
                                       capstyle="round"))
    degree = np.bincount(np.ravel(edges), minlength=len(vertices))
    for chosen, mark in [(degree == 1, TIP), (degree >= 3, JUNCTION)]:
        axes.scatter(*vertices[chosen].T, s=9, c=mark, edgecolors="white", linewidths=0.4, zorder=3)


def read_skeleton(filename):
    """Vertices and edges of a .ply that write_curve_skeleton() wrote."""
    with open(filename, encoding="ascii") as file:
        sizes = {}
        for line in file:
            words = line.split()
            if words[0] == "element":
                sizes[words[1]] = int(words[2])
            if words[0] == "end_header":
                break
        rows = [line.split() for line in file]
    vertices = np.array([row[:3] for row in rows[: sizes["vertex"]]], float).reshape(-1, 3)
    return vertices, np.array(rows[sizes["vertex"]:], int).reshape(-1, 2)


def ellipses(rows):
    """Widths, heights and angles of the projected covariances, given as xx xy xz yy yz zz."""
    covariances = np.stack([np.stack([rows[:, 0], rows[:, 1]], -1),
                            np.stack([rows[:, 1], rows[:, 3]], -1)], 1)
    values, vectors = np.linalg.eigh(covariances)
    deviations = 2 * np.sqrt(np.maximum(values, 0))
    angles = np.degrees(np.arctan2(vectors[:, 1, 1], vectors[:, 0, 1]))
    return deviations[:, 1], deviations[:, 0], angles


def draw_approach(programs, folder):
    """A figure for every stage: what it takes in grey, what it gives in colour."""
    points = programs.sampled("dino", 20000)
    size = np.linalg.norm(np.ptp(points, axis=0))
    noisy = points + np.random.default_rng(1).normal(0, 0.006 * size, points.shape)
    np.savetxt(programs.folder / "noisy.xyz", noisy)
    programs.run("stage_by_stage_example", "noisy.xyz")
    mixture = programs.read("stage_1.txt")
    surface = programs.read("stage_2_surface.txt")
    samples = programs.read("stage_2_samples.txt")
    vertices, edges = read_skeleton(programs.folder / "stage_by_stage_example.ply")

    def start():
        figure, axes = plt.subplots(figsize=(5, 4.4))
        frame(axes)
        return figure, axes

    figure, axes = start()
    draw_cloud(axes, flat(noisy), most=20000)
    widths, heights, angles = ellipses(mixture[:, 3:])
    axes.add_collection(EllipseCollection(
        widths, heights, angles, units="xy", offsets=flat(mixture[:, :3]),
        transOffset=axes.transData, facecolors="none", edgecolors="#2e6f9e", linewidths=0.4))
    save(figure, folder, "approach_1_mixture.png", 160)

    figure, axes = start()
    draw_cloud(axes, flat(surface[:, :3]), s=1.5)
    draw_cloud(axes, flat(surface[:, 3:]), s=1.5, c="#2e6f9e")
    save(figure, folder, "approach_2a_consolidated.png", 160)

    figure, axes = start()
    draw_cloud(axes, flat(surface[:, 3:]))
    axes.add_collection(LineCollection(np.stack([flat(samples[:, :3]), flat(samples[:, 3:6])], 1),
                                       colors="#b9cfe0", linewidths=0.5))
    shown = axes.scatter(*flat(samples[:, 3:6]).T, s=3, c=samples[:, 6], cmap="plasma",
                         linewidths=0)
    figure.colorbar(shown, ax=axes, shrink=0.6, label="radius")
    save(figure, folder, "approach_2c_samples.png", 160)

    figure, axes = start()
    nearest = np.argmin(((samples[:, None, 3:6] - vertices[None]) ** 2).sum(2), 1)
    branch = branch_numbers(len(vertices), edges)[nearest]
    axes.scatter(*flat(samples[:, :3]).T, s=4, c=[BRANCHES[b % 20] for b in branch], linewidths=0)
    draw_graph(axes, flat(vertices), edges, "black")
    save(figure, folder, "approach_3_skeleton.png", 160)


def branch_numbers(size, edges):
    """For every vertex, a number that those between the same two ends share."""
    degree = np.bincount(edges.ravel(), minlength=size)
    number = np.arange(size)
    inner = edges[(degree[edges] <= 2).all(1)]
    for _ in range(size):
        before = number.copy()
        np.minimum.at(number, inner[:, 0], before[inner[:, 1]])
        np.minimum.at(number, inner[:, 1], before[inner[:, 0]])
        if (number == before).all():
            break
    return np.unique(number, return_inverse=True)[1]


def draw_row(row, cases, turn):
    """A panel for each (title, points, skeleton)."""
    for axes, (title, points, skeleton) in zip(row, cases):
        draw_cloud(axes, flat(points, turn), most=3000)
        draw_graph(axes, flat(skeleton.vertices, turn), skeleton.edges)
        frame(axes, title)


def draw_parameters(programs, folder):
    """What the default method makes of one shape, with other points and other parameters."""
    from point_set_skeletonization import skeletonize

    random = np.random.default_rng(2)
    camel = programs.sampled("camel", 100000)
    random.shuffle(camel)
    size = np.linalg.norm(np.ptp(camel, axis=0))
    figure, rows = plt.subplots(3, 4, figsize=(11, 8.4))
    turn = 35

    def case(title, points, **parameters):
        return title, points, skeletonize(points, **parameters)

    draw_row(rows[0], [case(f"{n} points", camel[:n]) for n in (1000, 4000, 20000, 100000)], turn)
    draw_row(rows[1], [case(f"noise {share:g} % of the diagonal", camel[:20000]
                            + random.normal(0, share / 100 * size, (20000, 3)))
                       for share in (0.2, 0.5, 1, 2)], turn)
    cut = camel[:20000]
    along = cut @ np.array([0.0, 0.35, 0.94])  # through the neck
    cut = cut[~((along > np.quantile(along, 0.86)) & (along < np.quantile(along, 0.93)))]
    draw_row(rows[2], [case("is_tree(false)", camel[:20000]),
                       case("is_tree(true)", camel[:20000], is_tree=True),
                       case("single_component(false)", cut),
                       case("single_component(true)", cut, single_component=True)], turn)
    save(figure, folder, "parameters.png")


def draw_published_parameters(programs, folder):
    """Every parameter of the published method: lower, its default, higher."""
    from point_set_skeletonization import skeletonize_as_published

    points = programs.sampled("dino", 8000)
    values = {"h_0": (0.03, 0.1, 0.3), "delta_h": (0.1, 0.5, 1.5),
              "number_of_iterations": (10, 30, 60), "mu": (0.0, 0.2, 0.45),
              "samples": (150, 500, 2000), "alpha": (1.2, 2.2, 4.0), "levels": (1, 3, 5),
              "flatness": (0.03, 0.3, 1.0), "sample_flatness": (0.03, 0.3, 1.0),
              "alpha_min": (30, 90, 150), "b_min": (2, 5, 12), "d_max": (0.05, 0.15, 0.5)}
    figure, rows = plt.subplots(6, 6, figsize=(11, 10.5))
    for k, (name, three) in enumerate(values.items()):
        row = rows[k // 2][3 * (k % 2): 3 * (k % 2) + 3]
        draw_row(row, [(f"{name} = {value:g}", points,
                        skeletonize_as_published(points, **{name: value})) for value in three], 0)
    save(figure, folder, "published_parameters.png")


def upright(points, turn=0.0):
    """As flat(), of what stands along z."""
    return flat(np.asarray(points)[..., [0, 2, 1]], turn)


def draw_examples(programs, folder):
    """A plant, a tree, and two scans of a plant."""
    for name in "plant_phenotyping", "branches", "compare_scans":
        programs.run(f"{name}_example")
    figure, row = plt.subplots(1, 3, figsize=(11, 4.2))
    for axes, name, title in zip(row, ("plant_phenotyping", "branches"),
                                 ("plant_phenotyping_example", "branches_example")):
        draw_cloud(axes, upright(programs.read(f"{name}_example.xyz"), 30))
        vertices, edges = read_skeleton(programs.folder / f"{name}_example.ply")
        draw_graph(axes, upright(vertices, 30), edges)
        frame(axes, title)
    for when, colour in ("before", "#8a8f98"), ("after", CURVE):
        vertices, edges = read_skeleton(programs.folder / f"compare_scans_example_{when}.ply")
        draw_graph(row[2], upright(vertices, 30), edges, colour)
    frame(row[2], "compare_scans_example")
    save(figure, folder, "examples.png")


def main():
    build, folder = sys.argv[1:]
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch:
        programs = Programs(build, scratch)
        for draw in draw_approach, draw_parameters, draw_published_parameters, draw_examples:
            draw(programs, folder)


if __name__ == "__main__":
    main()
