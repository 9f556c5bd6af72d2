"""The units as importers run them: test.py FOLDER REFERENCE, where REFERENCE answers as the library in Rust does."""

import math
import pathlib
import random
import struct
import subprocess
import sys
import tempfile

import numpy
from fmpy import extract, read_model_description, simulate_fmu
from fmpy.fmi2 import FMU2Slave
from fmpy.fmi3 import FMU3Slave
from fmpy.validation import validate_fmu

PARAMETERS = {"period": 1e-3, "fastest": 16.0, "damping_limit": 250.0, "device_damping": 0.5, "budget": 1e-3}
INPUTS = ["position", "applied", "effort"]
OUTPUTS = ["command", "observed_energy", "alpha", "shortfall"]
TICKS = 10_000


def bits(number):
    return "%016x" % struct.unpack("<Q", struct.pack("<d", number))[0]


class Unit:
    """An instance of a unit, by names, for both versions."""

    def __init__(self, path, parameters, told=None):
        description = read_model_description(str(path))
        self.places = {variable.name: variable.valueReference for variable in description.modelVariables}
        self.three = description.fmiVersion.startswith("3")
        kind = FMU3Slave if self.three else FMU2Slave
        self.told = told if told is not None else []
        self.slave = kind(
            guid=description.guid,
            unzipDirectory=extract(str(path)),
            modelIdentifier=description.coSimulation.modelIdentifier,
            instanceName="unit",
        )
        self.instantiate()
        if not self.three:
            self.slave.setupExperiment(startTime=0.0)
        self.slave.enterInitializationMode()
        self.set(**parameters)
        self.at_first = self.get(*OUTPUTS)
        self.slave.exitInitializationMode()

    def instantiate(self):
        if self.three:
            from fmpy.fmi3 import fmi3LogMessageCallback

            self.log = fmi3LogMessageCallback(lambda _, status, category, text: self.told.append(text.decode()))
            self.slave.instantiate(logMessage=self.log)
        else:
            self.slave.instantiate()

    def set(self, **values):
        (self.slave.setFloat64 if self.three else self.slave.setReal)([self.places[name] for name in values], list(values.values()))

    def get(self, *names):
        return list((self.slave.getFloat64 if self.three else self.slave.getReal)([self.places[name] for name in names]))

    def accepted(self):
        return int(list(self.slave.getBoolean([self.places["accepted"]]))[0])

    def step(self, tick, step=PARAMETERS["period"]):
        self.slave.doStep(currentCommunicationPoint=tick * PARAMETERS["period"], communicationStepSize=step)

    def tick(self, tick, inputs):
        self.set(**dict(zip(INPUTS, inputs)))
        self.step(tick)
        return [bits(number) for number in self.get(*OUTPUTS)] + [str(self.accepted())]


def own(block):
    return {name: value for name, value in PARAMETERS.items() if block == "lolc" or name != "device_damping"}


def random_ticks():
    """A device that wanders, with readings that no device should tell."""
    chance = random.Random(20)
    position = 0.0
    for _ in range(TICKS):
        position += chance.uniform(-5e-4, 5e-4)
        inputs = [position, chance.uniform(-10.0, 10.0), chance.uniform(-10.0, 10.0)]
        if chance.random() < 0.005:
            inputs[chance.randrange(3)] = chance.choice([math.nan, math.inf, -math.inf, 1e30])
        yield inputs


def refused(action):
    try:
        action()
    except Exception:
        return True
    return False


def equals_rust(path, block, reference):
    ticks = list(random_ticks())
    lines = "".join(" ".join(map(bits, inputs)) + "\n" for inputs in ticks)
    command = [reference, block, *map(repr, own(block).values())]
    expected = [line.split() for line in subprocess.run(command, input=lines, capture_output=True, text=True, check=True).stdout.splitlines()]
    assert len(expected) == TICKS
    unit = Unit(path, own(block))
    for tick, inputs in enumerate(ticks):
        found = unit.tick(tick, inputs)
        assert found == expected[tick], f"{path}, tick {tick}: {found}, and in Rust {expected[tick]}"
    # Both a damper at work and a rejection were among them.
    assert any(line[2] != bits(0.0) for line in expected) and any(line[4] == "0" for line in expected)


