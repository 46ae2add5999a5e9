"""Does Blender show an exported take where Kumite has it?

    kumite export --out take.glb; kumite export --out take.bvh; kumite export --out take.npz
    blender -b --python tests/benchmarks/blender_check.py -- take.npz take.glb
    blender -b --python tests/benchmarks/blender_check.py -- take.npz take-2.bvh 2 0.01

Prints the largest distance between a joint of the .npz and of the imported file, over some frames,
in millimetres; ends with 1 if it is beyond 1 mm. After a .bvh: the player and metres per unit. A .bvh
stands on its recording's floor, not at 0; that shift is left out.
"""
import builtins
import sys

import bpy
import numpy as np

arguments = sys.argv[sys.argv.index("--") + 1:]
arrays = np.load(arguments[0])
path = arguments[1]
bpy.ops.wm.read_factory_settings(use_empty=True)
is_bvh = path.endswith(".bvh")
if is_bvh:
    # Debian 12's Blender 3.4 opens .bvh with a mode that its Python no longer knows.
    plain_open = builtins.open
    builtins.open = lambda file, mode="r", *rest, **named: plain_open(
        file, mode.replace("U", ""), *rest, **named)
    player = arguments[2] if len(arguments) > 2 else "1"
    suffixes = ["" if player == "1" else "_" + player]
    bpy.ops.import_anim.bvh(filepath=path, global_scale=float(arguments[3]), frame_start=1,
                            axis_forward="-Z", axis_up="Y", update_scene_duration=True)
else:
    suffixes = ["", "_2"]
    # Debian 12's Blender (3.4 with numpy 1.24) cannot import a mesh with the shading of the file.
    bpy.ops.import_scene.gltf(filepath=path, import_shading="SMOOTH")
scene = bpy.context.scene
fps = scene.render.fps / scene.render.fps_base

worst = 0.0
figures = sorted((o for o in bpy.data.objects if o.type == "ARMATURE"), key=lambda o: o.name)
for figure, suffix in zip(figures, suffixes):
    names = list(arrays["names" + suffix])
    expected = arrays["positions" + suffix].astype(float)
    rate, start = float(arrays["rate" + suffix]), float(arrays["start" + suffix])
    shift = None
    for frame in np.linspace(0, len(expected) - 1, 9).astype(int):
        moment = frame + 1.0 if is_bvh else (start + frame / rate) * fps
        scene.frame_set(int(np.floor(moment)), subframe=moment - np.floor(moment))
        shown = figure.evaluated_get(bpy.context.evaluated_depsgraph_get())
        for joint, name in enumerate(names):
            bone = shown.pose.bones.get(name)
            if bone is None:  # an End Site of a .bvh is the end of a bone, not a bone
                continue
            place = shown.matrix_world @ bone.head
            place = np.array([place.x, place.z, -place.y])  # Blender has z up
            if shift is None:
                shift = np.array([0, place[1] - expected[frame, joint, 1], 0]) * is_bvh
            worst = max(worst, np.linalg.norm(place - shift - expected[frame, joint]))
print(f"{len(figures)} figure(s), {1000 * worst:.4f} mm at most")
sys.exit(0 if worst < 1e-3 and figures else 1)
