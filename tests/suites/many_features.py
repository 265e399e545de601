"""Print a stream as JSON lines: COUNT small roofs, and one large relief."""
import json
import sys


def polygon(number, surface):
    """A triangle of its own on a grid, 2 m wide."""
    x, y = 500000 + number % 300 * 2, 5300000 + number // 300 * 2
    return {
        "surface": surface,
        "rings": [{"vertex_count": 3}],
        "vertices": [[x, y, 0], [x + 1, y, 0], [x, y + 1, 0]],
        "triangles": [[0, 1, 2]],
    }


def put(record):
    """One line."""
    print(json.dumps(record, separators=(",", ":")))


def main():
    """Head, buildings, relief, end."""
    count = int(sys.argv[1])
    put({"record": "head", "crs": {
        "kind": "projected", "metres_per_unit": 1, "metres_per_unit_up": 1}})
    for i in range(count):
        put({"record": "object",
             "features": [{"class": "Building", "id": f"b{i}"},
                          {"class": "RoofSurface", "parent": 0}],
             "geometries": [{"feature": 1, "lod": 2, "kind": "multi-surface",
                             "polygons": [polygon(i, 1)]}]})
    put({"record": "object",
         "features": [{"class": "ReliefFeature"}],
         "geometries": [{"feature": 0, "lod": 1, "kind": "tin",
                         "polygons": [polygon(i, 0) for i in range(25000)]}]})
    put({"record": "end"})


main()
