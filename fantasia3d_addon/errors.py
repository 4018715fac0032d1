"""Errors that the user can fix, as one sentence each. Anything else keeps its traceback."""


class AddonError(Exception):
    """``text``: one sentence, what is wrong; ``fix``: what the user can do."""

    def __init__(self, text: str, fix: str = "") -> None:
        # Blender's text and some terminals refuse half of a surrogate pair, which JSON may hold.
        self.text, self.fix = (x.encode(errors="backslashreplace").decode() for x in (text, fix))
        super().__init__(f"{self.text} {self.fix}".strip())


class AssetError(AddonError):
    """A folder is not an asset, or an incomplete one."""


class JobError(AddonError):
    """A job could not be started."""


class LightError(AddonError):
    """A light does not exist, or is not a picture."""


class OutputError(AddonError):
    """A file could not be written."""
