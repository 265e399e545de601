// node browser.mjs FILE.gml FILE.glb PICTURE.png: a city in three.js in a
// headless Chromium.
//
// Shows FILE.glb, saves a picture, and stands in front of walls that are read
// from FILE.gml: what the page sees there must be that wall, by its id. The
// picture must hold more than one colour. CHROMIUM names the browser.
import fs from 'node:fs';
import http from 'node:http';
import os from 'node:os';
import path from 'node:path';
import {fileURLToPath} from 'node:url';
import {chromium} from 'playwright-core';
import {polygonArea, readGml, ringNormal} from './gml.mjs';
import {readModel} from './glb.mjs';

const [gmlFile, gltfFile, picture] = process.argv.slice(2);
const here = path.dirname(fileURLToPath(import.meta.url));
const width = 1600;
const height = 900;
const view = {azimuth: Number(process.env.AZIMUTH ?? 22),
  elevation: Number(process.env.ELEVATION ?? 25),
  fill: Number(process.env.FILL ?? 0.92),
  aim: (process.env.AIM ?? '-0.03,0.01').split(',').map(Number)};
const types = {'.html': 'text/html', '.js': 'text/javascript',
  '.mjs': 'text/javascript', '.glb': 'model/gltf-binary'};

function serve() {
  const server = http.createServer((request, response) => {
    const name = new URL(request.url, 'http://localhost').pathname;
    const file = name === '/city.glb' ? gltfFile : path.join(here, name);
    fs.readFile(file, (problem, bytes) => {
      response.writeHead(problem ? 404 : 200,
        {'content-type': types[path.extname(file)] ?? 'text/plain'});
      response.end(bytes);
    });
  });
  return new Promise(done => server.listen(0, '127.0.0.1', () => done(server)));
}

// Up to `count` large walls without holes: {id, middle, outside}.
function walls(count) {
  const {origin} = readModel(gltfFile).json.asset.extras;
  const found = [];
  for (const feature of readGml(gmlFile).values()) {
    const [polygon] = feature.polygons;
    if (feature.class !== 'WallSurface' || feature.polygons.length !== 1 ||
        polygon.rings.length !== 1 || polygon.rings[0].length !== 4) {
      continue;
    }
    const [ring] = polygon.rings;
    const normal = ringNormal(ring);
    const length = Math.hypot(...normal);
    found.push({
      id: feature.id,
      parent: feature.parent,
      area: polygonArea(polygon),
      middle: origin.map((o, k) =>
        ring.reduce((sum, point) => sum + point[k], 0) / 4 - o),
      normal: normal.map(value => value / length),
    });
  }
  return found.sort((a, b) => b.area - a.area).slice(0, count);
}

async function pickWalls(page) {
  let seen = 0;
  let failed = 0;
  for (const {id, parent, middle, normal} of walls(20)) {
    const eye = middle.map((value, k) => value + 0.4 * normal[k]);
    const hit = await page.evaluate(
      ([from, to]) => window.pick(from, to), [eye, middle]);
    const right = hit?.id === id && hit.class === 'WallSurface' &&
      hit.parent === parent && Math.abs(hit.distance - 0.4) < 0.01;
    seen += right;
    failed += !right;
    if (!right) {
      console.log(`in front of ${id} of ${parent}: ${JSON.stringify(hit)}`);
    }
  }
  console.log(`${seen} walls picked, ${failed} not`);
  return seen > 0 && failed === 0;
}

// The share of the pixels that have the commonest of 4096 colours.
const flatness = page => page.evaluate(() => {
  const source = document.querySelector('canvas');
  const copy = document.createElement('canvas');
  copy.width = 320;
  copy.height = 180;
  const pen = copy.getContext('2d');
  window.again();
  pen.drawImage(source, 0, 0, 320, 180);
  const {data} = pen.getImageData(0, 0, 320, 180);
  const counts = new Uint32Array(4096);
  for (let i = 0; i < data.length; i += 4) {
    counts[data[i] >> 4 << 8 | data[i + 1] >> 4 << 4 | data[i + 2] >> 4]++;
  }
  return Math.max(...counts) / (320 * 180);
});

async function show(browser, address) {
  const page = await browser.newPage();
  const problems = [];
  page.on('pageerror', problem => problems.push(String(problem)));
  page.on('console', message => message.type() === 'error' &&
    !message.location().url.endsWith('favicon.ico') &&
    problems.push(message.text()));
  await page.goto(`${address}/view.html`);
  await page.waitForFunction('window.ready', null, {timeout: 60000});
  const shown = await page.evaluate(
    ([w, h, v]) => window.show('city.glb', w, h, v), [width, height, view]);
  console.log(`${shown.meshes} meshes, ` +
    `${shown.size.map(Math.round).join(' x ')} m`);
  await page.screenshot({path: picture, timeout: 120000});
  const flat = await flatness(page);
  if (flat > 0.6) {
    problems.push(`${Math.round(100 * flat)} % of the picture is one colour`);
  }
  if (!await pickWalls(page)) {
    problems.push('a wall was not what was seen');
  }
  problems.forEach(problem => console.log(problem));
  return problems.length === 0;
}

const server = await serve();
const profile = fs.mkdtempSync(path.join(os.tmpdir(), 'browser-'));
const browser = await chromium.launchPersistentContext(profile, {
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  headless: true,
  viewport: {width, height},
  args: ['--no-sandbox', '--disable-quic', '--no-first-run',
    '--disable-background-networking', '--disable-component-update',
    '--disable-sync', '--use-gl=angle', '--use-angle=swiftshader',
    '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'],
});
try {
  const good = await show(browser,
    `http://127.0.0.1:${server.address().port}`);
  process.exitCode = good ? 0 : 1;
} finally {
  await browser.close();
  server.close();
  fs.rmSync(profile, {recursive: true, force: true});
}
