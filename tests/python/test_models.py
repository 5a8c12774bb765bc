"""L-systems: texts, strings and counts are those of the program."""

import json
import pathlib

import numpy as np
import pytest
import tractus

GROWING = """Lsystem: 1
#define ANGLE 30 /* degrees */
#define STEPS 4 // so many
derivation length: STEPS
Axiom: A(1)
A(x) --> F(x)[+(ANGLE)A(x*0.5)][-(ANGLE)A(x*0.5)]
endlsystem
"""


@pytest.mark.parametrize("name", tractus.model_names())
def test_string_and_counts_are_those_of_the_program(name, program):
    string = tractus.Model(name).derive(steps=4, seed=7)
    assert str(string) + "\n" == program("derive", name, "--string", "-n", 4, "--seed", 7)
    assert string.counts() == json.loads(program("derive", name, "--count", "-n", 4, "--seed", 7))


def test_homomorphism_is_that_of_the_program(program):
    image = tractus.Model("birch").derive(steps=5).homomorphism()
    assert str(image) + "\n" == program("derive", "birch", "--string", "--homomorphism", "-n", 5)


def test_a_path_reads_the_file_and_the_view_beside_it(tmp_path):
    (tmp_path / "mine.l").write_text(GROWING)
    (tmp_path / "mine.v").write_text("angle factor: 8\n")
    model = tractus.Model(tmp_path / "mine.l")
    assert (model.name, model.steps, model.text) == ("mine", 4, GROWING)
    assert "angle factor: 8" in model.view
    assert str(model.derive(1)) == "F(1)[+(30)A(0.5)][-(30)A(0.5)]"


def test_a_text_is_a_model_with_includes():
    text = '#include "rules.h"\nLsystem: 1\nderivation length: 1\nAxiom: A\nA --> F(LENGTH)\nendlsystem\n'
    model = tractus.Model.from_text(text, includes={"rules.h": "#define LENGTH 12\n"})
    assert str(model.derive()) == "F(12)"
    with pytest.raises(tractus.Error, match="model.l includes rules.h, which is missing"):
        tractus.Model.from_text(text)


def test_constants_are_the_numbers_of_the_rules():
    model = tractus.Model.from_text(GROWING)
    assert model.constants == {"ANGLE": 30.0, "STEPS": 4.0}
    other = model.with_constants(ANGLE=-22.5, STEPS=1)
    assert other.text == GROWING.replace("30 /*", "-22.5 /*").replace("4 //", "1 //")
    assert str(other.derive()) == "F(1)[+(-22.5)A(0.5)][-(-22.5)A(0.5)]"
    assert model.text == GROWING


def test_a_constant_that_is_not_there_is_refused():
    model = tractus.Model.from_text(GROWING)
    with pytest.raises(tractus.Error, match=r"no constant ANGEL \(did you mean ANGLE\?\): it has ANGLE, STEPS"):
        model.with_constants(ANGEL=3)
    with pytest.raises(tractus.Error, match="the constant ANGLE is inf: give a finite number"):
        model.with_constants(ANGLE=float("inf"))


def test_letters_and_parameters_are_those_of_the_text():
    string = tractus.Model.from_text(GROWING).derive(3)
    assert b"".join(string.letters).decode() == "".join(c for c in str(string) if c not in "(),.0123456789")
    places, parameters = string.modules("F")
    assert (string.letters[places] == b"F").all()
    assert parameters.shape == (7, 1)
    assert sorted(parameters[:, 0]) == [0.25] * 4 + [0.5] * 2 + [1.0]
    width = np.array([count for _, count in string.kinds])
    assert width[string.kind_ids].sum() == len(string.parameters)
    assert len(string) == len(string.letters) == len(string.kind_ids)


def test_a_letter_with_several_numbers_of_parameters_needs_a_choice():
    rules = "Lsystem: 1\nderivation length: 0\nAxiom: FF(2)F(3,0.5)\nendlsystem\n"
    string = tractus.Model.from_text(rules).derive()
    assert string.modules("F", 0)[1].shape == (1, 0)
    assert string.modules("F", 2)[1].tolist() == [[3.0, 0.5]]
    with pytest.raises(tractus.Error, match="different numbers of parameters: say how many"):
        string.modules("F")
    with pytest.raises(tractus.Error, match="has no module Q"):
        string.modules("Q")


def test_arrays_show_the_strings_own_memory_and_keep_it():
    string = tractus.Model.from_text(GROWING).derive(3)
    ids, parameters = string.kind_ids, string.parameters
    assert np.shares_memory(ids, string.kind_ids)
    assert not ids.flags.writeable
    with pytest.raises(ValueError, match="read-only"):
        parameters[0] = 1
    before = (ids.copy(), parameters.copy())
    del string
    for _ in range(20): # Other strings would take the memory if it were free.
        tractus.Model.from_text(GROWING).derive(5, seed=3)
    assert (ids == before[0]).all()
    assert (parameters == before[1]).all()


def resident_bytes():
    pages = int(pathlib.Path("/proc/self/statm").read_text().split()[1])
    return pages * 4096


def test_ten_million_modules_take_the_memory_of_their_letters_and_parameters():
    rules = "Lsystem: 1\nderivation length: 23\nAxiom: A\nA --> F(1)AA\nendlsystem\n"
    model = tractus.Model.from_text(rules)
    string = model.derive()
    assert len(string) > 10_000_000
    assert string.nbytes == len(string) + 4 * string.counts()["F"]
    before = resident_bytes()
    views = [string.kind_ids for _ in range(50)] + [string.parameters for _ in range(50)]
    # A hundred copies would be two gigabytes.
    assert sum(view.nbytes for view in views) > 2_000_000_000
    assert resident_bytes() - before < 10_000_000


def test_limits_end_a_derivation_with_the_programs_sentence(program):
    rules = "Lsystem: 1\nderivation length: 40\nAxiom: A\nA --> AA\nendlsystem\n"
    (program.folder / "model.l").write_text(rules)
    with pytest.raises(tractus.Error) as caught:
        tractus.Model.from_text(rules).derive(max_modules=1000)
    assert str(caught.value) == program.error("derive", "model.l", "--count", "--max-modules", 1000)
    assert caught.value.fault == "user"


@pytest.mark.parametrize("arguments", [["nothing"], ["brich"], ["/nowhere/model.l"]])
def test_errors_are_the_programs_sentences(arguments, program):
    with pytest.raises(tractus.Error) as caught:
        tractus.Model(*arguments)
    assert str(caught.value) == program.error("derive", *arguments, "--count")


def test_an_error_in_the_text_says_where():
    with pytest.raises(tractus.Error, match=r"^mine\.l:3:\d+: "):
        tractus.Model.from_text("Lsystem: 1\nAxiom: A\nA --> F(\nendlsystem\n", name="mine.l")
    with pytest.raises(tractus.Error, match="steps is -1: it must be 0 to 1000000000$"):
        tractus.Model("birch").derive(-1)
