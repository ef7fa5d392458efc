"""Prints what meshio finds in a .msh file: a line "dimension tag name elements size" per group.

Elements of no group count as tag 0. Sizes are numbers of points, lengths and signed areas.
Exit status 3: meshio is not installed.
"""
import contextlib
import sys

try:
    import meshio
except ImportError:
    sys.exit(3)

DIMENSION = {"vertex": 0, "line": 1, "triangle": 2}


def size(points):
    if len(points) == 1:
        return 1.0
    (x0, y0), (x1, y1) = points[0][:2], points[1][:2]
    if len(points) == 2:
        return float(((x1 - x0) ** 2 + (y1 - y0) ** 2) ** 0.5)
    x2, y2 = points[2][:2]
    return float(0.5 * ((x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)))


def main(path):
    with contextlib.redirect_stdout(sys.stderr):  # it prints while it reads
        mesh = meshio.read(path)
    names = {(int(d), int(t)): n for n, (t, d) in mesh.field_data.items()}
    tags = mesh.cell_data.get("gmsh:physical")
    groups = {}
    for i, block in enumerate(mesh.cells):
        dimension = DIMENSION[block.type]
        for k, cell in enumerate(block.data):
            key = (dimension, int(tags[i][k]) if tags is not None else 0)
            count, total = groups.get(key, (0, 0.0))
            groups[key] = (count + 1, total + size(mesh.points[cell]))
    print("vertices", len(mesh.points))
    for key in sorted(groups):
        print(*key, names.get(key, "-"), groups[key][0], f"{groups[key][1]:.12g}")


main(sys.argv[1])
