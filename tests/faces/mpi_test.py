"""Sweeps by many processes: the same table as by one, whatever is lost on the way."""

import fcntl
import os
import re
import resource
import shutil
import signal
import subprocess
import time
import unittest
from pathlib import Path

from face_support import CLI, run
from sweep_test import SweepTest, sweep_of

MPI = f"{CLI}-mpi"
MISSING = next((f"{what} is not there" for what in ("mpirun", MPI) if not shutil.which(what)), None)
# More ranks than cores, also as root in a container.
SETTINGS = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_rmaps_base_oversubscribe": "1",
            "OMPI_MCA_hwloc_base_binding_policy": "none", "OMPI_MCA_mpi_yield_when_idle": "1"}
# As between nodes whose network does not reach into memory.
BY_MESSAGES = ("--mca", "osc", "pt2pt", "--mca", "btl", "tcp,self")

SWEEP = sweep_of(160)  # half a second


@unittest.skipIf(MISSING, MISSING)
class MpiTest(SweepTest):
    tables = {}

    def whole(self, content):
        """By the ordinary program, once for all tests."""
        key = str(content)
        if key not in self.tables:
            self.tables[key] = super().whole(content)
        return self.tables[key]

    def begin(self, ranks, content, *more, settings=(), **options):
        path = self.write("sweep.json", content)
        command = ["mpirun", "-n", str(ranks), *settings, MPI, "sweep", str(path), "-o", str(self.output), *map(str, more)]
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                env={**os.environ, **SETTINGS, "TMPDIR": "/tmp"}, **options)
        self.addCleanup(process.kill)
        return process

    def ranks(self, *arguments, **options):
        """Exit status, standard output, the program's own lines of standard error."""
        process = self.begin(*arguments, **options)
        output, error = (text.decode() for text in process.communicate(timeout=600))
        return process.returncode, output, self.own_lines(error)

    @staticmethod
    def own_lines(error):
        return [line for line in error.splitlines() if re.match(r"linkwright: |/.*?(\.h5|\.json): ", line)]

    def done_by(self, ranks, content, *more, **options):
        status, output, error = self.ranks(ranks, content, *more, **options)
        self.assertEqual((status, error), (0, []))
        self.assertEqual(len(output.splitlines()), 1)
        self.assertFalse(self.partial.exists())
        return self.output.read_bytes()

    def kept(self):
        return {path.name: path.stat().st_size for path in self.partial.glob("*.journal")}

    def await_kept(self, ranks):
        """Until each rank has kept something."""
        for _ in range(20000):
            kept = self.kept()
            if len(kept) == ranks and min(kept.values()) > 2000:
                return
            time.sleep(0.005)
        self.fail(f"not all ranks keep blocks: {kept}")

    def await_quiet(self):
        """Until no rank of a run that was killed writes any more."""
        for path in self.partial.glob("*.journal"):
            with path.open("rb") as journal:
                fcntl.flock(journal, fcntl.LOCK_EX)

    def killed_midway(self, ranks, content, *victims):
        """mpirun ends the others when a rank is killed."""
        process = self.begin(ranks, content)
        self.await_kept(ranks)
        for rank in victims:
            os.kill(pid_of_rank(process.pid, rank), signal.SIGKILL)
        process.communicate(timeout=600)
        self.await_quiet()
        self.assertNotEqual(process.returncode, 0)
        self.assertFalse(self.output.exists())


def pid_of_rank(launcher, rank):
    for pid in Path(f"/proc/{launcher}/task/{launcher}/children").read_text(encoding="ascii").split():
        if f"OMPI_COMM_WORLD_RANK={rank}\0".encode() in Path(f"/proc/{pid}/environ").read_bytes():
            return int(pid)
    raise LookupError(f"no rank {rank}")


