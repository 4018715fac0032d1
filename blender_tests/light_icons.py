"""Renders the pictures of the lights that the panel offers: a ball under each of them.

``python -m blender_tests.light_icons`` (needs bpy with its studio lights) writes
fantasia3d_addon/ui/light_icons/. Run it when Blender's lights change.
"""

import math
import os
import sys

import bpy

from fantasia3d_addon.blender import compat
from fantasia3d_addon.scene import light
from fantasia3d_addon.ui import icons

SIZE = 96  # pixels
WHITE = 0.8  # what a white matt surface that faces the camera shows
LOOK = (0.0, -1.0, 0.35)  # towards the camera


def main() -> None:
    icons.LIGHTS.mkdir(exist_ok=True)
    for name, path in {"neutral": light.STUDIO_FILE, **light.blender_lights()}.items():
        bpy.ops.wm.read_factory_settings(use_empty=True)
        scene = bpy.context.scene
        _stage(scene)
        world = light.set_world(scene, path)
        background = next(n for n in world.node_tree.nodes if n.bl_idname == "ShaderNodeBackground")
        length = math.hypot(*LOOK)
        seen = light.irradiance(light.environment_image(world), [x / length for x in LOOK])
        background.inputs["Strength"].default_value = WHITE / max(seen, 1e-6)
        scene.render.filepath = str(icons.LIGHTS / f"{name}.png")
        bpy.ops.render.render(write_still=True)


def _stage(scene: bpy.types.Scene) -> None:
    """A satin metal ball before a transparent ground."""
    bpy.ops.mesh.primitive_uv_sphere_add(segments=96, ring_count=48)
    ball = bpy.context.object
    ball.data.shade_smooth()
    material = bpy.data.materials.new("Ball")
    if not compat.ALWAYS_HAS_NODES:
        material.use_nodes = True
    shader = material.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (0.9, 0.9, 0.9, 1)
    shader.inputs["Metallic"].default_value = 0.75
    shader.inputs["Roughness"].default_value = 0.22
    ball.data.materials.append(material)
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    camera.data.type, camera.data.ortho_scale = "ORTHO", 2.1
    camera.location = [5 * x for x in LOOK]
    camera.rotation_euler = (math.atan2(1.0, LOOK[2]), 0, 0)
    scene.collection.objects.link(camera)
    scene.camera = camera
    scene.render.engine, scene.cycles.samples = "CYCLES", 48
    scene.cycles.device, scene.cycles.use_denoising = "CPU", True
    scene.render.resolution_x = scene.render.resolution_y = SIZE
    scene.render.film_transparent = True
    scene.render.image_settings.color_mode = "RGBA"
    scene.render.image_settings.compression = 100
    scene.view_settings.view_transform = "Standard"


main()
sys.stdout.flush()
os._exit(0)  # an ordinary exit may hang with bpy 4.5
