// Imports .glb files with other libraries, and compares plants and triangles with the writer's
// numbers: FOLDER/counts.txt has lines "FILE PLANTS TRIANGLES". Compressed files are also compared
// with the same files only quantised: positions must be equal, and normals nearly so.
//   Run: node import_glb.mjs three|gltf-transform NODE_MODULES FOLDER
// Exit code: 0 if all agree, 1 if not, 77 if the module is not installed.
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

async function meshopt_decoder() {
    const { MeshoptDecoder } = await module_at('three/examples/jsm/libs/meshopt_decoder.module.js');
    await MeshoptDecoder.ready;
    return MeshoptDecoder;
}

// Pictures are not decoded, because node cannot display them.
async function three() {
    globalThis.self = globalThis;
    const { GLTFLoader } = await module_at('three/examples/jsm/loaders/GLTFLoader.js');
    const { Matrix4, Texture, Vector3 } = await module_at('three/build/three.module.js');
    const loader = new GLTFLoader();
    loader.setMeshoptDecoder(await meshopt_decoder());
    loader.register((parser) => {
        parser.textureLoader = { load: (url, done) => done(new Texture()) };
        return { name: 'undecoded' };
    });
    return async (file) => {
        const bytes = readFileSync(file);
        const start = bytes.byteOffset;
        const gltf = await loader.parseAsync(bytes.buffer.slice(start, start + bytes.byteLength), '');
        gltf.scene.updateMatrixWorld();
        let triangles = 0;
        const corners = [];
        const place = new Matrix4();
        gltf.scene.traverse((thing) => {
            if (!thing.isMesh)
                return;
            const { index, attributes } = thing.geometry;
            const places = thing.isInstancedMesh ? thing.count : 1;
            triangles += index.count / 3 * places;
            for (let i = 0; i < places; ++i) {
                place.copy(thing.matrixWorld);
                if (thing.isInstancedMesh)
                    place.multiply(new Matrix4().fromArray(thing.instanceMatrix.array, 16 * i));
                for (const vertex of index.array)
                    corners.push({
                        position: new Vector3().fromBufferAttribute(attributes.position, vertex).applyMatrix4(place),
                        normal: new Vector3().fromBufferAttribute(attributes.normal, vertex).normalize(),
                    });
            }
        });
        return { plants: gltf.scene.children.length, triangles, corners };
    };
}

async function gltf_transform() {
    const { NodeIO } = await module_at('@gltf-transform/core/dist/index.modern.js');
    const { ALL_EXTENSIONS } = await module_at('@gltf-transform/extensions/dist/index.modern.js');
    const io = new NodeIO().registerExtensions(ALL_EXTENSIONS)
        .registerDependencies({ 'meshopt.decoder': await meshopt_decoder() });
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

const quantized_twins = {
    'compressed.glb': 'quantized.glb',
    'instanced_compressed.glb': 'instanced_quantized.glb',
    'details_compressed.glb': 'details_quantized.glb',
    'wind_compressed.glb': 'wind.glb',
};

// True if the corners of all triangles have the same positions as in another file, and the same
// normals within 2.5 degrees, since both files are rounded.
function is_same_shape(corners, others) {
    return corners.length === others.length && corners.every(({ position, normal }, i) =>
        position.distanceTo(others[i].position) < 1e-6 && normal.dot(others[i].normal) > 0.999);
}

const read = program === 'three' ? await three() : await gltf_transform();
const lines = readFileSync(join(folder, 'counts.txt'), 'utf8').trim().split('\n');
let failed = lines.length === 0;
for (const line of lines) {
    const [file, plants, triangles] = line.split(' ');
    const found = await read(join(folder, file));
    let agree = found.plants === Number(plants) && found.triangles === Number(triangles);
    console.log(`${file}: ${found.plants} of ${plants} plants, ${found.triangles} of ${triangles} triangles`);
    if (agree && found.corners && file in quantized_twins) {
        agree = is_same_shape(found.corners, (await read(join(folder, quantized_twins[file]))).corners);
        console.log(`${file}: ${agree ? 'the same shape as' : 'another shape than'} ${quantized_twins[file]}`);
    }
    failed ||= !agree;
}
process.exit(failed ? 1 : 0);
