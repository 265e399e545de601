// The polygons of a CityGML file and whose they are, found by a reader that
// knows nothing of ours: element names, gml:id, xlink:href and coordinate lists,
// with coordinates taken as they are written, easting first.
import fs from 'node:fs';

const token = /<(\/?)([A-Za-z_][\w.-]*:)?([\w.-]+)((?:\s+[^<>"']+=(?:"[^"]*"|'[^']*'))*)\s*(\/?)>|<!\[CDATA\[[\s\S]*?\]\]>|<!--[\s\S]*?-->|<\?[\s\S]*?\?>/g;
const notFeatures = new Set(['gml:', 'app:', 'xAL:', 'xal:']);
const level = /^lod(\d)/;

function attribute(text, name) {
  const found = text.match(new RegExp(`\\s(?:\\w+:)?${name}=["']([^"']*)["']`));
  return found?.[1];
}

const isFeature = ({prefix, name}) => /^[A-Z]/.test(name) &&
  !notFeatures.has(prefix) && name !== 'ImplicitGeometry' &&
  name !== 'CityModel' && name !== 'Address' && name !== 'ExternalReference' &&
  name !== 'ExternalObject';

function numbers(text) {
  return text.trim().split(/\s+/).map(Number);
}

// The ring without the repetition of its first point.
function ringOf(values) {
  const points = [];
  for (let i = 0; i + 2 < values.length; i += 3) {
    points.push(values.slice(i, i + 3));
  }
  const [first] = points;
  const last = points.at(-1);
  if (points.length > 1 && first.every((value, k) => value === last[k])) {
    points.pop();
  }
  return points;
}

// Walk all elements: `open` and `close` get the stack, the innermost last.
function walk(text, open, close) {
  const stack = [];
  for (const found of text.matchAll(token)) {
    const [whole, end, prefix = '', name, attributes = '', empty] = found;
    if (!name) {
      continue;
    }
    if (!end) {
      const element = {prefix, name, attributes,
        id: attribute(attributes, 'id'), from: found.index + whole.length};
      stack.push(element);
      open(stack, element);
    }
    if (end || empty) {
      const element = stack.at(-1);
      close(stack, element, empty ? '' : text.slice(element.from, found.index));
      stack.pop();
    }
  }
}

// A geometry holds what it links to, through as many links as it takes.
function followLinks(links, geometries) {
  for (let grown = true; grown;) {
    grown = false;
    for (const {target, within} of links) {
      for (const id of within) {
        const all = geometries.get(id) ?? [];
        const more = (geometries.get(target) ?? []).filter(
          polygon => !all.includes(polygon));
        grown ||= more.length > 0;
        geometries.set(id, [...all, ...more]);
      }
    }
  }
}

// [{id, class, name, parent, polygons: [{lod, rings}], implicit}] by id, plus
// the polygons that a feature only refers to.
export function readGml(file) {
  const features = new Map();
  const geometries = new Map(); // id of a geometry: its polygons
  const links = [];
  let polygon;

  const featureOf = stack => {
    const element = stack.findLast(isFeature);
    return element && features.get(element.id);
  };
  const lodOf = stack => stack.map(
    ({name}) => name.match(level)?.[1]).findLast(Boolean);

  walk(fs.readFileSync(file, 'utf8'), (stack, element) => {
    if (isFeature(element) && element.id) {
      const above = stack.slice(0, -1).findLast(isFeature);
      features.set(element.id, {id: element.id, class: element.name,
        parent: above?.id, polygons: []});
    }
    const feature = featureOf(stack);
    if (element.name === 'ImplicitGeometry' && feature) {
      feature.implicit = true;
    }
    if (element.name === 'Polygon' || element.name === 'Triangle') {
      polygon = {lod: lodOf(stack), rings: [], points: []};
      feature?.polygons.push(polygon);
      for (const {id} of stack) {
        if (id) {
          geometries.has(id) ? geometries.get(id).push(polygon)
            : geometries.set(id, [polygon]);
        }
      }
    }
    const href = attribute(element.attributes, 'href');
    if (href?.startsWith('#') && feature && lodOf(stack)) {
      links.push({feature, lod: lodOf(stack), target: href.slice(1),
        within: stack.map(({id}) => id).filter(Boolean)});
    }
  }, (stack, element, content) => {
    if (element.name === 'name' && element.prefix === 'gml:') {
      const owner = stack.at(-2);
      if (owner && isFeature(owner)) {
        features.get(owner.id).name ??= content;
      }
    }
    if (!polygon) {
      return;
    }
    if (element.name === 'posList' || element.name === 'pos') {
      polygon.points.push(...numbers(content));
    } else if (element.name === 'LinearRing') {
      polygon.rings.push(ringOf(polygon.points));
      polygon.points = [];
    } else if (element.name === 'Polygon' || element.name === 'Triangle') {
      polygon = undefined;
    }
  });
  followLinks(links, geometries);
  for (const {feature, lod, target} of links) {
    for (const linked of geometries.get(target) ?? []) {
      feature.polygons.push({...linked, lod, linked: true});
    }
  }
  return features;
}

// Newell's normal: twice the area long.
export function ringNormal(ring) {
  const sum = [0, 0, 0];
  ring.forEach((a, i) => {
    const b = ring[(i + 1) % ring.length];
    sum[0] += (a[1] - b[1]) * (a[2] + b[2] - 2 * ring[0][2]);
    sum[1] += (a[2] - b[2]) * (a[0] + b[0] - 2 * ring[0][0]);
    sum[2] += (a[0] - b[0]) * (a[1] + b[1] - 2 * ring[0][1]);
  });
  return sum;
}

export const ringArea = ring => Math.hypot(...ringNormal(ring)) / 2;

export const polygonArea = ({rings}) => rings.reduce(
  (sum, ring, i) => i ? sum - ringArea(ring) : ringArea(ring), 0);
