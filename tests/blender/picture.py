# Renders a .glb with Cycles, with the camera and a similar light as "tractus render".
#
#   blender -b --factory-startup -P tests/blender/picture.py -- FILE.glb PICTURE.png WIDTH HEIGHT AZIMUTH ELEVATION
#
# Azimuth and elevation are in degrees, as for "tractus render".
import math
import sys

import bpy
import numpy
from mathutils import Vector

numpy.bool = bool  # Blender 3.4's importer uses this name, which newer versions of NumPy no longer have.
glb, picture, width, height, azimuth, elevation = sys.argv[sys.argv.index("--") + 1:]
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath=glb)
scene = bpy.context.scene
corners = [o.matrix_world @ Vector(c) for o in scene.objects if o.type == "MESH" for c in o.bound_box]
low = Vector(min(c[k] for c in corners) for k in range(3))
high = Vector(max(c[k] for c in corners) for k in range(3))
middle = (low + high) / 2
reach = (high - low).length / 2

scene.render.engine = "CYCLES"
scene.cycles.samples = 64
scene.cycles.use_denoising = False
scene.cycles.seed = 0
scene.render.resolution_x, scene.render.resolution_y = int(width), int(height)
scene.view_settings.view_transform = "Standard"
world = bpy.data.worlds.new("sky")
world.use_nodes = True
world.node_tree.nodes["Background"].inputs[0].default_value = (0.75, 0.85, 1, 1)
world.node_tree.nodes["Background"].inputs[1].default_value = 0.35
scene.world = world
light = bpy.data.lights.new("sun", "SUN")
light.energy = 7
light.angle = math.radians(2)
sun = bpy.data.objects.new("sun", light)
sun.rotation_euler = (Vector((0, 0, 0)) - Vector((-0.62, -0.28, 0.73))).to_track_quat("-Z", "Y").to_euler()
scene.collection.objects.link(sun)
camera_data = bpy.data.cameras.new("camera")
camera_data.lens_unit = "FOV"
camera_data.angle = math.radians(35)
camera = bpy.data.objects.new("camera", camera_data)
scene.collection.objects.link(camera)
scene.camera = camera
turn, rise = math.radians(float(azimuth)), math.radians(float(elevation))
way = Vector((math.sin(turn) * math.cos(rise), -math.cos(turn) * math.cos(rise), math.sin(rise)))
camera.location = middle + way * 0.8 * reach / math.tan(camera_data.angle / 2)
camera.rotation_euler = (middle - camera.location).to_track_quat("-Z", "Y").to_euler()
scene.render.filepath = picture
bpy.ops.render.render(write_still=True)
