"""While the tests run, the core's signatures are checked: shapes (jaxtyping), types (beartype).

In production the checks are off and cost nothing.
"""

from pathlib import Path

from jaxtyping import install_import_hook

# An int may stand for a float, as PEP 484 has it.
CHECKER = "beartype.beartype(conf=beartype.BeartypeConf(is_pep484_tower=True))"
UNCHECKED = {
    "kernels",  # numba compiles what it is given, and checks types itself
    "__init__",  # the prefix "core" would take in all the rest
    "tests",  # pytest rewrites their asserts instead
    "protocol",  # it refuses wrong types itself, in words for the user
}


def checked_modules() -> list[str]:
    """The core's modules and packages whose signatures are checked."""
    core = Path(__file__).parent / "core"
    names = {path.stem for path in core.iterdir() if path.suffix == ".py" or path.is_dir()}
    return sorted(f"core.{name}" for name in names - UNCHECKED if not name.startswith("__pyc"))


install_import_hook(checked_modules(), CHECKER)
