"""Recordings: strokes and rigs are those that the program finds in the same files."""

import json

import numpy as np
import pytest
import tractus


@pytest.fixture(scope="module")
def log():
    from conftest import TREE

    return TREE / "app" / "demo" / "shrub.tractus-log"


def test_strokes_are_those_that_the_program_writes(log, program):
    program("convert", log, "-o", "drawing.strokes")
    # The program writes only strokes of tools that draw lines.
    drawn = [stroke for stroke in tractus.replay(log).strokes if stroke.tool == "draw"]
    written = tractus.replay(program.folder / "drawing.strokes")
    assert len(drawn) == len(written) > 0
    for stroke, other in zip(drawn, written.strokes):
        assert stroke.tips.shape == (len(stroke), 5)
        assert np.allclose(stroke.tips[:, :4], other.tips[:, :4], atol=2e-3)
    assert written.reports == 0


def test_tips_are_in_order_and_in_range(log):
    recording = tractus.replay(log)
    assert recording.reports > 1000
    ends = -1.0
    for stroke in recording.strokes:
        x, y, z, pressure, t = stroke.tips.T
        assert t[0] > ends
        assert (np.diff(t) >= 0).all()
        ends = t[-1]
        assert ((pressure >= 0) & (pressure <= 1)).all()
        assert (np.abs(stroke.tips[:, :3]) < 1000).all()
        assert stroke.tool


def test_strokes_are_those_of_the_stream(log, program):
    lines = map(json.loads, program("stream", log).splitlines())
    strokes = [line for line in lines if line.get("kind", line.get("type")) == "stroke"]
    recording = tractus.replay(log)
    assert len(strokes) == len(recording)
    for told, stroke in zip(strokes, recording.strokes):
        assert told["tool"].split()[0] == stroke.tool
        assert len(told["tips"]) == len(stroke)


def test_another_height_makes_flat_strokes(log):
    for stroke in tractus.replay(log, height="120").strokes:
        assert np.allclose(stroke.tips[:, 2], stroke.tips[0, 2], atol=5)


def test_a_rig_has_units_in_its_keys(log, tmp_path):
    rig = tractus.read_rig(log)
    flat = json.dumps(rig, default=str)
    assert "_mm" in flat
    (tmp_path / "other.rig.toml").write_text("nonsense = 1\n")
    with pytest.raises(tractus.Error, match="other.rig.toml"):
        tractus.read_rig(tmp_path / "other.rig.toml")


def test_errors_are_the_programs_sentences(program):
    (program.folder / "empty.tractus-log").write_text("")
    for name in ("missing.tractus-log", "empty.tractus-log"):
        with pytest.raises(tractus.Error) as caught:
            tractus.replay(program.folder / name)
        said = program.error("convert", program.folder / name, "-o", "x.strokes")
        assert str(caught.value) == said
