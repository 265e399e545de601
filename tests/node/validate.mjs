// node validate.mjs FILE...: the Khronos glTF validator on each file.
//
// Prints a line per error or warning and exits 1 when there is one. Notes are
// printed too, save four that are expected: the validator does not know the
// two metadata extensions, and so does not see who uses the buffer views of the
// tables; an object without geometry is an empty node; and textures may have any
// size since WebGL 2.
import fs from 'node:fs';
import path from 'node:path';
import validator from 'gltf-validator';

const severities = ['error', 'warning', 'note', 'hint'];

function isExpected({code, pointer = ''}) {
  return code === 'UNSUPPORTED_EXTENSION' || code === 'NODE_EMPTY' ||
    code === 'IMAGE_NPOT_DIMENSIONS' ||
    (code === 'UNUSED_OBJECT' && pointer.startsWith('/bufferViews/'));
}

async function validate(file) {
  const folder = path.dirname(file);
  const report = await validator.validateBytes(
    new Uint8Array(fs.readFileSync(file)), {
      uri: path.basename(file),
      maxIssues: 1000,
      externalResourceFunction: async uri => new Uint8Array(
        fs.readFileSync(path.join(folder, decodeURIComponent(uri)))),
    });
  return report.issues;
}

let bad = 0;
for (const file of process.argv.slice(2)) {
  try {
    const issues = await validate(file);
    bad += issues.numErrors + issues.numWarnings;
    for (const issue of issues.messages) {
      if (issue.severity < 2 || !isExpected(issue)) {
        console.log(`${file}: ${severities[issue.severity]}: ${issue.code} ` +
          `${issue.pointer ?? ''}: ${issue.message}`);
      }
    }
  } catch (problem) {
    bad++;
    console.log(`${file}: error: ${problem}`);
  }
}
process.exitCode = bad ? 1 : 0;
