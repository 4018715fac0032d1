"""Settings by their names, ``geometry.coarse.steps``: text to values, within their ranges."""

import dataclasses
import difflib
from dataclasses import fields, replace
from typing import Any, Literal, get_args, get_origin

from core.config import Config, PhaseConfig
from core.errors import UserError, shown
from core.ranges import range_of


def with_settings(config: Config, settings: dict[str, Any]) -> Config:
    """``config`` with ``{"geometry.coarse.steps": 100}`` and the like applied.

    Values may be text, as they come from ``--set``; tuples are numbers with commas.

    Raises:
        UserError: an unknown key (with the nearest known one), a value of another type or out of
            its range.
    """
    for key, value in settings.items():
        config = _with_setting(config, key, key.split("."), value)
    return config


def check(config: Any, prefix: str = "") -> None:
    """Refuse a config with a value out of its range.

    Raises:
        UserError: the first one, by name, with its range.
    """
    for f in fields(config):
        value, key = getattr(config, f.name), prefix + f.name
        if dataclasses.is_dataclass(value):
            check(value, f"{key}.")
        else:
            _check_range(key, f.type, value)
    if isinstance(config, PhaseConfig) and config.t_low > min(config.t_high):
        raise UserError(
            f"{prefix}t_low is {config.t_low}.",
            f"Use no more than {prefix}t_high, which is {min(config.t_high)}.",
        )


def _check_range(key: str, kind: Any, value: Any) -> None:
    allowed = range_of(kind)
    if allowed and not allowed.allows(value):
        text = ",".join(map(str, value)) if isinstance(value, tuple) else shown(value)
        raise UserError(f"{key} is {text}.", f"Use {allowed}.")


def setting_names(config: Any, prefix: str = "") -> list[str]:
    """All keys that :func:`with_settings` takes."""
    names = []
    for f in fields(config):
        value = getattr(config, f.name)
        if dataclasses.is_dataclass(value):
            names += setting_names(value, f"{prefix}{f.name}.")
        else:
            names.append(prefix + f.name)
    return names


def _with_setting(config: Any, key: str, path: list[str], value: Any) -> Any:
    kinds = {f.name: f.type for f in fields(config)}
    name, rest = path[0], path[1:]
    here = getattr(config, name, None) if name in kinds else None
    if name not in kinds or bool(rest) != dataclasses.is_dataclass(here):
        raise UserError(f"There is no setting {shown(key)}.", _did_you_mean(key))
    new = _with_setting(here, key, rest, value) if rest else _parse(key, kinds[name], here, value)
    if not rest:
        _check_range(key, kinds[name], new)
    return replace(config, **{name: new})


def _did_you_mean(key: str) -> str:
    names = setting_names(Config())
    tail = key.rsplit(".", 1)[-1]
    near = difflib.get_close_matches(key, names, n=3, cutoff=0.5)
    near += [n for n in names if n.rsplit(".", 1)[-1] == tail and n not in near]
    fix = "Name it as stage.field, such as geometry.fine.steps or texture.size."
    return f"Did you mean {' or '.join(near[:3])}?" if near else fix


def _parse(key: str, kind: Any, here: Any, value: Any) -> Any:
    """``value`` as the type of the field whose present value is ``here``."""
    try:
        if get_origin(kind) is Literal:
            if value not in get_args(kind):
                raise ValueError
            return value
        if isinstance(here, bool):
            return {"true": True, "false": False}[str(value).lower()]
        if isinstance(here, tuple):
            parts = value.split(",") if isinstance(value, str) else list(value)
            return tuple(_number(type(x), p) for x, p in zip(here, parts, strict=True))
        return _number(type(here), value)
    except (ValueError, KeyError, TypeError, OverflowError):
        takes = " or ".join(get_args(kind)) if get_origin(kind) is Literal else _describe(here)
        raise UserError(f"{key} is {shown(value)}.", f"Use {takes}.") from None


def _number(kind: type, value: Any) -> Any:
    """``value`` as an int or a float; ValueError where that would change it."""
    # bool is an int to Python, and int() would cut 1.7 down to 1.
    if isinstance(value, bool) or not isinstance(value, str | int | float):
        raise ValueError
    number = kind(value)
    if not isinstance(value, str) and number != value:
        raise ValueError
    return number


def _describe(here: Any) -> str:
    if isinstance(here, bool):
        return "true or false"
    if isinstance(here, tuple):
        return f"{len(here)} numbers with commas, such as {','.join(map(str, here))}"
    return "a whole number" if isinstance(here, int) else "a number"
