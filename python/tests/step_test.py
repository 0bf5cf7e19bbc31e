# SPDX-License-Identifier: Apache-2.0
"""A simulation step by step is the run: step_test.py PROGRAM (which is not used)."""

import os
import subprocess
import sys
import unittest

import numpy as np
from interrupt import interrupt

import trammel
from trammel import _core
from trammel.step import _Field

TWIN = {"engine": "twin"}


class Steps(unittest.TestCase):
    def test_steps_of_any_length_give_the_events_of_a_run(self):
        for engine in ("rtl", "twin"):
            whole = trammel.run("circle", engine=engine, **{"run.max_s": 0.2})
            simulation = trammel.open("circle", engine=engine, **{"run.max_s": 0.2})
            for seconds in (20e-9, 1e-6, 0.00123, 0.05, 0.0101):
                before = simulation.time_s
                after = simulation.advance(seconds)
                self.assertGreaterEqual(after - before, seconds - 1e-9)
                self.assertLess(after - before, seconds + 300e-6)
                self.assertEqual(after, simulation.time_s)
            result = simulation.finish()
            self.assertEqual(result.event_hash, whole.event_hash)
            self.assertEqual(result["x_encoder_count"].tobytes(),
                             whole["x_encoder_count"].tobytes())
            self.assertTrue(simulation.over)
            self.assertRaisesRegex(trammel.ConfigError, "over", simulation.advance, 1)

    def test_every_machine_can_be_stepped(self):
        tried = set()
        for scenario in trammel.scenarios():
            asked = trammel.settings(scenario, **{"run.max_s": 0.03})
            if asked.machine in tried:
                continue
            tried.add(asked.machine)
            simulation = trammel.open(asked)
            while not simulation.over:
                simulation.advance(0.004)
            self.assertEqual(simulation.finish().event_hash, trammel.run(asked).event_hash,
                             scenario)
        self.assertEqual(sorted(tried), sorted(_core.machines()))

    def test_registers_are_read_and_written(self):
        simulation = trammel.open("circle", **TWIN)
        simulation.advance(0.3)
        tick = simulation.read("TICK")
        self.assertAlmostEqual(tick / 2000, simulation.time_s, delta=0.001)
        self.assertEqual(simulation.read(simulation.registers["TICK"]), tick)
        position = simulation.read("x.POS")
        self.assertNotEqual(position, 0)
        kept = simulation.read("x.KP")
        simulation.write("x.KP.mant", 77)
        self.assertEqual(simulation.read("x.KP.mant"), 77)
        self.assertEqual(simulation.read("x.KP") >> 16, kept >> 16)
        simulation.write("x.KP", kept)
        self.assertEqual(simulation.read("x.KP"), kept)
        simulation.write("x.IQ_MANUAL", -3)
        self.assertEqual(simulation.read("x.IQ_MANUAL"), -3)

    def test_a_write_has_its_effect(self):
        """The drives off: the gates go low, and the run is another."""
        simulation = trammel.open("circle", **TWIN)
        simulation.advance(0.3)
        seen = set()
        for _ in range(20):
            simulation.advance(7e-6)
            seen.add(simulation.outputs)
        self.assertGreater(len(seen), 1)
        for axis in ("x", "y"):
            simulation.write(f"{axis}.CTRL.enable", 0)
        simulation.advance(1e-4)
        self.assertEqual(simulation.outputs, 0)
        self.assertNotEqual(simulation.inputs, 0)
        self.assertNotEqual(simulation.finish().end, "done")

    def test_where_a_machine_is(self):
        simulation = trammel.open("circle", **TWIN)
        simulation.advance(0.3017)
        x, at = simulation.position("x"), simulation.time_s
        self.assertEqual((x.unit, sorted(simulation.positions)), ("m", ["x", "y"]))
        result = simulation.finish()
        self.assertAlmostEqual(x, np.interp(at, result["t_s"], result["x_position_m"]), delta=1e-6)
        self.assertEqual(result.event_hash, trammel.run("circle", **TWIN).event_hash)

    def test_every_machine_tells_where_it_is_as_its_trace_does(self):
        tried = set()
        for scenario in trammel.scenarios():
            asked = trammel.settings(scenario, engine="twin", **{"run.max_s": 0.4})
            if asked.machine in tried:
                continue
            tried.add(asked.machine)
            simulation = trammel.open(asked)
            simulation.advance(0.3)
            places = simulation.positions
            units = {figure.unit for figure in places.values()}
            self.assertEqual(len(units), 1, scenario)
            with self.assertRaisesRegex(trammel.SettingError, "there are '.?'"):
                simulation.position("z")
            result = simulation.stop()
            self.assertLess(units, set(result.units.values()))
            for axis, place in places.items():
                self.check_place(result, axis, place, scenario)

    def check_place(self, result, axis, place, scenario):
        """A column of the axis is there at the end, but for the motion of a sample."""
        last, near = {}, []
        for name, unit in result.units.items():
            if unit != place.unit or (axis and not name.startswith(f"{axis}_")):
                continue
            column = np.asarray(result[name], dtype=float)
            last[name] = column[-1]
            if abs(place - column[-1]) <= np.abs(np.diff(column)).max() + 1e-9:
                near.append(name)
        self.assertNotEqual(near, [], f"{scenario}: {axis} at {place}, its last sample {last}")

    def test_words_of_a_chip_are_those_of_the_trace(self):
        machines, compared = set(), set()
        for scenario in trammel.scenarios():
            asked = trammel.settings(scenario, engine="twin", **{"run.max_s": 0.4})
            if asked.machine in machines:
                continue
            machines.add(asked.machine)
            simulation = trammel.open(asked)
            simulation.advance(0.3)
            words = {name: simulation.signal(name) for name in simulation.signals}
            self.assertEqual(len(words), len(simulation.signals), scenario)
            with self.assertRaises(trammel.SettingError) as told:
                simulation.signal("no")
            self.assertEqual(str(told.exception), "signal no: not of this machine; there are "
                             + (", ".join(words) or "none"))
            result = simulation.stop()
            for name, value in words.items():
                column = name.replace(".", "_")
                if column in result and result[column].dtype == np.int64:
                    self.assertIn(value, result[column][-3:], f"{scenario}: {name}")
                    compared.add((asked.machine, name, value))
        self.assertGreater(len({value for *_, value in compared}), 8, compared)

    def test_wrong_names_and_values(self):
        simulation = trammel.open("circle", **TWIN)
        def opened(**keys):
            trammel.open("circle", **keys)

        for call, given, keys in ((simulation.read, ["x.NOTHING"], {}),
                                  (simulation.read, [3], {}),
                                  (simulation.write, ["x.KP.mant", 1 << 11], {}),
                                  (simulation.write, [0, 1 << 32], {}),
                                  (simulation.signal, ["no"], {}),
                                  (simulation.advance, [0], {}),
                                  (simulation.advance, [float("1e99")], {}),
                                  (opened, [], {"run.wave": "fst"}),
                                  (opened, [], {"run.cpu": "rtl"})):
            with self.subTest(call=call.__name__, given=given, keys=keys):
                with self.assertRaises(trammel.ConfigError) as told:
                    call(*given, **keys)
                self.assertNotIn("\n", str(told.exception))
        with self.assertRaises(trammel.SettingError) as told:
            simulation.write("x.KP.mant", 1 << 11)
        self.assertEqual((told.exception.key, told.exception.range), ("x.KP.mant", "0..2047"))
        with self.assertRaisesRegex(trammel.ConfigError, "run.cpu: .* step by step"):
            trammel.open("circle", **{"run.cpu": "rtl"})
        part = next(one for one in map(trammel.open, trammel.scenarios()) if not one.registers)
        with self.assertRaisesRegex(trammel.SettingError, "has no register map; give a byte addr"):
            part.read("STATUS")

    def test_values_just_beyond_their_range(self):
        simulation = trammel.open("circle", **TWIN)
        self.assertRegex(repr(simulation), "^<circle: stands at .* s>$")
        signed = simulation.fields["x.IQ_MANUAL"]
        low = -(1 << signed.bits - 1)
        for call, *given in ((simulation.write, "x.KP.mant", -1),
                             (simulation.write, "x.IQ_MANUAL", low - 1),
                             (simulation.write, "x.IQ_MANUAL", -low),
                             (simulation.write, 0, -(2**31) - 1),
                             (simulation.read, -4), (simulation.read, 1 << 32),
                             (simulation.advance, -1), (simulation.advance, 1e11)):
            with self.subTest(call=call.__name__, given=given):
                self.assertRaises(trammel.SettingError, call, *given)
        for value in (low, -low - 1):
            simulation.write("x.IQ_MANUAL", value)
            self.assertEqual(simulation.read("x.IQ_MANUAL"), value)
        simulation.stop()
        self.assertRegex(repr(simulation), "^<circle: over at .* s>$")

    def test_a_simulation_that_is_dropped_ends(self):
        for _ in range(20):
            trammel.open("circle").advance(1e-3)

    def test_stop_keeps_the_record(self):
        simulation = trammel.open("circle", **TWIN)
        simulation.advance(0.2)
        result = simulation.stop()
        self.assertEqual(result.end, "interrupted")
        self.assertAlmostEqual(result["t_s"][-1], 0.2, delta=0.002)

    def test_a_run_that_fails_says_why_each_time(self):
        script = ("import resource, trammel\n"
                  "resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))\n"
                  "for calls in (('advance', 'advance', 'finish', 'stop', 'finish'),\n"
                  "              ('finish', 'stop')):\n"
                  "    s = trammel.open('circle', engine='twin')\n"
                  "    for call in calls:\n"
                  "        try: getattr(s, call)(*([60] if call == 'advance' else []))\n"
                  "        except OSError as e: print(call, e.errno, s.over)\n"
                  "        except trammel.ConfigError as e: print(call, 'is over', s.over)\n")
        done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True,
                              check=False, timeout=60)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(done.stdout.splitlines(), [
            "advance 27 True", "advance is over True", "finish 27 True", "stop 27 True",
            "finish 27 True", "finish 27 True", "stop 27 True"])

    def test_an_interrupt_leaves_it_standing(self):
        script = ("import trammel, sys\n"
                  "s = trammel.open('circle', **{'run.leap': False})\n"
                  "print('begun', flush=True)\n"
                  "try: s.advance(100)\n"
                  "except KeyboardInterrupt: print(s.over); s.advance(1e-5); sys.exit(7)\n")
        self.assertEqual(interrupt(script, 30), ("begun\nFalse\n", 7))


