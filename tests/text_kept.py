#!/usr/bin/env python3
"""Compare the text of a CityGML file with that of its stream.

    text_kept.py FILE STREAM.json

Every text and every attribute of the file, ids and code spaces included, must
be a string of the stream, which tcs2json printed. Prints what is not, by
element, and how often: "Address/@id:3;…", or "-" for nothing. Not looked at:

- numbers of positions, textures and materials, which others compare;
- ids of geometries around polygons, orientations, and where geometries link
  to: the stream has these resolved;
- of appearances all but themes, images and MIME types, and of these what
  stands in geometries that are not kept;
- properties of the model that come to nothing else than a count;
- files that Python's reader refuses: those with undeclared prefixes.
"""
import gzip
import json
import sys
import xml.etree.ElementTree as ElementTree

NUMBERS = {
    "posList", "pos", "coordinates", "lowerCorner", "upperCorner", "X", "Y",
    "Z", "transformationMatrix", "textureCoordinates", "worldToTexture",
}
AROUND_POLYGONS = {
    "MultiSurface", "CompositeSurface", "OrientableSurface", "Solid", "Shell",
    "MultiSolid", "CompositeSolid", "TexturedSurface", "MultiCurve",
    "TriangulatedSurface", "Tin", "PolyhedralSurface", "MultiGeometry",
}
OF_GEOMETRY = {"orientation", "srsName", "srsDimension", "count", "decimal",
               "cs", "ts"}
OF_APPEARANCE = {"theme", "imageURI", "mimeType"}
OF_MODEL = {"boundedBy", "name", "description", "cityObjectMember",
            "featureMember", "featureMembers", "appearanceMember"}


def split(tag):
    space, _, local = tag[1:].rpartition("}") if tag[0] == "{" else \
        ("", "", tag)
    return space, local


def is_gml(space):
    return "opengis.net/gml" in space


def strings_of(name):
    """All strings and numbers of the stream, as text."""
    found, rest = set(), []
    with open(name, encoding="utf-8") as file:
        rest = [json.loads(line) for line in file]
    while rest:
        value = rest.pop()
        if isinstance(value, dict):
            rest.extend(value.values())
        elif isinstance(value, list):
            rest.extend(value)
        elif isinstance(value, str):
            found.add(value)
    return found


def attributes_of(element, space, local, in_appearance):
    """The attributes to be looked at, with their names."""
    for key, value in element.attrib.items():
        attribute_space, name = split(key)
        if "XMLSchema-instance" in attribute_space:
            continue
        if "xlink" in attribute_space and (
                name != "href" or is_gml(space) or local.startswith("lod")):
            continue
        if is_gml(space) and (name in OF_GEOMETRY or (
                name == "id" and local in AROUND_POLYGONS)):
            continue
        if in_appearance:
            continue
        yield name, value


def texts_of(root):
    """(name, text) of all that is to be in the stream."""
    stack = [(root, False)]
    while stack:
        element, in_appearance = stack.pop()
        if not isinstance(element.tag, str):
            continue
        space, local = split(element.tag)
        in_appearance = in_appearance or local in ("Appearance",
                                                   "appearanceMember")
        text = (element.text or "").strip()
        if text and local not in NUMBERS and (
                not in_appearance or local in OF_APPEARANCE):
            yield local, text
        for name, value in attributes_of(element, space, local,
                                         in_appearance):
            yield f"{local}/@{name}", value.strip()
        stack.extend((child, in_appearance) for child in element
                     if element is not root or not isinstance(child.tag, str)
                     or split(child.tag)[1] in OF_MODEL)


def main():
    opened = gzip.open if sys.argv[1].endswith(".gz") else open
    with opened(sys.argv[1], "rb") as file:
        try:
            root = ElementTree.parse(file).getroot()
        except ElementTree.ParseError:  # a prefix is not declared
            print("-")
            return
    kept = strings_of(sys.argv[2])
    lost = {}
    for name, text in texts_of(root):
        if text and text not in kept and text.lstrip("#") not in kept:
            lost[name] = lost.get(name, 0) + 1
    print(";".join(f"{name}:{lost[name]}" for name in sorted(lost)) or "-")


main()
