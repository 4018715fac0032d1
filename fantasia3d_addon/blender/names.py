"""Names of datablocks. No bpy."""

NAME_BYTES = 63  # of a datablock, in UTF-8; Blender 5 takes more, but earlier ones read its files


def data_name(prompt: str, suffix: str = "") -> str:
    """``prompt`` as a name in Blender: one line, room for ".001", no letter cut in half."""
    line = " ".join(prompt.split()) or "Asset"
    room = NAME_BYTES - len(suffix) - len(".001")
    return line.encode(errors="replace")[:room].decode(errors="ignore").rstrip() + suffix
