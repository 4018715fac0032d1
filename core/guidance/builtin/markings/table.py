"""Which thing has which markings (:mod:`core.guidance.builtin.markings.markings`)."""

from core.guidance.builtin.markings.marking import Rows
from core.guidance.builtin.markings.rows.buildings import BUILDINGS
from core.guidance.builtin.markings.rows.built import BUILT
from core.guidance.builtin.markings.rows.crafts import CRAFTS
from core.guidance.builtin.markings.rows.creatures import CREATURES
from core.guidance.builtin.markings.rows.everyday import EVERYDAY
from core.guidance.builtin.markings.rows.homely import HOMELY
from core.guidance.builtin.markings.rows.household import HOUSEHOLD
from core.guidance.builtin.markings.rows.living import LIVING
from core.guidance.builtin.markings.rows.machines import MACHINES

MARKINGS: Rows = (
    EVERYDAY | BUILT | LIVING | BUILDINGS | CRAFTS | HOUSEHOLD | HOMELY | MACHINES | CREATURES
)
