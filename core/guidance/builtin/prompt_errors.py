"""Errors of a prompt that the built-in prior refuses."""

from core.errors import UserError


class PromptError(UserError):
    """A prompt that the built-in prior cannot make."""

    window_fix = "Change the prompt. “Words” next to it lists what is known."


class UnknownWordsError(PromptError):
    """A prompt has words that are not known; ``nearest`` has the nearest known ones of each."""

    def __init__(self, text: str, fix: str, nearest: dict[str, list[str]]) -> None:
        super().__init__(text, fix)
        self.nearest = nearest
