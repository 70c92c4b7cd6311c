# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that are right, and what can be done to them."""

import json
import pathlib
import re
import zlib

TESTS = pathlib.Path(__file__).resolve().parent.parent
NUMBER = re.compile(rb"-?\d+(\.\d+)?([eE][-+]?\d+)?")
# What stands where a number should stand, or a name.
EXTREMES = [b"0", b"-1", b"1e300", b"-1e300", b"nan", b"inf", b"1e-300",
            b"2147483648", b"4294967296", b"99999999999999999999", b"0.5",
            b"1e9", b"", b"x", b"1,1", b"\x1b[2J", b"~", b"'", b"0x10", b"077",
            b"a" * 3000]


def points(n):
    """The corners of n x n cells in the unit square."""
    return [(i / n, j / n) for j in range(n + 1) for i in range(n + 1)]


def cells(n):
    """Their corners, from 0 on, anticlockwise."""
    return [(j * (n + 1) + i, j * (n + 1) + i + 1, (j + 1) * (n + 1) + i + 1,
             (j + 1) * (n + 1) + i) for j in range(n) for i in range(n)]


def bottom(n):
    return [(i, i + 1) for i in range(n)]


def joined(rows):
    return "".join(" ".join(str(x) for x in row) + "\n" for row in rows)


def msh_2(n):
    elements = [(i + 1, 3, 2, 9, 1, *(v + 1 for v in c))
                for i, c in enumerate(cells(n))]
    elements += [(100 + i, 1, 2, 5, 1, a + 1, b + 1)
                 for i, (a, b) in enumerate(bottom(n))]
    return ("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
            "$PhysicalNames\n1\n1 5 \"bed\"\n$EndPhysicalNames\n$Nodes\n"
            f"{len(points(n))}\n"
            + joined((i + 1, *p, 0) for i, p in enumerate(points(n)))
            + f"$EndNodes\n$Elements\n{len(elements)}\n" + joined(elements)
            + "$EndElements\n")


def msh_4(n):
    m, c, b = len(points(n)), len(cells(n)), len(bottom(n))
    return ("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 1 1 0\n"
            "1 0 0 0 1 0 0 1 5 0\n1 0 0 0 1 1 0 1 9 1 1\n$EndEntities\n"
            f"$Nodes\n1 {m} 1 {m}\n2 1 0 {m}\n"
            + joined((i + 1,) for i in range(m))
            + joined((*p, 0) for p in points(n))
            + f"$EndNodes\n$Elements\n2 {c + b} 1 {c + b}\n1 1 1 {b}\n"
            + joined((c + i + 1, p + 1, q + 1)
                     for i, (p, q) in enumerate(bottom(n)))
            + f"2 1 3 {c}\n"
            + joined((i + 1, *(v + 1 for v in cell))
                     for i, cell in enumerate(cells(n)))
            + "$EndElements\n")


def vtk(n):
    return ("# vtk DataFile Version 3.0\na square\nASCII\n"
            f"DATASET UNSTRUCTURED_GRID\nPOINTS {len(points(n))} double\n"
            + joined((*p, 0) for p in points(n))
            + f"\nCELLS {len(cells(n))} {5 * len(cells(n))}\n"
            + joined((4, *c) for c in cells(n))
            + f"\nCELL_TYPES {len(cells(n))}\n"
            + joined([[9] * len(cells(n))]))


def inp(n):
    return ("*HEADING\na square\n*NODE\n"
            + "".join(f"{i + 1}, {x}, {y}, 0\n"
                      for i, (x, y) in enumerate(points(n)))
            + "*ELEMENT, TYPE=CPS4R, ELSET=EB1\n"
            + "".join(f"{i + 1}, " + ", ".join(str(v + 1) for v in c) + "\n"
                      for i, c in enumerate(cells(n)))
            + "*ELSET, ELSET=LOW, GENERATE\n" + f"1, {n}, 1\n"
            + "*SURFACE, NAME=SS7\n"
            + "".join(f"{i + 1}, S1\n" for i in range(n)))


def ucd(n):
    return (f"{len(points(n))} {len(cells(n)) + n} 0 0 0\n"
            + joined((i + 1, *p, 0) for i, p in enumerate(points(n)))
            + joined((i + 1, 3, "quad", *(v + 1 for v in c))
                     for i, c in enumerate(cells(n)))
            + joined((100 + i, 5, "line", a + 1, b + 1)
                     for i, (a, b) in enumerate(bottom(n))))


def unv(n):
    return ("    -1\n  2411\n"
            + "".join(f"{i + 1} 1 1 11\n{x} {y} 0\n"
                      for i, (x, y) in enumerate(points(n)))
            + "    -1\n    -1\n  2412\n"
            + "".join(f"{i + 1} 94 1 1 7 4\n"
                      + " ".join(str(v + 1) for v in c) + "\n"
                      for i, c in enumerate(cells(n)))
            + "    -1\n")


def xda(n):
    return (f"DEAL:LIBMESH\n{len(cells(n))}\t# cells\n{len(points(n))}\t# nodes"
            "\n" + 8 * "0\n"
            + joined(cells(n)) + joined((*p, 0) for p in points(n)))


