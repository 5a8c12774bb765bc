// Checks .glb files with the Khronos validator, and prints every issue.
//   Run: node validate_glb.mjs NODE_MODULES FILE.glb...
// Exit code: 0 without errors and warnings, 1 with any, 77 if the validator is not installed.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { resolve } from 'node:path';

const [modules, ...files] = process.argv.slice(2);
let validator;
try {
    validator = createRequire(resolve(modules, 'resolve.js'))(resolve(modules, 'gltf-validator'));
} catch {
    console.log(`gltf-validator is not in ${modules}: npm install --prefix ${resolve(modules, '..')} gltf-validator`);
    process.exit(77);
}

const severities = ['error', 'warning', 'information', 'hint'];
let failed = files.length === 0;
for (const file of files) {
    const report = await validator.validateBytes(new Uint8Array(readFileSync(file)), { maxIssues: 100 });
    for (const issue of report.issues.messages)
        console.log(`${file}: ${severities[issue.severity]}: ${issue.code}: ${issue.message} (${issue.pointer ?? `offset ${issue.offset}`})`);
    console.log(`${file}: ${report.issues.numErrors} errors, ${report.issues.numWarnings} warnings`);
    failed ||= report.issues.numErrors + report.issues.numWarnings > 0;
}
process.exit(failed ? 1 : 0);
