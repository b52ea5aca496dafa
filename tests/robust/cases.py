# SPDX-License-Identifier: Apache-2.0
"""The robustness cases as one table: a name, what is changed of a good scene, what the error must say."""
import dataclasses
import gzip

import inputs

GOOD_SCENE = b"""
[camera]
position = [0.5, 1.0, 6.0]
[image]
width = 8
height = 8
[shadows]
map_size = 16
[[light]]
name = "key"
position = [4.0, 4.0, 4.0]
[[material]]
name = "glass"
opacity = 0.3
[[mesh]]
name = "cup"
file = "closed.obj"
material = "glass"
[[volume]]
name = "smoke"
file = "grid.nrrd"
opacity = [[0.0, 0.0], [63.0, 0.5]]
color = [[0.0, 1.0, 1.0, 1.0]]
"""

GOOD_FILES = {
    "scene.toml": GOOD_SCENE,
    "closed.obj": inputs.CLOSED_OBJ,
    "open.obj": inputs.OPEN_OBJ,
    "grid.nrrd": inputs.GRID_NRRD,
    "points.csv": inputs.POINTS_CSV,
}

OUTPUTS = ["out.png", "out.csv", "out.exr", "stats.json", "trace.json"]
NAMELESS = ["render", "scene.toml", "--quiet"]
RENDER = ["render", "scene.toml", "-o", "out.png", "--stats", "stats.json", "--quiet"]
QUERY = ["transmittance", "scene.toml", "--light", "key", "--points", "points.csv", "-o", "out.csv", "--quiet"]
EXPORT = ["export-map", "scene.toml", "--light", "key", "-o", "out.exr", "--quiet"]


@dataclasses.dataclass
class Case:
    """`files` are written over the good ones (None: left out); `status` 0 is a run that must work."""

    name: str
    text: str
    arguments: list
    files: dict = dataclasses.field(default_factory=dict)
    status: int = 1
    outputs: tuple = ()

    def prepare(self, folder):
        for name, content in {**GOOD_FILES, **self.files}.items():
            if content is not None:
                (folder / name).parent.mkdir(parents=True, exist_ok=True)
                (folder / name).write_bytes(content)


def scene(name, text, old, new):
    """A scene with one of its lines changed."""
    assert old in GOOD_SCENE, old
    return Case(name, text, RENDER, {"scene.toml": GOOD_SCENE.replace(old, new)})


def directional(direction):
    """The good scene with parallel light."""
    return GOOD_SCENE.replace(b"position = [4.0, 4.0, 4.0]", b"type = 'directional'\ndirection = " + direction)


def volume(name, content, text="", file="grid.nrrd"):
    """A volume file that cannot be right."""
    files = {"scene.toml": GOOD_SCENE.replace(b"grid.nrrd", file.encode()), file: content}
    return Case(name, text or file, RENDER, files)


def mesh(name, content, file="closed.obj", text=""):
    """A mesh file that cannot be right."""
    files = {"scene.toml": GOOD_SCENE.replace(b"closed.obj", file.encode()), file: content}
    return Case(name, text or file, RENDER, files)


def points(name, content, text):
    return Case(name, text, QUERY, {"points.csv": content})


def settings(name, text, *values):
    """A scene changed on the command line."""
    return Case(name, text, RENDER + [word for value in values for word in ("--set", value)])


def animated(key, frames, times=1):
    """The good scene with an [[animate]] table."""
    return GOOD_SCENE + times * (b"[[animate]]\nkey = " + key + b"\nframes = " + frames + b"\n")


def animation(name, text, key, frames, arguments=(), status=1, outputs=(), base=RENDER):
    """The good scene with an [[animate]] table, rendered with more arguments."""
    return Case(name, text, base + list(arguments), {"scene.toml": animated(key, frames)}, status, outputs)


def replaced(arguments, old, new):
    return [new if word == old else word for word in arguments]


def usage(name, text, arguments):
    return Case(name, text, arguments, status=2)


def works(name, arguments, outputs):
    return Case(name, "", arguments, status=0, outputs=outputs)


GOOD_RUNS = [
    works("a good scene renders", RENDER, ("out.png", "stats.json")),
    works("a good query is answered", QUERY, ("out.csv",)),
    works("good maps are exported", EXPORT + ["--stats", "stats.json"], ("out.exr", "stats.json")),
    works("a good run is traced", RENDER + ["--trace", "trace.json"], ("out.png", "stats.json", "trace.json")),
    works("a good query is traced", QUERY + ["--trace", "trace.json"], ("out.csv", "trace.json")),
    works("a good export is traced", EXPORT + ["--trace", "trace.json"], ("out.exr", "trace.json")),
    works("good maps are exported in tiles", EXPORT + ["--tiled", "--set", "shadows.memory=atlas"], ("out.exr",)),
    works("a light inside a volume", RENDER + ["--set", "light.key.position=[1.5, 1.5, 1.5]"], ("out.png",)),
    works("a closed mesh as boundary", RENDER + ["--set", "volume.smoke.boundary=cup"], ("out.png",)),
    works("an omni light inside a volume", RENDER + ["--set", "light.key.type=omni"]
          + ["--set", "light.key.position=[1.5, 1.5, 1.5]"], ("out.png",)),
    Case("a directional light", "", RENDER, {"scene.toml": directional(b"[0, -1, 0]")}, 0, ("out.png",)),
    works("objects that cast and receive nothing", RENDER + ["--set", "mesh.cup.casts_shadow=false"]
          + ["--set", "volume.smoke.receives_shadow=false", "--set", "mesh.cup.cluster_weight=1000"], ("out.png",)),
    works("two nodes per texel", RENDER + ["--set", "shadows.memory=fixed", "--set", "shadows.max_nodes=2"],
          ("out.png", "stats.json")),
    works("small nodes", RENDER + ["--set", "shadows.node_format=unorm16"], ("out.png", "stats.json")),
    works("a light inside a volume and a wide filter", RENDER + ["--set", "light.key.position=[1.5, 1.5, 1.5]"]
          + ["--set", "shadows.technique=shadow-map", "--set", "shadows.pcf=16"], ("out.png",)),
    works("stochastic shadows", RENDER + ["--set", "shadows.technique=stochastic", "--set", "shadows.stratified=true"]
          + ["--set", "shadows.samples=21", "--set", "volume.smoke.shadow_opacity=[[0, 0.9]]"], ("out.png",)),
    works("a query by chance", QUERY + ["--set", "shadows.technique=stochastic", "--set", "shadows.seed=0"],
          ("out.csv",)),
    works("a query by opaque rays", QUERY + ["--set", "shadows.technique=shadow-rays", "--set", "shadows.rays=opaque"]
          + ["--set", "shadows.threshold=0"], ("out.csv",)),
    works("a camera inside a volume", RENDER + ["--set", "camera.position=[1.5, 1.5, 1.5]"], ("out.png",)),
]

