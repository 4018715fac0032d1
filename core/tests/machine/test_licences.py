"""The licences of what is installed: all known, all allowed, listed as they are."""

import importlib.util

import pytest

from core.tests import licences

ROWS = licences.rows()
FIX = "run: run.py python -m core.tests.licences"


def test_every_package_of_the_lock_file_has_a_licence_that_is_allowed():
    here = importlib.util.find_spec("bpy")  # or this environment was made without a group
    assert [row.name for row in ROWS if not row.licence and (here or row.section == "core")] == []
    wrong = [row for row in ROWS if row.licence and licences.refused(row.licence, row.section)]
    assert wrong == []


def test_the_page_lists_what_is_installed():
    page = licences.TABLE.read_text(encoding="utf-8")
    listed = [line for line in page.splitlines() if line.startswith("| ")][1:]
    assert len(listed) == len(ROWS), FIX
    expected = [f"| {' | '.join(row)} |" for row in ROWS if row.licence]
    assert [line for line in expected if line not in listed] == [], FIX


@pytest.mark.parametrize(
    ("expression", "section", "wrong"),
    [
        ("MIT", "core", set()),
        ("(MIT OR Apache-2.0) AND BSD-3-Clause", "core", set()),
        ("MIT AND SSPL-1.0", "core", {"SSPL-1.0"}),
        ("NVIDIA", "core", {"NVIDIA"}),
        ("NVIDIA", "cuda", set()),
        ("Apache-2.0 WITH LLVM-exception", "test", set()),
    ],
)
def test_a_licence_that_is_not_on_the_list_is_seen(expression, section, wrong):
    assert licences.refused(expression, section) == wrong
