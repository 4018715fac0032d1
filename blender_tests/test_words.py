"""What is understood of a prompt, shown while it is typed; the menus of words."""

import sys
import time
from pathlib import Path

import pytest

bpy = pytest.importorskip("bpy")

from fantasia3d_addon.jobs import submit, words  # noqa: E402
from fantasia3d_addon.jobs.process import Core  # noqa: E402
from fantasia3d_addon.jobs.session import session  # noqa: E402
from fantasia3d_addon.ui import words_menu  # noqa: E402

pytestmark = [pytest.mark.blender]
ROOT = Path(__file__).parents[1]
CORE = Core(Path(sys.executable), ROOT)


def answer(reader: words.Words, ask):
    deadline = time.monotonic() + 60
    while (found := ask()) is None or reader.pending:
        reader.tick(CORE)
        assert time.monotonic() < deadline
        time.sleep(0.01)
    return found


def test_a_prompt_is_reported_once_it_rests():
    reader = words.Words()
    assert reader.report("") is None
    assert not reader.pending
    assert reader.report("a red wo") is None
    reader.tick(CORE)
    assert reader._task is None  # a key was pressed a moment ago
    report = answer(reader, lambda: reader.report("a red wooden chair "))
    assert words.summary(report) == "chair, red, wooden"
    assert report["size_m"] == 0.9
    assert reader.report("a red wooden chair") is report
    assert not reader.pending


def test_a_part_with_a_color_is_named_once():
    report = words.ask(CORE, ("a blue mug with a red handle", False))
    assert words.summary(report) == "mug, blue, red handle"
    report["part_sheens"] = {"handle": "glowing"}
    assert words.summary(report) == "mug, blue, glowing red handle"
    report = words.ask(CORE, ("a blue mug with a thick red handle", False))
    assert words.summary(report) == "mug, blue, thick red handle"
    report = words.ask(CORE, ("a birthday cake with five pink candles", False))
    assert words.summary(report) == "cake, 5 pink candles"


def test_its_pose_is_named_after_it_and_before_another_thing():
    report = words.ask(CORE, ("a sleeping grey cat", False))
    assert words.summary(report) == "cat, sleeping, grey"
    report = words.ask(CORE, ("a knight riding a rearing white horse", False))
    assert words.summary(report) == "knight, on: rearing white horse"
    report = words.ask(CORE, ("a low poly blue fox", False))
    assert words.summary(report) == "fox, low poly, blue"


def test_what_is_written_or_drawn_on_it_is_named():
    report = words.ask(CORE, ('a white mug with a red heart that says "HELLO"', False))
    assert words.summary(report) == 'mug, white, "HELLO", red heart'


def test_what_goes_with_it_comes_last():
    lines = {
        "a white rabbit on a wooden chair": "rabbit, white, on: wooden chair",
        "a cat wearing a santa hat": "cat, wears: santa hat",
        "a robot holding a sign that says HELLO": 'robot, holds: signpost ("HELLO")',
    }
    for prompt, line in lines.items():
        assert words.summary(words.ask(CORE, (prompt, False))) == line


def test_how_many_there_are_is_reported():
    lines = {
        "three red apples": "3 × apple, red",
        "a pile of skulls": "7 × skull",
        "an apple": "apple",
        "a basket of green apples": "basket, bears: 6 × green apple",
    }
    for prompt, line in lines.items():
        assert words.summary(words.ask(CORE, (prompt, False))) == line


def test_the_words_are_known_before_the_installation_by_blenders_own_python(tmp_path):
    core = Core(tmp_path / "no python", ROOT)
    assert words.ask(core, ("a mug", False))["thing"] == "mug"
    groups = words.ask(core, (words.GROUPS, False))
    assert len(groups) <= words_menu.MAX_GROUPS
    assert words.ask(Core(tmp_path / "none", tmp_path), ("a mug", False)) == {}


def test_a_prompt_like_an_option_is_a_prompt():
    assert words.ask(CORE, ("--mug", False)).get("thing") == "mug"


def test_without_a_core_nothing_is_shown_and_nothing_is_asked_again():
    reader = words.Words()
    reader.report("a mug")
    reader._since = 0
    reader.tick(None)
    assert reader.report("a mug") == {}
    assert not reader.pending


@pytest.mark.parametrize("question", ["report", "groups"])
def test_what_could_not_be_asked_is_asked_again_later(question):
    reader = words.Words()
    ask = {"report": lambda: reader.report("a mug"), "groups": reader.groups}[question]
    ask()
    reader._since = 0
    reader.tick(None)
    reader._failed -= words.RETRY
    assert not ask()
    assert reader.pending
    answer(reader, ask)
    assert ask()


