# Runs the manual's script for Blender on a stream, and compares the curves with the contents of the stream.
#   Run: blender -b --factory-startup --python-exit-code 1 -P stream.py -- MANUAL_PAGE SOCKET STREAM.jsonl
import json
import re
import sys

import bpy

page, address, expected = sys.argv[sys.argv.index("--") + 1 :]
script = re.search(r"```python\n(.*?)```", open(page).read(), re.DOTALL).group(1)
assert "/tmp/tractus.sock" in script
# Without a window, Blender does not run timers, so they are called here.
names = {}
exec(compile(script.replace("/tmp/tractus.sock", address), page, "exec"), names)
while names["take"]() is not None:
    pass

strokes = [line for line in map(json.loads, open(expected)) if line["type"] == "stroke"]
curves = [thing for thing in bpy.data.objects if thing.type == "CURVE"]
assert [curve.name for curve in curves] == [f"stroke {stroke['number']}" for stroke in strokes], curves
for curve, stroke in zip(curves, strokes):
    points = curve.data.splines[0].points
    assert len(points) == len(stroke["tips"])
    for point, (x, y, z, pressure, _) in zip(points, stroke["tips"]):
        error_m = max(abs(point.co[0] - x / 1000), abs(point.co[1] - y / 1000), abs(point.co[2] - z / 1000))
        assert error_m < 1e-6 and abs(point.radius - pressure) < 1e-6, (point.co, x, y, z)
assert strokes
print(f"{len(curves)} strokes arrived as curves")
