"""Deterministic mutations of files, for the fuzz tests. Standard library only."""

import copy
import json
import random
import struct
import zlib
from typing import Any

# Lengths, counts and offsets that readers stumble over.
WHOLE = (0, 1, 2, 7, 127, 128, 255, 256, 32767, 65535, 65536, 2**31 - 1, 2**31, 2**32 - 1)
TEXTS = (
    b"0", b"-1", b"1e39", b"-1e39", b"nan", b"inf", b"1e-400", b"999999999999999999999999", b"",
    b"2147483648", b"1.5", b"x", b"\xff", b"//", b"1000000000000", b"\0", b"\n", b" ",
)  # fmt: skip
VALUES = (
    None, True, -1, 0, 1, 3, 2**31, 10**12, 10**30, 0.5, -0.0, 1e308, "", "VEC3", "a", [], {}, [0],
    [[0]], {"a": 1}, [1.0] * 16,
)  # fmt: skip


def mutate(data: bytes, rng: random.Random) -> bytes:
    """``data`` with one to eight changes."""
    changed = bytearray(data)
    for _ in range(rng.choice((1, 1, 2, 3, 8))):
        rng.choice(CHANGES)(changed, rng)
    return bytes(changed)


def _flip(data: bytearray, rng: random.Random) -> None:
    if data:
        data[rng.randrange(len(data))] ^= 1 << rng.randrange(8)


def _byte(data: bytearray, rng: random.Random) -> None:
    if data:
        data[rng.randrange(len(data))] = rng.choice((0, 1, 127, 128, 254, 255, rng.randrange(256)))


def _number(data: bytearray, rng: random.Random) -> None:
    size = rng.choice((2, 4, 4, 8))
    if len(data) >= size:
        start = rng.randrange(len(data) - size + 1)
        value = rng.choice(WHOLE) % 256**size
        data[start : start + size] = value.to_bytes(size, rng.choice(("little", "big")))


def _cut(data: bytearray, rng: random.Random) -> None:
    if data:
        del data[rng.randrange(len(data)) :]


def _remove(data: bytearray, rng: random.Random) -> None:
    if data:
        start = rng.randrange(len(data))
        del data[start : start + rng.choice((1, 2, 4, 16, 64))]


def _repeat(data: bytearray, rng: random.Random) -> None:
    if data:
        start = rng.randrange(len(data))
        part = data[start : start + rng.choice((1, 4, 16, 64))]
        data[start:start] = part * rng.choice((1, 2, 30))


def _word(data: bytearray, rng: random.Random) -> None:
    """Another word of a text."""
    words = bytes(data).split(b" ")
    if len(words) > 1:
        words[rng.randrange(len(words))] = rng.choice(TEXTS)
        data[:] = b" ".join(words)


def _line(data: bytearray, rng: random.Random) -> None:
    """A line of a text elsewhere."""
    lines = bytes(data).split(b"\n")
    line = lines.pop(rng.randrange(len(lines)))
    lines.insert(rng.randrange(len(lines) + 1), line)
    data[:] = b"\n".join(lines)


CHANGES = (_flip, _byte, _byte, _number, _number, _cut, _remove, _repeat, _word, _word, _line)


def mutate_png(data: bytes, rng: random.Random) -> bytes:
    """Like :func:`mutate`, but often with right checksums, so that more than those is read."""
    if rng.random() < 0.3:
        return mutate(data, rng)
    chunks, place = [], 8
    while place + 12 <= len(data):
        length, name = struct.unpack_from(">I4s", data, place)
        chunks.append([name, data[place + 8 : place + 8 + length]])
        place += 12 + length
    chunk = rng.choice(chunks)
    if chunk[0] == b"IDAT" and rng.random() < 0.5:
        chunk[1] = zlib.compress(mutate(zlib.decompress(chunk[1]), rng))
    else:
        chunk[1] = mutate(chunk[1], rng)
    if rng.random() < 0.2:
        chunks.insert(rng.randrange(len(chunks)), rng.choice(chunks))
    return data[:8] + b"".join(
        struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))
        for name, body in chunks
    )


def mutate_glb(data: bytes, rng: random.Random) -> bytes:
    """Like :func:`mutate`, but often with other values in the JSON and right lengths."""
    if rng.random() < 0.3:
        return mutate(data, rng)
    (length,) = struct.unpack_from("<I", data, 12)
    tree = json.loads(data[20 : 20 + length])
    for _ in range(rng.choice((1, 1, 2, 4))):
        mutate_json(tree, rng)
    text = json.dumps(tree).encode()
    text += b" " * (-len(text) % 4)
    rest = data[20 + length :]
    if rng.random() < 0.3:
        rest = rest[:8] + mutate(rest[8:], rng)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + rest
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def mutate_json(tree: Any, rng: random.Random) -> None:
    """Another value somewhere in ``tree``, or none."""
    places: list[tuple[Any, Any]] = []

    def collect(value: Any) -> None:
        keys = value if isinstance(value, dict) else range(len(value))
        for key in keys:
            places.append((value, key))
            if isinstance(value[key], dict | list):
                collect(value[key])

    collect(tree)
    owner, key = rng.choice(places)
    change = rng.randrange(4)
    if change == 0:
        del owner[key]
    elif change == 1:
        owner[key] = rng.choice(places)[0]  # may contain itself: then the dump below refuses it
        try:
            json.dumps(tree)
        except (ValueError, RecursionError):
            owner[key] = copy.deepcopy(rng.choice(VALUES))
    else:
        owner[key] = copy.deepcopy(rng.choice(VALUES))  # which later changes may change
