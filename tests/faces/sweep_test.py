"""Sweeps from outside: the same table whatever stops them, and what is said when one cannot be."""

import json
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import time
import unittest
from pathlib import Path

from face_support import CLI, ROOT, FaceTest, load, run
from schema_test import jsonschema, validator

try:
    import h5py
except ImportError:
    h5py = None

PROGRESS = re.compile(r"linkwright: .* samples .*\n")  # of what takes longer than a few seconds
SWEEPS = sorted((ROOT / "examples/sweeps").glob("*.json"))
TAILGATE = load(ROOT / "examples/tailgate.json")
GENERATOR = load(ROOT / "examples/log_generator.json")


def sweep_of(samples=400, side=300, **more):
    """A tailgate whose third position varies; a few milliseconds a sample."""
    problem = {**TAILGATE, "options": {"region_samples": side}}
    return {"linkwright": 1, "problem": problem, "sampling": {"method": "sobol", "samples": samples},
            "vary": [{"name": "x3", "at": "/task/poses/2/x", "from": -240, "to": -200},
                     {"name": "angle", "at": "/requirements/min_transmission_angle_deg", "from": -5, "to": 90}],
            "keep": {"linkages": 2}, **more}


def limited_to(size):
    """For preexec_fn: files end at so many bytes, as a full disk does."""
    def limit():
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
    return limit


class SweepTest(FaceTest):
    def setUp(self):
        super().setUp()
        self.output = self.folder / "out.h5"
        self.partial = Path(f"{self.output}.partial")

    def sweep(self, content, *more, output=None, **options):
        path = self.folder / "sweep.json"
        path.write_text(json.dumps(content), encoding="utf-8")
        return run("sweep", path, "-o", output or self.output, *more, **options)

    def done(self, content, *more, **options):
        status, words, error = self.sweep(content, *more, **options)
        self.assertEqual((status, PROGRESS.sub("", error)), (0, ""))
        return words

    def start(self, content, *more):
        path = self.folder / "sweep.json"
        path.write_text(json.dumps(content), encoding="utf-8")
        return subprocess.Popen([CLI, "sweep", str(path), "-o", str(self.output), *more], stdout=subprocess.DEVNULL,
                                stderr=subprocess.PIPE)

    def stopped_midway(self, content, how=signal.SIGKILL):
        """Begun, and stopped once something is kept."""
        process = self.start(content)
        journal = self.partial / "000000.journal"
        for _ in range(20000):
            if journal.exists() and journal.stat().st_size > 20000:
                break
            time.sleep(0.005)
        process.send_signal(how)
        error = process.communicate()[1].decode()
        return process.returncode, error

    def whole(self, content):
        path = self.folder / "whole.h5"
        self.done(content, output=path)
        return path.read_bytes()


