# Copyright (c) 2026 The Point_set_skeletonization_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""The table of branches a.csv and the segmented cloud s.ply tell the same as the skeleton a.ply and
the cloud cloud.xyz, all in this folder."""

import csv

import numpy

cloud = numpy.loadtxt("cloud.xyz")
with open("s.ply", "rb") as file:
    header = file.read().partition(b"end_header\n")
fields = [("xyz", "<f8", 3), ("branch", "<i4"), ("order", "<i4"), ("distance", "<f8")]
points = numpy.frombuffer(header[2], fields)
assert (points["xyz"] == cloud).all()

with open("a.csv", encoding="ascii", newline="") as file:
    rows = list(csv.DictReader(file))
for b, row in enumerate(rows):
    assert int(row["points"]) == (points["branch"] == b).sum()
    assert (points["order"][points["branch"] == b] == int(row["order"])).all()
assert (points["order"][points["branch"] == -1] == -1).all()

with open("a.ply", encoding="ascii") as file:
    sizes = [int(line.split()[-1]) for line in file if line.startswith("element")]
vertices = numpy.loadtxt("a.ply", skiprows=11, max_rows=sizes[0])
edges = numpy.loadtxt("a.ply", int, skiprows=11 + sizes[0]).reshape(-1, 2)
start, end = vertices[edges[:, 0], :3], vertices[edges[:, 1], :3]
along = end - start
lengths = numpy.linalg.norm(along, axis=1)
assert abs(sum(float(row["length"]) for row in rows) - lengths.sum()) < 1e-9

share = ((cloud[:, None] - start) * along).sum(2) / (lengths**2)
nearest = start + numpy.clip(share, 0, 1)[:, :, None] * along
distances = numpy.linalg.norm(cloud[:, None] - nearest, axis=2).min(1)
assert abs(distances - points["distance"]).max() < 1e-12
