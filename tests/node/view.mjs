// The page that browser.mjs opens: shows city.glb and answers what is seen.
import * as THREE from 'three';
import {GLTFLoader} from 'three/addons/loaders/GLTFLoader.js';

const renderer = new THREE.WebGLRenderer({antialias: true});
const scene = new THREE.Scene();
const camera = new THREE.PerspectiveCamera(32, 1, 1, 20000);
const sun = new THREE.DirectionalLight(0xfff1dc, 2.6);
let parser;

function sky() {
  const canvas = document.createElement('canvas');
  canvas.width = 1;
  canvas.height = 256;
  const pen = canvas.getContext('2d');
  const fade = pen.createLinearGradient(0, 0, 0, 256);
  fade.addColorStop(0, '#8fb8dc');
  fade.addColorStop(0.55, '#dbe8f0');
  fade.addColorStop(1, '#e9ece6');
  pen.fillStyle = fade;
  pen.fillRect(0, 0, 1, 256);
  const texture = new THREE.CanvasTexture(canvas);
  texture.colorSpace = THREE.SRGBColorSpace;
  return texture;
}

function light(box) {
  const middle = box.getCenter(new THREE.Vector3());
  const reach = box.getSize(new THREE.Vector3()).length() / 2;
  scene.add(new THREE.HemisphereLight(0xdfeaf5, 0x9a9482, 1.5));
  sun.position.copy(middle).add(
    new THREE.Vector3(-0.55, 0.75, 0.5).multiplyScalar(2 * reach));
  sun.target.position.copy(middle);
  sun.castShadow = true;
  sun.shadow.mapSize.set(4096, 4096);
  sun.shadow.normalBias = 0.4;
  Object.assign(sun.shadow.camera, {left: -reach, right: reach, top: reach,
    bottom: -reach, near: reach / 10, far: 4 * reach});
  scene.add(sun, sun.target);
}

function dress(model) {
  const ink = new THREE.LineBasicMaterial(
    {color: 0x2b2722, transparent: true, opacity: 0.28});
  const meshes = [];
  model.traverse(node => node.isMesh && meshes.push(node));
  for (const mesh of meshes) {
    mesh.castShadow = true;
    mesh.receiveShadow = true;
    mesh.material.polygonOffset = true;
    mesh.material.polygonOffsetFactor = 1;
    mesh.material.polygonOffsetUnits = 1;
    if (mesh.geometry.index.count < 30000 && !mesh.isInstancedMesh) {
      mesh.add(new THREE.LineSegments(
        new THREE.EdgesGeometry(mesh.geometry, 20), ink));
    }
  }
}

// The box of what is a building; of all where nothing is.
async function town(model) {
  const box = new THREE.Box3();
  const meshes = [];
  model.traverse(node => node.isMesh && meshes.push(node));
  for (const mesh of meshes) {
    const row = mesh.geometry.attributes._feature_id_0?.getX(0);
    if (row !== undefined &&
        await property(0, 'class', row) === 'Building') {
      box.expandByObject(mesh);
    }
  }
  return box.isEmpty() ? new THREE.Box3().setFromObject(model) : box;
}

// From above, at such a distance that the box fills the picture.
function frame(box, {azimuth, elevation, fill, aim}) {
  const middle = box.getCenter(new THREE.Vector3());
  const size = box.getSize(new THREE.Vector3());
  const reach = Math.max(size.x, size.z);
  const distance = reach / fill / camera.aspect /
    (2 * Math.tan(camera.fov * Math.PI / 360));
  const a = azimuth * Math.PI / 180;
  const e = elevation * Math.PI / 180;
  middle.x += aim[0] * reach;
  middle.z -= aim[1] * reach;
  middle.y = box.min.y + size.y * 0.2;
  camera.position.copy(middle).add(new THREE.Vector3(
    Math.sin(a) * Math.cos(e), Math.sin(e), Math.cos(a) * Math.cos(e))
    .multiplyScalar(distance));
  camera.lookAt(middle);
  scene.fog = new THREE.Fog(0xdfe8ec, distance * 1.1, distance * 4);
}

window.show = async (url, width, height, view) => {
  const gltf = await new GLTFLoader().loadAsync(url);
  parser = gltf.parser;
  scene.add(gltf.scene);
  scene.updateMatrixWorld(true);
  const box = new THREE.Box3().setFromObject(gltf.scene);
  scene.background = sky();
  light(box);
  const part = await town(gltf.scene);
  dress(gltf.scene);
  renderer.setSize(width, height);
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = THREE.PCFSoftShadowMap;
  document.body.append(renderer.domElement);
  camera.aspect = width / height;
  frame(part, view);
  camera.updateProjectionMatrix();
  renderer.render(scene, camera);
  await new Promise(requestAnimationFrame);
  renderer.render(scene, camera);
  let count = 0;
  gltf.scene.traverse(node => count += node.isMesh ? 1 : 0);
  return {meshes: count, size: box.getSize(new THREE.Vector3()).toArray()};
};

// A string of a property table, by the extension's binary format.
async function property(table, id, row) {
  const {schema, propertyTables} = parser.json.extensions
    .EXT_structural_metadata;
  const place = propertyTables[table].properties[id];
  const kind = schema.classes[propertyTables[table].class].properties[id];
  const values = await parser.getDependency('bufferView', place.values);
  if (kind.type === 'STRING') {
    const offsets = new Uint32Array(
      await parser.getDependency('bufferView', place.stringOffsets));
    return new TextDecoder().decode(
      values.slice(offsets[row], offsets[row + 1]));
  }
  const Type = {FLOAT64: Float64Array, INT32: Int32Array,
    UINT8: Uint8Array}[kind.componentType];
  return new Type(values)[row];
}

// What stands in the middle of the picture for one who stands at `from` and
// looks at `to`, both in metres from the origin, z up.
window.pick = async (from, to) => {
  const eye = new THREE.PerspectiveCamera(40, 1, 0.01, 1000);
  const turned = ([x, y, z]) => new THREE.Vector3(x, z, -y);
  eye.position.copy(turned(from));
  eye.lookAt(turned(to));
  eye.updateMatrixWorld(true);
  const ray = new THREE.Raycaster();
  ray.setFromCamera(new THREE.Vector2(0, 0), eye);
  const [hit] = ray.intersectObjects(scene.children, true)
    .filter(({object}) => object.isMesh);
  if (!hit) {
    return null;
  }
  const {attributes} = hit.object.geometry;
  const [object, surface] = ['_feature_id_0', '_feature_id_1'].map(
    name => attributes[name].getX(hit.face.a));
  const out = {distance: hit.distance};
  for (const id of ['id', 'class', 'parent']) {
    out[id] = await property(1, id, surface);
  }
  out.object = await property(0, 'id', object);
  return out;
};

window.again = () => renderer.render(scene, camera);
window.ready = true;
