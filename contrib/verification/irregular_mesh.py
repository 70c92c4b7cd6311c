# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of the unit box for Gmsh whose inner nodes are moved."""

import itertools
import random


def kuhn(vertex, dim):
    """The simplices of a cell with the corners VERTEX(offsets)."""
    for order in itertools.permutations(range(dim)):
        offset = [0] * dim
        nodes = [vertex(*offset)]
        for d in order:
            offset[d] = 1
            nodes.append(vertex(*offset))
        if sum(a > b for a, b in itertools.combinations(order, 2)) % 2:
            nodes[-2:] = nodes[:-3:-1]
        yield nodes


def write(path, dim, n, amplitude, simplices):
    """N cells a side, nodes moved by up to AMPLITUDE cells, the cells cut
    into triangles or tetrahedra if SIMPLICES."""
    noise = random.Random(1)
    nodes, elements = [], []
    for reverse in itertools.product(range(n + 1), repeat=dim):
        x = [(i + (0 if i in (0, n) else noise.uniform(-1, 1) * amplitude)) / n
             for i in reversed(reverse)]
        nodes.append(x + [0.] * (3 - dim))
    for reverse in itertools.product(range(n), repeat=dim):
        cell = reverse[::-1]

        def vertex(*offset):
            return 1 + sum((i + o) * (n + 1)**d
                           for d, (i, o) in enumerate(zip(cell, offset)))
        if simplices:
            elements += [(dim * 2 - 2, s) for s in kuhn(vertex, dim)]
        else:
            circle = ((0, 0), (1, 0), (1, 1), (0, 1))
            layers = [()] if dim == 2 else [(0,), (1,)]
            elements.append((dim * 2 - 1, [vertex(*c, *layer)
                                           for layer in layers
                                           for c in circle]))
    with open(path, "w") as file:
        file.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
                   f"$Nodes\n{len(nodes)}\n")
        for number, x in enumerate(nodes, 1):
            file.write(f"{number} {x[0]!r} {x[1]!r} {x[2]!r}\n")
        file.write(f"$EndNodes\n$Elements\n{len(elements)}\n")
        for number, (kind, corners) in enumerate(elements, 1):
            file.write(f"{number} {kind} 2 0 0 {' '.join(map(str, corners))}\n")
        file.write("$EndElements\n")
