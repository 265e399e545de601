// node acceptance.mjs count: the text twin of a stream from standard input, to
// one JSON object that has the columns of the manifest.
//
// node acceptance.mjs report MANIFEST DIFFERENCES FOLDER: compare what
// acceptance.sh left in FOLDER with the manifest, print the table, and end with
// "N passed, N failed".
import fs from 'node:fs';
import path from 'node:path';
import readline from 'node:readline';

// What a stream calls what 1.0 and 2.0 call otherwise.
const renamed = {
  Room: 'BuildingRoom',
  BridgeConstructiveElement: 'BridgeConstructionElement',
};

function add(counts, key, number = 1) {
  counts[key] = (counts[key] ?? 0) + number;
}

// ---- counting ---------------------------------------------------------------

function countPolygon(polygon, counts, box) {
  if (polygon.flags?.includes('shared')) {
    return;
  }
  counts.polygons++;
  counts.holes += Math.max(0, (polygon.rings?.length ?? 0) - 1);
  for (const ring of polygon.rings ?? []) {
    counts.max_ring_pts = Math.max(counts.max_ring_pts, ring.vertex_count + 1);
  }
  for (const vertex of polygon.vertices ?? []) {
    for (let axis = 0; box && axis < 3; axis++) {
      box.lower[axis] = Math.min(box.lower[axis], vertex[axis]);
      box.upper[axis] = Math.max(box.upper[axis], vertex[axis]);
    }
  }
}

function countGeometry(geometry, counts, box) {
  const flat = !['multi-curve', 'multi-point'].includes(geometry.kind);
  const shells = geometry.shells ?? [];
  const polygons = [...(geometry.polygons ?? []),
    ...shells.flatMap(shell => shell.polygons ?? [])];

  counts.voids += shells.filter(shell => shell.interior).length;
  counts.lods[geometry.lod ?? '-'] = true;
  for (const polygon of flat ? polygons : []) {
    countPolygon(polygon, counts, box);
    counts.triangles += geometry.kind === 'tin' ? 1 : 0;
  }
}

// What CityGML does not know goes by its own name, as in the manifest.
function className(feature) {
  const type = (feature.type ?? '').replace(/^.*:/, '');
  return feature.class && feature.class !== 'Unknown' ? feature.class
    : renamed[type] ?? type;
}

function countObject(object, counts, isPrototype) {
  const features = object.features ?? [];

  for (const [index, feature] of isPrototype ? [] : features.entries()) {
    const name = className(feature);
    if (index === 0) {
      add(counts.features, name);
    }
    add(counts.surfaces, name);
  }
  for (const geometry of object.geometries ?? []) {
    countGeometry(geometry, counts, isPrototype ? null : counts.box);
  }
  for (const instance of object.instances ?? []) {
    counts.implicit++;
    counts.lods[instance.lod ?? '-'] = true;
  }
}

async function count() {
  const counts = {
    polygons: 0, triangles: 0, holes: 0, voids: 0, implicit: 0, x3dmat: 0,
    max_ring_pts: 0, features: {}, surfaces: {}, lods: {}, images: {}, crs: null,
    box: {lower: [Infinity, Infinity, Infinity],
      upper: [-Infinity, -Infinity, -Infinity]},
  };

  for await (const line of readline.createInterface({input: process.stdin})) {
    const record = JSON.parse(line);
    if (record.record === 'head') {
      counts.crs = record.crs;
    } else if (record.record === 'palette') {
      counts.x3dmat += record.materials?.length ?? 0;
      for (const image of record.images ?? []) {
        counts.images[image.uri] = true;
      }
    } else if (record.record === 'object' || record.record === 'prototype') {
      countObject(record, counts, record.record === 'prototype');
    }
  }
  console.log(JSON.stringify(counts));
}

// ---- comparing --------------------------------------------------------------

function table(file) {
  const lines = fs.readFileSync(file, 'utf8').split('\n').filter(Boolean);
  const names = lines.shift().split('\t');
  return lines.map(line => Object.fromEntries(
    line.split('\t').map((cell, index) => [names[index], cell])));
}

function list(counts) {
  return Object.keys(counts).sort().map(key => `${key}:${counts[key]}`)
    .join(';') || '-';
}

// "Building:1;Room:2" with the stream's names.
function streamNames(cell) {
  const counts = {};
  for (const entry of cell === '-' ? [] : cell.split(';')) {
    const [name, number] = entry.split(':');
    add(counts, renamed[name] ?? name, Number(number));
  }
  return counts;
}

// Only the classes that the manifest's column is about.
function known(counts, classes) {
  return Object.fromEntries(
    Object.entries(counts).filter(([name]) => classes.has(name)));
}

function skipped(stats, item, reason = /./) {
  return stats.skipped.filter(
    entry => entry.item === item && reason.test(entry.reason))
    .reduce((sum, entry) => sum + entry.count, 0);
}