class Fields(unittest.TestCase):
    def test_a_number_in_its_bits(self):
        signed = _Field(0, 4, 8, 6, True, "")  # bits 4..11, those above 9 repeat the sign
        plain = signed._replace(signed=False)
        for word, number in ((0x1f0, 31), (0x200, -32), (0x3f0, -1), (0xfffff3ff, -1), (0xf, 0),
                             (0x010, 1)):
            self.assertEqual(signed.of(word), number, hex(word))
            self.assertEqual(plain.of(word), number & 63, hex(word))
        for word, number, after in ((0xffffffff, 0, 0xfffff00f), (0, -1, 0xff0), (0, 31, 0x1f0),
                                    (0x12345678, -32, 0x12345e08), (0, 1, 0x10)):
            self.assertEqual(signed.into(word, number), after, (hex(word), number))
            self.assertEqual(signed.of(after), number)

    def test_each_axis_has_its_own(self):
        simulation = trammel.open("circle", **TWIN)
        for axis, other in (("x", "y"), ("y", "x")):
            kept = simulation.read(f"{other}.KP.mant")
            simulation.write(f"{axis}.KP.mant", kept + 7)
            self.assertEqual(simulation.read(f"{other}.KP.mant"), kept, axis)
            self.assertEqual(simulation.read(f"{axis}.KP.mant"), kept + 7)
            simulation.write(f"{axis}.KP.mant", kept)
        for name, field in simulation.fields.items():
            whole = simulation.registers.get(name) or simulation.registers[name.rpartition(".")[0]]
            self.assertEqual(field.address, whole, name)

    def test_a_word_is_written_whole(self):
        simulation = trammel.open("circle", **TWIN)
        at = simulation.registers["x.IQ_MANUAL"]
        for given, kept in ((-(2**31), 0x80000000), (-1, 0xffffffff), (2**32 - 1, 0xffffffff),
                            (5, 5)):
            simulation.write(at, given)
            self.assertEqual(simulation._done[-1], ("write", at, kept))
        with self.assertRaises(trammel.SettingError) as told:
            simulation.position()
        self.assertIn("there are 'x', 'y'", str(told.exception))


