# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading the fields of a run and cutting out the water."""

import sys

import numpy

try:
    import vtk
    from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
except ImportError:
    sys.exit("This tool needs the Debian package python3-vtk9: "
             "apt install python3-vtk9")


def read_grid(path):
    """The mesh with its point data; equal points of cells are joined."""
    reader = (vtk.vtkXMLPUnstructuredGridReader() if path.endswith(".pvtu")
              else vtk.vtkXMLUnstructuredGridReader())
    reader.SetFileName(path)
    reader.Update()
    raw = reader.GetOutput()
    if raw.GetNumberOfCells() == 0:
        sys.exit(f"Error: cannot read '{path}', or it has no cells.")

    points = vtk_to_numpy(raw.GetPoints().GetData())
    size = numpy.ptp(points, axis=0).max()
    _, first, merged = numpy.unique(
        numpy.round(points / (1e-6 * size)).astype(numpy.int64), axis=0,
        return_index=True, return_inverse=True)

    grid = vtk.vtkUnstructuredGrid()
    vtk_points = vtk.vtkPoints()
    vtk_points.SetData(numpy_to_vtk(points[first].copy(), deep=True))
    grid.SetPoints(vtk_points)
    connectivity = vtk_to_numpy(raw.GetCells().GetConnectivityArray())
    offsets = vtk_to_numpy(raw.GetCells().GetOffsetsArray())
    cells = vtk.vtkCellArray()
    cells.SetData(
        numpy_to_vtk(offsets.astype(numpy.int64), deep=True,
                     array_type=vtk.VTK_ID_TYPE),
        numpy_to_vtk(merged.ravel()[connectivity].astype(numpy.int64),
                     deep=True, array_type=vtk.VTK_ID_TYPE))
    grid.SetCells(raw.GetCellType(0), cells)
    for i in range(raw.GetPointData().GetNumberOfArrays()):
        array = raw.GetPointData().GetArray(i)
        copy = numpy_to_vtk(vtk_to_numpy(array)[first].copy(), deep=True)
        copy.SetName(array.GetName())
        grid.GetPointData().AddArray(copy)
    return grid


def is_flat(grid):
    """Whether the mesh is two-dimensional."""
    return grid.GetCellType(0) == vtk.VTK_QUAD


def cut_water(grid):
    """The part where the level set is negative; all without a level set."""
    if not grid.GetPointData().HasArray("level_set"):
        return grid
    grid.GetPointData().SetActiveScalars("level_set")
    clip = vtk.vtkTableBasedClipDataSet()
    clip.SetInputData(grid)
    clip.SetValue(0.)
    clip.InsideOutOn()
    clip.Update()
    return clip.GetOutput()


def polygons(data):
    """The corners of all two-dimensional cells, a list of arrays."""
    if data.GetNumberOfCells() == 0:
        return []
    points = vtk_to_numpy(data.GetPoints().GetData())
    cells = (data.GetPolys() if isinstance(data, vtk.vtkPolyData) else
             data.GetCells())
    connectivity = vtk_to_numpy(cells.GetConnectivityArray())
    offsets = vtk_to_numpy(cells.GetOffsetsArray())
    return [points[part] for part in
            numpy.split(connectivity, offsets[1:-1])]


def interface_lines(grid):
    """The line segments where the level set vanishes."""
    if not grid.GetPointData().HasArray("level_set"):
        return []
    grid.GetPointData().SetActiveScalars("level_set")
    contour = vtk.vtkContourFilter()
    contour.SetInputData(grid)
    contour.SetValue(0, 0.)
    contour.Update()
    output = contour.GetOutput()
    points = vtk_to_numpy(output.GetPoints().GetData())
    lines = vtk_to_numpy(output.GetLines().GetConnectivityArray())
    return points[lines.reshape(-1, 2)][:, :, :2] if len(lines) else []


def surface(data):
    """Corners (n, 3, 3) and averaged normals (n, 3) of the triangles of the
    surface of a three-dimensional grid."""
    hull = vtk.vtkGeometryFilter()
    hull.SetInputData(data)
    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputConnection(hull.GetOutputPort())
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputConnection(triangles.GetOutputPort())
    normals.SetFeatureAngle(50.)
    normals.AutoOrientNormalsOn()
    normals.Update()
    output = normals.GetOutput()
    if output.GetNumberOfPolys() == 0:
        return numpy.zeros((0, 3, 3)), numpy.zeros((0, 3))
    points = vtk_to_numpy(output.GetPoints().GetData())
    directions = vtk_to_numpy(output.GetPointData().GetNormals())
    corners = vtk_to_numpy(
        output.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    mean = directions[corners].mean(axis=1)
    length = numpy.linalg.norm(mean, axis=1, keepdims=True)
    return points[corners], mean / numpy.maximum(length, 1e-12)


def lie_inside(grid, positions):
    """Whether each of the positions (n, 3) is in a cell of the grid."""
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(numpy.ascontiguousarray(positions), deep=True))
    cloud = vtk.vtkPolyData()
    cloud.SetPoints(points)
    probe = vtk.vtkProbeFilter()
    # The default walks from cell to cell and ends where levels change.
    probe.SetCellLocatorPrototype(vtk.vtkStaticCellLocator())
    probe.SetInputData(cloud)
    probe.SetSourceData(grid)
    probe.Update()
    return point_array(probe.GetOutput(), "vtkValidPointMask") == 1


def point_array(data, name):
    """An array at the points, or None."""
    array = data.GetPointData().GetArray(name)
    return None if array is None else vtk_to_numpy(array)


def cell_means(data, values):
    """The mean over each cell of a value given at the points."""
    cells = data.GetCells()
    connectivity = vtk_to_numpy(cells.GetConnectivityArray())
    offsets = vtk_to_numpy(cells.GetOffsetsArray())
    sums = numpy.add.reduceat(values[connectivity], offsets[:-1])
    return sums / numpy.diff(offsets)


def point_positions(data):
    """The coordinates of the points."""
    return vtk_to_numpy(data.GetPoints().GetData())