def dbmesh(n):
    return ("MeshVersionFormatted 0\n\nDimension\n2\n\n# END\n\nVertices\n"
            f"{len(points(n))}\n" + joined((*p, 0) for p in points(n))
            + "\nEdges\n0\n\nCrackedEdges\n0\n\nQuadrilaterals\n"
            f"{len(cells(n))}\n"
            + joined((*(v + 1 for v in c), 0) for c in cells(n)) + "\nEnd\n")


def tecplot(n):
    return ("TITLE=\"square\"\nVARIABLES=\"x\" \"y\"\n"
            f"ZONE N={len(points(n))}, E={len(cells(n))}, F=FEPOINT, "
            "ET=QUADRILATERAL\n"
            + joined(points(n)) + joined([v + 1 for v in c] for c in cells(n)))


MESHES = {"m.msh": msh_2(3), "n.msh": msh_4(3), "m.vtk": vtk(3),
          "m.inp": inp(3), "m.ucd": ucd(3), "m.unv": unv(3), "m.xda": xda(3),
          "m.dbmesh": dbmesh(3), "m.dat": tecplot(3)}


def mutated(content, chance):
    """CONTENT with one to three changes."""
    for _ in range(chance.choice([1, 1, 1, 2, 3])):
        content = chance.choice(MUTATIONS)(content, chance)
    return content


def change_number(content, chance):
    found = list(NUMBER.finditer(content))
    if not found:
        return content
    place = chance.choice(found)
    return (content[:place.start()] + chance.choice(EXTREMES)
            + content[place.end():])


def swap_numbers(content, chance):
    found = list(NUMBER.finditer(content))
    if len(found) < 2:
        return content
    a, b = sorted(chance.sample(found, 2), key=lambda m: m.start())
    return (content[:a.start()] + b.group() + content[a.end():b.start()]
            + a.group() + content[b.end():])


def change_lines(content, chance):
    lines = content.split(b"\n")
    i, j = chance.randrange(len(lines)), chance.randrange(len(lines))
    how = chance.choice(["drop", "double", "swap", "many", "join"])
    if how == "drop":
        del lines[i]
    elif how == "double":
        lines.insert(j, lines[i])
    elif how == "swap":
        lines[i], lines[j] = lines[j], lines[i]
    elif how == "many":
        lines[i:i] = [lines[i]] * 2000
    else:
        lines[i:i + 2] = [b" ".join(lines[i:i + 2])]
    return b"\n".join(lines)


def cut(content, chance):
    return content[:chance.randrange(len(content) + 1)]


def change_bytes(content, chance):
    content = bytearray(content)
    for _ in range(chance.choice([1, 1, 20])):
        if content:
            content[chance.randrange(len(content))] = chance.randrange(256)
    return bytes(content)


def insert(content, chance):
    i = chance.randrange(len(content) + 1)
    return content[:i] + chance.choice(EXTREMES) + content[i:]


MUTATIONS = [change_number, change_number, swap_numbers, change_lines, cut,
             change_bytes, insert]


def mutated_json(value, chance):
    """A JSON value with something changed somewhere in it."""
    if isinstance(value, (dict, list)) and value and chance.random() < .9:
        key = chance.choice(list(value) if isinstance(value, dict)
                            else range(len(value)))
        if chance.random() < .2:
            del value[key]
        else:
            value[key] = mutated_json(value[key], chance)
        return value
    return chance.choice([None, -1, 0, 1e300, 2**64, "", "../x", "a" * 3000,
                          [], {}, [1] * 1000, True, "\x1b[2J", 1.5])


def signed(content):
    """The text of a manifest with the checksum of its own that fits."""
    if isinstance(content, dict):
        content.pop("checksum", None)
        text = json.dumps(content, separators=(",", ":"), sort_keys=True,
                          ensure_ascii=False)
        content["checksum"] = zlib.crc32(text.encode(errors="replace"))
    return json.dumps(content)


def mutate_manifest(checkpoint, chance):
    """Changes the manifest, and often lets its checksum fit. Returns whether
    that tells that it was changed."""
    path = checkpoint / "manifest.json"
    if chance.random() < .3:
        path.write_bytes(mutated(path.read_bytes(), chance))
        return True
    content = mutated_json(json.loads(path.read_text()), chance)
    is_signed = chance.random() < .5
    path.write_text(signed(content) if is_signed else json.dumps(content))
    return not is_signed


def mutate_data(checkpoint, chance):
    """Changes a file, and often lets the manifest say that it is whole.
    Returns whether its checksum tells that it is not."""
    files = sorted(p for p in checkpoint.iterdir()
                   if p.is_file() and p.name != "manifest.json")
    path = chance.choice(files)
    path.write_bytes(mutated(path.read_bytes(), chance))
    manifest = checkpoint / "manifest.json"
    content = json.loads(manifest.read_text())
    entry = content.get("files", {}).get(path.name)
    if isinstance(entry, dict) and chance.random() < .7:
        entry["size"] = path.stat().st_size
        entry["checksum"] = zlib.crc32(path.read_bytes())
        manifest.write_text(signed(content))
        return False
    return True
