// node validate.mjs FILE...: the Khronos glTF validator on each file.
//
// Prints a line per error or warning and exits 1 when there is one. Notes are
// printed too, save four that are expected: the validator does not know the
// extensions for metadata and instances, and so does not see who uses their
// buffer views and accessors; an object without geometry is an empty node; and textures may have any
// size since WebGL 2.
import fs from 'node:fs';
import path from 'node:path';
import validator from 'gltf-validator';

const severities = ['error', 'warning', 'note', 'hint'];

function isExpected({code, pointer = ''}, instanced) {
  return code === 'UNSUPPORTED_EXTENSION' || code === 'NODE_EMPTY' ||
    code === 'IMAGE_NPOT_DIMENSIONS' ||
    (code === 'UNUSED_OBJECT' && (pointer.startsWith('/bufferViews/') ||
      (instanced && pointer.startsWith('/accessors/'))));
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
  const instanced = report.info.extensionsUsed
    ?.includes('EXT_mesh_gpu_instancing');
  return {...report.issues, instanced};
}

let bad = 0;
for (const file of process.argv.slice(2)) {
  try {
    const issues = await validate(file);
    bad += issues.numErrors + issues.numWarnings;
    for (const issue of issues.messages) {
      if (issue.severity < 2 || !isExpected(issue, issues.instanced)) {
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
