"""Long calls let other threads run, and several threads may work at the same time."""

import threading
import signal

import pytest
import tractus

RULES = "Lsystem: 1\nderivation length: 30\nAxiom: A\nA --> AA\nendlsystem\n"


def in_threads(count, work):
    results, errors = [None] * count, []

    def run(number):
        try:
            results[number] = work(number)
        except Exception as error: # Told by the assertion below.
            errors.append(error)

    threads = [threading.Thread(target=run, args=(number,)) for number in range(count)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert errors == []
    return results


def test_two_threads_at_once_make_what_one_makes():
    names = ["birch", "shrub", "daisy", "palm"]

    def work(number):
        plant = tractus.grow(names[number % 4], seed=number // 4 + 1)
        mesh = plant.mesh()
        return plant.to_mtg(), [surface.positions_mm.tobytes() for surface in mesh.surfaces]

    alone = [work(number) for number in range(8)]
    assert in_threads(8, work) == alone


def test_threads_share_a_model_and_a_plant():
    model, plant = tractus.Model("birch"), tractus.grow("birch")
    strings = in_threads(4, lambda number: str(model.derive(6, number % 2)))
    assert strings[0] == strings[2] and strings[1] == strings[3]
    assert len(set(in_threads(4, lambda number: plant.to_mtg()))) == 1


def test_a_long_call_lets_other_threads_run():
    """A derivation that only its limit of modules would end is ended by another thread's flag."""
    begun, ended = threading.Event(), threading.Event()

    def derive():
        begun.set()
        with pytest.raises(tractus.Error):
            tractus.Model.from_text(RULES).derive(1000, max_modules=200_000_000)
        ended.set()

    thread = threading.Thread(target=derive)
    thread.start()
    begun.wait()
    steps = 0
    while not ended.is_set():
        steps += 1 # With the lock held by derive(), this loop would get no turn before the end.
    thread.join()
    assert steps > 1000


def test_ctrl_c_stops_a_model():
    rules = "Lsystem: 1\nderivation length: 1000000000\nAxiom: A\nA --> A\nendlsystem\n"

    def press():
        signal.raise_signal(signal.SIGINT)

    timer = threading.Timer(0.2, press)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        tractus.Model.from_text(rules).derive(max_seconds=0)
    timer.join()
    assert len(tractus.Model.from_text(RULES).derive(3)) == 8
