#!/usr/bin/env python3
"""How many polygons GDAL finds in a file: gdal_polygons.py FILE"""
import sys

from osgeo import gdal, ogr


def count(geometry):
    kind = ogr.GT_Flatten(geometry.GetGeometryType())
    if kind in (ogr.wkbPolygon, ogr.wkbCurvePolygon, ogr.wkbTriangle):
        return 1
    return sum(count(geometry.GetGeometryRef(i))
               for i in range(geometry.GetGeometryCount()))


def main():
    gdal.UseExceptions()
    gdal.SetConfigOption("GML_SKIP_RESOLVE_ELEMS", "NONE")
    polygons = 0
    source = ogr.Open(sys.argv[1])
    for i in range(source.GetLayerCount()):
        for feature in source.GetLayer(i):
            for k in range(feature.GetGeomFieldCount()):
                geometry = feature.GetGeomFieldRef(k)
                polygons += count(geometry) if geometry else 0
    print(polygons)


if __name__ == "__main__":
    main()
