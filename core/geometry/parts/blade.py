"""The blade that a component is: a lozenge across, that comes to a point.

By least squares (:mod:`core.geometry.parts.fitting`): a network rounds thin edges off, and the
sides show where they meet.
"""

import numpy as np
from jaxtyping import Float
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

from core.geometry.parts.components import Component, points_of
from core.geometry.parts.primitives import FRAMES, Points, Primitive

LONG = 1.5  # times as long as wide, at least
TIP = 0.2  # of the length, to begin with
STEPS = 40  # evaluations of the gradient, at most
SOFT = 0.3  # errors, beyond which a point counts less
ENDS = 4.0  # points' worth, of where the points end
WIDER, STEEPER, SLIMMER = 3.0, 5.0, 8.0  # times, at most, than to begin with


def blade(component: Component) -> Primitive | None:
    """The blade along the component's longest axis, up or down, that is nearest to it; None if it
    is hardly longer than wide."""
    size = np.ptp(component.verts.double().numpy(), axis=0)
    axis = int(size.argmax())
    if size[axis] < LONG * np.delete(size, axis).max():
        return None
    frame, points = FRAMES[(2 - axis) % 3], points_of(component)
    ways = (frame, frame @ np.diag([1.0, -1.0, -1.0]))
    found = [_fitted(points, way, component.error) for way in ways]
    return min(found, key=lambda one: one.off(points, component.error))


def _fitted(points: Points, frame: Float[np.ndarray, "3 3"], error: float) -> Primitive:
    local = points @ frame
    low, high = local.min(0), local.max(0)
    size, turn = high - low, Rotation.from_matrix(frame).as_rotvec()

    def of(x: Float[np.ndarray, " 8"]) -> Primitive:
        return Primitive("blade", frame @ x[:3], turn, np.exp(x[3:]))

    def residuals(x: Float[np.ndarray, " 8"]) -> Float[np.ndarray, " k"]:
        one = of(x)
        return np.append(one.at(points), ENDS * one.local(points)[:, 2].min()) / error

    long = size[2] * np.array([1 - TIP, TIP])
    first = np.array([*(low + high)[:2] / 2, low[2], *np.log([*size[:2] / 2, *long, 1.0])])
    reach = np.array([*size / 3, *np.log([WIDER, WIDER, STEEPER, STEEPER, SLIMMER])])
    bounds = first - reach, first + reach
    solved = least_squares(
        residuals, first, bounds=bounds, loss="soft_l1", f_scale=SOFT, max_nfev=STEPS
    )
    return of(solved.x)
