# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads one tree back from OBJ, FBX and GLB in Blender, compares it with what it should be, and renders it.

Usage: blender -b --factory-startup --python check_exports.py -- FOLDER
FOLDER has expected.json, and tree.obj, tree.fbx, tree.glb or some of them:
    name     the tree's, which meshes and materials are called after
    suffixes which of the three there are
    meshes   by name: vertices, triangles, lower and upper corner in metres, y up
    camera   position, right and up, y up; full vertical fieldOfView in rad; size in pixels
Pictures of the FBX and the GLB, on nothing, become fbx.png and glb.png there. Prints "EXPORTS ARE GOOD" if all is well; Blender's exit code says nothing after an error in Python.
"""
import json
import math
import os
import sys

import numpy

numpy.bool = bool  # Blender's glTF importer still says np.bool, which NumPy has dropped
import bmesh
import bpy
from mathutils import Matrix, Vector

folder = sys.argv[sys.argv.index("--") + 1]
with open(os.path.join(folder, "expected.json"), encoding="utf-8") as file:
    expected = json.load(file)
faults = []
# By mesh: the roughness and the specular that each format leads to.
glosses = {}


def check(good, what):
    if not good:
        faults.append(what)
        print("FAULT:", what)


def load(suffix):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    path = os.path.join(folder, "tree." + suffix)
    if suffix == "obj":
        bpy.ops.wm.obj_import(filepath=path)
    elif suffix == "fbx":
        bpy.ops.import_scene.fbx(filepath=path)
    else:
        bpy.ops.import_scene.gltf(filepath=path)
    return {o.name: o for o in bpy.data.objects if o.type == "MESH"}


def to_z_up(corner):
    x, y, z = corner
    return (x, -z, y)


def check_bounds(where, mesh_object, wanted):
    points = [mesh_object.matrix_world @ v.co for v in mesh_object.data.vertices]
    lower = [min(p[i] for p in points) for i in range(3)]
    upper = [max(p[i] for p in points) for i in range(3)]
    a, b = to_z_up(wanted["lower"]), to_z_up(wanted["upper"])
    wanted_lower = [min(a[i], b[i]) for i in range(3)]
    wanted_upper = [max(a[i], b[i]) for i in range(3)]
    size = max(wanted_upper[i] - wanted_lower[i] for i in range(3))
    off = max(max(abs(lower[i] - wanted_lower[i]), abs(upper[i] - wanted_upper[i])) for i in range(3))
    check(off <= 0.001 * size, f"{where}: bounds {lower} {upper} instead of {wanted_lower} {wanted_upper}")


def check_closed(where, mesh_object):
    surface = bmesh.new()
    surface.from_mesh(mesh_object.data)
    # With a smaller distance Blender does not even find vertices at the same place.
    bmesh.ops.remove_doubles(surface, verts=surface.verts, dist=1e-6)
    wrong = sum(1 for edge in surface.edges if len(edge.link_faces) != 2)
    inward = 0.0
    for face in surface.faces:
        inward += face.calc_center_median().dot(face.normal) * face.calc_area()
    surface.free()
    check(wrong == 0, f"{where}: {wrong} edges without two faces")
    check(inward > 0.0, f"{where}: the surface is inside out")


def check_normals(where, mesh_object):
    """Corner normals point the way that the faces do."""
    mesh = mesh_object.data
    mesh.calc_normals_split()
    against = sum(1 for p in mesh.polygons for i in p.loop_indices if mesh.loops[i].normal.dot(p.normal) < -0.5)
    check(against < 0.01 * len(mesh.loops), f"{where}: {against} of {len(mesh.loops)} normals point inward")


def image_behind(socket, depth=0):
    """The image that a shader's socket takes its value from."""
    if not socket.is_linked or depth > 5:
        return None
    node = socket.links[0].from_node
    if node.type == "TEX_IMAGE":
        return node.image
    for name in ("Color", "Color1", "A", "Image", "Normal", "Value"):
        if name in node.inputs:
            found = image_behind(node.inputs[name], depth + 1)
            if found:
                return found
    return None


def check_image(where, image):
    check(image is not None, f"{where} has no texture")
    if image is None:
        return
    if not image.packed_file:
        check(os.path.exists(bpy.path.abspath(image.filepath)), f"{where}: {image.filepath} does not exist")
    check(image.size[0] > 0, f"{where}: {image.name} cannot be read")


def channel_means(image):
    pixels = numpy.empty(len(image.pixels), dtype=numpy.float32)
    image.pixels.foreach_get(pixels)
    return pixels.reshape(-1, 4).mean(axis=0)


def check_roughness(where, socket, suffix):
    image = image_behind(socket)
    check_image(f"{where}: roughness", image)
    if image is None:
        return
    mean = channel_means(image)[1]
    check(0.3 < mean < 1.0, f"{where}: a mean roughness of {mean}")
    check(image.colorspace_settings.name == "Non-Color", f"{where}: the roughness is read as {image.colorspace_settings.name}")
    if suffix == "glb":
        source = socket.links[0].from_socket.name
        check(source == "Green", f"{where}: the roughness comes from {source}")


def value_of(socket, channel):
    """The value of a shader's socket: its number, or the mean of its texture."""
    image = image_behind(socket)
    return socket.default_value if image is None else float(channel_means(image)[channel])


def check_same_gloss():
    """All formats show a surface equally rough and equally specular."""
    for name, by_format in glosses.items():
        for what in ("roughness", "specular"):
            values = {suffix: gloss[what] for suffix, gloss in by_format.items()}
            print(f"{name}: {what} {values}")
            check(max(values.values()) - min(values.values()) < 0.01, f"{name}: {what} differs: {values}")


