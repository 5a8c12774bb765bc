// Reads a plant's files in other programs' formats with other libraries: .obj, .ply, .stl and .usda
// with three.js, .usda also with TinyUSDZ. FOLDER/counts.txt has lines "FILE TRIANGLES"; every file
// must have its number. The corners of all triangles of the .usda files and of open.ply must be
// where those of tree.obj are, and the surface of the .stl files closed.
//   Run: node import_formats.mjs NODE_MODULES FOLDER
// Exit code: 0 if all agree, 1 if not, 77 if a module is not installed.
import { readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [modules, folder] = process.argv.slice(2);
const three_folder = 'three-usd'; // A version of three.js that reads .usda.
globalThis.self = globalThis;
globalThis.window = globalThis;
process.type = 'renderer'; // TinyUSDZ refuses to run in node otherwise.

async function module_at(path) {
    try {
        return await import(pathToFileURL(resolve(modules, path)));
    } catch (error) {
        console.log(`${path} is not in ${modules}, see tests/run: ${error.message}`);
        process.exit(77);
    }
}

const { FileLoader, ImageLoader, Matrix4, Quaternion, Texture, TextureLoader, Vector3 }
    = await module_at(`${three_folder}/build/three.module.js`);
const loader = async (name) => (await module_at(`${three_folder}/examples/jsm/loaders/${name}.js`))[name];
const [OBJLoader, PLYLoader, STLLoader, USDLoader]
    = await Promise.all(['OBJLoader', 'PLYLoader', 'STLLoader', 'USDLoader'].map(loader));
const { USDAParser } = await module_at(`${three_folder}/examples/jsm/loaders/usd/USDAParser.js`);
const { default: tiny_usdz } = await module_at('tinyusdz/tinyusdz.js');

// Pictures are not decoded, because node cannot display them; only the requests are counted.
const pictures = new Set();
for (const kind of [FileLoader, ImageLoader, TextureLoader])
    kind.prototype.load = function (url, done) {
        pictures.add(url);
        if (kind === TextureLoader)
            return new Texture();
        queueMicrotask(() => done?.({ width: 1, height: 1 }));
    };

const bytes_of = (file) => {
    const bytes = readFileSync(join(folder, file));
    return bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
};
const text_of = (file) => readFileSync(join(folder, file), 'utf8');

function corners_of_geometry({ index, attributes: { position } }, place = new Matrix4()) {
    const count = index ? index.count : position.count;
    return Array.from({ length: count }, (_, i) =>
        new Vector3().fromBufferAttribute(position, index ? index.getX(i) : i).applyMatrix4(place));
}

function corners_of_scene(scene) {
    const meshes = [];
    scene.updateMatrixWorld();
    scene.traverse((thing) => {
        if (thing.isMesh)
            meshes.push(thing);
    });
    return meshes.flatMap((mesh) => corners_of_geometry(mesh.geometry, mesh.matrixWorld));
}

// The prim whose declaration begins with `start`, somewhere inside of `prim`.
function find_prim(prim, start) {
    for (const [key, value] of Object.entries(prim)) {
        if (typeof value !== 'object')
            continue;
        const found = key.startsWith(start) ? value : find_prim(value, start);
        if (found)
            return found;
    }
    return null;
}

const numbers_of = (text) => text.match(/-?[0-9.]+(e[-+]?[0-9]+)?/g).map(Number);
const vectors_of = (text) => {
    const numbers = numbers_of(text);
    return Array.from({ length: numbers.length / 3 }, (_, i) => new Vector3(...numbers.slice(3 * i, 3 * i + 3)));
};

// three.js reads point instancers as text, but does not draw them.
function corners_of_instances(text) {
    const instancer = find_prim(new USDAParser().parseText(text), 'def PointInstancer');
    const scope = find_prim(instancer, 'def Scope "Prototypes"');
    const prototypes = Object.values(scope).map((prim) => {
        const mesh = find_prim(prim, 'def Mesh');
        const points = vectors_of(mesh['point3f[] points']);
        return numbers_of(mesh['int[] faceVertexIndices']).map((i) => points[i]);
    });
    const positions = vectors_of(instancer['point3f[] positions']);
    const scales = vectors_of(instancer['float3[] scales']);
    const rotations = numbers_of(instancer['quatf[] orientationsf']);
    return numbers_of(instancer['int[] protoIndices']).flatMap((prototype, i) => {
        const [w, x, y, z] = rotations.slice(4 * i, 4 * i + 4);
        const place = new Matrix4().compose(positions[i], new Quaternion(x, y, z, w), scales[i]);
        return prototypes[prototype].map((point) => point.clone().applyMatrix4(place));
    });
}

function corners_of_usda(file) {
    const text = text_of(file);
    const begin = text.indexOf('def PointInstancer');
    if (begin < 0)
        return corners_of_scene(new USDLoader().parse(text));
    const scene = new USDLoader().parse(text);
    const organs = scene.getObjectByName('organs');
    organs.removeFromParent();
    return [...corners_of_scene(scene), ...corners_of_instances(text)];
}

const readers = {
    obj: (file) => corners_of_scene(new OBJLoader().parse(text_of(file))),
    ply: (file) => corners_of_geometry(new PLYLoader().parse(bytes_of(file))),
    stl: (file) => corners_of_geometry(new STLLoader().parse(bytes_of(file))),
    usda: corners_of_usda,
};

// From millimetres, z up, to metres, y up.
const in_metres = ({ x, y, z }) => new Vector3(x / 1000, z / 1000, -y / 1000);

// Corners sorted by place, since formats list triangles in orders of their own. Places are rounded,
// so neighbours may be swapped: the distance of the sums along each axis is compared, too.
function farthest_apart(corners, others) {
    if (corners.length !== others.length)
        return Infinity;
    return Math.max(...['x', 'y', 'z'].map((axis) => {
        const [a, b] = [corners, others].map((all) => Float64Array.from(all, (corner) => corner[axis]).sort());
        return a.reduce((most, value, i) => Math.max(most, Math.abs(value - b[i])), 0);
    }));
}

function bad_edges(corners) {
    const uses = new Map();
    const name = ({ x, y, z }) => `${x} ${y} ${z}`;
    for (let i = 0; i < corners.length; i += 3)
        for (let k = 0; k < 3; ++k) {
            const [from, to] = [name(corners[i + k]), name(corners[i + (k + 1) % 3])];
            const key = from < to ? `${from},${to}` : `${to},${from}`;
            const [forth, back] = uses.get(key) ?? [0, 0];
            uses.set(key, from < to ? [forth + 1, back] : [forth, back + 1]);
        }
    return [...uses.values()].filter(([forth, back]) => forth !== 1 || back !== 1).length;
}

let failed = false;
function expect(is_right, text) {
    console.log(`${is_right ? 'right' : 'WRONG'}: ${text}`);
    failed ||= !is_right;
}

const expected = readers.obj('tree.obj');
for (const line of text_of('counts.txt').trim().split('\n')) {
    const [file, triangles] = line.split(' ');
    const ending = file.split('.').pop();
    const corners = readers[ending](file);
    expect(corners.length === 3 * Number(triangles), `${file}: ${corners.length / 3} of ${triangles} triangles`);
    if (ending === 'stl')
        expect(bad_edges(corners) === 0, `${file}: every edge has two triangles`);
    if (ending === 'usda' || file === 'open.ply') {
        const apart = farthest_apart(ending === 'ply' ? corners.map(in_metres) : corners, expected);
        expect(apart < 1e-5, `${file}: corners are ${apart} m from those of tree.obj`);
    }
}
expect([...pictures].some((url) => url.includes('merged-bark-color.png')), `pictures: ${[...pictures].join(', ')}`);

const native = await tiny_usdz({ wasmBinary: readFileSync(resolve(modules, 'tinyusdz/tinyusdz.wasm')) });
for (const [file, meshes] of [['instanced.usda', 3], ['merged.usda', 2]]) {
    const usd = new native.TinyUSDZLoaderNative();
    usd.setLoadTextureInNative(false);
    const is_read = usd.loadFromBinary(readFileSync(join(folder, file)), file);
    expect(is_read && usd.numMeshes() === meshes, `${file}: TinyUSDZ ${is_read ? `reads ${usd.numMeshes()} meshes` : `says ${usd.error()}`}`);
    const material = is_read ? usd.getMaterial(0) : {};
    expect('diffuseColorTextureId' in material, `${file}: TinyUSDZ finds the bark's picture`);
}
process.exit(failed ? 1 : 0);
