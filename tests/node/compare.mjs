// node compare.mjs FILE.jsonl FILE.glb: does the glTF say what the stream says?
//
// FILE.jsonl is what tcs2json prints of a stream, FILE.glb what tcs2gltf makes
// of it with its default options. The two are compared feature by feature (id,
// class, name, parent, attributes) and triangle by triangle (surface, corners
// in metres to the precision of a float). Prints the first differences and a
// summary; exits 1 when there is a difference. In geographic coordinates
// triangles are compared by surface and number only.
import fs from 'node:fs';
import readline from 'node:readline';
import {readModel} from './glb.mjs';
import {demand, readTables, tableRows, triangles} from './metadata.mjs';

const surfaces = /Surface$|^(Window|Door|TrafficArea|AuxiliaryTrafficArea|Marking)$/;
const areaKinds = new Set(['solid', 'multi-solid', 'composite-solid',
  'multi-surface', 'composite-surface', 'tin']);
const fixed = new Set(['id', 'class', 'name', 'parent', 'type']);

// ---- what is expected of the stream ----------------------------------------

const rank = lod => lod === undefined ? -1 : lod;

// The geometries and instances drawn: the highest level of each host.
function chosen(object) {
  const features = object.features;
  const hosts = [];
  features.forEach((feature, i) => {
    hosts.push(feature.parent !== undefined && surfaces.test(feature.class)
      ? hosts[feature.parent] : i);
  });
  const best = new Map();
  const vote = (feature, lod) => {
    const host = hosts[feature];
    best.set(host, Math.max(best.get(host) ?? -2, rank(lod)));
  };
  const geometries = (object.geometries ?? []).filter(
    geometry => areaKinds.has(geometry.kind));
  for (const geometry of geometries) {
    if (geometry.polygons?.some(polygon => polygon.triangles?.length)) {
      vote(geometry.feature, geometry.lod);
    }
  }
  (object.instances ?? []).forEach(it => vote(it.feature, it.lod));
  const isBest = it => best.get(hosts[it.feature]) === rank(it.lod);
  return {
    geometries: geometries.filter(isBest),
    instances: (object.instances ?? []).filter(isBest),
  };
}