class Snapshots(unittest.TestCase):
    def test_a_snapshot_stays_as_it_was_taken(self):
        asked = trammel.settings("circle", **TWIN, **{"run.max_s": 0.05})
        first = trammel.open(asked)
        asked.set("controller", "fc")  # of another run
        first.advance(0.01)
        kept, clock = first.snapshot(), first.clock
        first.advance(0.01)
        restored = trammel.restore(kept)
        self.assertEqual((restored.clock, first.time_s), (clock, first.clock * 20e-9))
        kept.settings.set("controller", "fc")
        for one in (first, restored):
            self.assertEqual(one.snapshot().settings.values["controller"],
                             trammel.settings("circle").values["controller"])
        self.assertEqual(restored.finish().event_hash, trammel.run(
            "circle", **TWIN, **{"run.max_s": 0.05}).event_hash)

    def test_a_restored_simulation_goes_on_as_the_first(self):
        for engine in ("rtl", "twin"):
            first = trammel.open("circle", engine=engine, **{"run.max_s": 0.2})
            first.advance(0.1)
            first.write("x.SHIFT.e", first.read("x.SHIFT.e") + 1)
            first.advance(0.01)
            kept = first.snapshot()
            second = trammel.restore(kept)
            self.assertEqual(second.clock, first.clock)
            other = trammel.restore(kept)
            other.write("x.CTRL.enable", 0)
            ends = [one.finish() for one in (first, second, other)]
            self.assertEqual(ends[0].event_hash, ends[1].event_hash)
            self.assertNotEqual(ends[0].event_hash, ends[2].event_hash)
            self.assertNotEqual(
                ends[0].event_hash,
                trammel.run("circle", engine=engine, **{"run.max_s": 0.2}).event_hash)


if __name__ == "__main__":
    sys.argv[1:] = sys.argv[2:]
    os.environ.pop("TRAMMEL_VERBS", None)
    unittest.main()
