// node instances.mjs A B: two files show the same triangles of each feature,
// however prototypes were written: as part of the objects, as nodes that share
// a mesh, or by EXT_mesh_gpu_instancing.
//
// Per row of the surface table: the number of triangles, the sums of their
// corners and of the volumes under them, which turn with their winding.
import {accessorValues, readModel} from './glb.mjs';

const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

// By columns, as glTF has them.
function multiply(a, b) {
  return identity.map((_, i) => [0, 1, 2, 3].reduce(
    (sum, k) => sum + a[4 * k + i % 4] * b[4 * (i >> 2) + k], 0));
}

function compose([tx, ty, tz], [x, y, z, w], [sx, sy, sz]) {
  return [
    sx * (1 - 2 * (y * y + z * z)), sx * 2 * (x * y + z * w),
    sx * 2 * (x * z - y * w), 0,
    sy * 2 * (x * y - z * w), sy * (1 - 2 * (x * x + z * z)),
    sy * 2 * (y * z + x * w), 0,
    sz * 2 * (x * z + y * w), sz * 2 * (y * z - x * w),
    sz * (1 - 2 * (x * x + y * y)), 0, tx, ty, tz, 1];
}

function turn(m, [x, y, z]) {
  return [0, 1, 2].map(
    i => m[i] * x + m[4 + i] * y + m[8 + i] * z + m[12 + i]);
}

const mirrors = m => m[0] * (m[5] * m[10] - m[6] * m[9]) -
  m[4] * (m[1] * m[10] - m[2] * m[9]) +
  m[8] * (m[1] * m[6] - m[2] * m[5]) < 0;

function add(sums, row, corners) {
  const [[a, b, c], [d, e, f], [g, h, i]] = corners;
  const sum = sums.get(row) ?? [0, 0, 0, 0, 0];
  sum[0]++;
  corners.forEach(at => at.forEach((value, k) => sum[1 + k] += value));
  sum[4] += a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
  sums.set(row, sum);
}

// The triangles of a mesh under a matrix; `row` where its vertices have none.
function draw(model, number, matrix, row, sums) {
  const order = mirrors(matrix) ? [2, 1, 0] : [0, 1, 2];
  for (const primitive of model.json.meshes[number].primitives) {
    const read = name => accessorValues(model, primitive.attributes[name]);
    const positions = read('POSITION');
    const rows = row === undefined ? read('_FEATURE_ID_1') : null;
    const indices = accessorValues(model, primitive.indices);
    for (let at = 0; at < indices.length; at += 3) {
      const corners = order.map(k => indices[at + k]).map(index =>
        turn(matrix, positions.subarray(3 * index, 3 * index + 3)));
      add(sums, rows ? rows[indices[at]] : row, corners);
    }
  }
}

function drawInstances(model, node, matrix, sums) {
  const {attributes} = node.extensions.EXT_mesh_gpu_instancing;
  const read = name => accessorValues(model, attributes[name]);
  const [t, r, s] = ['TRANSLATION', 'ROTATION', 'SCALE'].map(read);
  const rows = read('_FEATURE_ID_1');
  rows.forEach((row, i) => draw(model, node.mesh, multiply(matrix, compose(
    t.subarray(3 * i, 3 * i + 3), r.subarray(4 * i, 4 * i + 4),
    s.subarray(3 * i, 3 * i + 3))), row, sums));
}

function walk(model, number, above, sums) {
  const node = model.json.nodes[number];
  const matrix = multiply(above, node.matrix ?? identity);
  if (node.extensions?.EXT_mesh_gpu_instancing) {
    drawInstances(model, node, matrix, sums);
  } else if (node.mesh !== undefined) {
    draw(model, node.mesh, matrix, node.extras?.surface, sums);
  }
  node.children?.forEach(child => walk(model, child, matrix, sums));
}

function look(file) {
  const model = readModel(file);
  const sums = new Map();
  model.json.scenes[0].nodes.forEach(
    number => walk(model, number, identity, sums));
  return sums;
}

const [one, two] = process.argv.slice(2, 4).map(look);
let bad = one.size === two.size ? 0 : 1;
for (const [row, sum] of one) {
  const other = two.get(row);
  const near = other?.every((value, k) =>
    Math.abs(value - sum[k]) <= 1e-4 * sum[0] + 1e-4 * Math.abs(sum[k]));
  if (!near) {
    bad++;
    console.log(`feature ${row}: ${sum} and ${other}`);
  }
}
console.log(`${one.size} features with triangles, ${bad} differ`);
process.exitCode = bad || !one.size ? 1 : 0;
