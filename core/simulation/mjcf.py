"""MJCF: one free body, for MuJoCo; a scene takes it in with ``<include file="..."/>``."""

from xml.sax.saxutils import quoteattr

from core.simulation.body import Body


def mjcf_text(body: Body, folder: str) -> str:
    """The file; ``folder`` holds visual.obj, base_color.png and the hulls."""
    name, names = body.name, [f"{body.name}_hull_{i:02}" for i in range(len(body.hulls))]
    (xx, xy, xz), (_, yy, yz), (_, _, zz) = body.mass.inertia.tolist()
    center = " ".join(f"{x:.9g}" for x in body.mass.center.tolist())
    inertia = " ".join(f"{x:.9g}" for x in (xx, yy, zz, xy, xz, yz))
    files = "".join(
        f'    <mesh name="{hull}" file={quoteattr(f"{folder}/hull_{i:02}.obj")}/>\n'
        for i, hull in enumerate(names)
    )
    geoms = "".join(f'      <geom type="mesh" mesh="{hull}" group="3"/>\n' for hull in names)
    return (
        f"<mujoco model={quoteattr(body.title)}>\n  <asset>\n"
        f'    <texture name="{name}" type="2d" file={quoteattr(f"{folder}/base_color.png")}/>\n'
        f'    <material name="{name}" texture="{name}"/>\n'
        f'    <mesh name="{name}_visual" file={quoteattr(f"{folder}/visual.obj")} '
        f'inertia="shell"/>\n'
        f'{files}  </asset>\n  <worldbody>\n    <body name="{name}">\n      <freejoint/>\n'
        f'      <inertial pos="{center}" mass="{body.mass.mass:.9g}" fullinertia="{inertia}"/>\n'
        f'      <geom type="mesh" mesh="{name}_visual" material="{name}" contype="0" '
        f'conaffinity="0" group="2"/>\n{geoms}    </body>\n  </worldbody>\n</mujoco>\n'
    )
