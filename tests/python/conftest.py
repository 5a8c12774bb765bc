"""What the tests share: the program, with which the module must agree."""

import os
import pathlib
import subprocess

import pytest

TREE = pathlib.Path(__file__).resolve().parents[2]


class Program:
    """The program tractus, in a folder of the test's own."""

    def __init__(self, folder):
        self.folder = folder

    def __call__(self, *arguments):
        done = self.run(*arguments)
        assert done.returncode == 0, done.stderr
        return done.stdout

    def run(self, *arguments):
        command = [os.environ["TRACTUS_PROGRAM"], *map(str, arguments)]
        return subprocess.run(command, cwd=self.folder, capture_output=True, text=True, check=False)

    def error(self, *arguments):
        """The sentence of the program's error."""
        done = self.run(*arguments)
        assert done.returncode == 1, done.stdout
        return done.stderr.splitlines()[-1].removeprefix("error: ")


@pytest.fixture
def program(tmp_path):
    return Program(tmp_path)


@pytest.fixture
def tree():
    """The root of the source tree."""
    return TREE
