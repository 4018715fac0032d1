"""The options of the tools, each declared once: type, default, range, unit, label and tooltip.

The operators, the scene's properties (``ui``) and the command line (``cli``) are built from these,
and the functions check against the same ranges. No bpy.
"""

from __future__ import annotations

from dataclasses import dataclass

Items = tuple[tuple[str, str, str], ...]  # identifier, label, tooltip


@dataclass(frozen=True)
class Option:
    """One option; its type is that of ``default``."""

    name: str  # of the property and of the function's argument
    label: str
    tip: str
    default: bool | int | float | str
    low: float | None = None
    high: float | None = None
    soft_high: float | None = None  # of the slider; a number above it can be typed
    subtype: str = "NONE"  # Blender's: FACTOR, DISTANCE (metres), ANGLE (radians), FILE_PATH
    items: Items = ()  # of an enum

    @property
    def names(self) -> tuple[str, ...]:
        """The identifiers of an enum."""
        return tuple(item[0] for item in self.items)

    @property
    def range(self) -> str:
        """The allowed numbers in words: "2 to 5000", "0 or more"."""
        if self.low is None and self.high is None:
            return "any number"
        return (
            f"{self.low:g} to {self.high:g}" if self.high is not None else f"{self.low:g} or more"
        )

    def allows(self, value: float) -> bool:
        """Whether a number is in range; infinities and NaN never are."""
        if not abs(value) < float("inf"):  # false for NaN too
            return False
        return (self.low is None or value >= self.low) and (self.high is None or value <= self.high)


# Light and turntable

STRENGTH = Option(
    "strength",
    "Strength",
    "Factor on the light's own radiance",
    1.0,
    low=0.0,
    high=1e6,
    soft_high=10.0,
)
ROTATION = Option(
    "rotation", "Rotation", "Turns the light about the vertical axis, counter-clockwise from above",
    0.0, subtype="ANGLE",
)  # fmt: skip
TURN = Option(
    "turn", "Turntable", "What rotates in the turntable", "CAMERA",
    items=(
        ("CAMERA", "Camera", "The camera moves around the asset and its light"),
        ("OBJECT", "Asset", "The asset rotates under a fixed light"),
        ("LIGHT", "Light", "The light rotates around the asset"),
    ),
)  # fmt: skip
TURN_FRAMES = Option("frames", "Frames", "Frames of one full turn", 48, low=2, high=5000)
SIZE = Option(
    "size", "Resolution", "Width and height of the picture in pixels", 640, low=16, high=8192
)
SAMPLES = Option(
    "samples", "Samples", "Samples per pixel; 0: as many as a clean picture needs", 0, low=0,
    high=1 << 16,
)  # fmt: skip

# Material

MATERIAL = Option(
    "material", "Material", "A material of the add-on's library (wood, gold, …), or one of this "
    "file, by name", "wood",
)  # fmt: skip
KEEP_NORMALS = Option(
    "keep_normals", "Keep Baked Detail", "Keep the asset's normal map under the new material", True
)
ROUGHNESS_SCALE = Option(
    "roughness_scale", "Roughness", "Factor on the roughness", 1.0, low=0.0, soft_high=2.0
)
METALLIC_SCALE = Option(
    "metallic_scale", "Metallic", "Factor on the metallic value", 1.0, low=0.0, soft_high=2.0
)

# Simulation

KIND = Option(
    "kind", "Simulation", "How the asset moves", "RIGID",
    items=(
        ("RIGID", "Rigid Body", "It falls and tumbles without deforming"),
        ("SOFT", "Soft Body", "It squashes and springs back"),
        ("CLOTH", "Cloth", "Its surface falls together like a garment"),
        ("DRAPE", "Drape", "A sheet of cloth falls over it"),
    ),
)  # fmt: skip
FRAMES = Option("frames", "Frames", "Number of frames to bake", 60, low=2, high=5000)
HEIGHT = Option(
    "height", "Height", "How far above its present place the fall starts", 0.5, low=0.0,
    high=1000.0, subtype="DISTANCE",
)  # fmt: skip
CONVEX = Option(
    "convex", "Convex Hull", "One convex hull as the collision shape: faster, but it fills hollows",
    False,
)  # fmt: skip
SOFTNESS = Option(
    "softness", "Softness", "0: firm rubber; 1: jelly", 0.5, low=0.0, high=1.0, subtype="FACTOR"
)
SELF_COLLISION = Option(
    "self_collision", "Self Collision", "Prevents the cloth from passing through itself (slower)",
    False,
)  # fmt: skip
SIMULATION = (FRAMES, HEIGHT, CONVEX, SOFTNESS, SELF_COLLISION)
# The option that a kind has beyond frames and height.
OF_KIND = {
    "RIGID": CONVEX,
    "SOFT": SOFTNESS,
    "CLOTH": SELF_COLLISION,
    "DRAPE": SELF_COLLISION,
}

# Mesh and export

LEVELS = Option("levels", "Levels", "Number of levels of detail to create", 3, low=1, high=8)
RATIO = Option(
    "ratio", "Ratio", "Faces of each level as a fraction of the level before", 0.5, low=0.05,
    high=0.95, subtype="FACTOR",
)  # fmt: skip
MAX_FACES = Option(
    "max_faces", "Max Faces", "One level with this many triangles or fewer; 0: by levels and ratio",
    0, low=0, soft_high=100_000,
)  # fmt: skip
QUADS = Option("faces", "Quads", "Quads, at most", 4000, low=100, soft_high=100_000)
BAKE_SIZE = Option(
    "texture_size", "Texture Size", "Texels along a side; 0: as the present maps", 0, low=0
)
FORMAT = Option(
    "format", "Format", "The file format", "glb",
    items=(
        ("glb", "glTF (.glb)", "One file: web, game engines, viewers"),
        ("usdz", "USD (.usdz)", "One file: Apple, Omniverse"),
        ("usdc", "USD (.usdc)", "Textures in a folder next to it: film pipelines"),
        ("fbx", "FBX (.fbx)", "One file: Unity, Unreal, Maya"),
        ("obj", "OBJ (.obj)", "Textures in a folder next to it: everything else"),
        ("stl", "STL (.stl)", "3D printing, in millimetres, without colours"),
        ("3mf", "3MF (.3mf)", "3D printing, in millimetres, without colours"),
        ("urdf", "URDF (.urdf)", "Robot simulators: mass, inertia, convex colliders"),
        ("mjcf", "MuJoCo (.xml)", "MuJoCo: mass, inertia, convex colliders"),
        ("usd-physics", "USD Physics (.usda)", "Isaac Sim: mass, inertia, convex colliders"),
        ("godot", "Godot", "A folder with a GLB that has convex colliders"),
        ("unity", "Unity", "A folder with an FBX that has LODs and colliders, and a mask map"),
        ("unreal", "Unreal", "A folder with an FBX that has LODs and colliders, and an ORM map"),
    ),
)  # fmt: skip
FLIP_NORMAL_Y = Option(
    "flip_normal_y", "DirectX Normals", "Flip the green channel of the normal map (FBX and OBJ)",
    False,
)  # fmt: skip
TAGS = Option("tags", "Tags", "Tags of the asset, separated by commas", "generated")
BOX_HEIGHT = Option(
    "height", "Height", "Height of the box; 0 fits the assets", 0.0, low=0.0, subtype="DISTANCE"
)
