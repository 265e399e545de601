// node compare_gml.mjs FILE.gml FILE.glb: is every triangle where the CityGML
// has a polygon of the surface that the triangle says it belongs to?
//
// Independent of the stream: the polygons are read from the GML by gml.mjs. For
// each feature with triangles: the id is one of the GML's and so are class and
// parent; all corners of a triangle are vertices of one of the feature's
// polygons; and the triangles' area is that of the polygons at one level of
// detail. Each surface that has polygons at its host's highest level is drawn.
// Placed prototypes are checked for id, class and parent only.
import {polygonArea, readGml} from './gml.mjs';
import {readModel} from './glb.mjs';
import {readTables, tableRows, triangles} from './metadata.mjs';

const [gmlFile, gltfFile] = process.argv.slice(2);
const features = readGml(gmlFile);
const model = readModel(gltfFile);
const tables = readTables(model);
const rows = tableRows(tables[1]);
const {origin} = model.json.asset.extras;
const tolerance = 1e-3; // metres
// Where 3.0 has another name than the stream, which keeps that of 2.0.
const renamed = {BridgeConstructiveElement: 'BridgeConstructionElement'};
let differences = 0;
const counts = {features: 0, triangles: 0, placed: 0};

function differ(text) {
  if (++differences <= 20) {
    console.log(text);
  }
}

function triangleArea([a, b, c]) {
  const u = b.map((value, k) => value - a[k]);
  const v = c.map((value, k) => value - a[k]);
  return Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
    u[0] * v[1] - u[1] * v[0]) / 2;
}

const isNear = (p, q) => p.every(
  (value, k) => Math.abs(value - q[k]) <= tolerance);

const holds = ({rings}, corners) => corners.every(
  corner => rings.some(ring => ring.some(point => isNear(corner, point))));

function checkTriangle(feature, corners, where) {
  counts.triangles++;
  if (!feature.polygons.some(polygon => holds(polygon, corners))) {
    differ(`${where}: not of its polygons: ${JSON.stringify(corners)}`);
  }
}

// What a surface links to is its own; what a host links to is its surfaces'.
function checkArea(feature, drawn, where) {
  const levels = new Map();
  for (const polygon of feature.polygons) {
    if (isSurface(feature) || !polygon.linked) {
      levels.set(polygon.lod,
        (levels.get(polygon.lod) ?? 0) + polygonArea(polygon));
    }
  }
  const expected = [...levels.values()];
  if (!expected.some(area => Math.abs(area - drawn) <= 1e-3 * area + 1e-3)) {
    differ(`${where}: ${drawn} m2 drawn of ${expected}`);
  }
}

const isSurface = ({class: name}) => /Surface$/.test(name) ||
  name === 'Window' || name === 'Door';

const hostOf = feature => isSurface(feature) && features.has(feature.parent)
  ? hostOf(features.get(feature.parent)) : feature;

const levelOf = ({polygons}) => Math.max(-1,
  ...polygons.filter(({rings}) => rings.length).map(({lod}) => Number(lod)));

function checkComplete(drawn) {
  const levels = new Map();
  for (const feature of features.values()) {
    const host = hostOf(feature);
    levels.set(host, Math.max(levels.get(host) ?? -1, levelOf(feature)));
  }
  for (const feature of features.values()) {
    if (isSurface(feature) && feature.polygons.length > 0 &&
        levelOf(feature) === levels.get(hostOf(feature)) &&
        !drawn.has(feature.id)) {
      differ(`${feature.class} ${feature.id} is not drawn`);
    }
  }
}

const byRow = new Map();
for (const {surface, corners} of triangles(model, tables)) {
  const moved = corners.map(p => p.map((value, k) => value + origin[k]));
  byRow.has(surface) ? byRow.get(surface).push(moved)
    : byRow.set(surface, [moved]);
}
for (const [number, all] of byRow) {
  const row = rows[number];
  const feature = features.get(row.id);
  const where = `${row.class} ${row.id}`;
  counts.features++;
  if (!feature) {
    if (!row.id.includes('#')) {
      differ(`${where}: no such id in the GML`);
    }
    continue;
  }
  if ((renamed[feature.class] ?? feature.class) !== row.class || (feature.parent ?? '') !==
      (row.parent ?? '')) {
    differ(`${where}, parent ${row.parent}: in the GML a ${feature.class}, ` +
      `parent ${feature.parent}`);
  }
  if (feature.implicit) {
    counts.placed++;
    continue;
  }
  all.forEach(corners => checkTriangle(feature, corners, where));
  checkArea(feature, all.reduce((sum, at) => sum + triangleArea(at), 0), where);
}
checkComplete(new Set([...byRow.keys()].map(number => rows[number].id)));
console.log(`${counts.features} features, ${counts.placed} of them placed ` +
  `prototypes, ${counts.triangles} triangles: ${differences} differences`);
process.exitCode = differences ? 1 : 0;
