# Copyright (c) 2026 The Point_set_skeletonization_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Reads the files of made_up_skeleton with other people's readers, where Debian has one; every
coordinate has to be the same double. Usage: check_formats.py [--vtk], in the folder of s.*"""

import csv
import math
import sys
import unittest

import ezdxf
import meshio
import networkx
import numpy

CORNERS = [(0, 0, 0), (0, 0, 1), (0, 0, 2), (1, 0, 3), (0, 0, 4), (-1, 0, 3), (0, 2, 1), (9, 9, 9)]
POINTS = [(500000 + x / 3, 5300000 + y / 7, 400 + z / 3) for x, y, z in CORNERS]
RADII = [0.1 + 0.1 * i for i in range(len(POINTS))]
EDGES = {(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (2, 5), (1, 6)}
BRANCHES = {(0, 1), (1, 6), (1, 2), (2, 3, 4, 5, 2), (7,)}  # each in one of its directions
ORDER = {(0, 1): 0, (1, 6): 1, (1, 2): 0, (2, 3, 4, 5, 2): 1, (7,): 0}


def number(point):
    """Of the vertex with exactly these coordinates."""
    return POINTS.index(tuple(point))


def directed(path):
    """A branch as it is listed above."""
    path = tuple(path)
    return path if path in BRANCHES else path[::-1]


def sorted_edge(v, w):
    return min(v, w), max(v, w)


class FormatsTest(unittest.TestCase):
    def check_branches(self, paths):
        self.assertEqual(sorted(map(directed, paths)), sorted(BRANCHES))

    def test_polylines(self):
        with open("s.polylines.txt", encoding="ascii") as file:
            rows = [numpy.array(line.split(), float) for line in file]
        for row in rows:
            self.assertEqual(len(row), 1 + 3 * row[0])
        self.check_branches([number(p) for p in row[1:].reshape(-1, 3)] for row in rows)

    def test_obj_by_meshio(self):
        with open("s.obj", encoding="ascii") as file:
            lines = [line.split() for line in file]
        mesh = meshio.read("s.obj")  # reads vertices, and no lines
        self.assertEqual([tuple(p) for p in mesh.points], POINTS)
        edges = {sorted_edge(int(v) - 1, int(w) - 1) for kind, v, w, *_ in lines if kind == "l"}
        self.assertEqual(edges, EDGES)

    def test_ply(self):
        header = 11
        rows = numpy.loadtxt("s.ply", skiprows=header, max_rows=len(POINTS))
        self.assertEqual([tuple(row) for row in rows[:, :3]], POINTS)
        self.assertEqual(list(rows[:, 3]), RADII)
        edges = numpy.loadtxt("s.ply", int, skiprows=header + len(POINTS))
        self.assertEqual({sorted_edge(*edge) for edge in edges}, EDGES)

    def test_graphml_by_networkx(self):
        graph = networkx.read_graphml("s.graphml", node_type=int)
        for v, data in graph.nodes(data=True):
            self.assertEqual((data["x"], data["y"], data["z"]), POINTS[v])
            self.assertEqual(data["radius"], RADII[v])
        self.assertEqual({sorted_edge(*edge) for edge in graph.edges}, EDGES)
        self.assertEqual(len(networkx.cycle_basis(graph)), 1)
        for v, w, data in graph.edges(data=True):
            self.assertAlmostEqual(data["length"], math.dist(POINTS[v], POINTS[w]), 9)
        self.assertEqual(graph.edges[0, 1]["branch"], 0)
        self.assertEqual(graph.edges[1, 6]["order"], 1)
        self.assertEqual(graph.edges[1, 2]["axis"], graph.edges[0, 1]["axis"])

    def test_dxf_by_ezdxf(self):
        document = ezdxf.readfile("s.dxf")
        self.assertEqual(document.dxfversion, "AC1009")
        paths = []
        for line in document.modelspace().query("POLYLINE"):
            path = [number(p) for p in line.points()]
            path += path[:1] if line.is_closed else []
            self.assertEqual(line.get_mode(), "AcDb3dPolyline")
            self.assertEqual(line.dxf.layer, f"ORDER_{ORDER[directed(path)]}")
            paths.append(path)
        paths += [[number(p.dxf.location)] for p in document.modelspace().query("POINT")]
        self.check_branches(paths)

    def test_swc(self):
        rows = numpy.loadtxt("s.swc", comments="#")
        ids = list(rows[:, 0].astype(int))
        self.assertEqual(ids, list(range(1, len(POINTS) + 1)))
        vertex = [number(p) for p in rows[:, 2:5]]
        self.assertEqual(list(rows[:, 5]), [RADII[v] for v in vertex])
        edges = set()
        for row_id, parent in zip(ids, rows[:, 6].astype(int)):
            self.assertLess(parent, row_id)
            if parent != -1:
                edges.add(sorted_edge(vertex[row_id - 1], vertex[parent - 1]))
        with open("s.swc", encoding="ascii") as file:
            closing = [line.split()[-2:] for line in file if line.startswith("# closes a cycle:")]
        self.assertEqual(len(closing), 1)
        (v, w), = [(vertex[int(i) - 1], vertex[int(j) - 1]) for i, j in closing]
        self.assertEqual(edges | {sorted_edge(v, w)}, EDGES)
        self.assertNotIn(sorted_edge(v, w), edges)

    def test_tubes_by_meshio(self):
        for filename in "s.off", "s.tubes.ply":
            mesh = meshio.read(filename)
            self.assertEqual([block.type for block in mesh.cells], ["triangle"])
            triangles = mesh.cells[0].data
            sides = [(t[k], t[(k + 1) % 3]) for t in triangles.tolist() for k in range(3)]
            # Closed: every side once in each direction.
            self.assertEqual(len(set(sides)), len(sides))
            self.assertEqual({(w, v) for v, w in sides}, set(sides))
            away = [min(math.dist(p, q) for q in POINTS) for p in mesh.points]
            self.assertLess(max(away), 1)

    def test_cylinders(self):
        with open("s.csv", encoding="ascii", newline="") as file:
            rows = list(csv.DictReader(file))
        ends = {}
        for row in rows:
            start, end = ([float(row[side + axis]) for axis in "XYZ"] for side in ("start", "end"))
            ends[row["ID"]] = number(start), number(end)
            self.assertAlmostEqual(float(row["length"]), math.dist(start, end), 9)
            radii = [RADII[v] for v in ends[row["ID"]]]
            self.assertAlmostEqual(float(row["radius"]), sum(radii) / 2, 12)
            if row["parentID"] == "-1":
                self.assertEqual(row["parentSegmentID"], "-1")
            else:  # a cylinder starts where its parent ends
                self.assertEqual(ends[row["parentID"]][1], ends[row["ID"]][0])
        self.assertEqual({sorted_edge(*edge) for edge in ends.values()}, EDGES)
        self.assertEqual(sum(row["parentID"] == "-1" for row in rows), 1)


class VtkTest(unittest.TestCase):
    def read(self, reader, filename):
        reader.SetFileName(filename)
        reader.Update()
        data = reader.GetOutput()
        self.assertEqual(data.GetNumberOfPoints(), len(POINTS))
        return data

    def lines(self, data):
        result = []
        for i in range(data.GetNumberOfCells()):
            cell = data.GetCell(i)  # valid until the next call
            result.append([cell.GetPointId(k) for k in range(cell.GetNumberOfPoints())])
        return result

    def test_vtp(self):
        import vtk
        data = self.read(vtk.vtkXMLPolyDataReader(), "s.vtp")
        for v, point in enumerate(POINTS):
            self.assertEqual(data.GetPoint(v), point)
            self.assertEqual(data.GetPointData().GetArray("radius").GetValue(v), RADII[v])
        paths = self.lines(data)
        self.assertEqual(sorted(map(directed, paths)), sorted(BRANCHES))
        for i, path in enumerate(paths):
            order = data.GetCellData().GetArray("order").GetValue(i)
            self.assertEqual(order, ORDER[directed(path)])
            length = sum(math.dist(POINTS[v], POINTS[w]) for v, w in zip(path, path[1:]))
            self.assertAlmostEqual(data.GetCellData().GetArray("length").GetValue(i), length, 9)

    def test_ply(self):
        import vtk
        data = self.read(vtk.vtkPLYReader(), "s.ply")  # coordinates as float, no edges
        for v, point in enumerate(POINTS):
            numpy.testing.assert_allclose(data.GetPoint(v), point, rtol=1e-7)

    def test_tubes(self):
        import vtk
        reader = vtk.vtkPLYReader()
        reader.SetFileName("s.tubes.ply")
        reader.Update()
        edges = vtk.vtkFeatureEdges()  # of closed manifolds there are none
        edges.SetInputData(reader.GetOutput())
        edges.FeatureEdgesOff()
        edges.Update()
        self.assertGreater(reader.GetOutput().GetNumberOfPolys(), 0)
        self.assertEqual(edges.GetOutput().GetNumberOfCells(), 0)

    def test_obj(self):
        import vtk
        data = self.read(vtk.vtkOBJReader(), "s.obj")  # coordinates as float
        self.assertEqual({sorted_edge(*edge) for edge in self.lines(data)}, EDGES)


if __name__ == "__main__":
    if "--vtk" in sys.argv:
        sys.argv.remove("--vtk")
    else:
        del VtkTest
    unittest.main()