SCENES = [
    Case("missing scene", "none.toml: ", ["render", "none.toml", "-o", "out.png"]),
    Case("a folder as scene", "", ["render", ".", "-o", "out.png"]),
    Case("empty scene", "scene.toml: ", RENDER, {"scene.toml": b""}),
    Case("binary scene", "scene.toml:1:", RENDER, {"scene.toml": bytes(range(256))}),
    scene("deeply nested TOML", "scene.toml:5:", b"width = 8", b"width = " + b"[" * 100000),
    scene("broken TOML", "scene.toml:4:", b"[image]", b"[image"),
    scene("key given twice", "scene.toml:6:", b"height = 8", b"width = 9"),
    scene("unknown key", "scene.toml:6:1: unknown key 'depth' in [image]", b"height = 8", b"depth = 8"),
    scene("misspelt key", "unknown key 'heigth' in [image], did you mean 'height'?", b"height = 8", b"heigth = 8"),
    scene("wrong type", "scene.toml:5:9: width is a string", b"width = 8", b"width = '8'"),
    scene("wrong length", "scene.toml:3:12: position is an array of 2", b"[0.5, 1.0, 6.0]", b"[0.5, 1.0]"),
    scene("NaN", "scene.toml:3:13: position is nan", b"[0.5,", b"[nan,"),
    scene("infinity", "scene.toml:3:13: position is -inf", b"[0.5,", b"[-inf,"),
    scene("number out of range", "scene.toml:5:9: width is 0, must be in [1, 16384]", b"width = 8", b"width = 0"),
    scene(
        "image far too large",
        "scene.toml:5:9: width is 9.223372e+18", b"width = 8", b"width = 9223372036854775807",
    ),
    scene("map far too large", "must be in [8, 16384]", b"map_size = 16", b"map_size = 1000000"),
    scene("degenerate camera", "scene.toml:2:1: camera: position and target", b"[0.5, 1.0, 6.0]", b"[0, 0, 0]"),
    scene("camera up along the view", "camera up is parallel", b"[0.5, 1.0, 6.0]", b"[0, 9, 0]"),
    scene("degenerate light", "light 'key': position and target", b"[4.0, 4.0, 4.0]", b"[0, 0, 0]"),
    scene("unknown type of light", "unknown type 'area'", b'name = "key"', b'name = "key"\ntype = "area"'),
    scene("direction of a spot", "'direction' is of lights of type directional", b'name = "key"',
          b'name = "key"\ndirection = [0, -1, 0]'),
    settings("cutoff of an omni light", "'cutoff' is of lights of type spot, must be left out of type omni",
             "light.key.type=omni", "light.key.cutoff=20"),
    settings("position of a directional light", "scene.toml:11:12: 'position' is of lights of type spot, omni",
             "light.key.type=directional"),
    Case("direction without a length", "light 'key': direction has no length", RENDER,
         {"scene.toml": directional(b"[0, 0, 0]")}),
    Case("direction with a NaN", "direction is nan", RENDER, {"scene.toml": directional(b"[0, nan, 0]")}),
    scene("light without a name", "[[light]] has no 'name'", b'name = "key"', b""),
    scene("line break in a name", "unknown key", b'name = "key"', b'name = "k\\ney"\n"col\\nour" = 1'),
    scene("name used twice", "material 'glass' is already", b"[[mesh]]", b"[[material]]\nname = 'glass'\n[[mesh]]"),
    scene(
        "unknown material",
        "unknown material 'glas', did you mean 'glass'?", b'material = "glass"', b'material = "glas"',
    ),
    scene("unsorted transfer function", "must be ascending", b"[[0.0, 0.0], [63.0, 0.5]]", b"[[1, 0], [0, 0.5]]"),
    scene("empty transfer function", "at least one point", b"[[0.0, 0.0], [63.0, 0.5]]", b"[]"),
    scene(
        "open mesh with an interior",
        "mesh 'cup' has 3 open edges", b"closed.obj\"", b"open.obj\"\ninterior_extinction = 1",
    ),
    scene("transform without inverse", "cannot be inverted", b"closed.obj\"", b"closed.obj\"\nscale = 1e-30"),
    settings("unknown memory strategy", "unknown memory 'exakt', did you mean 'exact'?", "shadows.memory=exakt"),
    settings("too few nodes", "max_nodes is 1, must be in [2, 256] nodes", "shadows.max_nodes=1"),
    settings("too many nodes", "max_nodes is 257, must be in [2, 256] nodes", "shadows.max_nodes=257"),
    settings("part of a node", "max_nodes is", "shadows.max_nodes=2.5"),
    settings("nodes as a word", "max_nodes is a string", "shadows.max_nodes=many"),
    settings("unknown format of nodes", "unknown node_format 'unorm8', did you mean 'unorm16'?",
             "shadows.node_format=unorm8"),
    settings("format of nodes as a number", "node_format is an integer", "shadows.node_format=16"),
    settings("tolerance finer than 16 bits", "tolerance with node_format unorm16 is 1e-05, must be in [2e-05, 1)",
             "shadows.tolerance=1e-5", "shadows.node_format=unorm16"),
    settings("no tolerance with 16 bits", "node_format unorm16 is 0, must be in [2e-05, 1)", "shadows.tolerance=0",
             "shadows.node_format=unorm16"),
    settings("too many clusters", "clusters is 65, must be in [1, 64]", "shadows.clusters=65"),
    settings("cluster distance of 0", "cluster_distance is 0, must be in (0, 2.83]", "shadows.cluster_distance=0"),
    settings("cluster distance with a NaN", "cluster_distance is nan", "shadows.cluster_distance=nan"),
    settings("unknown tolerance mode", "unknown tolerance_mode 'all', must be one of: samples, everywhere",
             "shadows.tolerance_mode=all"),
    settings("tolerance mode as a number", "tolerance_mode is an integer", "shadows.tolerance_mode=1"),
    settings("tolerance finer than single precision", "tolerance_mode everywhere is 0, must be in [0.001, 1)",
             "shadows.tolerance=0", "shadows.tolerance_mode=everywhere"),
    settings("negative memory limit", "memory_limit_mb is -1, must be at least 0", "shadows.memory_limit_mb=-1"),
    settings("memory limit with a NaN", "memory_limit_mb is nan", "shadows.memory_limit_mb=nan"),
    settings("memory limit beyond all bounds", "memory_limit_mb is inf", "shadows.memory_limit_mb=inf"),
    settings("memory limit as a text", "memory_limit_mb is a string", "shadows.memory_limit_mb=64MB"),
    settings("unknown answer to overflow", "unknown on_overflow 'coarse', did you mean 'coarsen'?",
             "shadows.on_overflow=coarse"),
    settings("maps beyond the memory limit", "more than shadows.memory_limit_mb = 0.001; take smaller maps",
             "shadows.memory_limit_mb=0.001"),
    settings("maps beyond the memory limit however coarse", "even at the largest tolerance",
             "shadows.memory_limit_mb=0.001", "shadows.on_overflow=coarsen"),
    settings("texels beyond the memory limit", "the maps need at least 32.0 MiB",
             "shadows.memory_limit_mb=0.5", "shadows.map_size=16384"),
    settings("rays of another kind", "unknown rays 'fuzzy', must be one of: exact, opaque", "shadows.rays=fuzzy"),
    settings("threshold of 1", "threshold is 1, must be in [0, 1)", "shadows.threshold=1"),
    settings("threshold below 0", "threshold is -0.1, must be in [0, 1)", "shadows.threshold=-0.1"),
    settings("threshold with a NaN", "threshold is nan", "shadows.threshold=nan"),
    settings("threshold as a text", "threshold is a string", "shadows.threshold='half'"),
    settings("too wide a filter", "pcf is 17, must be in [0, 16] texels", "shadows.pcf=17"),
    settings("pcf below 0", "pcf is -1, must be in [0, 16] texels", "shadows.pcf=-1"),
    settings("pcf of half a texel", "pcf is a number with a fraction", "shadows.pcf=0.5"),
    settings("unknown cache", "unknown cache 'voxels', must be one of: none, volume", "shadows.cache=voxels"),
    settings("cache as a flag", "cache is a boolean, must be a string", "shadows.cache=true"),
    settings("samples of no known lookup", "samples is 14, must be 7, 13 or 21", "shadows.samples=14"),
    settings("samples below 0", "samples is -7, must be in [7, 21]", "shadows.samples=-7"),
    settings("part of a sample", "samples is a number with a fraction", "shadows.samples=7.5"),
    settings("spheres' shadows without spheres", "the technique implicit-sphere needs [[spheres]]",
             "shadows.technique=implicit-sphere"),
    settings("patch below 0", "patch is -1, must be in [0, 64]", "shadows.patch=-1"),
    settings("patch of no known word", 'patch must be "auto" or an integer in [0, 64]', "shadows.patch=all"),
    settings("part of a ring", 'patch must be "auto" or an integer', "shadows.patch=0.5"),
    settings("softness below 0", "softness is -0.5, must be at least 0", "shadows.softness=-0.5"),
    settings("softness at no distance", "softness_distance is 0, must be above 0", "shadows.softness_distance=0"),
    settings("softness that is no number", "softness_exponent is nan, must be above 0",
             "shadows.softness_exponent=nan"),
    settings("seed below 0", "seed is -1, must be in [0, 999999]", "shadows.seed=-1"),
    settings("seed with a fraction", "seed is a number with a fraction", "shadows.seed=0.5"),
    settings("stratified as a number", "stratified is an integer, must be true or false", "shadows.stratified=1"),
    settings("shadow opacity over 1", "shadow_opacity is 1.5, must be in [0, 1]",
             "volume.smoke.shadow_opacity=[[0, 0], [1, 1.5]]"),
    settings("shadow opacity that falls back", "shadow_opacity has the value 0 after 1, must be ascending",
             "volume.smoke.shadow_opacity=[[1, 0], [0, 0.5]]"),
    settings("shadow opacity of nothing", "shadow_opacity is an array", "volume.smoke.shadow_opacity=[]"),
    settings("shadow opacity as a number", "shadow_opacity is", "volume.smoke.shadow_opacity=0.5"),
    settings("stable as a number", "stable is an integer, must be true or false", "shadows.stable=1"),
    scene("casting as a word", "casts_shadow is a string, must be true or false",
          b"closed.obj\"", b"closed.obj\"\ncasts_shadow = 'no'"),
    settings("receiving as a number", "receives_shadow is an integer, must be", "volume.smoke.receives_shadow=0"),
    settings("weight of 0", "cluster_weight is 0, must be in (0, 1000]", "mesh.cup.cluster_weight=0"),
    settings("weight beyond all bounds", "cluster_weight is inf", "volume.smoke.cluster_weight=inf"),
    settings("open mesh as boundary", "open edges", "mesh.cup.file=open.obj", "volume.smoke.boundary=cup"),
    settings("override of an unknown key", "--set image.widht=3: unknown key", "image.widht=3"),
    settings("override of an unknown light", "must be one of: key", "light.fill.cutoff=3"),
    settings("override out of range", "--set light.key.cutoff=95: cutoff is 95", "light.key.cutoff=95"),
]