def check_metal(where, socket):
    if not socket.is_linked:
        check(socket.default_value == 0.0, f"{where}: it is of metal")
        return
    image = image_behind(socket)
    check(image is not None and channel_means(image)[2] == 0.0, f"{where}: it is of metal in places")


def check_material(where, mesh_object, suffix):
    kind = "Leaves" if mesh_object.name.endswith("_Leaves_LOD0") else "Bark"
    materials = [s.material for s in mesh_object.material_slots]
    check(len(materials) == 1, f"{where}: {len(materials)} materials")
    if not materials:
        return
    material = materials[0]
    wanted = f"{expected['name']}_{kind}"
    check(material.name == wanted, f"{where}: the material is {material.name}, not {wanted}")
    shader = next(n for n in material.node_tree.nodes if n.type == "BSDF_PRINCIPLED")
    check_image(f"{where}: base colour", image_behind(shader.inputs["Base Color"]))
    check_image(f"{where}: normal", image_behind(shader.inputs["Normal"]))
    check_metal(where, shader.inputs["Metallic"])
    glosses.setdefault(mesh_object.name, {})[suffix] = {
        "roughness": value_of(shader.inputs["Roughness"], 1),
        "specular": value_of(shader.inputs["Specular"], 1),
    }
    # Of an OBJ's roughness, Blender 3.4 reads the number and not the texture.
    if suffix != "obj":
        check_roughness(where, shader.inputs["Roughness"], suffix)
    alpha = shader.inputs["Alpha"]
    if kind == "Leaves":
        check_image(f"{where}: alpha", image_behind(alpha))
        check(alpha.is_linked and alpha.links[0].from_socket.name in ("Alpha", "Value", "Result"),
              f"{where}: alpha comes from {alpha.links[0].from_socket.name if alpha.is_linked else 'nowhere'}")
        mask = image_behind(alpha)
        # In an FBX, Blender uses the alpha of the colour image if it has one, and ignores TransparentColor.
        if suffix == "obj" and mask is not None:
            pixels = numpy.empty(len(mask.pixels), dtype=numpy.float32)
            mask.pixels.foreach_get(pixels)
            pixels = pixels.reshape(-1, 4)
            check(mask.name.startswith("tree") and "_mask" in mask.name, f"{where}: alpha comes from {mask.name}")
            check(abs(pixels - pixels[:, 3:]).max() < 0.01, f"{where}: the channels of {mask.name} differ")
        if suffix == "glb":
            check(material.blend_method == "CLIP" and abs(material.alpha_threshold - 0.5) < 0.01,
                  f"{where}: {material.blend_method} at {material.alpha_threshold} is no mask at 0.5")
            check(not material.use_backface_culling, f"{where}: leaves are seen from one side alone")
    else:
        check(not alpha.is_linked and alpha.default_value == 1.0, f"{where}: the bark is transparent")


def render(suffix):
    """The view of the camera, in Cycles, because the other renderers need a graphics card."""
    wanted = expected["camera"]
    position, right, up = (Vector(to_z_up(wanted[name])) for name in ("position", "right", "up"))
    scene = bpy.context.scene
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    scene.collection.objects.link(camera)
    camera.matrix_world = Matrix.Translation(position) @ Matrix((right, up, right.cross(up))).transposed().to_4x4()
    camera.data.sensor_fit = "VERTICAL"
    camera.data.angle_y = wanted["fieldOfView"]
    scene.camera = camera
    sun = bpy.data.objects.new("Sun", bpy.data.lights.new("Sun", "SUN"))
    sun.data.energy = 4.5
    sun.matrix_world = camera.matrix_world @ Matrix.Rotation(math.radians(40), 4, "Y") @ Matrix.Rotation(math.radians(-40), 4, "X")
    scene.collection.objects.link(sun)
    scene.world = bpy.data.worlds.new("World")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (1.0, 1.0, 1.0, 1.0)
    scene.world.node_tree.nodes["Background"].inputs["Strength"].default_value = 0.4
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = 12
    scene.cycles.use_denoising = False
    scene.cycles.pixel_filter_type = "BOX"
    scene.cycles.max_bounces = 1
    scene.cycles.transparent_max_bounces = 32
    scene.view_settings.view_transform = "Standard"
    scene.render.film_transparent = True
    scene.render.resolution_x, scene.render.resolution_y = wanted["size"]
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "PNG"
    scene.render.image_settings.color_mode = "RGBA"
    scene.render.filepath = os.path.join(folder, suffix + ".png")
    bpy.ops.render.render(write_still=True)


for suffix in expected["suffixes"]:
    objects = load(suffix)
    check(sorted(objects) == sorted(expected["meshes"]), f"{suffix}: meshes {sorted(objects)}")
    for name, wanted in expected["meshes"].items():
        if name not in objects:
            continue
        where = f"{suffix}: {name}"
        mesh_object = objects[name]
        check(len(mesh_object.data.polygons) == wanted["triangles"],
              f"{where}: {len(mesh_object.data.polygons)} triangles instead of {wanted['triangles']}")
        vertices = wanted["places" if suffix == "obj" else "vertices"]
        check(len(mesh_object.data.vertices) == vertices,
              f"{where}: {len(mesh_object.data.vertices)} vertices instead of {vertices}")
        check((mesh_object.matrix_world.translation - Vector((0, 0, 0))).length < 1e-6, f"{where}: pivot is not at the origin")
        check(len(mesh_object.data.uv_layers) >= 1, f"{where}: no texture coordinates")
        check_bounds(where, mesh_object, wanted)
        check_normals(where, mesh_object)
        check_material(where, mesh_object, suffix)
        if name.endswith("_Bark_LOD0"):
            check_closed(where, mesh_object)
    if suffix != "obj":
        render(suffix)

check_same_gloss()
if not faults:
    print("EXPORTS ARE GOOD")
