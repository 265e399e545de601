// node web_ifc.mjs ROUNDS FILE...: what web-ifc takes to parse each file and
// to tessellate all of its products. A line a file: seconds of CPU time, the
// median of the rounds, and triangles; "failed" where it gives up. Its own
// start-up stands before the clock starts.
import fs from 'node:fs';
import * as webIfc from 'web-ifc';

const [rounds, ...files] = process.argv.slice(2);

async function start() {
  const api = new webIfc.IfcAPI();
  await api.Init();
  api.SetLogLevel(webIfc.LogLevel.LOG_LEVEL_OFF);
  return api;
}

// The triangles of the file; its meshes are copied out, as a viewer does.
function tessellate(api, bytes) {
  const model = api.OpenModel(bytes);
  let triangles = 0;
  api.StreamAllMeshes(model, mesh => {
    for (let i = 0; i < mesh.geometries.size(); i++) {
      const geometry = api.GetGeometry(model,
        mesh.geometries.get(i).geometryExpressID);
      api.GetVertexArray(geometry.GetVertexData(),
        geometry.GetVertexDataSize());
      triangles += api.GetIndexArray(geometry.GetIndexData(),
        geometry.GetIndexDataSize()).length / 3;
      geometry.delete();
    }
  });
  api.CloseModel(model);
  return triangles;
}

let api = await start();
for (const file of files) {
  const bytes = fs.readFileSync(file);
  const seconds = [];
  let triangles = 0;
  try {
    for (let round = 0; round < Number(rounds); round++) {
      const before = process.cpuUsage();
      triangles = tessellate(api, bytes);
      const {user, system} = process.cpuUsage(before);
      seconds.push((user + system) / 1e6);
    }
    seconds.sort((a, b) => a - b);
    console.log(seconds[seconds.length >> 1], triangles);
  } catch {
    console.log('failed', 0);
    api = await start();
  }
}