def returns_to_a_state(path, block):
    ticks = list(random_ticks())[:200]
    unit = Unit(path, own(block))
    for tick in range(100):
        unit.tick(tick, ticks[tick])
    get, put = ("getFMUState", "setFMUState") if unit.three else ("getFMUstate", "setFMUstate")
    state = getattr(unit.slave, get)()
    first = [unit.tick(tick, ticks[tick]) for tick in range(100, 200)]
    getattr(unit.slave, put)(state)
    assert first == [unit.tick(tick, ticks[tick]) for tick in range(100, 200)]


def initial_values(path, block):
    """What is answered before the initialization ends, and what it depends on."""
    unit = Unit(path, own(block) | {"budget": 0.25})
    assert unit.at_first == unit.get(*OUTPUTS) == [0.0, 0.25, 0.0, 0.0], unit.at_first
    for unknown in read_model_description(str(path)).initialUnknowns:
        expected = ["budget"] if unknown.variable.name == "observed_energy" else []
        assert [it.name for it in unknown.dependencies] == expected, unknown.variable.name


def refuses(path, block):
    told = []
    assert refused(lambda: Unit(path, own(block) | {"damping_limit": -1.0}, told)), "a damping limit below 0 was taken"
    unit = Unit(path, own(block), told)
    assert refused(lambda: unit.step(0, step=2e-3)), "a step that is not the period was taken"
    assert refused(lambda: unit.set(damping_limit=1.0)), "a parameter was changed in a running unit"
    assert refused(lambda: unit.set(command=1.0)), "an output was set"
    if unit.three:
        said = "\n".join(told)
        for expected in ["damping_limit is -1", "it must be the parameter period, 0.001 s", "set it before the initialization ends"]:
            assert expected in said, f"{expected!r} is not in {said!r}"


def late_swing(path, block, stabilized):
    """Swing of the mass of examples/wall.c after a while, on the wall that is too stiff; the unit's force acts a period late."""
    period, mass, stiffness = PARAMETERS["period"], 0.3, 3000.0
    # The library's limit for an effort that is one period late.
    limit = 0.5 * math.tan(math.pi / 8) * mass / period
    told = own(block) | {"fastest": 1e300, "damping_limit": limit, "budget": 0.0}
    unit = Unit(path, told | {"device_damping": 0.2} if block == "lolc" else told)
    position, velocity, force, applied, swing = -4e-3, 0.0, 0.0, 0.0, 0.0
    for tick in range(20_000):
        wall = stiffness * position if position > 0.0 else 0.0
        unit.set(position=position, applied=applied, effort=wall)
        # What acts from now on is what the last step answered.
        applied = unit.get("command")[0] if stabilized else force
        unit.step(tick)
        force = wall
        for _ in range(10):
            velocity += (-50.0 * position - 0.2 * velocity - applied) / mass * (period / 10)
            position += velocity * (period / 10)
        if tick >= 15_000:
            swing = max(swing, abs(position))
    return swing


def runs_by_itself(path, block):
    """As a user runs it: one call, inputs as a table."""
    table = numpy.array([(0.0, 0.0, 0.0, 2.0), (0.05, 1e-3, 0.0, 2.0)], dtype=[("time", float)] + [(name, float) for name in INPUTS])
    result = simulate_fmu(str(path), start_values=own(block), input=table, stop_time=0.1, step_size=1e-3, output_interval=1e-3,
                          output=["command", "accepted"])
    assert result["command"][-1] == 2.0 and bool(result["accepted"][-1])


def main():
    folder, reference = pathlib.Path(sys.argv[1]), sys.argv[2]
    for version in ["fmi2", "fmi3"]:
        for block in ["popc", "lolc"]:
            path = folder / version / f"lyapunov_{block}.fmu"
            problems = validate_fmu(str(path))
            assert not problems, f"{path}: {problems}"
            equals_rust(path, block, reference)
            returns_to_a_state(path, block)
            initial_values(path, block)
            refuses(path, block)
            runs_by_itself(path, block)
            alone, stabilized = late_swing(path, block, False), late_swing(path, block, True)
            assert stabilized < 4.1e-3 and alone > 2 * stabilized, f"{path}: swing {alone} m alone, {stabilized} m with it"
            print(f"{version} {block}: valid, {TICKS} ticks equal Rust's; late swing {alone:.3g} m alone, {stabilized:.3g} m with it")


# Units are unpacked where nothing stays.
with tempfile.TemporaryDirectory() as unpacked:
    tempfile.tempdir = unpacked
    main()
