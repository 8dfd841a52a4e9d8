// Validate glTF files by the Khronos validator, and decode what EXT_meshopt_compression compressed. Prints a list
// of JSON: the issues of each file, and the decoded arrays of its buffer views.
//   node gltf_validation.js MODULES FILE.glb...
// MODULES is the folder of the npm packages gltf-validator and meshoptimizer.
"use strict";
const fs = require("fs");
const path = require("path");
const [modules, ...files] = process.argv.slice(2);
const validator = require(path.join(modules, "gltf-validator"));
const { MeshoptDecoder } = require(path.join(modules, "meshoptimizer"));

function decoded(bytes) {
  const length = bytes.readUInt32LE(12);
  const document = JSON.parse(bytes.toString("utf8", 20, 20 + length));
  const binary = bytes.subarray(28 + length);
  return document.bufferViews.map((view) => {
    const packed = (view.extensions || {}).EXT_meshopt_compression;
    if (!packed) {
      return null;
    }
    const target = new Uint8Array(packed.count * packed.byteStride);
    const source = new Uint8Array(binary.subarray(packed.byteOffset, packed.byteOffset + packed.byteLength));
    MeshoptDecoder.decodeGltfBuffer(target, packed.count, packed.byteStride, source, packed.mode, packed.filter);
    return Buffer.from(target).toString("base64");
  });
}

(async () => {
  await MeshoptDecoder.ready;
  const results = [];
  for (const file of files) {
    const bytes = fs.readFileSync(file);
    const report = await validator.validateBytes(new Uint8Array(bytes));
    results.push({ issues: report.issues.messages, views: decoded(bytes) });
  }
  console.log(JSON.stringify(results));
})();
