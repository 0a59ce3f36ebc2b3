"""The judge against Cycles: the same medium, sun and camera by both. Do their means agree, and who is sooner
at the same error?

    blender -b --python tests/cycles/against_cycles.py -- PILEUS FILE.vdb [WIDTH HEIGHT [SAMPLES [CYCLES]]]

PILEUS is the built program; FILE.vdb has a grid 'density' and is smoke1.vdb in docs/bench.md; SAMPLES and
CYCLES are samples a pixel of either. Nothing else of Pileus needs Blender (tried with 3.4 of Debian 12). CPU
seconds are those of all threads, without what any picture of few samples takes: files, compiling, trees.
Errors are those of single pixels, by the variance of samples here and by two seeds there.
"""

import array
import json
import math
import os
import resource
import struct
import subprocess
import sys
import tempfile
import time
import zlib

import bpy
import mathutils

EXTINCTION, ALBEDO = 0.5, 0.99
EYE, TARGET, FOV = (10.0, 42.0, 46.0), (-6.0, 38.0, 0.0), 40.0
AZIMUTH, ELEVATION, IRRADIANCE = 30.0, 40.0, 10.0


def sun_direction():
    a, e = math.radians(AZIMUTH), math.radians(ELEVATION)
    return math.cos(e) * math.sin(a), math.sin(e), math.cos(e) * math.cos(a)


# --- EXR: scan lines of float or half, uncompressed or by zlib ---


