"""Plants: their arrays against the files that the program writes of the same plants."""

import gc
import json
import weakref

import numpy as np
import pytest
import tractus


@pytest.fixture(scope="module")
def birch():
    return tractus.grow("birch")


def test_mtg_is_that_of_the_program(birch, program):
    program("grow", "birch", "-o", "birch.mtg")
    assert birch.to_mtg() == (program.folder / "birch.mtg").read_text()


def test_a_plant_comes_back_from_its_mtg(birch):
    again = tractus.Plant.from_mtg(birch.to_mtg(), "again")
    assert len(again.segment_parents) == len(birch.segment_parents)
    # Positions are written with nine digits.
    assert np.allclose(again.bounds_mm, birch.bounds_mm, atol=1e-4)
    with pytest.raises(tractus.Error, match="^broken"):
        tractus.Plant.from_mtg("no graph", "broken")


def test_measures_are_those_of_the_program(birch, program):
    assert birch.measures() == json.loads(program("grow", "birch", "--report"))


def test_nodes_are_those_of_the_graph(birch):
    """The graph has the upper end of each segment, and of one without length below each trunk."""
    lines = birch.to_mtg().splitlines()
    header = next(number for number, line in enumerate(lines) if line.startswith("ENTITY-CODE"))
    first = lines[header].split("\t").index("XX")
    ends = []
    for line in lines[header + 1 :]:
        cells = line.split("\t")
        entity = "".join(cells[:first]).lstrip("^/<+")
        if entity.startswith("S"):
            ends.append([float(cell) for cell in cells[first : first + 3]])
    trunks = birch.axes["first_node"][birch.axis_parents == -1]
    nodes = np.concatenate([birch.segment_nodes[:, 1], trunks])
    sort = lambda rows: np.array(sorted(map(tuple, np.round(rows, 4))))
    assert np.allclose(sort(birch.node_positions_mm[nodes]), sort(ends), atol=1e-3)


def test_axes_make_one_tree(birch):
    axes = birch.axes
    assert len(birch.node_positions_mm) == len(birch.node_radii_mm)
    assert len(birch.node_positions_mm) == (axes["segment_count"] + 1).sum()
    laterals = axes["parent_axis"] >= 0
    assert (axes["parent_axis"][laterals] < np.nonzero(laterals)[0]).all()
    assert (axes["order"][laterals] == axes["order"][axes["parent_axis"][laterals]] + 1).all()
    assert (axes["order"][~laterals] == 0).all()
    assert (birch.axis_orders == axes["order"]).all()
    assert (birch.axis_parents == axes["parent_axis"]).all()


def test_segments_know_the_segment_below(birch):
    parents, nodes, axes = birch.segment_parents, birch.segment_nodes, birch.segment_axes
    first = birch.axes["first_segment"]
    assert (parents[first] == birch.axes["parent_segment"]).all()
    inner = np.setdiff1d(np.arange(len(parents)), first)
    assert (parents[inner] == inner - 1).all()
    assert (nodes[inner, 0] == nodes[inner - 1, 1]).all()
    assert (axes[inner] == axes[inner - 1]).all()
    assert (np.bincount(axes) == birch.axes["segment_count"]).all()


def test_organs_stand_at_the_ends_of_their_segments(birch):
    organs = birch.organs
    assert len(organs) == birch.measures()["organs"]
    assert np.allclose(np.linalg.norm(organs["orientation"], axis=1), 1)
    attached = organs["segment"] >= 0
    ends = birch.node_positions_mm[birch.segment_nodes[organs["segment"][attached], 1]]
    away_mm = np.linalg.norm(organs["position_mm"][attached] - ends, axis=1)
    radii = birch.node_radii_mm[birch.segment_nodes[organs["segment"][attached], 1]]
    assert (away_mm <= radii + 1e-6).all()
    shapes = birch.organ_shapes
    assert organs["shape"].max() < len(shapes)
    assert {shape.kind for shape in shapes} <= {"blade", "needle", "disc", "ball", "surface", "leaf"}


