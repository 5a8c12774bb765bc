# Imports files into Blender and compares the result with the expected numbers.
#   Run: blender -b --factory-startup --python-exit-code 1 -P import.py -- [FILE OBJECTS MATERIALS TRIANGLES]...
import sys

import bpy
import numpy

# Blender 3.4 of Debian 12 uses this name, which its numpy 1.24 no longer has.
numpy.bool = bool


def read(path):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    if path.endswith(".obj"):
        bpy.ops.wm.obj_import(filepath=path)
    elif path.endswith(".usda"):
        bpy.ops.wm.usd_import(filepath=path)
    elif path.endswith(".ply"):
        bpy.ops.import_mesh.ply(filepath=path)
    elif path.endswith(".stl"):
        bpy.ops.import_mesh.stl(filepath=path)
    else:
        bpy.ops.import_scene.gltf(filepath=path)


def count():
    objects = [thing for thing in bpy.data.objects if thing.type == "MESH"]
    triangles = sum(len(face.vertices) - 2 for thing in objects for face in thing.data.polygons)
    materials = {slot.material.name for thing in objects for slot in thing.material_slots}
    return len(objects), len(materials), triangles


# True if the bark has its colour and, in an .obj, its normals, from pictures that exist.
def has_bark(path):
    tree = bpy.data.materials["bark"].node_tree
    shader = tree.nodes["Principled BSDF"]
    pictures = [node.image for node in tree.nodes if node.type == "TEX_IMAGE"]
    names = ("Base Color", "Normal") if path.endswith(".obj") else ("Base Color",)
    linked = all(shader.inputs[name].is_linked for name in names)
    return linked and len(pictures) >= len(names) and all(picture.size[0] > 0 for picture in pictures)


arguments = sys.argv[sys.argv.index("--") + 1 :]
failed = not arguments
for i in range(0, len(arguments), 4):
    path = arguments[i]
    if path.endswith(".usda") and not bpy.app.usd.supported:
        print(f"{path}: this Blender is built without USD: not imported", flush=True)
        continue
    expected = tuple(int(number) for number in arguments[i + 1 : i + 4])
    read(path)
    found = count()
    print(f"{path}: objects, materials, triangles: {found}, expected {expected}", flush=True)
    failed = failed or found != expected
    if "bark" in bpy.data.materials and not has_bark(path):
        print(f"{path}: bark has not its pictures", flush=True)
        failed = True
if failed:
    raise SystemExit(1)
