"""URDF: one link, as ROS, Gazebo, Isaac Sim, PyBullet and MuJoCo read it.

Meshes are named by paths relative to the file. The element ``mujoco`` is for MuJoCo alone, which
otherwise may drop their folder and joins the link with the world; other readers ignore it.
"""

from xml.sax.saxutils import quoteattr

from core.simulation.body import Body


def urdf_text(body: Body, folder: str) -> str:
    """The file; ``folder`` holds visual.obj and the hulls."""
    (xx, xy, xz), (_, yy, yz), (_, _, zz) = body.mass.inertia.tolist()
    center = " ".join(f"{x:.9g}" for x in body.mass.center.tolist())
    hulls = "".join(
        f"    <collision name={quoteattr(f'hull_{i:02}')}>\n      {_mesh(folder, f'hull_{i:02}')}\n"
        "    </collision>\n"
        for i in range(len(body.hulls))
    )
    return (
        f'<?xml version="1.0" encoding="UTF-8"?>\n<robot name={quoteattr(body.name)}>\n'
        '  <mujoco>\n    <compiler strippath="false" discardvisual="false" fusestatic="false"/>\n'
        "  </mujoco>\n"
        f"  <link name={quoteattr(body.name)}>\n    <inertial>\n"
        f'      <origin xyz="{center}" rpy="0 0 0"/>\n      <mass value="{body.mass.mass:.9g}"/>\n'
        f'      <inertia ixx="{xx:.9g}" ixy="{xy:.9g}" ixz="{xz:.9g}" iyy="{yy:.9g}" '
        f'iyz="{yz:.9g}" izz="{zz:.9g}"/>\n    </inertial>\n'
        f"    <visual>\n      {_mesh(folder, 'visual')}\n    </visual>\n{hulls}"
        "  </link>\n</robot>\n"
    )


def _mesh(folder: str, name: str) -> str:
    return f"<geometry><mesh filename={quoteattr(f'{folder}/{name}.obj')}/></geometry>"
