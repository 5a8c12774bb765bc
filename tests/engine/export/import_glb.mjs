// Imports .glb files as other programs do, and compares plants and triangles with what their writer
// said: FOLDER/counts.txt has "FILE PLANTS TRIANGLES".
// Run: node import_glb.mjs three|gltf-transform NODE_MODULES FOLDER
// Exit code: 0 where all agree, 1 where not, 77 where the module is not installed.
import { readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [program, modules, folder] = process.argv.slice(2);

async function module_at(path) {
    try {
        return await import(pathToFileURL(resolve(modules, path)));
    } catch (error) {
        console.log(`${path} is not in ${modules}, see tests/run: ${error.message}`);
        process.exit(77);
    }
}

// Pictures stay undecoded: node has nothing that shows them.
async function three() {
    globalThis.self = globalThis;
    const { GLTFLoader } = await module_at('three/examples/jsm/loaders/GLTFLoader.js');
    const { Texture } = await module_at('three/build/three.module.js');
    const loader = new GLTFLoader();
    loader.register((parser) => {
        parser.textureLoader = { load: (url, done) => done(new Texture()) };
        return { name: 'undecoded' };
    });
    return async (file) => {
        const bytes = readFileSync(file);
        const start = bytes.byteOffset;
        const gltf = await loader.parseAsync(bytes.buffer.slice(start, start + bytes.byteLength), '');
        let triangles = 0;
        gltf.scene.traverse((thing) => {
            if (thing.isMesh)
                triangles += thing.geometry.index.count / 3 * (thing.isInstancedMesh ? thing.count : 1);
        });
        return { plants: gltf.scene.children.length, triangles };
    };
}

async function gltf_transform() {
    const { NodeIO } = await module_at('@gltf-transform/core/dist/index.modern.js');
    const { ALL_EXTENSIONS } = await module_at('@gltf-transform/extensions/dist/index.modern.js');
    const io = new NodeIO().registerExtensions(ALL_EXTENSIONS);
    return async (file) => {
        const scene = (await io.read(file)).getRoot().listScenes()[0];
        let triangles = 0;
        scene.traverse((node) => {
            const places = node.getExtension('EXT_mesh_gpu_instancing')?.getAttribute('TRANSLATION').getCount() ?? 1;
            for (const primitive of node.getMesh()?.listPrimitives() ?? [])
                triangles += places * primitive.getIndices().getCount() / 3;
        });
        return { plants: scene.listChildren().length, triangles };
    };
}

const read = program === 'three' ? await three() : await gltf_transform();
const lines = readFileSync(join(folder, 'counts.txt'), 'utf8').trim().split('\n');
let failed = lines.length === 0;
for (const line of lines) {
    const [file, plants, triangles] = line.split(' ');
    const found = await read(join(folder, file));
    const agree = found.plants === Number(plants) && found.triangles === Number(triangles);
    console.log(`${file}: ${found.plants} of ${plants} plants, ${found.triangles} of ${triangles} triangles`);
    failed ||= !agree;
}
process.exit(failed ? 1 : 0);
