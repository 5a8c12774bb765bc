"""Meshes: against the .glb that the program writes of the same plant, read here byte by byte."""

import json
import struct

import numpy as np
import pytest
import tractus

FLOATS = {"VEC2": 2, "VEC3": 3, "VEC4": 4}


def glb_primitives(path):
    """The primitives of a .glb of one plant, by the name of their material."""
    data = path.read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]
    gltf = json.loads(data[20 : 20 + length])
    binary = data[20 + length + 8 :]

    def accessor(number):
        entry = gltf["accessors"][number]
        view = gltf["bufferViews"][entry["bufferView"]]
        begin = view.get("byteOffset", 0) + entry.get("byteOffset", 0)
        if entry["type"] == "SCALAR":
            kind = {5121: "u1", 5123: "<u2", 5125: "<u4"}[entry["componentType"]]
            return np.frombuffer(binary, kind, entry["count"], begin)
        width = FLOATS[entry["type"]]
        stride = view.get("byteStride", 4 * width)
        return np.ndarray((entry["count"], width), "<f4", binary, begin, (stride, 4))

    found = {}
    for primitive in gltf["meshes"][0]["primitives"]:
        name = gltf["materials"][primitive["material"]]["name"]
        part = {key: accessor(number) for key, number in primitive["attributes"].items()}
        part["indices"] = accessor(primitive["indices"])
        found.setdefault(name, []).append(part)
    return found


@pytest.fixture(scope="module")
def plant():
    return tractus.grow("birch")


@pytest.fixture(scope="module")
def mesh(plant):
    return plant.mesh()


def test_the_tubes_are_those_of_the_glb(mesh, program):
    program("grow", "birch", "-o", "birch.glb")
    primitives = glb_primitives(program.folder / "birch.glb")
    assert mesh.surfaces
    for surface in mesh.surfaces:
        (written,) = primitives[mesh.materials[surface.material].name]
        count = len(surface.positions_mm) # Organs of the same material follow.
        x, y, z = surface.positions_mm.T
        # glTF has metres, and +y up.
        assert np.allclose(written["POSITION"][:count], np.stack([x, z, -y], 1) / 1000, atol=1e-6)
        x, y, z = surface.normals.T
        assert np.allclose(written["NORMAL"][:count], np.stack([x, z, -y], 1), atol=1e-6)
        triangles = surface.indices.ravel()
        assert (written["indices"][: len(triangles)] == triangles).all()


def test_all_triangles_are_those_of_the_glb(mesh, program):
    program("grow", "birch", "-o", "birch.glb")
    written = sum(
        len(part["indices"]) // 3
        for parts in glb_primitives(program.folder / "birch.glb").values()
        for part in parts
    )
    shown = sum(len(surface.indices) for surface in mesh.surfaces) + sum(
        len(organs.prototype.indices) * len(organs.scales) for organs in mesh.organs
    )
    assert mesh.triangle_count == shown == written


def test_arrays_have_the_shapes_that_the_docstrings_say(mesh):
    for surface in [*mesh.surfaces, *(organs.prototype for organs in mesh.organs)]:
        count = len(surface.positions_mm)
        assert surface.positions_mm.shape == surface.normals.shape == (count, 3)
        assert surface.texture_coordinates.shape == (count, 2)
        assert surface.indices.shape[1] == 3
        assert surface.indices.max() < count
        assert np.allclose(np.linalg.norm(surface.normals, axis=1), 1, atol=1e-4)


def test_copies_of_organs_are_the_plants_organs(plant, mesh):
    for organs in mesh.organs:
        own = plant.organs[plant.organs["shape"] == organs.shape]
        assert np.allclose(organs.translations_mm, own["position_mm"], atol=1e-3)
        assert np.allclose(organs.rotations, own["orientation"], atol=1e-6)
        assert (organs.scales == own["scale"]).all()
    assert sum(len(organs.scales) for organs in mesh.organs) == len(plant.organs)


def test_arrays_keep_their_mesh():
    arrays = [surface.positions_mm for surface in tractus.grow("shrub").mesh().surfaces]
    kept = [array.copy() for array in arrays]
    for seed in range(5): # Other meshes would take the memory if it were free.
        tractus.grow("shrub", seed=seed).mesh()
    for array, copy in zip(arrays, kept):
        assert (array == copy).all()
        assert not array.flags.writeable


def test_fewer_sides_make_fewer_triangles(plant, mesh):
    coarse = plant.mesh(3, subdivision=0)
    assert sum(len(surface.indices) for surface in coarse.surfaces) * 2 < sum(
        len(surface.indices) for surface in mesh.surfaces
    )
    for sides in (2, 65):
        with pytest.raises(tractus.Error, match=f"sides is {sides}: it must be 3 to 64"):
            plant.mesh(sides)