VOLUMES = [
    volume("missing volume", None),
    volume("empty volume file", b""),
    volume("truncated volume", inputs.GRID_NRRD[:-1]),
    volume("volume without its header's end", inputs.GRID_NRRD[:30]),
    volume("volume with no voxels", inputs.EMPTY_NRRD),
    volume("volume that claims to be huge", inputs.HUGE_NRRD),
    volume("volume with a NaN", inputs.NAN_NRRD),
    volume("volume without space", inputs.FLAT_NRRD),
    volume("volume of noise", bytes(range(256)) * 4),
    volume("unknown volume format", b"x", file="grid.xyz"),
    volume("noise as MetaImage", bytes(range(256)), file="grid.mha"),
    volume("noise as NIfTI", bytes(range(256)) * 4, file="grid.nii"),
]

def chosen(name, file, content, text, key):
    """A volume file with a key that chooses a part of it."""
    scene_text = GOOD_SCENE.replace(b'"grid.nrrd"', b'"' + file.encode() + b'"\n' + key)
    return Case(name, text, RENDER, {"scene.toml": scene_text, file: content})


FORMATS = [
    Case("a VTI volume", "", RENDER, {"scene.toml": GOOD_SCENE.replace(b"grid.nrrd", b"grid.vti"),
                                      "grid.vti": inputs.GRID_VTI}, 0, ("out.png",)),
    Case("a raw volume", "", RENDER, {"scene.toml": GOOD_SCENE.replace(b"grid.nrrd", b"g_4x4x4_uint8.raw"),
                                      "g_4x4x4_uint8.raw": bytes(64)}, 0, ("out.png",)),
    volume("raw volume without a size", bytes(64), "no size and type in its name", "grid.raw"),
    volume("raw volume that is too short", bytes(63), "fewer than the 64 bytes", "g_4x4x4_uint8.raw"),
    volume("raw volume that claims to be huge", bytes(64), "2^34 voxels", "g_99999x99999x99999_uint8.raw"),
    volume("raw volume that claims to be packed well", bytes(64), "fewer than", "g_2000x2000x2000_uint8.raw.gz"),
    volume("noise as VTI", bytes(range(1, 256)), "is not well-formed XML", "grid.vti"),
    volume("truncated VTI", inputs.GRID_VTI[:-20], "grid.vti:", "grid.vti"),
    volume("VTI that claims to be huge", inputs.vti("0 99999 0 99999 0 99999", "1"), "2^34 voxels", "grid.vti"),
    volume("VTI of vectors", inputs.vti("0 3 0 3 0 3", "1", 3), "grid.vti:2:1: array \"a\" has \"3\" components",
           "grid.vti"),
    volume("VTI of cells", inputs.vti("0 3 0 3 0 3", "1", 1, "CellData"), "cell data alone", "grid.vti"),
    volume("VTI with a voxel out of range", inputs.vti("0 0 0 0 0 0", "256"), "number 1 of its voxels", "grid.vti"),
    volume("noise as OpenVDB", bytes(range(256)) * 4, "not an OpenVDB file", "grid.vdb"),
    volume("a slice of DICOM", b"x", "name the folder", "slice.dcm"),
    Case("a folder without slices", "folder with 0 DICOM files", RENDER,
         {"scene.toml": GOOD_SCENE.replace(b"grid.nrrd", b".")}),
    Case("noise as DICOM", "\"DICM\" must stand at byte 128", RENDER, {
        "scene.toml": GOOD_SCENE.replace(b"grid.nrrd", b"."), "1.dcm": bytes(600), "2.dcm": bytes(600)}),
    chosen("an array that is not there", "grid.vti", inputs.GRID_VTI, "no point data \"b\"", b"array = 'b'"),
    chosen("grid of a file without", "g.nrrd", inputs.GRID_NRRD, "scene.toml:22:8: grid chooses", b"grid = 'a'"),
    chosen("array of a file without", "g.nrrd", inputs.GRID_NRRD, "scene.toml:22:9: array chooses", b"array = 'a'"),
    chosen("grid as a number", "g.nrrd", inputs.GRID_NRRD, "scene.toml:22:8: grid is an integer", b"grid = 1"),
]

