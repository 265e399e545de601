// The metadata of a glTF by EXT_mesh_features and EXT_structural_metadata,
// read back and checked against what the two specifications demand.
//
//     node metadata.mjs FILE        dumps it as JSON lines: one per row of each
//                                   table, then one per triangle
import {fileURLToPath} from 'node:url';
import {accessorValues, readModel, viewBytes} from './glb.mjs';

const identifier = /^[a-zA-Z_][a-zA-Z0-9_]*$/;
const scalars = {
  INT8: Int8Array, UINT8: Uint8Array, INT16: Int16Array, UINT16: Uint16Array,
  INT32: Int32Array, UINT32: Uint32Array, FLOAT32: Float32Array,
  FLOAT64: Float64Array,
};
const ranges = {
  INT8: [-128, 127], UINT8: [0, 255], INT16: [-32768, 32767],
  UINT16: [0, 65535], INT32: [-2147483648, 2147483647],
  UINT32: [0, 4294967295],
};

export function demand(condition, text) {
  if (!condition) {
    throw new Error(text);
  }
}

// A buffer view of a property table: aligned to 8 bytes in the file and in the
// buffer, and of no other use.
function tableBytes(model, number, where) {
  const view = model.json.bufferViews[number];
  demand(view, `${where}: no buffer view ${number}`);
  demand((view.byteOffset ?? 0) % 8 === 0, `${where}: not aligned to 8`);
  demand((model.start + (view.byteOffset ?? 0)) % 8 === 0,
    `${where}: not aligned to 8 in the file`);
  demand(view.target === undefined && view.byteStride === undefined,
    `${where}: a view with a target or stride`);
  return viewBytes(model, number);
}

function readStrings(model, property, count, where) {
  const bytes = tableBytes(model, property.values, where);
  const raw = tableBytes(model, property.stringOffsets, where);
  const wide = property.stringOffsetType === 'UINT64';
  const offsets = wide
    ? Array.from(new BigUint64Array(raw.buffer), Number)
    : new Uint32Array(raw.buffer);
  demand(['UINT32', 'UINT64', undefined].includes(property.stringOffsetType),
    `${where}: offset type ${property.stringOffsetType}`);
  demand(offsets.length === count + 1,
    `${where}: ${offsets.length} offsets for ${count} rows`);
  demand(offsets[0] === 0 && offsets[count] === bytes.length,
    `${where}: offsets do not span the values`);
  const decoder = new TextDecoder('utf-8', {fatal: true, ignoreBOM: true});
  const out = [];
  for (let i = 0; i < count; i++) {
    demand(offsets[i] <= offsets[i + 1], `${where}: offsets descend`);
    out.push(decoder.decode(bytes.subarray(offsets[i], offsets[i + 1])));
  }
  return out;
}

function readBooleans(model, property, count, where) {
  const bytes = tableBytes(model, property.values, where);
  demand(bytes.length === Math.ceil(count / 8), `${where}: wrong size`);
  return Array.from({length: count},
    (_, i) => Boolean(bytes[i >> 3] >> (i & 7) & 1));
}

function readScalars(model, property, kind, count, where) {
  const Type = scalars[kind.componentType];
  demand(Type, `${where}: component type ${kind.componentType}`);
  const bytes = tableBytes(model, property.values, where);
  demand(bytes.length === count * Type.BYTES_PER_ELEMENT,
    `${where}: wrong size`);
  return Array.from(new Type(bytes.buffer));
}

function checkKind(kind, where) {
  const range = ranges[kind.componentType];
  demand(['STRING', 'SCALAR', 'BOOLEAN'].includes(kind.type),
    `${where}: type ${kind.type}`);
  demand((kind.type === 'SCALAR') === (kind.componentType !== undefined),
    `${where}: component type`);
  if (kind.noData === undefined) {
    return;
  }
  demand(!kind.required, `${where}: required and noData`);
  demand(kind.type !== 'BOOLEAN', `${where}: noData of a boolean`);
  demand(typeof kind.noData === (kind.type === 'STRING' ? 'string' : 'number'),
    `${where}: noData is ${JSON.stringify(kind.noData)}`);
  demand(!range || (Number.isInteger(kind.noData) &&
    kind.noData >= range[0] && kind.noData <= range[1]),
    `${where}: noData out of range`);
}

function readProperty(model, property, kind, count, where) {
  checkKind(kind, where);
  const values = kind.type === 'STRING'
    ? readStrings(model, property, count, where)
    : kind.type === 'BOOLEAN'
      ? readBooleans(model, property, count, where)
      : readScalars(model, property, kind, count, where);
  return kind.noData === undefined
    ? values
    : values.map(value => value === kind.noData ? undefined : value);
}

