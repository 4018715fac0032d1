"""Blender properties from the declarations of :mod:`options`."""

from __future__ import annotations

from typing import Any

from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, StringProperty

from ..options import Option


def option_property(option: Option, **more: Any) -> Any:
    """``option`` as a property of an operator or a property group; ``more`` overrides parts."""
    settings: dict[str, Any] = {"name": option.label, "description": option.tip}
    settings |= {"default": option.default}
    if option.items:
        return EnumProperty(items=option.items, **(settings | more))
    if option.subtype != "NONE":
        settings |= {"subtype": option.subtype}
    if isinstance(option.default, bool):  # before int: a bool is one
        return BoolProperty(**(settings | more))
    if isinstance(option.default, str):
        return StringProperty(**(settings | more))
    limits = {"min": option.low, "max": option.high, "soft_max": option.soft_high}
    settings |= {name: value for name, value in limits.items() if value is not None}
    kind = IntProperty if isinstance(option.default, int) else FloatProperty
    return kind(**(settings | more))