WITH_PRESET = GOOD_SCENE.split(b"opacity = [[")[0] + b'transfer_function = "preset.json"\n'


def preset(name, text, content=inputs.PRESET, more=b"", status=1):
    """The volume with a ParaView preset and more keys."""
    files = {"scene.toml": WITH_PRESET + more, "preset.json": content}
    return Case(name, text, RENDER, files, status, ("out.png",) if status == 0 else ())


PRESETS = [
    preset("a preset", "", status=0),
    preset("a preset with a range", "", more=b"range = [-5, 5]", status=0),
    preset("a preset whose range moves", "", status=0,
           more=b"range = [0, 1]\n[[animate]]\nkey = 'volume.smoke.range'\nframes = [[0, 0, 9], [1, 0, 99]]"),
    preset("missing preset", "preset.json: there is no such file", None),
    preset("empty preset", "preset.json: is empty", b""),
    preset("preset of noise", "preset.json:1:1: is not JSON", bytes(range(256))),
    preset("truncated preset", "preset.json:1:1: is not JSON", inputs.PRESET[:-9]),
    preset("deeply nested preset", "is not JSON", b"[" * 100000),
    preset("preset with a huge number", "", inputs.PRESET.replace(b"63", b"1e300")),
    preset("preset that descends", "must be ascending", inputs.PRESET.replace(b"[0, 0, 0, 1", b"[99, 0, 0, 1")),
    preset("preset and colour", "color and transfer_function are given", more=b"color = [[0, 1, 1, 1]]"),
    preset("preset and opacity", "the transfer_function has opacities", more=b"opacity = [[0, 1]]"),
    preset("preset without opacity", "scene.toml:22:21: the preset has no opacities", b'{"RGBPoints": [0, 0, 0, 1]}'),
    preset("range that descends", "scene.toml:23:9: range must be [low, high]", more=b"range = [5, 5]"),
    preset("range of one number", "range is an array of 1", more=b"range = [5]"),
    preset("range with a NaN", "range is nan", more=b"range = [nan, 5]"),
    settings("range without a preset", "which is not given", "volume.smoke.range=[0, 1]"),
]