class Ranks(MpiTest):
    def test_any_number_of_ranks_writes_the_same_bytes(self):
        content = sweep_of(40, 100)
        whole = self.whole(content)
        for ranks, more in ((1, []), (2, ["--threads", 1]), (4, ["--threads", 2])):
            self.assertEqual(self.done_by(ranks, content, "--overwrite", *more), whole)
        self.assertEqual(self.done_by(3, content, "--overwrite", settings=BY_MESSAGES), whole)
        self.assertIn("is complete", self.ranks(2, content, "--resume")[1])

    def test_the_ordinary_program_needs_no_mpi(self):
        linked = subprocess.run(["ldd", CLI], capture_output=True, check=True).stdout
        self.assertNotIn(b"libmpi", linked)

    def test_a_killed_rank_costs_its_blocks_under_way(self):
        content = SWEEP
        whole = self.whole(content)
        self.killed_midway(4, content, 2)
        status, words, _ = run("sweep", "--inspect", self.output)
        self.assertEqual(status, 0)
        self.assertRegex(words, r"\d+ of 160 samples are done")
        self.assertEqual(self.done_by(2, content, "--resume"), whole)

    def test_the_ordinary_program_goes_on_where_rank_0_was_killed(self):
        content = SWEEP
        whole = self.whole(content)
        self.killed_midway(3, content, 0)
        self.assertEqual(self.sweep(content, "--resume")[0], 0)
        self.assertEqual(self.output.read_bytes(), whole)

    def test_interrupted_it_says_how_to_go_on(self):
        content = SWEEP
        whole = self.whole(content)
        process = self.begin(2, content)
        self.await_kept(2)
        os.kill(pid_of_rank(process.pid, 0), signal.SIGTERM)
        error = process.communicate(timeout=600)[1].decode()
        self.await_quiet()
        self.assertEqual(process.returncode, 128 + signal.SIGTERM)
        self.assertEqual(error.count("--resume goes on"), 1, error)
        self.assertEqual(self.done_by(4, content, "--resume"), whole)


class Mistakes(MpiTest):
    def test_two_runs_do_not_write_one_table(self):
        content = sweep_of(4000)
        process = self.begin(2, content)
        self.await_kept(2)
        for status, error in (self.ranks(2, content, "--resume")[::2], self.sweep(content, "--resume")[::2]):
            self.assertEqual(status, 2)
            self.assertIn("another run is writing this file", str(error))
        process.terminate()
        process.communicate(timeout=600)

    def test_a_full_disk_is_told_once(self):
        content = SWEEP
        whole = self.whole(content)
        process = self.begin(3, content)
        self.await_kept(3)
        for rank in (1, 2):  # not from the start: what MPI shares in memory is a file, too
            resource.prlimit(pid_of_rank(process.pid, rank), resource.RLIMIT_FSIZE, (2500, 2500))
        error = self.own_lines(process.communicate(timeout=600)[1].decode())
        self.assertEqual(process.returncode, 1)
        self.assertEqual(len(error), 1, error)
        self.assertRegex(error[0], r"00000\d\.journal cannot be written: File too large")
        self.assertEqual(self.done_by(2, content, "--resume"), whole)

    def test_what_is_corrupt_is_computed_anew(self):
        content = SWEEP
        whole = self.whole(content)
        self.killed_midway(2, content, 1)
        for name in self.kept():
            kept = bytearray((self.partial / name).read_bytes())
            kept[1500] ^= 0x10
            (self.partial / name).write_bytes(kept)
        status, _, error = self.ranks(2, content, "--resume")
        self.assertEqual(status, 0)
        self.assertRegex(str(error), "(one piece|2 pieces) of what was kept (is|are) corrupt")
        self.assertEqual(self.output.read_bytes(), whole)

    def test_another_sweep_or_flag_is_refused_once(self):
        self.stopped_midway(SWEEP)
        for content, more, words in ((sweep_of(161), ["--resume"], "they differ at /sweep/sampling/samples"),
                                     (SWEEP, [], "a sweep to this file was begun"),
                                     (SWEEP, ["--thread"], "see linkwright-mpi sweep --help"),
                                     (sweep_of(0), ["--overwrite"], "sampling.samples")):
            status, output, error = self.ranks(2, content, *more)
            self.assertEqual((status, output, len(error)), (2, "", 1), error)
            self.assertIn(words, error[0])


if __name__ == "__main__":
    unittest.main()
