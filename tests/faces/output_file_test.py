"""Output files are written whole or not at all; what cannot be written is said, with exit status 1."""

import json
import os
import pty
import resource
import signal
import subprocess
import time
import unittest

from face_support import CLI, TAILGATE, FaceTest, as_nobody, nobody_may_run, run

SMALL = ("--samples", "64")


class OutputFiles(FaceTest):
    def files(self):
        return sorted(path.name for path in self.folder.iterdir())

    def test_results_may_be_replaced(self):
        result = self.write("result.json", "an old result")
        self.assertEqual(run("solve", TAILGATE, *SMALL, "-o", result)[0], 0)
        self.assertEqual(json.loads(result.read_text())["status"], "solved")
        self.assertEqual(self.files(), ["result.json"])

    def test_only_regular_files_are_replaced(self):
        (self.folder / "folder").mkdir()
        for path, reason in ((self.folder / "folder", "a directory"), ("/dev/full", "a device"), ("/dev/null", "a device")):
            for option in ("-o", "--svg"):
                self.assert_failure(run("solve", TAILGATE, *SMALL, option, path), str(path), reason)
        self.assertTrue(os.path.exists("/dev/full"))

    def test_missing_folder(self):
        path = self.folder / "missing/result.json"
        self.assert_failure(run("solve", TAILGATE, *SMALL, "-o", path), str(path), "No such file or directory")

    def test_without_permission(self):
        if not nobody_may_run():
            self.skipTest("the program lies where only root may run it")
        self.folder.chmod(0o555)
        problem = TAILGATE.read_text(encoding="utf-8")
        ran = run("solve", "-", *SMALL, "-o", self.folder / "result.json", input=problem, preexec_fn=as_nobody)
        self.assert_failure(ran, "Permission denied")
        self.assertEqual(self.files(), [])

    def test_full_disk_leaves_nothing(self):
        def allow_little():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))

        old = self.write("old.json", "an old result")
        for name in ("new.json", "old.json"):
            ran = run("solve", TAILGATE, *SMALL, "--region", "-o", self.folder / name, preexec_fn=allow_little)
            self.assert_failure(ran, name, "File too large")
        self.assertEqual(self.files(), ["old.json"])
        self.assertEqual(old.read_text(), "an old result")

    def test_full_standard_output(self):
        for arguments in (("solve", TAILGATE, *SMALL), ("solve", TAILGATE, *SMALL, "-o", "-"), ("--help",)):
            with open("/dev/full", "wb") as full:
                done = subprocess.run([CLI, *map(str, arguments)], stdout=full, stderr=subprocess.PIPE, check=False, timeout=600)
            self.assertEqual(done.returncode, 1, arguments)

    def test_standard_output_holds_only_the_json(self):
        status, output, error = run("solve", TAILGATE, *SMALL, "-o", "-")
        self.assertEqual((status, error), (0, ""))
        self.assertEqual(json.loads(output)["status"], "solved")

    def test_an_empty_memory_is_said(self):
        def allow_little():
            resource.setrlimit(resource.RLIMIT_AS, (600 << 20, 600 << 20))

        ran = run("solve", TAILGATE, "--samples", 20000, "-o", self.folder / "result.json", preexec_fn=allow_little)
        self.assert_failure(ran, "memory")
        self.assertEqual(self.files(), [])


class Interruption(FaceTest):
    def interrupt(self, signal_number, after):
        """Interrupts a long solve after some seconds; its exit status and standard error."""
        command = [CLI, "solve", TAILGATE, "--samples", "6000", "-o", self.folder / "result.json"]
        process = subprocess.Popen([*map(str, command)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        time.sleep(after)
        process.send_signal(signal_number)
        _, error = process.communicate(timeout=300)
        return process.returncode, error.decode()

    def test_stops_cleanly(self):
        interrupted = 0
        for signal_number, status in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            for after in (0.1, 0.2):
                returned, error = self.interrupt(signal_number, after)
                if returned == 0:
                    continue  # it was faster
                interrupted += 1
                self.assertEqual(returned, status)
                self.assertIn("stopped; nothing was written", error)
                self.assertEqual(list(self.folder.iterdir()), [])
        self.assertGreater(interrupted, 0)


class EveryCommandEnds(FaceTest):
    """Ctrl-C and SIGTERM, whatever the command waits for: here for an input that does not come."""

    def test_at_once(self):
        pipe = self.folder / "pipe"
        os.mkfifo(pipe)
        for command in (["solve", "-"], ["solve", pipe], ["analyze", pipe], ["export", pipe, "--format", "svg"],
                        ["attitude", "convert", "-"]):
            for signal_number, status in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
                process = subprocess.Popen([CLI, *map(str, command)], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                           stderr=subprocess.PIPE)
                time.sleep(0.2)
                process.send_signal(signal_number)
                process.wait(timeout=300)  # its input stays open: who waits for what does not come never ends
                error = process.communicate(timeout=300)[1].decode()
                self.assertEqual(process.returncode, status, (command, error))
                self.assertIn("stopped; nothing was written", error, command)

    def test_a_second_signal_is_not_waited_for(self):
        process = subprocess.Popen([CLI, "solve", "-"], stdin=subprocess.PIPE, stderr=subprocess.PIPE)
        time.sleep(0.2)
        process.send_signal(signal.SIGTERM)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=300)
        self.assertIn(process.returncode, (130, 143))


def everything_on(terminal):
    """What was written to a terminal whose other end is closed: it comes in pieces, and ends with an error."""
    shown = b""
    while True:
        try:
            piece = os.read(terminal, 1 << 16)
        except OSError:
            break
        if not piece:
            break
        shown += piece
    return shown.decode()


class Progress(FaceTest):
    def test_is_shown_on_a_terminal_only(self):
        _, _, error = run("solve", TAILGATE, "--samples", 1000)
        self.assertEqual(error, "")
        leader, follower = pty.openpty()
        done = subprocess.run([CLI, "solve", str(TAILGATE), "--samples", "1000"], stdout=subprocess.DEVNULL,
                              stderr=follower, check=False, timeout=600)
        os.close(follower)
        shown = everything_on(leader)
        os.close(leader)
        self.assertEqual(done.returncode, 0)
        self.assertIn("%", shown)
        self.assertTrue(shown.endswith("\r\033[K"), repr(shown))


if __name__ == "__main__":
    unittest.main()
