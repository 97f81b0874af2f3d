#!/usr/bin/python3
# Copyright (c) 2026 The Point_set_skeletonization_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares skeletons of a plot of the command `forest` with its trees.

Usage: check_forest.py truth.csv SKELETON.ply... , one of all trees or one of each
"""
import csv
import sys

import numpy


def read(filename):
    """The vertices and edges of a skeleton."""
    with open(filename) as file:
        counts = {}
        for line in file:
            words = line.split()
            if words[0] == "element":
                counts[words[1]] = int(words[2])
            if words[0] == "end_header":
                break
        rows = [line.split() for line in file]
    vertices = numpy.array([[float(x) for x in row[:3]] for row in rows[:counts["vertex"]]])
    return vertices, [(int(row[0]), int(row[1])) for row in rows[counts["vertex"]:]]


def components(size, edges):
    """The component of each vertex."""
    parent = list(range(size))

    def find(v):
        while parent[v] != v:
            parent[v] = parent[parent[v]]
            v = parent[v]
        return v

    for a, b in edges:
        parent[find(a)] = find(b)
    return [find(v) for v in range(size)]


def main():
    with open(sys.argv[1]) as file:
        trees = list(csv.DictReader(file))
    skeletons = [read(filename) for filename in sys.argv[2:]]
    whole = ends_found = ends_true = acyclic = strays = 0
    for tree in trees:
        box = {key: float(tree[key]) for key in ("xmin", "ymin", "xmax", "ymax")}
        parts, ends, cycles = 0, 0, 0
        for vertices, edges in skeletons:
            inside = ((vertices[:, 0] >= box["xmin"]) & (vertices[:, 0] < box["xmax"])
                      & (vertices[:, 1] >= box["ymin"]) & (vertices[:, 1] < box["ymax"]))
            if not inside.any():
                continue
            here = [(a, b) for a, b in edges if inside[a]]
            strays += sum(not inside[b] for a, b in here)
            own = {c for c, i in zip(components(len(vertices), edges), inside) if i}
            degree = numpy.bincount(numpy.array(edges).ravel(), minlength=len(vertices))
            parts += len(own)
            ends += int((degree[inside] == 1).sum())
            cycles += len(here) + len(own) - int(inside.sum())
        whole += parts == 1
        acyclic += cycles == 0
        ends_found += min(ends, int(tree["ends"]))
        ends_true += int(tree["ends"])
    print(f"trees {len(trees)}, one component {whole}, without cycle {acyclic}, "
          f"tips {ends_found} of {ends_true}, edges between trees {strays}, "
          f"files {len(skeletons)}")


main()