function readTable(model, schema, table, where) {
  const kinds = schema.classes[table.class]?.properties;
  demand(kinds, `${where}: no class ${table.class}`);
  demand(Number.isInteger(table.count) && table.count >= 1, `${where}: count`);
  const columns = {};
  for (const [id, property] of Object.entries(table.properties)) {
    demand(identifier.test(id), `${where}: property id ${id}`);
    demand(kinds[id], `${where}: ${id} is not in the class`);
    columns[id] = readProperty(model, property, kinds[id], table.count,
      `${where}.${id}`);
  }
  for (const [id, kind] of Object.entries(kinds)) {
    demand(columns[id] || !kind.required, `${where}: ${id} is missing`);
  }
  demand(kinds.id?.semantic === 'ID' && kinds.id.required &&
    kinds.id.type === 'STRING', `${where}: no id`);
  return {class: table.class, count: table.count, kinds, columns};
}

// All tables: {class, count, kinds, columns}.
export function readTables(model) {
  const extension = model.json.extensions?.EXT_structural_metadata;
  if (!extension) {
    return [];
  }
  demand(model.json.extensionsUsed.includes('EXT_structural_metadata'),
    'EXT_structural_metadata is not in extensionsUsed');
  demand(!model.json.extensionsRequired, 'an extension is required');
  const {schema, propertyTables} = extension;
  demand(identifier.test(schema.id), 'the schema has no id');
  for (const id of Object.keys(schema.classes)) {
    demand(identifier.test(id), `class id ${id}`);
  }
  return propertyTables.map((table, i) =>
    readTable(model, schema, table, `table ${i}`));
}

// The rows of a table as objects, what has no value left out.
export function tableRows(table) {
  return Array.from({length: table.count}, (_, i) => {
    const row = {};
    for (const [id, values] of Object.entries(table.columns)) {
      if (values[i] !== undefined) {
        row[id] = values[i];
      }
    }
    return row;
  });
}

function readIds(model, primitive, set, tables, where) {
  const number = primitive.attributes[`_FEATURE_ID_${set.attribute}`];
  const accessor = model.json.accessors[number];
  const view = model.json.bufferViews[accessor.bufferView];
  const table = tables[set.propertyTable];
  demand(table, `${where}: no table ${set.propertyTable}`);
  demand(accessor.type === 'SCALAR' && !accessor.normalized,
    `${where}: not a plain scalar`);
  demand(accessor.componentType === 5126 ||
    (accessor.componentType === 5123 && view.byteStride === 4),
    `${where}: component type ${accessor.componentType}`);
  const ids = accessorValues(model, number);
  demand(ids.every(id => Number.isInteger(id) && id >= 0 && id < table.count),
    `${where}: an id is beyond its table`);
  demand(new Set(ids).size === set.featureCount,
    `${where}: ${new Set(ids).size} ids, featureCount ${set.featureCount}`);
  return ids;
}

function* primitiveTriangles(model, primitive, tables, node, where) {
  const sets = primitive.extensions.EXT_mesh_features.featureIds;
  demand(sets.length === 2, `${where}: ${sets.length} sets`);
  const ids = sets.map((set, i) =>
    readIds(model, primitive, set, tables, `${where} set ${i}`));
  const at = accessorValues(model, primitive.attributes.POSITION);
  const normals = primitive.attributes.NORMAL === undefined ? undefined
    : accessorValues(model, primitive.attributes.NORMAL);
  const indices = accessorValues(model, primitive.indices);
  demand(primitive.mode === undefined || primitive.mode === 4,
    `${where}: not triangles`);
  for (let i = 0; i < indices.length; i += 3) {
    const corners = [indices[i], indices[i + 1], indices[i + 2]];
    for (const set of ids) {
      demand(set[corners[0]] === set[corners[1]] &&
        set[corners[0]] === set[corners[2]],
        `${where}: a triangle of two features`);
    }
    yield {
      node,
      object: ids[0][corners[0]],
      surface: ids[1][corners[0]],
      material: primitive.material,
      corners: corners.map(c => Array.from(at.subarray(3 * c, 3 * c + 3))),
      normals: normals && corners.map(
        c => Array.from(normals.subarray(3 * c, 3 * c + 3))),
    };
  }
}

// Every triangle, with the rows of its features: z up, metres from the origin.
export function* triangles(model, tables) {
  const {nodes = [], meshes = []} = model.json;
  for (const [i, node] of nodes.entries()) {
    if (node.mesh === undefined) {
      continue;
    }
    for (const [k, primitive] of meshes[node.mesh].primitives.entries()) {
      yield* primitiveTriangles(model, primitive, tables, node.name,
        `node ${i} primitive ${k}`);
    }
  }
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const model = readModel(process.argv[2]);
  const tables = readTables(model);
  for (const table of tables) {
    for (const row of tableRows(table)) {
      console.log(JSON.stringify({table: table.class, ...row}));
    }
  }
  for (const triangle of triangles(model, tables)) {
    console.log(JSON.stringify(triangle));
  }
}
