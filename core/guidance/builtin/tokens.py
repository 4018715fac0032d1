"""A prompt's text as words. Standard library only."""

import re
import unicodedata


def tokens_of(prompt: str) -> tuple[list[str], set[int]]:
    """The words of a prompt in lower case, and the indices of those that punctuation precedes."""
    tokens: list[str] = []
    breaks: set[int] = set()
    # The s of a possessive is no word.
    plain = unicodedata.normalize("NFKC", prompt).lower().replace("'s", " ")
    for token in re.findall(r"[^\W_]+|[,;:.!?()]", plain):
        if token[0].isalnum():
            tokens.append(token)
        else:
            breaks.add(len(tokens))
    return tokens, breaks
