"""While the tests run, the core's signatures are checked: shapes (jaxtyping), types (beartype).

In production the checks are off and cost nothing.
"""

from pathlib import Path

from jaxtyping import install_import_hook

# An int may stand for a float, as PEP 484 has it.
CHECKER = "beartype.beartype(conf=beartype.BeartypeConf(is_pep484_tower=True))"
UNCHECKED = {
    "core/kernels",  # numba compiles what it is given, and checks types itself
    "core/tests",  # pytest rewrites their asserts instead
    "core/io/job.py",  # it refuses wrong types itself, in words for the user
}


def checked_modules() -> list[str]:
    """The core's modules whose signatures are checked."""
    root = Path(__file__).parent
    files = [path.relative_to(root) for path in (root / "core").rglob("*.py")]
    return sorted(
        ".".join(path.with_suffix("").parts)
        for path in files
        if path.stem != "__init__"  # the hook takes a package's name for all that is in it
        and not {path.as_posix(), *(above.as_posix() for above in path.parents)} & UNCHECKED
    )


install_import_hook(checked_modules(), CHECKER)