function cross([ax, ay, az], [bx, by, bz]) {
  return [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
}

const minus = (a, b) => a.map((value, i) => value - b[i]);

function hasArea([a, b, c]) {
  return cross(minus(b, a), minus(c, a)).some(value => value !== 0);
}

// Triangles as [surface, corners]; `place` takes a point to local metres.
function* drawn(geometries, place, surfaceOf) {
  const seen = new Set();
  for (const geometry of geometries) {
    for (const polygon of geometry.polygons ?? []) {
      if (polygon.flags?.includes('shared') && seen.has(polygon.id)) {
        continue;
      }
      for (const corners of polygon.triangles ?? []) {
        const at = corners.map(i => place(polygon.vertices[i]));
        if (hasArea(at)) {
          yield [surfaceOf(polygon), at];
        }
      }
    }
    for (const polygon of geometry.polygons ?? []) {
      polygon.id && seen.add(polygon.id);
    }
  }
}

function moved(instance, toLocal) {
  const m = instance.matrix;
  return ([x, y, z]) => toLocal([0, 4, 8].map((row, i) =>
    m[row] * x + m[row + 1] * y + m[row + 2] * z + m[row + 3] +
    instance.anchor[i]));
}

const determinant = m => m[0] * (m[5] * m[10] - m[6] * m[9]) -
  m[1] * (m[4] * m[10] - m[6] * m[8]) + m[2] * (m[4] * m[9] - m[5] * m[8]);

function* expectedTriangles(object, prototypes, toLocal) {
  const {geometries, instances} = chosen(object);
  yield* drawn(geometries, toLocal, polygon => polygon.surface);
  for (const instance of instances) {
    const all = (prototypes[instance.prototype].geometries ?? []).filter(
      geometry => areaKinds.has(geometry.kind));
    for (const [surface, at] of
      drawn(all, moved(instance, toLocal), () => instance.feature)) {
      yield [surface, determinant(instance.matrix) < 0 ? at.reverse() : at];
    }
  }
}

// Attribute values by full name: [[name, value, number]].
function attributeValues(feature) {
  const paths = [];
  const out = [];
  for (const attribute of feature.attributes ?? []) {
    const own = (attribute.space ? `${attribute.space}:` : '') +
      (attribute.name ?? '');
    const path = attribute.member_of === undefined
      ? own : `${paths[attribute.member_of]}.${own}`;
    paths.push(path);
    if (attribute.type !== 'set' && attribute.value) {
      out.push([path, attribute.value, attribute.number ?? 0]);
    }
  }
  return out;
}

// ---- comparison ------------------------------------------------------------

let differences = 0;
const counts = {objects: 0, features: 0, values: 0, triangles: 0};

function differ(text) {
  if (++differences <= 20) {
    console.log(text);
  }
}

function compareValues(expected, row, kinds, where) {
  const got = [];
  for (const [id, value] of Object.entries(row)) {
    if (!fixed.has(id)) {
      got.push([kinds[id].name, value]);
    }
  }
  for (const [name, text, number] of expected) {
    const i = got.findIndex(([other, value]) => other === name &&
      (typeof value === 'string' ? value === text : Number(value) === number));
    if (i < 0) {
      differ(`${where}: ${name} = ${text} is missing`);
    } else {
      got.splice(i, 1);
    }
    counts.values++;
  }
  got.forEach(([name, value]) => differ(`${where}: ${name} = ${value} is new`));
}

function compareRow(expected, row, kinds, where) {
  for (const key of ['id', 'class', 'name', 'type', 'parent']) {
    if ((expected[key] ?? '') !== (row[key] ?? '')) {
      differ(`${where}: ${key} is ${row[key]}, not ${expected[key]}`);
    }
  }
  compareValues(expected.values, row, kinds, where);
}

function featureRow(object, number, base) {
  const feature = object.features[number];
  const idOf = i => object.features[i].id ??
    `${object.features[i].class}#${base + i}`;
  return {
    id: idOf(number), class: feature.class, name: feature.name,
    type: feature.type,
    parent: feature.parent === undefined ? undefined : idOf(feature.parent),
    values: attributeValues(feature),
  };
}

const isNear = (a, b) => a.every((p, i) => p.every((value, k) =>
  Math.abs(value - b[i][k]) <= 1e-9 + Math.abs(value) * 2 ** -22));

function takeMatch(left, key, at) {
  const same = left.get(key) ?? [];
  const i = same.findIndex(other => isNear(at, other));
  if (i < 0) {
    return false;
  }
  same.splice(i, 1);
  return true;
}

// Compare the triangles of one object: `got` maps surface rows to corners.
function compareTriangles(expected, got, base, exact, where) {
  for (const [surface, at] of expected) {
    const left = got.get(base + surface) ?? [];
    counts.triangles++;
    if (exact ? !takeMatch(got, base + surface, at) : !left.pop()) {
      differ(`${where}: surface ${surface} lacks ${JSON.stringify(at)}`);
    }
  }
  for (const [row, left] of got) {
    left.forEach(at => differ(
      `${where}: row ${row} has one too many: ${JSON.stringify(at)}`));
  }
}

function trianglesByObject(model, tables) {
  const objects = new Map();
  for (const {object, surface, corners} of triangles(model, tables)) {
    if (!objects.has(object)) {
      objects.set(object, new Map());
    }
    const rows = objects.get(object);
    rows.has(surface) ? rows.get(surface).push(corners)
      : rows.set(surface, [corners]);
  }
  return objects;
}

const [streamFile, gltfFile] = process.argv.slice(2);
const model = readModel(gltfFile);
const tables = readTables(model);
const rows = tables.map(tableRows);
const objects = trianglesByObject(model, tables);
const origin = model.json.asset.extras.origin;
const prototypes = [];
let base = 0;
let crs;

const isProjected = () =>
  crs.kind !== 'geographic' && crs.kind !== 'geocentric';

// Metres of a degree, near enough to tell which triangles are flat.
const degrees = () => [111320 * Math.cos(origin[1] * Math.PI / 180), 111320];

function toLocal(point) {
  const [x, y] = crs.kind === 'geographic'
    ? degrees() : [crs.metres_per_unit, crs.metres_per_unit];
  const scale = [x, y, crs.metres_per_unit_up];
  return point.map(
    (value, i) => Math.fround((value - origin[i]) * scale[i]));
}

const lines = readline.createInterface(
  {input: fs.createReadStream(streamFile)});
for await (const line of lines) {
  const record = JSON.parse(line);
  if (record.record === 'head') {
    crs = record.crs;
  } else if (record.record === 'prototype') {
    prototypes.push(record);
  } else if (record.record === 'object') {
    const exact = isProjected();
    const where = `object ${counts.objects}`;
    compareRow({...featureRow(record, 0, base), parent: ''},
      rows[0][counts.objects], tables[0].kinds, `${where} in set 0`);
    record.features.forEach((_, i) => {
      const expected = featureRow(record, i, base);
      compareRow(i ? expected : {...expected, values: []}, rows[1][base + i],
        tables[1].kinds, `${where} feature ${i}`);
    });
    compareTriangles(expectedTriangles(record, prototypes, toLocal),
      objects.get(counts.objects) ?? new Map(), base, exact, where);
    base += record.features.length;
    counts.objects++;
  }
}
counts.features = base;
demand(counts.objects === (tables[0]?.count ?? 0) &&
  base === (tables[1]?.count ?? 0), 'the tables have other row counts');
console.log(`${counts.objects} objects, ${counts.features} features, ` +
  `${counts.values} values, ${counts.triangles} triangles: ` +
  `${differences} differences`);
process.exitCode = differences ? 1 : 0;