// The columns of one file, [name, manifest's value, ours].
function columns(row, {counts, stats, lost}, classes) {
  const surfaces = known(counts.surfaces, classes);
  return [
    ['features', list(streamNames(row.features)), list(counts.features)],
    ['surfaces', list(streamNames(row.surfaces)), list(surfaces)],
    ['buildings', row.buildings, counts.surfaces.Building ?? 0],
    ['parts', row.parts, counts.surfaces.BuildingPart ?? 0],
    ['polygons', row.polygons, counts.polygons],
    ['triangles', row.triangles, counts.triangles],
    ['holes', row.holes, counts.holes],
    ['voids', row.voids, counts.voids],
    ['implicit', row.implicit, counts.implicit],
    ['x3dmat', row.x3dmat, counts.x3dmat],
    ['textures_refd', row.textures_refd, Object.keys(counts.images).length],
    ['textures_present', row.textures_present,
      stats.counts['images present'] ?? 0],
    ['text', '-', lost],
    ['xlink_dangling', row.xlink_dangling,
      skipped(stats, 'link', /no.*id|nothing/)],
    ['max_ring_pts', row.max_ring_pts, counts.max_ring_pts],
    ['lods', row.lods, Object.keys(counts.lods).filter(lod => lod !== '-')
      .sort().join('') || '-'],
    ['srsName', row.srsName.split(' | ')[0], counts.crs.name ?? '-'],
    ['coords', row.coords, range(row.coords, counts)],
  ].map(([name, theirs, ours]) => [name, String(theirs), String(ours)])
    .filter(([, theirs, ours]) => theirs !== ours);
}

// The numbers of "posList x[1,2] y[3,4] z[5,6]", which has six digits of each.
function rangeNumbers(cell) {
  return (cell.match(/\[[^\]]*\]/g) ?? []).flatMap(
    pair => pair.slice(1, -1).split(',').map(Number));
}

// The bounds of the stream, as far as six digits can tell equal to theirs.
function range(theirs, {box: {lower, upper}, crs}) {
  const order = crs.flags?.includes('north-first') ? [1, 0, 2] : [0, 1, 2];
  const wanted = rangeNumbers(theirs);

  if (!Number.isFinite(lower[0])) {
    return '-';
  }
  const ours = order.flatMap(axis => [lower[axis], upper[axis]]);
  const digits = index => index < 4 ? 5 : 3;
  const same = ours.every((value, index) => Math.abs(value - wanted[index]) <=
    Math.max(Math.abs(value) * 10 ** -digits(index), 1e-6));
  return same ? theirs : `[${ours.map(value => value.toPrecision(7))}]`;
}

// ---- the report -------------------------------------------------------------

function readResult(folder, number) {
  const at = path.join(folder, String(number));
  const text = suffix => fs.existsSync(at + suffix)
    ? fs.readFileSync(at + suffix, 'utf8') : '';
  const result = {
    status: text('.status').trim(),
    broken: text('.broken').split('\n').filter(Boolean),
    said: text('.said').trim(),
  };

  if (result.status === '0' && text('.counts')) {
    result.counts = JSON.parse(text('.counts'));
    result.stats = JSON.parse(text('.stats'));
    result.lost = text('.text').trim();
  } else if (result.status === '0') {
    result.broken.push('a readable stream');
  }
  return result;
}

function complaints(folder) {
  const file = path.join(folder, 'validator');
  const byNumber = {};

  for (const line of fs.existsSync(file)
    ? fs.readFileSync(file, 'utf8').split('\n') : []) {
    const match = /\/(\d+)\.glb: (error|warning): (.*)/.exec(line);
    if (match) {
      (byNumber[match[1]] ??= []).push(`${match[2]}: ${match[3]}`);
    }
  }
  return byNumber;
}

// Find the reason for a difference, and remember that it was needed.
function explain(differences, file, column, theirs, ours) {
  const entry = differences.find(each => each.file === file &&
    each.column === column && each.manifest === theirs && each.ours === ours);
  if (entry) {
    entry.used = true;
  }
  return entry?.reason;
}

function judge(row, result, differences, classes, complaint) {
  const notes = [], faults = [...result.broken, ...complaint ?? []];
  const found = result.counts
    ? columns(row, result, classes)
    : result.status === '0' ? [] : [['status', '0', result.status]];

  if (result.status !== '0') {
    notes.push(result.said);
  }
  for (const [column, theirs, ours] of found) {
    const reason = explain(differences, row.path, column, theirs, ours);
    const text = `${column}: ${theirs} in the manifest, ${ours} here`;
    (reason ? notes : faults).push(reason ? `${text}: ${reason}` : text);
  }
  return {notes, faults};
}

function report(manifest, explained, folder) {
  const rows = table(manifest), differences = table(explained);
  const classes = new Set(rows.flatMap(
    row => Object.keys(streamNames(row.surfaces))));
  const byNumber = complaints(folder);
  let passed = 0, failed = 0;

  console.log('status  polygons  triangles  surfaces  skipped  file');
  for (const [index, row] of rows.entries()) {
    const result = readResult(folder, index + 1);
    const {notes, faults} = judge(
      row, result, differences, classes, byNumber[index + 1]);
    const {counts, stats} = result;
    const cells = counts
      ? [counts.polygons, stats.counts.triangles,
        Object.values(counts.surfaces).reduce((a, b) => a + b, 0),
        stats.skipped.reduce((sum, entry) => sum + entry.count, 0)]
      : ['-', '-', '-', '-'];

    console.log(`${result.status.padEnd(6)}${String(cells[0]).padStart(10)}` +
      `${String(cells[1]).padStart(11)}${String(cells[2]).padStart(10)}` +
      `${String(cells[3]).padStart(9)}  ${row.path}`);
    notes.forEach(note => console.log(`        ${note}`));
    faults.forEach(fault => console.log(`        NOT SO: ${fault}`));
    faults.length ? failed++ : passed++;
  }
  for (const entry of differences.filter(each => !each.used)) {
    console.log(`explained but not so: ${entry.file}: ${entry.column}`);
    failed++;
  }
  console.log(`${passed} passed, ${failed} failed`);
  return failed ? 1 : 0;
}

const [mode, ...operands] = process.argv.slice(2);
if (mode === 'count') {
  await count();
} else {
  process.exitCode = report(...operands);
}
