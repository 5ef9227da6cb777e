// SPDX-License-Identifier: MIT
// NODE_PATH=FOLDER/node_modules node validate.js FILE.glb ...
// where FOLDER is build/gltf-validator after ./dev setup.
// Runs the Khronos validator; exits with 1 on any error or warning.
const validator = require("gltf-validator");
const fs = require("fs");

async function main(files) {
    for (const file of files) {
        const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)));
        const { numErrors, numWarnings, messages } = report.issues;
        console.log(`${file}: ${numErrors} errors, ${numWarnings} warnings`);
        messages.filter((m) => m.severity < 2).forEach((m) => console.log(m.pointer, m.message));
        if (numErrors + numWarnings > 0) {
            process.exitCode = 1;
        }
    }
}

main(process.argv.slice(2));