MESHES = [
    mesh("missing mesh", None),
    mesh("empty mesh file", b""),
    mesh("mesh of noise", bytes(range(256)) * 4),
    mesh("mesh without triangles", b"v 0 0 0\n"),
    mesh("mesh index out of range", inputs.INDEX_OBJ),
    mesh("mesh with a NaN", inputs.NAN_OBJ),
    mesh("truncated STL", inputs.stl(2)[:-10], "cup.stl"),
    mesh("STL that claims too many triangles", inputs.stl(1, 0xFFFFFFFF), "cup.stl"),
    mesh("PLY that claims too many vertices", inputs.ply(100), "cup.ply"),
    mesh("truncated glTF", b'{"asset": {"version": "2.0"', "cup.gltf"),
    mesh("noise as glb", b"glTF" + bytes(60), "cup.glb"),
    mesh("unknown mesh format", b"x", "cup.xyz"),
]

WITH_SPHERES = GOOD_SCENE + b"[[spheres]]\nname = 'atoms'\nfile = 'atoms.xyz'\nmaterial = 'glass'\n"


def molecule(name, text, content, file="atoms.xyz", more=b"", status=1):
    """The good scene with spheres of a file and more keys."""
    files = {"scene.toml": WITH_SPHERES.replace(b"atoms.xyz", file.encode()) + more, file: content}
    return Case(name, text, RENDER, files, status, ("out.png",) if status == 0 else ())


MOLECULES = [
    molecule("atoms", "", inputs.ATOMS_XYZ, status=0),
    molecule("atoms that occlude", "", inputs.ATOMS_XYZ, more=b"[ambient_occlusion]", status=0),
    scene("ambient occlusion of nothing", "scene.toml:2:1: ambient_occlusion needs [[spheres]]", b"[camera]",
          b"[ambient_occlusion]\n[camera]"),
    molecule("a PDB entry", "", inputs.pdb("  O"), "atoms.pdb", status=0),
    molecule("an mmCIF entry", "", inputs.mmcif("2.0"), "atoms.cif", status=0),
    molecule("packed atoms", "", gzip.compress(inputs.ATOMS_XYZ), "atoms.xyz.gz", status=0),
    molecule("particles with a radius", "", b"0 0 0\n1 2 3\n", more=b"radius = 0.5", status=0),
    molecule("particles without a radius", "atoms.xyz:1:1: no element is no known element", b"0 0 0\n1 2 3\n"),
    molecule("missing molecule", "atoms.xyz: there is no such file", None),
    molecule("empty molecule", "atoms.xyz: is empty", b""),
    molecule("unknown molecule format", "is not known as a molecule by its ending", b"x", "atoms.mol2"),
    molecule("molecule of noise", "atoms.xyz:1:1: ", bytes(range(256)) * 4),
    molecule("PDB of noise", "atoms.pdb: holds no atoms", bytes(range(256)) * 4, "atoms.pdb"),
    molecule("mmCIF of noise", "atoms.cif:1:", bytes(range(256)) * 4, "atoms.cif"),
    molecule("molecule without atoms", "atoms.xyz: holds no atoms", b"0\n\n"),
    molecule("truncated XYZ", "atoms.xyz:3:1: the file ends after 1 of its 2 atoms", inputs.ATOMS_XYZ[:11]),
    molecule("XYZ that claims to be huge", "ends after 2 of its 9999999999", b"9999999999" + inputs.ATOMS_XYZ[1:]),
    molecule("XYZ with too many rows", "more rows than the 2 atoms", inputs.ATOMS_XYZ + b"C 4 5 6\n"),
    molecule("XYZ with a NaN", "atoms.xyz:4:1: \"nan\" is no coordinate", inputs.ATOMS_XYZ.replace(b"1.0", b"nan")),
    molecule("XYZ with an infinity", "\"inf\" is no coordinate", inputs.ATOMS_XYZ.replace(b"1.0", b"inf")),
    molecule("XYZ of an unknown element", "atoms.xyz:4:1: \"Qq\" is no known element",
             inputs.ATOMS_XYZ.replace(b"C ", b"Qq ")),
    molecule("truncated packed atoms", "is the file cut short?", gzip.compress(inputs.ATOMS_XYZ)[:-4], "atoms.xyz.gz"),
    molecule("truncated PDB", "atoms.pdb:2:1: the record of an atom is too short", inputs.pdb("  O")[:60], "atoms.pdb"),
    molecule("PDB without its end", "atoms.pdb:2:1: an entry with a HEADER has no END", inputs.pdb("  O")[:-4],
             "atoms.pdb"),
    molecule("PDB of an unknown element", "atoms.pdb:2:1: \"Q1\" is no known element",
             inputs.pdb("  Q").replace(b" O  ", b" Q1 "), "atoms.pdb"),
    molecule("PDB with a NaN", "atoms.pdb:2:31: \"nan\"", inputs.pdb("  O").replace(b"1.000", b"  nan"), "atoms.pdb"),
    molecule("mmCIF with a NaN", "atoms.cif:8:1: \"nan\" is no coordinate", inputs.mmcif("nan"), "atoms.cif"),
    molecule("truncated mmCIF", "Wrong number of values", inputs.mmcif("2.0")[:-5], "atoms.cif"),
    molecule("deeply quoted mmCIF", "atoms.cif", b"data_a\n_b\n;" + b"'" * 100000, "atoms.cif"),
    molecule("negative radius", "radius is -1, must be at least 0", inputs.ATOMS_XYZ, more=b"radius = -1"),
    molecule("radius with a NaN", "radius is nan", inputs.ATOMS_XYZ, more=b"radius = nan"),
    molecule("spheres of no known colour", "unknown color 'red'", inputs.ATOMS_XYZ, more=b"color = 'red'"),
    molecule("spheres made flat", "scale is an array", inputs.ATOMS_XYZ, more=b"scale = [1, 1, 2]"),
    molecule("spheres made skew", "must scale all axes alike", inputs.ATOMS_XYZ,
             more=b"matrix = [1, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]"),
    molecule("water that is left out", "holds water alone", inputs.pdb("  O"), "atoms.pdb", b"waters = false"),
]

