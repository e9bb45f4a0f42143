# SPDX-License-Identifier: GPL-3.0-or-later
"""Says what Blender finds wrong with the wood of an OBJ file.

Usage: blender -b --factory-startup --python check_surface.py -- TREE.obj
Prints one line, "SURFACE " and an object of counts: vertices that select_non_manifold selects, edges that have not
two faces, edges whose faces disagree about the outside, faces with a corner twice; and the enclosed volume, m³.
"""
import json
import sys

import bmesh
import bpy

bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.wm.obj_import(filepath=sys.argv[sys.argv.index("--") + 1])
result = {"nonManifoldVertices": 0, "edgesWithoutTwoFaces": 0, "discontiguousEdges": 0, "degenerateFaces": 0, "volume": 0.0, "faces": 0}
for mesh_object in [o for o in bpy.data.objects if o.type == "MESH"]:
    bpy.context.view_layer.objects.active = mesh_object
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_mode(type="VERT")
    bpy.ops.mesh.select_all(action="DESELECT")
    bpy.ops.mesh.select_non_manifold()
    surface = bmesh.from_edit_mesh(mesh_object.data)
    result["nonManifoldVertices"] += sum(v.select for v in surface.verts)
    result["edgesWithoutTwoFaces"] += sum(len(e.link_faces) != 2 for e in surface.edges)
    result["discontiguousEdges"] += sum(len(e.link_faces) == 2 and not e.is_contiguous for e in surface.edges)
    result["degenerateFaces"] += sum(len({v.index for v in f.verts}) < 3 for f in surface.faces)
    result["volume"] += surface.calc_volume(signed=True)
    result["faces"] += len(surface.faces)
    bpy.ops.object.mode_set(mode="OBJECT")
print("SURFACE " + json.dumps(result))
