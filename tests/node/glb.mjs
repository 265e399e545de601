// A small reader of GLB and .gltf files, written from the specification alone:
// glTF 2.0, 3.6 (buffers, views, accessors) and 4.4 (GLB).
import fs from 'node:fs';
import path from 'node:path';

const components = {
  5120: Int8Array, 5121: Uint8Array, 5122: Int16Array, 5123: Uint16Array,
  5125: Uint32Array, 5126: Float32Array,
};
const widths = {SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16};

function splitGlb(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (view.getUint32(4, true) !== 2 ||
      view.getUint32(8, true) !== bytes.length) {
    throw new Error('the GLB header does not fit the file');
  }
  const chunks = {};
  for (let at = 12; at < bytes.length;) {
    const size = view.getUint32(at, true);
    const type = view.getUint32(at + 4, true);
    chunks[type] = bytes.subarray(at + 8, at + 8 + size);
    chunks[`${type}@`] = at + 8;
    at += 8 + size;
  }
  return {
    json: JSON.parse(new TextDecoder('utf-8', {fatal: true})
      .decode(chunks[0x4e4f534a])),
    bin: chunks[0x004e4942],
    start: chunks[`${0x004e4942}@`] ?? 0,
  };
}

export function readModel(file) {
  const bytes = fs.readFileSync(file);
  if (bytes.toString('latin1', 0, 4) === 'glTF') {
    return splitGlb(bytes);
  }
  const json = JSON.parse(bytes.toString('utf8'));
  const uri = json.buffers?.[0]?.uri;
  const bin = uri && fs.readFileSync(
    path.join(path.dirname(file), decodeURIComponent(uri)));
  return {json, bin, start: 0};
}

// The bytes of a buffer view, copied so that they are aligned.
export function viewBytes(model, number) {
  const view = model.json.bufferViews[number];
  const at = view.byteOffset ?? 0;
  if (view.buffer !== 0 || at + view.byteLength > model.bin.length) {
    throw new Error(`buffer view ${number} leaves the buffer`);
  }
  return Uint8Array.from(model.bin.subarray(at, at + view.byteLength));
}

// The elements of an accessor, without gaps. Views are cached by their number.
export function accessorValues(model, number) {
  const accessor = model.json.accessors[number];
  const view = model.json.bufferViews[accessor.bufferView];
  const Type = components[accessor.componentType];
  const width = widths[accessor.type];
  const size = Type.BYTES_PER_ELEMENT * width;
  const stride = view.byteStride ?? size;
  const out = new Type(accessor.count * width);
  const from = (view.byteOffset ?? 0) + (accessor.byteOffset ?? 0);
  const room = new Uint8Array(out.buffer);
  for (let i = 0; i < accessor.count; i++) {
    const at = from + i * stride;
    if (at + size > (view.byteOffset ?? 0) + view.byteLength) {
      throw new Error(`accessor ${number} leaves its view`);
    }
    room.set(model.bin.subarray(at, at + size), i * size);
  }
  return out;
}
