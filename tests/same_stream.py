#!/usr/bin/env python3
"""Compare two component streams as tcs2json prints them, the second being the
first after a way through CityGML.

    same_stream.py BEFORE.json AFTER.json

Prints the first differences and exits 1, or prints nothing and exits 0. What
may differ, because CityGML has no place for it or says it another way:

- the head, but for the name, code and kind of its coordinate system;
- ids where BEFORE has none: links and GML 3.2 want them;
- ids of materials and textures, and how often an equal one is listed: local
  appearances repeat them, so paints are compared by what they paint with;
- attributes of extensions, which come back as generic ones;
- the order of attributes, which the schema fixes, and of paints.
"""
import json
import sys


def load(name):
    with open(name, encoding="utf-8") as file:
        return [json.loads(line) for line in file]


def without(element, *names):
    return {k: v for k, v in element.items() if k not in names}


def tables(records):
    """Materials and images in the order of their numbers, without ids."""
    materials, images = [], []
    for record in records:
        if record["record"] == "palette":
            materials += [without(m, "id") for m in record.get("materials", [])]
            images += [without(i, "id") for i in record.get("images", [])]
    return materials, images


def paints(record, materials, images):
    out = []
    for paint in record.get("paints", []):
        paint = dict(paint)
        if "material" in paint:
            paint["material"] = materials[paint["material"]]
        if "image" in paint:
            paint["image"] = images[paint["image"]]
        out.append(paint)
    return sorted(out, key=lambda p: (p["polygon"], json.dumps(p, sort_keys=True)))


def attribute_tree(attributes):
    """Attributes with their members inside, in an order of their own."""
    nodes = [without(a, "member_of") for a in attributes]
    roots = []
    for node, attribute in zip(nodes, attributes):
        if attribute.get("space"):
            node["space"] = None
        above = attribute.get("member_of")
        if above is not None and attribute["name"] == "@id":
            nodes[above]["id"] = attribute["value"]
            continue
        home = roots if above is None else nodes[above].setdefault("members", [])
        home.append(node)
    roots = [r for r in roots if "space" not in r]
    return sorted(roots, key=order_without_ids)


def order_without_ids(node):
    if isinstance(node, dict):
        return json.dumps({k: order_without_ids(v) for k, v in node.items()
                           if k != "id"}, sort_keys=True)
    if isinstance(node, list):
        return json.dumps([order_without_ids(v) for v in node])
    return json.dumps(node)


def shape(record, materials, images):
    """A record as it is compared."""
    out = without(record, "paints", "features")
    out["features"] = [
        dict(without(f, "attributes"),
             attributes=attribute_tree(f.get("attributes", [])))
        for f in record.get("features", [])]
    out["paints"] = paints(record, materials, images)
    return out


def differences(before, after, path):
    if isinstance(before, dict) and isinstance(after, dict):
        for key in sorted(before.keys() | after.keys()):
            where = f"{path}.{key}"
            if key not in before:
                if key != "id":
                    yield f"{where} came: {json.dumps(after[key])[:200]}"
            elif key not in after:
                yield f"{where} went: {json.dumps(before[key])[:200]}"
            else:
                yield from differences(before[key], after[key], where)
    elif isinstance(before, list) and isinstance(after, list):
        if len(before) != len(after):
            yield f"{path}: {len(before)} before, {len(after)} after"
        for i, (b, a) in enumerate(zip(before, after)):
            yield from differences(b, a, f"{path}[{i}]")
    elif before != after:
        yield f"{path}: {json.dumps(before)[:200]} -> {json.dumps(after)[:200]}"


def kept(records):
    return [r for r in records if r["record"] in ("prototype", "object")]


def main():
    before, after = load(sys.argv[1]), load(sys.argv[2])
    found = list(differences(
        {k: before[0]["crs"].get(k) for k in ("name", "epsg", "kind")},
        {k: after[0]["crs"].get(k) for k in ("name", "epsg", "kind")}, "crs"))
    tables_before, tables_after = tables(before), tables(after)
    before, after = kept(before), kept(after)
    if len(before) != len(after):
        found.append(f"{len(before)} objects before, {len(after)} after")
    for b, a in zip(before, after):
        name = b["features"][0].get("id", "?")
        found += differences(
            shape(b, *tables_before), shape(a, *tables_after), name)
    for line in found[:20]:
        print(line)
    if len(found) > 20:
        print(f"… and {len(found) - 20} more")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