class Sweeps(SweepTest):
    def test_examples_are_swept(self):
        for example in SWEEPS:
            with self.subTest(example.name):
                output = self.folder / f"{example.stem}.h5"
                status, words, error = run("sweep", example, "-o", output)
                self.assertEqual((status, error), (0, ""))
                self.assertIn("samples are in", words)
                status, words, _ = run("sweep", "--inspect", output)
                self.assertEqual(status, 0)
                self.assertIn("/linkages: ", words)
                self.assertIn("min_transmission_angle_deg", words)
                status, words, _ = run("sweep", example, "--dry-run")
                self.assertEqual(status, 0)
                self.assertIn("A sample takes about", words)

    def test_a_search_is_not_counted_as_a_map_is(self):
        for problem, options in (("loader_bucket", {"effort": 100}), ("straight_search", {"effort": 10})):
            base = load(ROOT / f"examples/{problem}.json")
            base["options"] = {**base.get("options", {}), **options}
            self.done({"linkwright": 1, "problem": base, "sampling": {"method": "list", "rows": [[options["effort"]]]},
                       "vary": [{"name": "effort", "at": "/options/effort"}], "keep": {"linkages": 1}}, "--overwrite")
            _, words, _ = run("sweep", "--inspect", self.output)
            self.assertRegex(words, r"    cells +[1-9]")
            for counted in ("defect_free", "meeting_requirements", "types."):
                self.assertNotIn(f"    {counted}", words.split("/linkages: ")[0])

    @unittest.skipIf(h5py is None, "python3-h5py is not installed")
    def test_numbers_of_loads_vary_and_forces_are_columns(self):
        base = load(ROOT / "examples/tailgate_struts.json")
        base["options"] = {"region_samples": 60, "objective": "hand_force"}
        base["requirements"] = {"min_transmission_angle_deg": 20, "max_link_ratio": 8, "max_length": 450}
        forces = [f"loads.worst.{name}.value" for name in ("max_open_force", "hand_force", "hold_open", "max_pin_force")]
        vary = {"/loads/body/mass": [22, 26], "/loads/springs/0/F1": [300, 400, 600], "/loads/cases/1/temperature_C": [-30, 5]}
        self.done({"linkwright": 1, "problem": base, "sampling": {"method": "grid"},
                   "vary": [{"name": at[1:].replace("/", "."), "at": at, "values": values} for at, values in vary.items()],
                   "keep": {"linkages": 1, "columns": forces}})
        with h5py.File(self.output) as file:
            samples, linkages = file["samples"], file["linkages"]
            self.assertEqual(len(samples["sample"]), 12)
            # F1 of 600 is above F2.
            self.assertEqual([row for row in range(12) if samples["status"][row] == b"invalid"], [4, 5, 10, 11])
            told = {int(sample): [linkages[name][row] for name in forces] for row, sample in enumerate(linkages["sample"])}
            for sample, number in ((1, (22, 300, 5)), (8, (26, 400, -30))):
                base["loads"]["body"]["mass"], base["loads"]["springs"][0]["F1"], base["loads"]["cases"][1]["temperature_C"] = number
                answer = json.loads(run("solve", self.write("one.json", json.dumps(base)), "-o", "-")[1])
                worst = answer["linkages"][0]["loads"]["worst"]
                self.assertEqual(told[sample], [worst[name.split(".")[2]]["value"] for name in forces])

    @unittest.skipIf(h5py is None, "python3-h5py is not installed")
    def test_errors_of_what_comes_near_are_columns(self):
        for name, at, values, block in (("bean_stirrer", ("requirements", "max_length"), [200, 300], "fit"),
                                        ("hatch_all_near", ("task", "turning_length"), [300, 400], "near")):
            base = load(ROOT / f"examples/{name}.json")
            base.setdefault(at[0], {})[at[1]] = values[0]
            self.done({"linkwright": 1, "problem": base, "sampling": {"method": "grid"}, "keep": {"linkages": 1},
                       "vary": [{"name": "wanted", "at": "/" + "/".join(at), "values": values}]}, "--overwrite")
            with h5py.File(self.output) as file:
                told = list(file["linkages"][f"{block}.error.rms"])
            self.assertEqual(len(told), len(values))
            for value, rms in zip(values, told):
                base[at[0]][at[1]] = value
                answer = json.loads(run("solve", self.write("one.json", json.dumps(base)), "-o", "-")[1])
                self.assertEqual(rms, answer["linkages"][0][block]["error"]["rms"])

    def test_any_number_of_threads_writes_the_same_bytes(self):
        content = sweep_of(100)
        whole = self.whole(content)
        for threads in (1, 2, 5):
            self.done(content, "--threads", threads, "--overwrite")
            self.assertEqual(self.output.read_bytes(), whole)
        self.assertFalse(self.partial.exists())

    def test_killed_at_ten_moments_nothing_is_lost_or_doubled(self):
        content, moments = sweep_of(1500), random.Random(7)
        began = time.monotonic()
        whole = self.whole(content)
        lasts = time.monotonic() - began
        for round_ in range(10):
            process = self.start(content, "--resume")
            time.sleep(moments.uniform(0, lasts / 8))
            process.kill()
            process.communicate()
            self.assertEqual(self.output.exists(), process.returncode == 0)
        self.assertGreater((self.partial / "000000.journal").stat().st_size, 10000)
        status, _, _ = self.sweep(content, "--resume")
        self.assertEqual(status, 0)
        self.assertEqual(self.output.read_bytes(), whole)
        self.assertIn("is complete", self.done(content, "--resume"))

    def test_interrupted_it_says_how_to_go_on(self):
        for how in (signal.SIGINT, signal.SIGTERM):
            content = sweep_of(1500)
            status, error = self.stopped_midway(content, how)
            self.assertEqual(status, 128 + how)
            self.assertIn("--resume goes on", error)
            self.assertNotIn("Traceback", error)
            status, words, _ = run("sweep", "--inspect", self.output)
            self.assertEqual(status, 0)
            self.assertRegex(words, r"\d+ of 1 500 samples are done")
            self.assertEqual(self.sweep(content)[0], 2)
            self.assertEqual(self.sweep(content, "--overwrite")[0], 0)
            self.output.unlink()

    def test_a_full_disk_keeps_what_is_done(self):
        content = sweep_of(600)
        whole = self.whole(content)
        status, _, error = self.sweep(content, preexec_fn=limited_to(100_000))
        self.assertEqual(status, 1, error)
        self.assertIn("File too large", error)
        self.assertFalse(self.output.exists())
        self.done(content, "--resume")
        self.assertEqual(self.output.read_bytes(), whole)

    def test_a_table_that_does_not_fit_keeps_the_journal(self):
        content = sweep_of(3, 50, keep={"linkages": 0})
        whole = self.whole(content)
        status, _, error = self.sweep(content, preexec_fn=limited_to(len(whole) // 2))
        self.assertEqual(status, 1)
        self.assertIn("File too large", error)
        self.assertNotIn("HDF5", error)
        self.assertEqual({path.name for path in self.partial.iterdir()}, {"000000.journal", "sweep.json", "sweep.lock"})
        self.done(content, "--resume")
        self.assertEqual(self.output.read_bytes(), whole)

    def test_what_is_corrupt_is_computed_anew(self):
        content = sweep_of(1500)
        whole = self.whole(content)
        self.stopped_midway(content)
        journal = self.partial / "000000.journal"
        kept = bytearray(journal.read_bytes())
        for place in (3000, 9000, 15000):
            kept[place] ^= 0x10
        journal.write_bytes(kept)
        status, _, error = self.sweep(content, "--resume")
        self.assertEqual(status, 0)
        self.assertIn("corrupt; those blocks are computed anew", error)
        self.assertEqual(self.output.read_bytes(), whole)

    def test_two_runs_do_not_write_one_table(self):
        content = sweep_of(3000)
        process = self.start(content)
        while not (self.partial / "000000.journal").exists():
            time.sleep(0.005)
        for how in ([], ["--resume"], ["--overwrite"]):
            status, _, error = self.sweep(content, *how)
            self.assertEqual(status, 2)
            self.assertIn("another run is writing this file", error)
        process.kill()
        process.communicate()

    def test_what_others_have_put_beside_it_stays(self):
        content = sweep_of(50)
        self.partial.mkdir()
        note = self.partial / "note.txt"
        note.write_text("mine", encoding="utf-8")
        self.done(content)
        self.assertEqual({path.name for path in self.partial.iterdir()}, {"note.txt"})
        self.assertIn("is complete", self.done(content, "--resume"))

    def test_killed_while_it_tidies_up_it_is_complete(self):
        content = sweep_of(1500)
        self.stopped_midway(content)
        journal = (self.partial / "000000.journal").read_bytes()
        self.done(content, "--resume")
        whole = self.output.read_bytes()
        self.partial.mkdir()
        (self.partial / "000000.journal").write_bytes(journal)
        self.assertIn("is complete", self.done(content, "--resume"))
        self.assertFalse(self.partial.exists())
        self.done(sweep_of(20), "--overwrite")
        self.assertFalse(self.partial.exists())
        self.assertNotEqual(self.output.read_bytes(), whole)

    def test_what_came_to_be_there_meanwhile_stays(self):
        content = sweep_of(1500)
        whole = self.whole(content)
        self.stopped_midway(content)
        self.output.write_text("mine", encoding="utf-8")
        for _ in range(2):
            status, _, error = self.sweep(content, "--resume")
            self.assertEqual(status, 2)
            self.assertIn("move that file away, then --resume", error)
            self.assertEqual(self.output.read_text(encoding="utf-8"), "mine")
        self.output.unlink()
        self.done(content, "--resume")
        self.assertEqual(self.output.read_bytes(), whole)

    def test_stopped_between_its_name_and_tidying_up_it_can_be_resumed(self):
        content = sweep_of(300)
        self.stopped_midway(content)
        shutil.copytree(self.partial, self.folder / "kept")
        self.done(content, "--resume")
        whole = self.output.read_bytes()
        shutil.move(self.folder / "kept", self.partial)
        self.done(content, "--resume")
        self.assertEqual(self.output.read_bytes(), whole)
        self.assertFalse(self.partial.exists())

    def test_what_is_to_be_replaced_is_replaced_after_a_stop(self):
        content = sweep_of(1500)
        self.output.write_text("mine", encoding="utf-8")
        process = self.start(content, "--overwrite")
        while not (self.partial / "000000.journal").exists():
            time.sleep(0.005)
        process.kill()
        process.communicate()
        self.assertEqual(self.output.read_text(encoding="utf-8"), "mine")
        self.done(content, "--resume")
        self.assertEqual(self.output.read_bytes(), self.whole(content))

    def test_links_are_followed(self):
        content, link = sweep_of(5), self.folder / "link.h5"
        link.symlink_to(self.folder / "nowhere.h5")
        status, _, error = self.sweep(content, output=link)
        self.assertEqual(status, 2)
        self.assertIn("a symbolic link that leads nowhere", error)
        (self.folder / "nowhere.h5").write_text("mine", encoding="utf-8")
        self.done(content, "--overwrite", output=link)
        self.assertTrue(link.is_symlink())
        self.assertEqual((self.folder / "nowhere.h5").read_bytes(), self.whole(content))

    def test_damaged_tables_are_told(self):
        self.done(sweep_of(40))
        table, moments = self.output.read_bytes(), random.Random(3)
        told = set()
        for _ in range(150):
            damaged = bytearray(table)
            for _ in range(moments.choice((1, 2, 8, 40))):
                damaged[moments.randrange(len(table))] = moments.randrange(256)
            self.output.write_bytes(damaged)
            status, _, error = run("sweep", "--inspect", self.output)
            self.assertIn(status, (0, 2))
            self.assertEqual(status == 0, error == "")
            told.add(error.removeprefix(f"{self.output}: "))
        self.assertIn("this table is damaged: HDF5 fails when it is read\n", told)

    def test_a_reader_that_has_heard_enough_is_no_damage(self):
        self.done(sweep_of(40))
        for command in (["--inspect", str(self.output)], [str(self.folder / "sweep.json"), "-o", str(self.output), "--resume"]):
            read, write = os.pipe()
            os.close(read)
            done = subprocess.run([CLI, "sweep", *command], stdout=write, stderr=subprocess.PIPE, text=True, check=False)
            os.close(write)
            self.assertEqual((done.returncode, done.stderr), (-signal.SIGPIPE, ""))

    @unittest.skipUnless(h5py, "python3-h5py is not there")
    def test_tables_that_no_sweep_has_written_are_refused(self):
        self.done(sweep_of(40))
        table = self.output.read_bytes()
        for wrong in ({"chunks": (1 << 26,), "maxshape": (None,)}, {"external": [(str(self.folder / "raw"), 0, 8 << 20)]}):
            self.output.write_bytes(table)
            with h5py.File(self.output, "r+") as file:
                file["samples"].create_dataset("wrong", shape=(1 << 20,), dtype="f8", **wrong)
            status, _, error = run("sweep", "--inspect", self.output)
            self.assertEqual((status, error), (2, f"{self.output}: this is no table of a sweep: its column samples/wrong cannot be read\n"))

    def test_another_sweep_is_not_resumed(self):
        content = sweep_of(1500)
        self.stopped_midway(content)
        other = sweep_of(1500)
        other["problem"]["requirements"] = {**TAILGATE["requirements"], "max_length": 449}
        for changed, place in ((other, "/problem/requirements/max_length"), (sweep_of(1501), "/sweep/sampling/samples")):
            status, _, error = self.sweep(changed, "--resume")
            self.assertEqual(status, 2)
            self.assertIn(f"they differ at {place}", error)
        self.assertEqual(self.sweep(sweep_of(5), "--overwrite")[0], 0)
        before = self.output.read_bytes()
        for how in ([], ["--resume"]):
            self.assertEqual(self.sweep(sweep_of(6), *how)[0], 2)
        self.assertEqual(self.output.read_bytes(), before)

    def test_hostile_files_are_told_what_is_wrong(self):
        cases = {
            "no number there": ({"vary": [{"at": "/task/kind", "from": 0, "to": 1}]}, "vary[0].at: at \"/task/kind\""),
            "nothing there": ({"vary": [{"at": "/task/poses/9/x", "from": 0, "to": 1}]}, "there is nothing at"),
            "many": ({"sampling": {"method": "sobol", "samples": 1e300}}, "sampling.samples"),
            "a path of its own": ({"vary": [{"at": "/task/poses/2/x", "from": 0, "to": 1, "name": "../x"}]}, "vary[0].name"),
            "no method": ({"sampling": {"method": "hammersley", "samples": 4}}, "sampling.method"),
            "infinite": ({"vary": [{"at": "/task/poses/2/x", "from": -1.7e308, "to": 1.7e308}]}, "vary[0]"),
            "unknown column": ({"keep": {"columns": ["lenths.ground"]}}, "did you mean lengths.ground?"),
            "a device": ({"problem": "/dev/zero"}, "problem"),
            "itself": ({"problem": "sweep.json"}, "problem"),
        }
        for name, (change, words) in cases.items():
            with self.subTest(name):
                status, output, error = self.sweep({**sweep_of(4), **change})
                self.assertEqual((status, output), (2, ""))
                self.assertIn(words, error)
                self.assertEqual(error.count("\n"), len(error.splitlines()))
                self.assertFalse(self.output.exists() or self.partial.exists())
        for words in (["--output"], ["sweep"], ["sweep", "--inspect", self.folder], ["sweep", "--inspect", ROOT / "README.md"]):
            self.assertEqual(run(*words)[0], 2)

    @unittest.skipIf(jsonschema is None, "python3-jsonschema is not installed")
    def test_examples_keep_the_schema(self):
        sweep = validator("sweep")
        for example in SWEEPS:
            sweep.validate(load(example))
        self.assertFalse(sweep.is_valid({**sweep_of(4), "sampling": {"method": "grid", "samples": 4}}))


@unittest.skipIf(h5py is None, "python3-h5py is not installed")
class Tables(SweepTest):
    def test_numbers_are_those_of_solve(self):
        content = sweep_of(12, 100)
        self.done(content)
        with h5py.File(self.output) as table:
            samples, linkages = table["samples"], table["linkages"]
            base = json.loads(table.attrs["problem"])
            for i, status in enumerate(samples["status"].asstr()[:]):
                base["task"]["poses"][2]["x"] = samples["x3"][i]
                base["requirements"]["min_transmission_angle_deg"] = samples["angle"][i]
                base["options"]["best"] = 2
                code, output, _ = run("solve", self.write("problem.json", json.dumps(base)), "-o", "-")
                self.assertEqual(status == "invalid", code == 2)
                if code != 0:
                    continue
                result = json.loads(output)
                self.assertEqual(samples["defect_free"][i], result["region"]["counts"]["defect_free"])
                rows = linkages["sample"][:] == i
                self.assertEqual(rows.sum(), len(result["linkages"]))
                for column in ("ground", "input", "coupler", "output"):
                    self.assertEqual(list(linkages[f"lengths.{column}"][rows]),
                                     [linkage["lengths"][column] for linkage in result["linkages"]])
                self.assertEqual(list(linkages["type"].asstr()[rows]), [linkage["type"] for linkage in result["linkages"]])
            self.assertIn("invalid", samples["status"].asstr()[:])
            self.assertEqual(linkages["lengths.ground"].attrs["unit"], "mm")
            self.assertIn(b"angle", table["failures/message"][0])

    def test_sobols_and_haltons_points_are_scipys(self):
        try:
            from scipy.stats import qmc
        except ImportError:
            self.skipTest("scipy is not installed")
        vary = [{"name": f"x{k}", "at": f"/task/poses/{1 + k // 2}/{'xy'[k % 2]}", "from": 0, "to": 1} for k in range(6)]
        for method, engine in (("sobol", qmc.Sobol), ("halton", qmc.Halton)):
            content = sweep_of(64, 8, vary=vary, sampling={"method": method, "samples": 64}, keep={"linkages": 0})
            self.done(content, "--overwrite")
            expected = engine(6, scramble=False).random(64)
            with h5py.File(self.output) as table:
                for k in range(6):
                    for got, wanted in zip(table[f"samples/x{k}"][:], expected[:, k]):
                        self.assertAlmostEqual(got, wanted, 9)


if __name__ == "__main__":
    unittest.main()
