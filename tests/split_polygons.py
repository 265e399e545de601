#!/usr/bin/env python3
"""A stream, as tcs2json prints it, whose polygons are triangles: what a filter
leaves that knows of no polygons.

    split_polygons.py [--add FROM:TO] <IN >OUT

Every polygon that has triangles becomes one polygon for each of them, without
rings, painted as before. With --add, geometries of level FROM stay and get
such a companion at level TO.
"""
import json
import sys


def split(polygon):
    """The polygon's triangles as polygons, and their corners in it."""
    for corners in polygon["triangles"]:
        piece = {k: polygon[k] for k in ("id", "surface") if k in polygon}
        piece["vertices"] = [polygon["vertices"][c] for c in corners]
        piece["triangles"] = [[0, 1, 2]]
        yield piece, corners


class Writer:
    """The geometries of one object on their way out."""

    def __init__(self, record):
        self.geometries = []
        self.paints = []
        self.count = 0
        self.old_paints = {}
        for paint in record.get("paints", []):
            self.old_paints.setdefault(paint["polygon"], []).append(paint)

    def put(self, polygon, paints, corners):
        for paint in paints:
            paint = dict(paint, polygon=self.count)
            if "texcoords" in paint and corners is not None:
                paint["texcoords"] = [paint["texcoords"][c] for c in corners]
            self.paints.append(paint)
        self.count += 1
        return polygon

    def keep(self, geometry, first):
        for i, polygon in enumerate(geometry["polygons"]):
            self.put(polygon, self.old_paints.get(first + i, []), None)
        self.geometries.append(geometry)

    def split(self, geometry, first, **changes):
        polygons, counts = [], []
        for i, polygon in enumerate(geometry["polygons"]):
            paints = self.old_paints.get(first + i, [])
            if polygon.get("triangles"):
                pieces = [self.put(p, paints, c) for p, c in split(polygon)]
            else:
                pieces = [self.put(polygon, paints, None)]
            polygons += pieces
            counts.append(len(pieces))
        out = dict(geometry, polygons=polygons, flags=["simplified"], **changes)
        if "shells" in out:
            out["shells"] = [dict(s) for s in out["shells"]]
            at = 0
            for shell in out["shells"]:
                n = shell["polygon_count"]
                shell["polygon_count"] = sum(counts[at:at + n])
                at += n
        self.geometries.append(out)


def convert(record, add):
    out, first = Writer(record), 0
    for geometry in record.get("geometries", []):
        if add is None:
            out.split(geometry, first)
        else:
            out.keep(geometry, first)
            if geometry.get("lod") == add[0]:
                out.split(geometry, first, lod=add[1], role="")
        first += len(geometry.get("polygons", []))
    record["geometries"] = out.geometries
    if out.paints:
        record["paints"] = out.paints
    return out.count


def main():
    add = None
    if sys.argv[1:2] == ["--add"]:
        add = [int(level) for level in sys.argv[2].split(":")]
    polygons = triangles = 0
    for line in sys.stdin:
        record = json.loads(line)
        if record["record"] in ("object", "prototype"):
            convert(record, add)
            for geometry in record.get("geometries", []):
                polygons += len(geometry["polygons"])
                triangles += sum(len(p.get("triangles", []))
                                 for p in geometry["polygons"])
        if record["record"] == "end":
            record.update(polygons=polygons, triangles=triangles)
        print(json.dumps(record, separators=(",", ":")))


if __name__ == "__main__":
    main()