def read_exr(path):
    """{channel: array of floats, row by row from the top}."""
    data = open(path, "rb").read()
    at, channels, compression, window = 8, [], 0, None
    while data[at] != 0:
        name, kind = [], []
        for out in (name, kind):
            end = data.index(b"\0", at)
            out.append(data[at:end].decode())
            at = end + 1
        size = struct.unpack_from("<i", data, at)[0]
        value = data[at + 4 : at + 4 + size]
        at += 4 + size
        if name[0] == "channels":
            place = 0
            while value[place] != 0:
                end = value.index(b"\0", place)
                channels.append((value[place:end].decode(), struct.unpack_from("<i", value, end + 1)[0]))
                place = end + 17
        elif name[0] == "compression":
            compression = value[0]
        elif name[0] == "dataWindow":
            window = struct.unpack("<4i", value)
    at += 1
    assert compression in (0, 2, 3), "read_exr: no such compression"
    width, height = window[2] - window[0] + 1, window[3] - window[1] + 1
    rows = {0: 1, 2: 1, 3: 16}[compression]
    out = {name: array.array("f") for name, _ in channels}
    offsets = struct.unpack_from("<%dQ" % -(-height // rows), data, at)
    for offset in offsets:
        y, size = struct.unpack_from("<2i", data, offset)
        block = data[offset + 8 : offset + 8 + size]
        lines = min(rows, height - (y - window[1]))
        whole = sum(2 if kind == 1 else 4 for _, kind in channels) * width * lines
        if compression and size < whole:
            packed = bytearray(zlib.decompress(block))
            for i in range(1, len(packed)):
                packed[i] = (packed[i - 1] + packed[i] - 128) & 255
            half = (len(packed) + 1) // 2
            block = bytearray(len(packed))
            block[0::2], block[1::2] = packed[:half], packed[half:]
        place = 0
        for _ in range(lines):
            for name, kind in channels:
                code, bytes_ = ("e", 2) if kind == 1 else ("f", 4)
                out[name].extend(struct.unpack_from("<%d%s" % (width, code), block, place))
                place += bytes_ * width
    return out


def mean(values):
    return sum(values) / max(len(values), 1)


# --- here ---


def graph(vdb, size, g, bounces, samples):
    nodes = {
        "File": {"type": "volume.vdb_file", "params": {"file": vdb, "grid": "density"}},
        "Medium": {
            "type": "volume.medium",
            "params": {"extinction": EXTINCTION, "albedo": [ALBEDO] * 3, "anisotropy": g},
        },
        "Sun": {
            "type": "light.sun",
            "params": {"azimuth": AZIMUTH, "elevation": ELEVATION, "irradiance": IRRADIANCE},
        },
        "Metric": {"type": "shadow.pseudometric", "params": {}},
        "Map": {"type": "shadow.extinction", "params": {}},
        "Camera": {
            "type": "camera.perspective",
            "params": {"eye": list(EYE), "target": list(TARGET), "fov": FOV},
        },
        "Render": {"type": "render.path_trace", "params": {"samples": samples, "bounces": bounces}},
        "EXR": {"type": "output.exr", "params": {"type": "float"}},
    }
    links = [
        "File.volume -> Medium.volume",
        "Medium.volume -> Metric.volumes",
        "Sun.light -> Metric.light",
        "Metric.metric -> Map.metric",
        "Medium.volume -> Render.volumes",
        "Map.light -> Render.lights",
        "Camera.camera -> Render.camera",
        "Render.image -> EXR.image",
    ]
    return {"pileus": 2, "settings": {"size": list(size)}, "nodes": nodes, "links": links}


def children_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def traced(pileus, folder, vdb, size, g, bounces, samples):
    """Channels of the picture, and CPU seconds."""
    file, out = os.path.join(folder, "scene.json"), os.path.join(folder, "ours.exr")
    with open(file, "w") as f:
        json.dump(graph(vdb, size, g, bounces, samples), f)
    before = children_seconds()
    subprocess.run([pileus, "render", file, "-o", out, "--overwrite"], check=True, stdout=subprocess.DEVNULL)
    return read_exr(out), children_seconds() - before


def measured_here(pileus, folder, vdb, size, g, bounces, samples):
    _, start = traced(pileus, folder, vdb, size, g, bounces, 2)
    picture, seconds = traced(pileus, folder, vdb, size, g, bounces, samples)
    seen = [i for i, a in enumerate(picture["A"]) if a > 0.01]
    return {
        "mean": mean([picture["G"][i] for i in seen]),
        "variance": mean([picture["variance.G"][i] for i in seen]),
        "seconds": (seconds - start) * samples / (samples - 2),
        "seen": seen,
        "pixels": picture["G"],
    }


# --- there ---


def cycles_scene(vdb, size):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.resolution_x, scene.render.resolution_y = size
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.image_settings.exr_codec = "ZIP"
    scene.render.film_transparent = True
    world = bpy.data.worlds.new("black")
    world.use_nodes = True
    world.node_tree.nodes["Background"].inputs["Color"].default_value = (0, 0, 0, 1)
    scene.world = world

    c = scene.cycles
    c.device, c.feature_set = "CPU", "SUPPORTED"
    c.use_adaptive_sampling = c.use_denoising = False
    c.pixel_filter_type = "BOX"
    c.sample_clamp_direct = c.sample_clamp_indirect = 0
    c.light_sampling_threshold = 0
    c.volume_step_rate = 0.25
    c.volume_max_steps = 65536
    c.max_bounces = c.volume_bounces = 1024

    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit, camera.angle_y = "VERTICAL", math.radians(FOV)
    camera.sensor_fit, camera.clip_end = "VERTICAL", 1e5
    view = bpy.data.objects.new("camera", camera)
    eye, target = mathutils.Vector(EYE), mathutils.Vector(TARGET)
    back = (eye - target).normalized()
    right = mathutils.Vector((0, 1, 0)).cross(back).normalized()
    up = back.cross(right)
    matrix = mathutils.Matrix.Identity(4)
    for column, axis in enumerate((right, up, back, eye)):
        for row in range(3):
            matrix[row][column] = axis[row]
    view.matrix_world = matrix
    scene.collection.objects.link(view)
    scene.camera = view

    light = bpy.data.lights.new("sun", "SUN")
    light.energy, light.angle = IRRADIANCE, 0
    sun = bpy.data.objects.new("sun", light)
    sun.rotation_mode = "QUATERNION"
    sun.rotation_quaternion = mathutils.Vector(sun_direction()).to_track_quat("Z", "Y")
    scene.collection.objects.link(sun)

    volume = bpy.data.volumes.new("volume")
    volume.filepath = vdb
    volume.render.clipping = 0
    volume.render.precision = "FULL"
    placed = bpy.data.objects.new("volume", volume)
    # To Cycles the voxel of index i is the cell from i to i + 1; to OpenVDB, and here, its value is that at i.
    volume.grids.load()
    grid = next(x for x in volume.grids if x.name == "density")
    placed.location = grid.matrix_object.to_3x3() @ mathutils.Vector((-0.5, -0.5, -0.5))
    scene.collection.objects.link(placed)
    material = bpy.data.materials.new("medium")
    material.use_nodes = True
    material.cycles.volume_sampling = "MULTIPLE_IMPORTANCE"
    material.cycles.volume_interpolation = "LINEAR"
    tree = material.node_tree
    tree.nodes.clear()
    density = tree.nodes.new("ShaderNodeAttribute")
    density.attribute_name = "density"
    both = tree.nodes.new("ShaderNodeAddShader")
    for i, (kind, color, share) in enumerate(
        (("ShaderNodeVolumeScatter", 1, ALBEDO), ("ShaderNodeVolumeAbsorption", 0, 1 - ALBEDO))
    ):
        shader, times = tree.nodes.new(kind), tree.nodes.new("ShaderNodeMath")
        shader.name = kind
        shader.inputs["Color"].default_value = (color, color, color, 1)
        times.operation = "MULTIPLY"
        times.inputs[1].default_value = EXTINCTION * share
        tree.links.new(density.outputs["Fac"], times.inputs[0])
        tree.links.new(times.outputs[0], shader.inputs["Density"])
        tree.links.new(shader.outputs[0], both.inputs[i])
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(both.outputs[0], output.inputs["Volume"])
    volume.materials.append(material)
    return scene, tree.nodes["ShaderNodeVolumeScatter"]


def by_cycles(scene, folder, samples, seed):
    out = os.path.join(folder, "cycles.exr")
    scene.cycles.samples, scene.cycles.seed = samples, seed
    scene.render.filepath = out
    before = time.process_time()
    bpy.ops.render.render(write_still=True)
    return read_exr(out), time.process_time() - before


def measured_there(scene, folder, samples, seen):
    _, start = by_cycles(scene, folder, 2, 1)
    a, seconds = by_cycles(scene, folder, samples, 2)
    b, _ = by_cycles(scene, folder, samples, 3)
    a, b = a["G"], b["G"]
    return {
        "mean": mean([(a[i] + b[i]) / 2 for i in seen]),
        "variance": mean([(a[i] - b[i]) ** 2 / 2 for i in seen]),
        "seconds": (seconds - start) * samples / (samples - 2),
        "pixels": [(x + y) / 2 for x, y in zip(a, b)],
    }


def blocks(pixels, size, edge):
    wide, high = size[0] // edge, size[1] // edge
    return [
        mean([pixels[(y * edge + j) * size[0] + x * edge + i] for j in range(edge) for i in range(edge)])
        for y in range(high)
        for x in range(wide)
    ]


def main():
    given = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else []
    if len(given) < 2:
        sys.exit(__doc__)
    pileus, vdb = os.path.abspath(given[0]), os.path.abspath(given[1])
    size = (int(given[2]), int(given[3])) if len(given) > 3 else (320, 180)
    samples = int(given[4]) if len(given) > 4 else 64
    cycles = int(given[5]) if len(given) > 5 else samples
    lines = [
        "| scattering | g | mean here | Cycles | ratio | blocks of 8 x 8, mean difference | noise of that"
        " | CPU s here, error | Cycles | time at equal error, Cycles / here |",
        "|---|---|---|---|---|---|---|---|---|---|",
    ]
    with tempfile.TemporaryDirectory() as folder:
        for g in (0.0, 0.6):
            for bounces in (0, -1):
                ours = measured_here(pileus, folder, vdb, size, g, bounces, samples)
                scene, scatter = cycles_scene(vdb, size)
                scatter.inputs["Anisotropy"].default_value = g
                if bounces == 0:
                    scene.cycles.max_bounces = scene.cycles.volume_bounces = 0
                theirs = measured_there(scene, folder, cycles, ours["seen"])
                n = len(ours["seen"])
                noise = math.sqrt(ours["variance"] / n + theirs["variance"] / (2 * n))
                p, q = (blocks(x["pixels"], size, 8) for x in (ours, theirs))
                apart = mean([abs(a - b) for a, b in zip(p, q)]) / mean(q)
                expected = math.sqrt(2 / math.pi * (ours["variance"] + theirs["variance"] / 2)) / 8 / mean(q)
                cost = [x["variance"] * x["seconds"] for x in (ours, theirs)]
                relative = [100 * math.sqrt(x["variance"]) / x["mean"] for x in (ours, theirs)]
                lines.append(
                    "| %s | %.1f | %.5f | %.5f | %.4f +- %.4f | %.2f %% | %.2f %% | %.1f, %.1f %% | %.1f, %.1f %%"
                    " | %.2f |"
                    % (
                        "single" if bounces == 0 else "all",
                        g,
                        ours["mean"],
                        theirs["mean"],
                        ours["mean"] / theirs["mean"],
                        noise / theirs["mean"],
                        100 * apart,
                        100 * expected,
                        ours["seconds"],
                        relative[0],
                        theirs["seconds"],
                        relative[1],
                        cost[1] / cost[0],
                    )
                )
                print(lines[-1], flush=True)
    print("\n%d x %d, %d samples here, %d by Cycles of Blender %s\n" % (*size, samples, cycles, bpy.app.version_string))
    print("\n".join(lines))


main()
