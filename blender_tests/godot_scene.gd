extends SceneTree
# Runs inside Godot 3: what its importer made of a GLB, as a line of JSON.
# godot3-server --path PROJECT --script THIS; the project holds asset.glb, imported before.


func describe(node: Node, place: Transform, rows: Array) -> void:
    var here := place
    if node is Spatial:
        here = place * node.transform
    var row := {"name": node.name, "kind": node.get_class()}
    if node is MeshInstance:
        var box: AABB = here.xform(node.mesh.get_aabb())
        var material: SpatialMaterial = node.mesh.surface_get_material(0)
        row["low"] = numbers(box.position)
        row["high"] = numbers(box.end)
        row["textures"] = [
            material.albedo_texture != null,
            material.roughness_texture != null and material.metallic_texture != null,
            material.normal_enabled and material.normal_texture != null,
        ]
        row["channels"] = [
            material.roughness_texture_channel, material.metallic_texture_channel
        ]
    if node is CollisionShape:
        row["shape"] = node.shape.get_class()
        row["points"] = []
        for point in node.shape.points:
            row["points"].append(numbers(here.xform(point)))
    rows.append(row)
    for child in node.get_children():
        describe(child, here, rows)


func numbers(v: Vector3) -> Array:
    return [v.x, v.y, v.z]


func _init() -> void:
    var rows := []
    describe(load("res://asset.glb").instance(), Transform(), rows)
    print("SCENE " + JSON.print(rows))
    quit()