ANIMATIONS = [
    animation("an animated scene without --frames", "", b"'light.key.position'", b"[[0, 4, 4, 4]]",
              [], 0, ("out.png",)),
    animation("one frame", "", b"'light.key.position'", b"[[0, 4, 4, 4]]", ["--frames", "7"], 0, ("out.png",)),
    animation("some frames", "", b"'camera.fov'", b"[[0, 40], [9, 50]]",
              ["--frames", "9:11", "-o", "out_%03d.png"], 0, ("out_009.png", "out_010.png", "out_011.png"), NAMELESS),
    animation("frames without a name", "", b"'camera.fov'", b"[[0, 40], [9, 50]]",
              ["--frames", "0:1"], 0, ("scene_0000.png", "scene_0001.png"), NAMELESS),
    animation("animation of an unknown key", "scene.toml:25:7: unknown key 'fvo' of camera",
              b"'camera.fvo'", b"[[0, 1]]"),
    animation("animation of an unknown light", "unknown light 'fill', must be one of: key",
              b"'light.fill.color'", b"[]"),
    animation("animation of a text", "'technique' is a text", b"'shadows.technique'", b"[[0, 1]]"),
    animation("animation of nothing", "is no dotted key", b"''", b"[[0, 1]]"),
    animation("animation without rows", "scene.toml:26:10: frames must be", b"'camera.fov'", b"[]"),
    animation("animation with rows of different lengths", "scene.toml:26:20: a row", b"'camera.fov'", b"[[0, 45], []]"),
    animation("animation with too few numbers", "[frame, 3 numbers]", b"'light.key.position'", b"[[0, 1, 2]]"),
    animation("animation with a NaN", "scene.toml:26:15: an animated value", b"'camera.fov'", b"[[0, nan]]"),
    animation("animation with half a frame", "scene.toml:26:12: a row", b"'camera.fov'", b"[[0.5, 45]]"),
    animation("animation that runs backwards", "frame 1 follows frame 2", b"'camera.fov'", b"[[2, 45], [1, 45]]"),
    animation("animation out of range at its first frame", "scene.toml:25:7: frame 0: fov is 180, must be in (0, 180)",
              b"'camera.fov'", b"[[0, 180]]"),
    animation("override of an animated key", "--set camera.fov=40: the key is animated in line 25", b"'camera.fov'",
              b"[[0, 45]]", ["--set", "camera.fov=40"]),
    Case("two animations of a key", "scene.toml:28:7: 'camera.fov' is already animated in line 25", RENDER,
         {"scene.toml": animated(b"'camera.fov'", b"[[0, 45]]", 2)}),
]

QUERIES = [
    Case("unknown light", "fill", replaced(QUERY, "key", "fill")),
    Case("missing points", "points.csv", QUERY, {"points.csv": None}),
    points("points without a header", b"1,2,3\n", "points.csv:1:"),
    points("points with a word", b"x,y,z\n1,2,3\n1,two,3\n", "points.csv:3:3"),
    points("points with two values", b"x,y,z\n1,2\n", "points.csv:2:"),
    points("points with a NaN", b"x,y,z\n1,2,nan\n", "points.csv:2:5"),
]

EXPORTS = [
    Case("export of an unknown light", "no light 'fill'; known: key", replaced(EXPORT, "key", "fill")),
    Case("export of no scene", "none.toml: ", replaced(EXPORT, "scene.toml", "none.toml")),
    Case("export of a technique without maps", "'shadow-rays' keeps no deep shadow maps",
         EXPORT + ["--set", "shadows.technique=shadow-rays"]),
    Case("export of shadows of nothing", "light 'key' has no maps to write", EXPORT + ["--set", "shadows.clusters=2"]
         + ["--set", "mesh.cup.casts_shadow=false", "--set", "volume.smoke.casts_shadow=false"]),
    Case("maps as PNG", "out.png: must end in .exr", replaced(EXPORT, "out.exr", "out.png")),
    Case("maps in no folder", "none/out.exr", replaced(EXPORT, "out.exr", "none/out.exr")),
    Case("a folder as maps", "must end in .exr", replaced(EXPORT, "out.exr", ".")),
    usage("export of no light", "--light is required", ["export-map", "scene.toml", "-o", "out.exr"]),
    usage("export to no file", "-o is required", ["export-map", "scene.toml", "--light", "key"]),
    usage("maps over the statistics", "'out.exr' is named twice", EXPORT + ["--stats", "out.exr"]),
]

