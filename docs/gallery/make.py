"""Make the gallery: ``run.py python docs/gallery/make.py [COUNT]``; goes on where it stopped.

``run.py batch`` makes the prompts of prompts.txt, the first ``COUNT`` of them, by the draft preset
with seed 0. Each is shown as its normals, its base colour and a Cycles render. The batch lies in
out/gallery; the strips and README.md here are made of it, and the project's own picture of five.
"""

import csv
import subprocess
import sys
from pathlib import Path

from PIL import Image

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
BATCH = ROOT / "out" / "gallery"
SIDE = 192  # pixels, of one picture in a strip
RENDERED = 400  # pixels, of a Cycles render: as large as the project's own picture shows it
FIRST = (
    "a red house with a grey roof",
    "a blue robot with yellow eyes and red limbs",
    "an astronaut riding a horse",
    "a bucket of red apples",
    "a sitting corgi wearing a red scarf",
)
SHOWN = ("normal", "base_color", "cycles")
VIEW = ("--azimuth-deg", "30", "--elevation-deg", "20")


def run(*arguments: "str | Path") -> None:
    """``run.py`` with these arguments."""
    subprocess.run([sys.executable, ROOT / "run.py", *arguments], check=True)


def made(prompts: list[str]) -> dict[str, Path]:
    """The run folder of each prompt, made where it is not there yet."""
    table = BATCH / "prompts.txt"
    table.parent.mkdir(parents=True, exist_ok=True)
    table.write_text("\n".join(prompts) + "\n", encoding="utf-8")
    run("batch", table, "--out", BATCH)
    with (BATCH / "report.csv").open(encoding="utf-8", newline="") as file:
        return {row["prompt"]: BATCH / row["folder"] for row in csv.DictReader(file)}


def pictures(folder: Path) -> None:
    """The run's pictures, where they are not there yet."""
    cycles = folder / "cycles.png"
    if not cycles.exists():
        run("relight", folder / "asset", "--render", cycles, "--size", str(RENDERED))
    for map in ("normal", "base_color"):
        if not (picture := folder / f"{map}.png").exists():
            run("render", folder, "--map", map, *VIEW, "--size", str(2 * SIDE), "--out", picture)


def strip(folder: Path, out: Path) -> None:
    """The three pictures side by side, over white where they have alpha."""
    row = Image.new("RGB", (3 * SIDE, SIDE), "white")
    for i, name in enumerate(SHOWN):
        picture = Image.open(folder / f"{name}.png").convert("RGBA")
        side = min(picture.size)
        left, top = (picture.width - side) // 2, (picture.height - side) // 2
        square = picture.crop((left, top, left + side, top + side)).resize((SIDE, SIDE))
        row.paste(square, (i * SIDE, 0), square)
    row.save(out, quality=88, optimize=True)


def first_picture(folders: dict[str, Path], out: Path, side: int = RENDERED) -> None:
    """The Cycles renders of ``FIRST`` side by side, where all are there."""
    if not set(FIRST) <= folders.keys():
        return
    row = Image.new("RGB", (side * len(FIRST), side), "white")
    for i, prompt in enumerate(FIRST):
        picture = Image.open(folders[prompt] / "cycles.png").convert("RGB")
        row.paste(picture.resize((side, side)), (i * side, 0))
    row.save(out, quality=90, optimize=True)


def main(count: str = "") -> None:
    """Make the first ``count`` prompts (all, if empty), and the page of them."""
    prompts = (HERE / "prompts.txt").read_text(encoding="utf-8").splitlines()
    folders = made(prompts[: int(count) if count else None])
    lines = ["# Gallery", "", "Normals, base colour, Cycles; made by `make.py`, seed 0.", ""]
    for number, (prompt, folder) in enumerate(folders.items(), 1):
        pictures(folder)
        name = f"{number:02d}.jpg"
        strip(folder, HERE / name)
        lines += [f"{number}. {prompt}", "", f"    ![{prompt}]({name})", ""]
    first_picture(folders, HERE.parent / "images" / "assets.jpg")
    (HERE / "README.md").write_text("\n".join(lines), encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
