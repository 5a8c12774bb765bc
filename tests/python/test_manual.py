"""The examples of the manual's page on Python, run as a reader does: in order, in an empty folder."""

import contextlib
import io
import os

import pytest
from conftest import TREE

PAGE = TREE / "app" / "manual" / "python.md"


def blocks():
    """The page's Python blocks: line, code, and what the block right below says it prints."""
    found, language, begun, lines, below = [], None, 0, [], None
    for number, line in enumerate(PAGE.read_text().splitlines(), 1):
        if line.startswith("```") and language is None:
            language, begun, lines = line[3:], number, []
        elif line.startswith("```"):
            text = "\n".join(lines)
            if language == "python":
                found.append([begun, text, None])
                below = number
            elif language == "" and below and begun <= below + 2:
                found[-1][2] = text
            language = None
        elif language is not None:
            lines.append(line)
        elif line:
            below = None
    return found


@pytest.fixture(scope="module")
def reader(tmp_path_factory):
    """The reader's names, in an empty folder."""
    before = os.getcwd()
    os.chdir(tmp_path_factory.mktemp("reader"))
    yield {"__name__": "__main__"}
    os.chdir(before)


@pytest.mark.parametrize("line, code, expected", blocks(), ids=lambda value: str(value) if isinstance(value, int) else "")
def test_example(line, code, expected, reader):
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(compile("\n" * line + code, str(PAGE), "exec"), reader)
    if expected is not None:
        assert printed.getvalue().rstrip("\n") == expected


def test_the_page_has_examples_with_output():
    assert len([expected for _, _, expected in blocks() if expected]) >= 5
