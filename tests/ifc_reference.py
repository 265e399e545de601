"""ifc_reference.py TABLE FILE: compare the products of a stream, as text on
standard input, with those of FILE in a table of boxes and volumes.

Prints a line for each product of the table: agrees, box, volume or missing,
then its id, type, and how far off it is. A product agrees when its box is the
table's within a millimetre and its volume, where the table has one, within a
thousandth; where that is 0, as a sheet's, within a millionth of the box.
"""
import json
import sys

BOX = 0.001
VOLUME = 0.001
FLAT = 1e-6


class Measure:
    """Box and volume of some triangles, the volume about their first corner."""

    def __init__(self):
        self.lower = [float("inf")] * 3
        self.upper = [float("-inf")] * 3
        self.triangles = []

    def add(self, *corners):
        for point in corners:
            for i in range(3):
                self.lower[i] = min(self.lower[i], point[i])
                self.upper[i] = max(self.upper[i], point[i])
        self.triangles.append(corners)

    def box(self):
        """The volume of the box."""
        x, y, z = (self.upper[i] - self.lower[i] for i in range(3))
        return x * y * z

    def volume(self):
        origin = self.triangles[0][0]
        six = 0.0
        for corners in self.triangles:
            (ax, ay, az), (bx, by, bz), (cx, cy, cz) = (
                [p[i] - origin[i] for i in range(3)] for p in corners)
            six += (ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz)
                    + az * (bx * cy - by * cx))
        return six / 6


def triangles(thing):
    for geometry in thing.get("geometries", []):
        feature = geometry.get("feature", 0)
        for polygon in geometry.get("polygons", []):
            vertices = polygon["vertices"]
            for corners in polygon.get("triangles", []):
                yield feature, [vertices[i] for i in corners]


def placed(instance, point):
    matrix = instance["matrix"]
    anchor = instance.get("anchor", [0, 0, 0])
    return [anchor[i] + sum(matrix[4 * i + k] * point[k] for k in range(3))
            + matrix[4 * i + 3] for i in range(3)]


def measures(stream):
    prototypes, found = [], {}
    for line in stream:
        record = json.loads(line)
        if record["record"] == "prototype":
            prototypes.append([t for _, t in triangles(record)])
        if record["record"] != "object":
            continue
        ids = [feature.get("id") for feature in record["features"]]
        for feature, corners in triangles(record):
            found.setdefault(ids[feature], Measure()).add(*corners)
        for instance in record.get("instances", []):
            measure = found.setdefault(
                ids[instance.get("feature", 0)], Measure())
            for corners in prototypes[instance["prototype"]]:
                measure.add(*(placed(instance, p) for p in corners))
    return found


def rounding(text):
    """Half a unit of the last digit that the table has room for: it has nine,
    and no more than six behind the point, and leaves zeros at the end out."""
    return 0.5 * 10 ** -min(6, 9 - len(text.lstrip("-").partition(".")[0]))


def judge(row, measure):
    if measure is None:
        return "missing", ""
    off = max(abs(have - float(want)) - rounding(want) for have, want in
              zip(measure.lower + measure.upper, row[3:9]))
    if off > BOX:
        return "box", f"{off:.6g}"
    if row[9]:
        want, have = float(row[9]), measure.volume()
        slack = VOLUME * abs(want) if want else FLAT * measure.box()
        if abs(have - want) > slack:
            return "volume", f"{have:.9g} for {want:.9g}"
    return "agrees", ""


def main():
    table, name = sys.argv[1:]
    with open(table, encoding="utf-8") as rows:
        wanted = [line.rstrip("\n").split("\t") for line in rows]
    wanted = [row + [""] * (10 - len(row)) for row in wanted if row[0] == name]
    found = measures(sys.stdin)
    for row in wanted:
        verdict, detail = judge(row, found.get(row[1]))
        print(verdict, row[1], row[2], detail, sep="\t")


if __name__ == "__main__":
    main()
