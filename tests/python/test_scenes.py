"""Sources of plants: what load() and grow() take is what `tractus grow` takes."""

import json
import struct

import numpy as np
import pytest
import tractus

SAME = {
    "a model": (["shrub", "-n", "5", "--seed", "3"], ["shrub"], {"steps": 5, "seed": 3}),
    "a habit": (["--habit", "birch", "--years", "6", "--seed", "2"], [], {"habit": "birch", "years": 6, "seed": 2}),
    "a stand": (
        ["--habit", "oak", "--years", "3", "--stand", "3", "--spacing", "2"],
        [],
        {"habit": "oak", "years": 3, "stand": 3, "spacing_m": 2},
    ),
    "a habit from a model": (
        ["shrub", "--habit", "pine", "--years", "2"],
        ["shrub"],
        {"habit": "pine", "years": 2},
    ),
    "growth": (
        ["birch", "--growth", "usual", "--variability", "2", "--along-ground", "--seed", "9"],
        ["birch"],
        {"growth": "usual", "variability": 2, "along_ground": True, "seed": 9},
    ),
    "a season": (["broadleaf", "--season", "bare"], ["broadleaf"], {"season": "bare"}),
    "a month": (["broadleaf", "--season", "10.5"], ["broadleaf"], {"season": 10.5}),
}


@pytest.mark.parametrize("name", SAME)
def test_plants_are_those_of_the_program(name, program):
    options, arguments, keywords = SAME[name]
    program("grow", *options, "-o", "plant.mtg")
    plant = tractus.grow(*arguments, **keywords)
    assert plant.to_mtg() == (program.folder / "plant.mtg").read_text()


def test_a_session_is_a_plant(program, tree):
    session = tree / "tests" / "fixtures" / "format4.tractus"
    program("grow", session, "-o", "plant.mtg")
    assert tractus.grow(session).to_mtg() == (program.folder / "plant.mtg").read_text()


def test_a_drawing_shapes_a_plant(program, tree):
    log = tree / "app" / "demo" / "shrub.tractus-log"
    program("grow", "shrub", "--drawing", log, "-o", "plant.mtg")
    scene = tractus.load("shrub", drawing=log)
    assert scene.plant().to_mtg() == (program.folder / "plant.mtg").read_text()
    assert scene.plant().to_mtg() != tractus.grow("shrub").to_mtg()


def test_a_plant_of_another_program_is_one_too(program):
    tractus.grow("shrub", steps=5).save(program.folder / "shrub.mtg")
    program("grow", "shrub.mtg", "-o", "again.mtg")
    assert tractus.grow(program.folder / "shrub.mtg").to_mtg() == (program.folder / "again.mtg").read_text()


def test_variants_are_those_of_a_collection(program):
    program("vary", "shrub", "--count", 4, "--seed", 5, "-o", "plants", "--sides", 16, "--organ-error", 0)
    variants = tractus.load("shrub", growth="usual", seed=5).variants(4, 5)
    files = sorted((program.folder / "plants").glob("*.glb"))
    assert len(files) == len(variants) == 4
    counts = [variant.mesh().triangle_count for variant in variants]
    assert counts == [triangles_of(file) for file in files]
    assert len(set(counts)) > 1


def triangles_of(path):
    data = path.read_bytes()
    gltf = json.loads(data[20 : 20 + struct.unpack_from("<I", data, 12)[0]])
    return sum(
        gltf["accessors"][primitive["indices"]]["count"] // 3
        for mesh in gltf["meshes"]
        for primitive in mesh["primitives"]
    )


def test_variants_differ_and_are_the_same_again():
    scene = tractus.load("shrub", growth="usual")
    variants = scene.variants(5)
    assert [plant.name for plant in variants] == [f"shrub {number}" for number in range(1, 6)]
    texts = {plant.to_mtg() for plant in variants}
    assert len(texts) == 5
    assert {plant.to_mtg() for plant in scene.variants(3, first=2)} < texts
    assert scene.variants(0) == []


def test_variants_without_differences_are_all_alike():
    scene = tractus.load("shrub")
    same = scene.variants(3, branches=0, sizes=0, younger=0, leaf_size=0, own_seeds=0)
    assert len({plant.to_mtg() for plant in same}) == 1
    # Growing rounds.
    drawn = scene.plant().node_positions_mm
    assert np.allclose(same[0].node_positions_mm, drawn, atol=1e-6)


def test_a_models_scene_is_that_of_its_file():
    assert tractus.Model("shrub").grow(5, 3).to_mtg() == tractus.grow("shrub", steps=5, seed=3).to_mtg()
    taller = tractus.Model("birch").with_constants(SHOOT=96).grow()
    height_mm = lambda plant: np.ptp(plant.bounds_mm, axis=0)[2]
    assert height_mm(taller) > 1.5 * height_mm(tractus.grow("birch"))


REFUSED = {
    "nothing": ([], [], {}),
    "an unknown model": (["brich"], ["brich"], {}),
    "an unknown habit": (["--habit", "bjerk"], [], {"habit": "bjerk"}),
    "steps of a habit": (["--habit", "oak", "-n", "3"], [], {"habit": "oak", "steps": 3}),
    "a crown without an outline": (["--habit", "oak", "--fill"], [], {"habit": "oak", "fill": True}),
    "a stand of a model": (
        ["birch", "--habit", "oak", "--stand", "2"],
        ["birch"],
        {"habit": "oak", "stand": 2},
    ),
    "a log that is not there": (["birch", "--drawing", "no.log"], ["birch"], {"drawing": "no.log"}),
}


@pytest.mark.parametrize("name", REFUSED)
def test_refusals_are_the_programs_sentences(name, program):
    options, arguments, keywords = REFUSED[name]
    with pytest.raises(tractus.Error) as caught:
        tractus.grow(*arguments, **keywords)
    done = program.run("grow", *options, "-o", "plant.mtg")
    assert done.returncode != 0
    if name == "an unknown habit": # The command line refuses it before the program looks for it.
        assert "bjerk" in str(caught.value)
    else:
        assert done.stderr.splitlines()[-1] == f"error: {caught.value}"


def test_numbers_out_of_range_are_refused():
    for keywords in ({"years": 0}, {"stand": 1000}, {"spacing_m": 0}, {"variability": 5}):
        ((name, value),) = keywords.items()
        with pytest.raises(tractus.Error, match=f"{name} is {value}: it must be"):
            tractus.grow(habit="oak", **keywords)
    with pytest.raises(tractus.Error, match="branches is 0.9: it must be 0 to 0.5"):
        tractus.load("shrub", steps=2).variants(1, branches=0.9)
    with pytest.raises(tractus.Error, match="month"):
        tractus.grow("shrub", season="never")


def test_warnings_are_the_programs(program):
    (program.folder / "odd.l").write_text("Lsystem: 1\nderivation length: 1\nAxiom: F(UNKNOWN)\nendlsystem\n")
    said = program.run("grow", "odd.l", "-o", "odd.mtg").stderr
    scene = tractus.load(program.folder / "odd.l")
    assert scene.warnings
    assert scene.warnings == tractus.Model(program.folder / "odd.l").warnings
    for warning in scene.warnings:
        assert warning.split(":")[-1].strip() in said