COMPARE = ["compare", "scene.toml", "-o", "out", "--quiet", "--runs", "1"]
COMPARED = ("index.html", "compare.json", "shadow-rays.png", "none.png", "shadow-map_difference.png")
IN_OUT = tuple(f"out/{name}" for name in COMPARED)


def comparison(name, text, files, status=1, arguments=COMPARE, outputs=()):
    """A comparison beside more files."""
    return Case(name, text, arguments, files, status, outputs)


COMPARISONS = [
    comparison("a comparison", "", {}, 0, COMPARE, IN_OUT),
    comparison("a comparison with statistics and a trace", "", {}, 0,
               COMPARE + ["--stats", "stats.json", "--trace", "trace.json"], IN_OUT + ("stats.json", "trace.json")),
    comparison("a comparison again", "", {name: b"an earlier result" for name in IN_OUT}, 0, COMPARE, IN_OUT),
    comparison("a comparison without room for maps", "", {}, 0, COMPARE + ["--set", "shadows.memory_limit_mb=0.001"],
               IN_OUT),
    comparison("a comparison of frame 0", "", {"scene.toml": animated(b"'camera.fov'", b"[[0, 40], [9, 50]]")}, 0,
               COMPARE, IN_OUT),
    comparison("comparison of no scene", "none.toml: there is no such file", {"out/index.html": b"earlier"}, 1,
               replaced(COMPARE, "scene.toml", "none.toml")),
    comparison("comparison of a bad scene", "mesh 'cup' has 3 open edges", {
        "scene.toml": GOOD_SCENE.replace(b'closed.obj"', b'open.obj"\ninterior_extinction = 1'),
        "out/index.html": b"earlier"}),
    comparison("comparison in no folder", "none/out: its folder", {}, 1, replaced(COMPARE, "out", "none/out")),
    comparison("a file as folder", "points.csv: is a file; name a folder", {}, 1,
               replaced(COMPARE, "out", "points.csv")),
    comparison("comparison among other files", "out: holds thesis.tex, which is no part of a result",
               {"out/thesis.tex": b"work of years"}),
    comparison("comparison in the scene's folder", ".: holds ", {}, 1, replaced(COMPARE, "out", ".")),
    comparison("comparison on an unknown device", "no such device", {}, 1, COMPARE + ["--device", "no such device"]),
    comparison("comparison with statistics in no folder", "none/s.json", {}, 1, COMPARE + ["--stats", "none/s.json"]),
    usage("comparison to nowhere", "-o is required", ["compare", "scene.toml"]),
    usage("comparison over the scene", "'scene.toml' is named twice", replaced(COMPARE, "out", "scene.toml")),
    usage("comparison without runs", "--runs: Value 0 not in range", replaced(COMPARE, "1", "0")),
]

COMPARE = ["compare", "scene.toml", "-o", "out", "--quiet", "--runs", "1"]
COMPARED = ("index.html", "compare.json", "shadow-rays.png", "none.png", "shadow-map_difference.png")
IN_OUT = tuple(f"out/{name}" for name in COMPARED)


def comparison(name, text, files, status=1, arguments=COMPARE, outputs=()):
    """A comparison beside more files."""
    return Case(name, text, arguments, files, status, outputs)


COMPARISONS = [
    comparison("a comparison", "", {}, 0, COMPARE, IN_OUT),
    comparison("a comparison with statistics and a trace", "", {}, 0,
               COMPARE + ["--stats", "stats.json", "--trace", "trace.json"], IN_OUT + ("stats.json", "trace.json")),
    comparison("a comparison again", "", {name: b"an earlier result" for name in IN_OUT}, 0, COMPARE, IN_OUT),
    comparison("a comparison without room for maps", "", {}, 0, COMPARE + ["--set", "shadows.memory_limit_mb=0.001"],
               IN_OUT),
    comparison("a comparison of frame 0", "", {"scene.toml": animated(b"'camera.fov'", b"[[0, 40], [9, 50]]")}, 0,
               COMPARE, IN_OUT),
    comparison("comparison of no scene", "none.toml: there is no such file", {"out/index.html": b"earlier"}, 1,
               replaced(COMPARE, "scene.toml", "none.toml")),
    comparison("comparison of a bad scene", "mesh 'cup' has 3 open edges", {
        "scene.toml": GOOD_SCENE.replace(b'closed.obj"', b'open.obj"\ninterior_extinction = 1'),
        "out/index.html": b"earlier"}),
    comparison("comparison in no folder", "none/out: its folder", {}, 1, replaced(COMPARE, "out", "none/out")),
    comparison("a file as folder", "points.csv: is a file; name a folder", {}, 1,
               replaced(COMPARE, "out", "points.csv")),
    comparison("comparison among other files", "out: holds thesis.tex, which is no part of a result",
               {"out/thesis.tex": b"work of years"}),
    comparison("comparison in the scene's folder", ".: holds ", {}, 1, replaced(COMPARE, "out", ".")),
    comparison("comparison on an unknown device", "no such device", {}, 1, COMPARE + ["--device", "no such device"]),
    comparison("comparison with statistics in no folder", "none/s.json", {}, 1, COMPARE + ["--stats", "none/s.json"]),
    usage("comparison to nowhere", "-o is required", ["compare", "scene.toml"]),
    usage("comparison over the scene", "'scene.toml' is named twice", replaced(COMPARE, "out", "scene.toml")),
    usage("comparison without runs", "--runs: Value 0 not in range", replaced(COMPARE, "1", "0")),
]

