"""Prompts as tokens, and tokens as what a U-Net is conditioned on."""

import re
from typing import Any, NamedTuple

import torch
from jaxtyping import Float
from torch import Tensor

from core.guidance.stable_diffusion.prompts import fit_tokens


class Encoder(NamedTuple):
    """One of CLIP's text encoders, and its tokenizer."""

    model: Any  # transformers' CLIPTextModel, or its like with a projection (SDXL's second)
    tokenizer: Any


class Texts:
    """A checkpoint's text encoders: they run once, on the CPU."""

    def __init__(self, encoders: tuple[Encoder, ...], *, zero_empty: bool = False) -> None:
        """
        Args:
            encoders: one, whose last states are the text; or SDXL's two.
            zero_empty: SDXL's training replaced the empty text by zeros.
        """
        self.encoders, self.zero_empty = encoders, zero_empty
        self.tokenizer = encoders[0].tokenizer
        self.words: dict[str, list[int]] = {}  # of textual inversions, in small letters

    @property
    def widths(self) -> list[int]:
        """Of a token's vector in each encoder."""
        return [e.model.get_input_embeddings().embedding_dim for e in self.encoders]

    def add_words(self, words: set[str], vectors: list[Float[Tensor, "n w"]]) -> None:
        """Let each of ``words`` stand for new tokens.

        Args:
            vectors: of the new tokens, for each encoder.
        """
        for encoder, new in zip(self.encoders, vectors, strict=True):
            table = encoder.model.get_input_embeddings().weight
            first = len(table)
            longer = torch.nn.Embedding.from_pretrained(torch.cat([table, new.to(table)]))
            encoder.model.set_input_embeddings(longer)
        numbers = list(range(first, first + len(vectors[0])))
        self.words |= {word.lower(): numbers for word in words}

    def unused(self, *texts: str) -> list[str]:
        """Words of textual inversions that are in none of ``texts``."""
        used = {number for text in texts for number in self._ids(text)}
        return [word for word, numbers in self.words.items() if not used & set(numbers)]

    def tokens(self, text: str, suffix: str) -> tuple[list[int], str]:
        """The tokens of ``text`` and ``suffix``, and the end of ``text`` that did not fit."""
        tokenizer = self.tokenizer
        tokens, cut = fit_tokens(
            self._ids(text),
            self._ids(suffix),
            self._length,
            bos=tokenizer.bos_token_id,
            eos=tokenizer.eos_token_id,
            pad=tokenizer.pad_token_id,
        )
        return tokens, self._text(cut)

    @property
    def _length(self) -> int:
        """Tokens of a text; a tokenizer that was saved without one states a huge number."""
        places = self.encoders[0].model.config.max_position_embeddings
        return min(self.tokenizer.model_max_length, places)

    def _ids(self, text: str) -> list[int]:
        """The tokens of ``text``; a textual inversion's word is its own."""
        if not self.words:
            return self._plain(text)
        # The longest first: one word may begin with another.
        longest = sorted(self.words, key=len, reverse=True)
        word = rf"(?<!\w)({'|'.join(map(re.escape, longest))})(?!\w)"
        pieces = re.split(word, text, flags=re.IGNORECASE)
        ids = [self.words.get(p.lower()) if i % 2 else self._plain(p) for i, p in enumerate(pieces)]
        return [number for part in ids for number in part or []]

    def _plain(self, text: str) -> list[int]:
        return self.tokenizer(text, add_special_tokens=False, verbose=False).input_ids

    def _text(self, tokens: list[int]) -> str:
        """``tokens`` as text."""
        firsts = {numbers[0]: word for word, numbers in self.words.items()}
        known = {n for numbers in self.words.values() for n in numbers}
        words, run = [], []
        for number in tokens:
            if number not in known:
                run.append(number)
                continue
            words += [self.tokenizer.decode(run).strip(), firsts.get(number, "")]
            run = []
        return " ".join(w for w in [*words, self.tokenizer.decode(run).strip()] if w)

    @torch.no_grad()
    def encode(self, tokens: list[list[int]]) -> Float[Tensor, "n l d"]:
        """What the U-Net is conditioned on; of SDXL the pooled text is one more row, ``pooled``."""
        if len(self.encoders) == 1:
            return self.encoders[0].model(torch.tensor(tokens)).last_hidden_state
        first, second = self.encoders
        one = first.model(torch.tensor(tokens), output_hidden_states=True)
        padded = [self._padded(line) for line in tokens]
        two = second.model(torch.tensor(padded), output_hidden_states=True)
        # Both encoders' last but one states (Podell et al. 2023, §2.1).
        states = torch.cat([one.hidden_states[-2], two.hidden_states[-2]], -1)
        text = torch.cat([states, _as_row(self._pooled(two, padded), states.shape[-1])], 1)
        if self.zero_empty:
            text[[self._is_empty(line) for line in tokens]] = 0
        return text

    def _padded(self, tokens: list[int]) -> list[int]:
        """The tokens with the second tokenizer's filling after the end token."""
        end = tokens.index(self.tokenizer.eos_token_id) + 1
        pad = self.encoders[1].tokenizer.pad_token_id
        return tokens[:end] + [pad] * (len(tokens) - end)

    def _pooled(self, out: Any, tokens: list[list[int]]) -> Float[Tensor, "n p"]:
        """The projected state of the end token; by its position, since published configurations
        name a wrong number for it."""
        ends = [line.index(self.tokenizer.eos_token_id) for line in tokens]
        last = out.last_hidden_state[range(len(ends)), ends]
        return self.encoders[1].model.text_projection(last)

    def _is_empty(self, tokens: list[int]) -> bool:
        return tokens[1] == self.tokenizer.eos_token_id


def _as_row(pooled: Float[Tensor, "n p"], width: int) -> Float[Tensor, "n 1 d"]:
    return torch.nn.functional.pad(pooled, (0, width - pooled.shape[-1]))[:, None]


def pooled_of(text: Float[Tensor, "n l d"], width: int) -> Float[Tensor, "n p"]:
    """The pooled text that ``Texts.encode`` put into the last row."""
    return text[:, -1, :width]