@pytest.mark.parametrize(
    "name", ["node_positions_mm", "node_radii_mm", "axes", "axis_orders", "axis_parents", "organs"]
)
def test_arrays_are_not_copied_and_outlive_the_plant(name):
    plant = tractus.grow("shrub", steps=4)
    array = getattr(plant, name)
    assert np.shares_memory(array, getattr(plant, name))
    assert not array.flags.writeable
    with pytest.raises(ValueError):
        array.flags.writeable = True
    kept = array.copy()
    del plant
    gc.collect()
    for _ in range(20): # Other plants would take the memory if it were free.
        tractus.grow("shrub", steps=4, seed=2)
    assert (array == kept).all()


def test_an_array_lets_its_plant_go():
    array = tractus.grow("shrub", steps=4).node_positions_mm
    keeper = weakref.ref(array)
    del array
    gc.collect()
    assert keeper() is None


def test_an_empty_plant_has_empty_arrays():
    empty = tractus.Model.from_text("Lsystem: 1\nderivation length: 0\nAxiom: A\nendlsystem\n").grow()
    assert empty.node_positions_mm.shape == (0, 3)
    assert empty.axes.shape == empty.organs.shape == empty.axis_orders.shape == (0,)
    assert empty.segment_nodes.shape == (0, 2)
    assert empty.bounds_mm is None
    assert empty.mesh().triangle_count == 0


@pytest.mark.parametrize("ending", [".glb", ".obj", ".usda", ".ply", ".stl", ".mtg"])
def test_files_are_those_of_the_program(ending, program):
    plant = tractus.grow("daisy")
    folder = program.folder / "module"
    folder.mkdir()
    said = program("grow", "daisy", "-o", f"daisy{ending}")
    written = plant.save(folder / f"daisy{ending}")
    mine = {path.name: path.read_bytes() for path in folder.iterdir()}
    assert f"daisy{ending}" in mine
    for name, data in mine.items():
        assert data == (program.folder / name).read_bytes(), name
    if ending != ".mtg":
        assert f" {written.triangles} triangles" in said
    assert written.note in said


def test_options_of_files_are_those_of_the_program(program):
    plant = tractus.grow("daisy")
    program("grow", "daisy", "-o", "small.glb", "--organs", "instanced", "--compressed")
    plant.save(program.folder / "mine.glb", organs="instanced", vertices="compressed")
    # The name inside the file is the plant's, not the file's.
    assert (program.folder / "mine.glb").read_bytes() == (program.folder / "small.glb").read_bytes()
    program("grow", "daisy", "-o", "solid.stl", "--without-leaves", "--print-height", 100)
    plant.save(program.folder / "mine.stl", without_leaves=True, print_height_mm=100)
    assert (program.folder / "mine.stl").read_bytes() == (program.folder / "solid.stl").read_bytes()


def test_wrong_options_are_refused_in_a_sentence(birch, tmp_path):
    refused = {
        "birch.txt": ({}, r"birch.txt: a plant is written as \.glb"),
        "a.glb": ({"organs": "many"}, "organs is many: it must be merged, instanced or nodes"),
        "b.glb": ({"vertices": "tiny"}, "vertices is tiny: it must be float, quantized or compressed"),
        "c.stl": ({"print_height_mm": 0}, "print_height_mm is 0: it must be 0.1 to"),
        "d.png": ({"width": 3}, "a picture of 3 by 960 pixels cannot be made"),
        "file/e.glb": ({}, "file"),
    }
    (tmp_path / "file").write_text("no folder")
    for name, (options, sentence) in refused.items():
        with pytest.raises(tractus.Error, match=sentence):
            birch.save(tmp_path / name, **options)
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


def test_a_picture_is_an_array_of_its_size(program):
    plant = tractus.grow("daisy")
    try:
        picture = plant.picture(160, 120)
    except tractus.Error as error:
        pytest.skip(str(error)) # The system has no OpenGL.
    assert (picture.shape, picture.dtype) == ((120, 160, 4), np.uint8)
    assert len(np.unique(picture.reshape(-1, 4), axis=0)) > 100
    assert plant._repr_png_().startswith(b"\x89PNG\r\n")
    with pytest.raises(tractus.Error, match="a picture of 10 by 10 pixels cannot be made"):
        plant.picture(10, 10)
