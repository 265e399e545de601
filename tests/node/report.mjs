// node report.mjs PAGE SHOT PICTURES: open a report of tcs-compare in headless
// Chromium, cut off from every network, and write a screenshot of it. The page
// must ask for nothing, break no rule of its own policy, and hold so many
// pictures, each decoded and of several colours. CHROMIUM names the browser.
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import {pathToFileURL} from 'node:url';
import {chromium} from 'playwright-core';

const [file, shot, wanted] = process.argv.slice(2);
const problems = [];
const profile = fs.mkdtempSync(path.join(os.tmpdir(), 'report-'));
const browser = await chromium.launchPersistentContext(profile, {
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  headless: true,
  offline: true,
  viewport: {width: 1060, height: 1000},
  args: ['--no-sandbox', '--no-first-run', '--disable-background-networking',
    '--disable-component-update', '--disable-sync'],
});

// The number of colours in each picture, 0 for one that is not shown.
function countColours() {
  return [...document.images].map(image => {
    const canvas = document.createElement('canvas');
    canvas.width = image.naturalWidth;
    canvas.height = image.naturalHeight;
    if (!image.complete || !canvas.width) {
      return 0;
    }
    const pen = canvas.getContext('2d');
    pen.drawImage(image, 0, 0);
    const {data} = pen.getImageData(0, 0, canvas.width, canvas.height);
    const colours = new Set();
    for (let i = 0; i < data.length; i += 4) {
      colours.add(data[i] << 16 | data[i + 1] << 8 | data[i + 2]);
    }
    return colours.size;
  });
}

try {
  const page = await browser.newPage();
  const url = pathToFileURL(file).href;
  page.on('request', request => request.url() === url ||
    request.url().startsWith('data:image/png;base64,') ||
    problems.push(`asked for ${request.url().slice(0, 80)}`));
  page.on('console', message => problems.push(message.text()));
  page.on('pageerror', error => problems.push(String(error)));
  await page.goto(url);
  await page.screenshot({path: shot});
  const colours = await page.evaluate(countColours);
  if (colours.length !== Number(wanted)) {
    problems.push(`${colours.length} pictures, not ${wanted}`);
  }
  if (colours.some(count => count < 50)) {
    problems.push(`colours of the pictures: ${colours}`);
  }
} finally {
  await browser.close();
  fs.rmSync(profile, {recursive: true, force: true});
}
problems.forEach(problem => console.log(problem));
process.exitCode = problems.length ? 1 : 0;