@pytest.fixture
def settings(ready):
    """With the words' reader answered for each prompt that is set."""

    def set_prompt(prompt: str):
        ready.prompt = prompt
        answer(session.words, lambda: submit.report_of(ready))
        return ready

    return set_prompt


def test_an_unknown_word_disables_generate_until_it_is_replaced_or_ignored(settings):
    prompt = settings("a red Slug")
    assert (
        submit.reason_against_generate(bpy.context)
        == "Replace or ignore the unknown words of the prompt."
    )
    assert not bpy.ops.fantasia3d.generate.poll()
    assert words.unknown(submit.report_of(prompt)) == {"slug": ["snail"]}
    bpy.ops.fantasia3d.replace_word(old="slug", new="snail")
    assert prompt.prompt == "a red snail"
    settings("a red snail")
    assert submit.reason_against_generate(bpy.context) == ""
    settings("a red wombat, a cube")
    prompt.ignore_unknown = True
    settings("a red wombat, a cube")
    assert submit.reason_against_generate(bpy.context) == ""
    from fantasia3d_addon.jobs.job_settings import job_of

    assert job_of(prompt)["ignore_unknown_words"]


def test_another_model_takes_any_word(settings):
    prompt = settings("a wombat")
    prompt.guidance, prompt.hub_id = "hub", "some/model"
    assert submit.reason_against_generate(bpy.context) == ""


@pytest.mark.parametrize(
    ("prompt", "kind", "word", "thing", "result"),
    [
        ("", "thing", "axe", "", "an axe"),
        ("a red chair", "thing", "table", "chair", "a red table"),
        ("a chair", "color", "navy", "chair", "a navy chair"),
        ("a Chair with a hat", "material", "wooden", "chair", "a wooden chair with a hat"),
        ("a mug", "part", "no handle", "mug", "a mug without a handle"),
        ("a chair", "part", "armrests", "chair", "a chair with armrests"),
        ("a table", "part", "four legs", "table", "a table with four legs"),
        ("something odd", "thing", "mug", "", "something odd mug"),
        ("a couch", "color", "red", "sofa", "a couch red"),
    ],
)
def test_a_word_goes_where_it_belongs(prompt, kind, word, thing, result):
    assert words.with_word(prompt, kind, word, thing) == result


def test_every_word_of_the_menu_makes_a_prompt_that_is_understood():
    sys.path.insert(0, str(ROOT))
    pytest.importorskip("torch")
    from core.guidance.builtin.words.groups import word_groups
    from core.guidance.builtin.words.vocabulary import words_report

    for group in word_groups():
        for word in group["words"]:
            thing = group["of"][word][0] if "of" in group else "chair"
            prompt = words.with_word(f"a {thing}", group["kind"], word, thing)
            assert words_report(prompt)[1] == 0, prompt


class Recorder:
    """A layout that keeps what is drawn."""

    def __init__(self) -> None:
        self.texts: list[str] = []
        self.operators: list[str] = []

    def __getattr__(self, name):
        def record(*args, text="", **more):
            self.texts.append(text or " ".join(map(str, args[-1:])))
            if name == "operator":
                self.operators.append(args[0])
            return self

        return record

    def __setattr__(self, name, value):
        self.__dict__[name] = value


@pytest.mark.parametrize("prompt", ["a red wooden office chair", "a slug and a minaret", "red"])
def test_the_panel_shows_it_in_a_few_short_lines(settings, prompt, monkeypatch):
    from fantasia3d_addon.ui import text

    settings(prompt)
    answer(session.words, lambda: session.words.groups() or None)
    monkeypatch.setattr(text, "wrapped", lambda line, width: [line])
    layout = Recorder()
    words_menu.draw_understood(layout, bpy.context)
    assert sum(map(len, layout.texts)) < 260
    assert not any("--" in shown for shown in layout.texts)
    if "chair" in prompt:
        assert "office chair, red, wooden: 1.1 m" in layout.texts
    if "slug" in prompt:
        assert layout.operators == ["fantasia3d.replace_word"] * 4


@pytest.mark.parametrize(
    ("prompt", "size", "line"),
    [
        ("a robot 2 m tall", 0.0, "robot: 2 m (height)"),
        ("a 60 cm robot", 0.0, "robot: 60 cm"),
        ("a robot 2 m tall", 0.5, "robot: 50 cm"),  # what is set in the panel is the longest side
    ],
)
def test_the_panel_states_of_which_side_a_stated_size_is(settings, prompt, size, line, monkeypatch):
    from fantasia3d_addon.ui import text

    settings(prompt)
    bpy.context.scene.fantasia3d.size = size
    answer(session.words, lambda: session.words.report(prompt))
    monkeypatch.setattr(text, "wrapped", lambda line, width: [line])
    layout = Recorder()
    words_menu.draw_understood(layout, bpy.context)
    assert line in layout.texts
