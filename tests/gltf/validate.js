// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the Khronos glTF validator on GLB files. Prints a line for each issue of any severity, and for each use of
// an extension, of which the exports have none.
// Usage: node validate.js FOLDER_WITH_NODE_MODULES FILE...
// Ends with 0 when no file has an issue, and prints "GLTF IS VALID" as the last line then; otherwise with 1.
"use strict";
const fs = require("fs");
const path = require("path");

const [modules, ...files] = process.argv.slice(2);
const validator = require(path.join(modules, "node_modules", "gltf-validator"));
const severities = ["error", "warning", "information", "hint"];

async function issuesOf(file) {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), {
        uri: path.basename(file),
        format: "glb",
        maxIssues: 100,
    });
    const issues = report.issues.messages.map(
        (m) => `${severities[m.severity]} ${m.code} at ${m.pointer || m.offset}: ${m.message}`);
    for (const extension of report.info.extensionsUsed || []) {
        issues.push(`the extension ${extension} is declared`);
    }
    return issues;
}

(async () => {
    let found = 0;
    for (const file of files) {
        for (const issue of await issuesOf(file)) {
            console.log(`${path.basename(file)}: ${issue}`);
            ++found;
        }
    }
    if (found === 0) {
        console.log("GLTF IS VALID");
    }
    process.exitCode = found === 0 ? 0 : 1;
})().catch((error) => {
    console.log(String(error));
    process.exitCode = 1;
});