RUNS = [
    Case("output in no folder", "none/out.png", ["render", "scene.toml", "-o", "none/out.png"]),
    Case("a folder as output", ".", ["render", "scene.toml", "-o", "."]),
    Case("unknown image format", "out.jpg", ["render", "scene.toml", "-o", "out.jpg"]),
    Case("statistics in no folder", "none/s.json", ["render", "scene.toml", "-o", "out.png", "--stats", "none/s.json"]),
    Case("a trace in no folder", "none/t.json", RENDER + ["--trace", "none/t.json"]),
    Case("a folder as trace", "is a folder", EXPORT + ["--trace", "."]),
    Case("answers in no folder", "none/out.csv", replaced(QUERY, "out.csv", "none/out.csv")),
    Case("unknown device", "no such device", RENDER + ["--device", "no such device"]),
    Case("device number out of range", "99:0", RENDER + ["--device", "99:0"]),
]

VIEWS = [
    works(f"view {view}", RENDER + ["--view", view, "--light", "key"], ("out.png", "stats.json"))
    for view in ("clusters", "nodes", "layers", "steps", "texels")
] + [
    works("a view without shadows", RENDER + ["--view", "steps", "--set", "shadows.technique=none"], ("out.png",)),
    works("a view of frames", NAMELESS + ["--frames", "0:1", "--view", "nodes"], ("scene_0000.png", "scene_0001.png")),
    usage("unknown view", "--view: node not in {clusters,nodes,layers,steps,texels}", RENDER + ["--view", "node"]),
    usage("light without a view", "--light requires --view", RENDER + ["--light", "key"]),
    Case("view of an unknown light", "there is no light 'fill'; known: key",
         RENDER + ["--view", "nodes", "--light", "fill"]),
    Case("view of a light without a name", "there is no light ''", RENDER + ["--view", "steps", "--light", ""]),
] + [
    Case(f"{view} of rays", f"view '{view}' shows the deep shadow maps of a light, shadows.technique is 'shadow-rays'",
         RENDER + ["--view", view, "--set", "shadows.technique=shadow-rays"])
    for view in ("clusters", "nodes", "texels")
]

USAGE = [
    usage("no command", "error: ", []),
    usage("unknown command", "unknown command 'rendr'", ["rendr", "scene.toml"]),
    usage("no scene", "SCENE is required", ["render"]),
    usage("unknown option", "--colour", RENDER + ["--colour", "red"]),
    usage("unknown fetch path", "--fetch", RENDER + ["--fetch", "magic"]),
    usage("override without a value", "must be KEY=VALUE", RENDER + ["--set", "image.width"]),
    usage("query without points", "--points is required", ["transmittance", "scene.toml", "--light", "key"]),
    usage("statistics over the image", "'./out.png' is named twice", replaced(RENDER, "stats.json", "./out.png")),
    usage("a trace over the statistics", "'stats.json' is named twice", RENDER + ["--trace", "stats.json"]),
    usage("a trace over the points", "'points.csv' is named twice", QUERY + ["--trace", "points.csv"]),
    usage("statistics over the scene", "'scene.toml' is named twice", replaced(RENDER, "stats.json", "scene.toml")),
    usage("answers over the points", "'points.csv' is named twice", replaced(QUERY, "out.csv", "points.csv")),
    usage("no suite", "SUITE is required", ["bench"]),
    usage("unknown suite", "unknown suite 'map', must be one of: demo, map-size,", ["bench", "map"]),
    usage("a suite without runs", "--runs: Value 0 not in range", ["bench", "demo", "--runs", "0"]),
    usage("half a run", "--runs", ["bench", "demo", "--runs", "0.5"]),
    usage("a suite without size", "--scale: Value 0 not in range", ["bench", "demo", "--scale", "0"]),
    Case("a suite without scenes", "there is no such file; --scenes must name",
         ["bench", "chunks", "--scenes", "none"]),
    Case("a suite without its data", "'python3 ./papers/make_data.py' makes it", ["bench", "map-size", "--scenes", "."],
         {"papers/clustering/camera_b.toml": GOOD_SCENE.replace(b"closed.obj", b"../generated/cup.ply")}),
    Case("figures in no folder", "none/out.json", ["bench", "demo", "--json", "none/out.json"]),
]

FRAMES = [
    usage(f"frames {frames!r}", "must be FIRST:LAST or one number", NAMELESS + [f"--frames={frames}"])
    for frames in (" ", "a", "3:", ":3", "5:3", "-2:3", "1:2:3", "0.5", "0:1000000", "99999999999999999999")
] + [
    usage(f"frames to {image}", "must have", NAMELESS + ["--frames", "0:1", "-o", image])
    for image in ("out.png", "%s.png", "%n%n%n.png", "%d_%d.png", "%4d.png", "%-4d.png", "100%.png", "%0999999999d.png")
] + [
    usage("a frame over the scene", "'scene.toml' is named twice", NAMELESS + ["--frames", "0:1"]
          + ["-o", "out_%d.png", "--stats", "scene.toml"]),
    usage("a frame over the statistics", "'out_1.png' is named twice", NAMELESS + ["--frames", "0:1"]
          + ["-o", "out_%d.png", "--stats", "out_1.png"]),
    Case("frames in no folder", "none/0.png", NAMELESS + ["--frames", "0:1", "-o", "none/%d.png"]),
    Case("frames without a format", "0.jpg", NAMELESS + ["--frames", "0:1", "-o", "%d.jpg"]),
]

CASES = (GOOD_RUNS + SCENES + ANIMATIONS + VOLUMES + FORMATS + PRESETS + MESHES + MOLECULES + QUERIES + EXPORTS
         + COMPARISONS + RUNS + VIEWS + USAGE + FRAMES)
