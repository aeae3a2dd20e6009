"""The server of the workbench: what it sends, whom it refuses, how it starts and stops."""

import contextlib
import http.client
import os
import re
import select
import shutil
import signal
import socket
import subprocess
import threading
import unittest

from face_support import CLI, ROOT, FaceTest, run

LINE = re.compile(r"The workbench is at http://127\.0\.0\.1:(\d+)/ \(Ctrl-C stops\)\n")
STRICT = {
    "Content-Security-Policy": "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; "
                               "img-src 'self' data: blob:; worker-src 'self' blob:; connect-src 'self'; object-src 'none'; "
                               "base-uri 'none'; frame-ancestors 'none'; form-action 'none'",
    "Cross-Origin-Embedder-Policy": "require-corp",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
}
BIG = b"// a script\n" * 200_000


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Studio:
    """A running studio; `with` stops it."""

    def __init__(self, *arguments, program=CLI):
        command = [str(program), "studio", *map(str, arguments)]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        readable, _, _ = select.select([self.process.stdout], [], [], 200)
        self.line = self.process.stdout.readline().decode() if readable else ""
        match = LINE.fullmatch(self.line)
        if not match:
            self.process.kill()
            raise AssertionError(f"{self.line!r} {self.process.communicate()[1].decode()}")
        self.port = int(match[1])

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stop()

    def stop(self, signal_number=signal.SIGTERM):
        """Exit status and all that was printed after the first line."""
        self.process.send_signal(signal_number)
        output, error = self.process.communicate(timeout=200)
        return self.process.returncode, output.decode(), error.decode()

    def send(self, content):
        """The whole answer to some bytes: status (None if there is no answer), headers, body."""
        with socket.create_connection(("127.0.0.1", self.port), timeout=150) as connection:
            answer = b""
            try:
                connection.sendall(content)
                while piece := connection.recv(1 << 16):
                    answer += piece
            except (ConnectionResetError, BrokenPipeError):
                pass
        head, _, body = answer.partition(b"\r\n\r\n")
        status, *lines = head.decode("latin-1").split("\r\n")
        status = int(status.split()[1]) if status else None
        return status, dict(line.split(": ", 1) for line in lines), body

    def request(self, target, method="GET", host="127.0.0.1", headers=""):
        return self.send(f"{method} {target} HTTP/1.1\r\nHost: {host}\r\n{headers}\r\n".encode("latin-1"))


class StudioTest(FaceTest):
    """With a small workbench in self.web."""

    def setUp(self):
        super().setUp()
        self.web = self.folder / "web"
        (self.web / "assets").mkdir(parents=True)
        self.write("secret.txt", "secret")
        self.write("web_beside.txt", "secret")
        self.write("web/index.html", "<!doctype html><title>workbench</title>")
        self.write("web/icon.svg", "<svg/>")
        self.write("web/empty.txt", "")
        self.write("web/assets/index-1a2b.js", BIG)
        self.write("web/assets/engine-3c4d.wasm", b"\0asm\1\0\0\0")
        self.write("web/assets/name with blank.css", "p {}")
        (self.web / "way_out.txt").symlink_to("../secret.txt")
        (self.web / "folder_out").symlink_to("..")
        (self.web / "way_within.html").symlink_to("index.html")

    def serve(self, *arguments):
        studio = Studio("--folder", self.web, *arguments)
        self.addCleanup(studio.process.communicate)
        self.addCleanup(studio.process.kill)
        return studio

    def assert_strict(self, headers):
        self.assertEqual({name: headers.get(name) for name in STRICT}, STRICT)

    def assert_alive(self, studio):
        self.assertEqual(studio.request("/")[0], 200)


class Pages(StudioTest):
    def test_have_their_types_and_caching(self):
        html, script = "text/html; charset=utf-8", "text/javascript; charset=utf-8"
        once, always = "no-cache", "public, max-age=31536000, immutable"
        studio = self.serve()
        for target, name, media_type, caching in (
            ("/", "index.html", html, once),
            ("/?poses=1#place", "index.html", html, once),
            ("/index.html", "index.html", html, once),
            ("/icon.svg", "icon.svg", "image/svg+xml", once),
            ("/empty.txt", "empty.txt", "text/plain; charset=utf-8", once),
            ("/way_within.html", "index.html", html, once),
            ("/assets/index-1a2b.js", "assets/index-1a2b.js", script, always),
            ("/assets/engine-3c4d.wasm", "assets/engine-3c4d.wasm", "application/wasm", always),
            ("/assets/name%20with%20blank.css", "assets/name with blank.css", "text/css; charset=utf-8", always),
        ):
            with self.subTest(target):
                status, headers, body = studio.request(target)
                self.assertEqual((status, body), (200, (self.web / name).read_bytes()))
                self.assertEqual((headers["Content-Type"], headers["Cache-Control"]), (media_type, caching))
                self.assert_strict(headers)

    def test_head_sends_no_body(self):
        status, headers, body = self.serve().request("/assets/index-1a2b.js", "HEAD")
        self.assertEqual((status, body, headers["Content-Length"]), (200, b"", str(len(BIG))))
        self.assert_strict(headers)

    def test_are_not_compressed(self):  # it would take the library seconds for a megabyte
        _, headers, body = self.serve().request("/assets/index-1a2b.js", headers="Accept-Encoding: gzip, br\r\n")
        self.assertNotIn("Content-Encoding", headers)
        self.assertEqual(body, BIG)

    def test_ranges_are_ignored(self):
        studio = self.serve()
        for asked in ("0-3", "30-30000", "900-1000", "-70000", "0-0,0-0", "0-,0-,5-9"):
            with self.subTest(asked):
                for target in ("/", "/empty.txt", "/missing"):
                    status, _, body = studio.request(target, headers=f"Range: bytes={asked}\r\n")
                    self.assertEqual((status, body), studio.request(target)[::2])

    def test_a_browser_may_ask_many_at_once(self):
        studio = self.serve()
        found = []
        askers = [threading.Thread(target=lambda: found.append(studio.request("/assets/index-1a2b.js")[2] == BIG))
                  for _ in range(40)]
        for asker in askers:
            asker.start()
        for asker in askers:
            asker.join()
        self.assertEqual(found, [True] * 40)

    def test_connections_without_a_request_hold_nobody_up(self):
        studio = self.serve()
        with contextlib.ExitStack() as silent:
            for _ in range(100):  # more than the server has threads
                silent.enter_context(socket.create_connection(("127.0.0.1", studio.port)))
            self.assert_alive(studio)

    def test_a_rebuilt_page_is_served(self):
        studio = self.serve()
        self.assert_alive(studio)
        self.write("web/index.html", "rebuilt")
        self.assertEqual(studio.request("/")[2], b"rebuilt")


class Policy(unittest.TestCase):
    def test_is_that_of_the_page_itself(self):
        built_with = (ROOT / "web/vite.config.ts").read_text(encoding="utf-8")
        policy = "".join(re.findall(r'^  "((?:default|worker)-src .*)"', built_with, re.MULTILINE))
        self.assertEqual(policy, STRICT["Content-Security-Policy"].replace("frame-ancestors 'none'; ", ""))  # a page cannot say that


class Refusals(StudioTest):
    def test_nothing_outside_of_the_folder(self):
        studio = self.serve()
        outside = [
            "/../secret.txt", "/assets/../../secret.txt", "/%2e%2e/secret.txt", "/..%2fsecret.txt", "/%2e%2e%2fsecret.txt",
            "/.%2e/secret.txt", "/..%5csecret.txt", "/..\\secret.txt", "/%252e%252e/secret.txt", "/..;/secret.txt",
            "/%c0%ae%c0%ae/secret.txt", "/%u002e%u002e/secret.txt", "/../web_beside.txt", "/%2e%2e/web_beside.txt",
            f"{self.folder}/secret.txt", f"/{self.folder}/secret.txt", "//etc/passwd", "/%2fetc/passwd", "/%2f%2fetc%2fpasswd",
            "/way_out.txt", "/folder_out/secret.txt", "/icon.svg%00.html", "/%00", "/icon.svg%00",
            "file:///etc/passwd", "http://127.0.0.1/../secret.txt", "../secret.txt", "*", "secret.txt", "/icon.svg/../../secret.txt",
        ]
        for target in outside:
            with self.subTest(target):
                status, headers, body = studio.request(target)
                self.assertIn(status, (400, 404))
                self.assertNotIn(b"secret", body)
                self.assert_strict(headers)

    def test_folders_and_what_is_missing(self):
        studio = self.serve()
        os.mkfifo(self.web / "pipe")
        for target in ("/missing", "/assets", "/assets/", "/folder_out", "/index.html/", "/pipe", "/" + "a" * 5000):
            with self.subTest(target):
                status, headers, body = studio.request(target)
                self.assertEqual(status, 404)
                self.assertEqual(headers["Content-Type"], "text/plain; charset=utf-8")
                self.assertEqual(len(body.splitlines()), 1)
                self.assert_strict(headers)

    def test_foreign_names(self):
        studio = self.serve()
        for host in ("127.0.0.1", "localhost", "LocalHost", f"127.0.0.1:{studio.port}", f"localhost:{studio.port}", "localhost:80"):
            with self.subTest(host):
                self.assertEqual(studio.request("/", host=host)[0], 200)
        for host in ("evil.example", f"evil.example:{studio.port}", "127.0.0.1.evil.example", "localhost.evil.example",
                     "127.0.0.1@evil.example", "127.0.0.1:80@evil.example", "127.0.0.1:80:80", "127.0.0.1:", "0.0.0.0", "127.0.0.2",
                     "[::1]", "127.0.0.1 evil.example", "2130706433", "127.1"):
            with self.subTest(host):
                status, headers, body = studio.request("/", host=host)
                self.assertEqual(status, 421)
                self.assertNotIn(b"workbench</title>", body)
                self.assert_strict(headers)
        for lines in ("", "Host: \r\n", "Host: 127.0.0.1\r\nHost: evil.example\r\n", "Host: 127.0.0.1\r\nHost: 127.0.0.1\r\n"):
            self.assertEqual(studio.send(f"GET / HTTP/1.1\r\n{lines}\r\n".encode())[0], 400)

    def test_methods(self):
        studio = self.serve()
        for method in ("POST", "PUT", "DELETE", "PATCH", "OPTIONS", "TRACE", "CONNECT"):
            with self.subTest(method):
                status, headers, _ = studio.request("/", method)
                self.assertEqual((status, headers["Allow"]), (405, "GET, HEAD"))
                self.assert_strict(headers)
        for method in ("BREW", "get", "", "GET\0"):
            with self.subTest(method):
                status, headers, _ = studio.request("/", method)
                self.assertEqual(status, 400)
                self.assert_strict(headers)

    def test_a_body_is_no_second_request(self):
        body = "GET /icon.svg HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n"
        headers = f"Content-Length: {len(body)}\r\nConnection: keep-alive\r\n"
        for method in ("GET", "POST"):
            connection = http.client.HTTPConnection("127.0.0.1", self.serve().port, timeout=100)
            connection.request(method, "/", body, {"Connection": "keep-alive"})
            answer = connection.getresponse()
            self.assertEqual(answer.getheader("Connection"), "close")
            connection.close()
            self.assertNotIn(b"<svg/>", self.serve().request("/", method, headers=headers + "\r\n" + body)[2])


class HostileRequests(StudioTest):
    def test_are_answered_or_dropped(self):
        studio = self.serve()
        line, host = b"GET / HTTP/1.1\r\n", b"Host: 127.0.0.1\r\n"
        for name, content, allowed in (
            ("nothing", b"\r\n\r\n", (400, None)),
            ("noise", bytes(range(256)) * 40 + b"\r\n\r\n", (400, 414, None)),
            ("another protocol", b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03" + bytes(600), (400, None)),
            ("a long address", b"GET /" + b"a" * 100_000 + b" HTTP/1.1\r\n" + host + b"\r\n", (414,)),
            ("a long header", line + host + b"X: " + b"a" * 1_000_000 + b"\r\n\r\n", (400, None)),
            ("many headers", line + host + b"X: 1\r\n" * 50_000 + b"\r\n", (200, 400, None)),
            ("a bare header", line + host + b"X\r\n\r\n", (200, 400)),
            ("no version", b"GET /\r\n" + host + b"\r\n", (400,)),
            ("a future version", b"GET / HTTP/9.9\r\n" + host + b"\r\n", (400, 200)),
            ("many ranges", line + host + b"Range: bytes=" + b"0-0," * 1900 + b"0-0\r\n\r\n", (200, 416)),
            ("a broken range", line + host + b"Range: bytes=zz\r\n\r\n", (416,)),
            ("a huge range", line + host + b"Range: bytes=" + b"9" * 400 + b"-\r\n\r\n", (200, 400, 416, None)),
            ("many percents", b"GET /" + b"%" * 4000 + b" HTTP/1.1\r\n" + host + b"\r\n", (404, 400)),
            ("a huge length", line + host + b"Content-Length: 99999999999999999999\r\n\r\n", (200, 400)),
            ("both lengths", line + host + b"Content-Length: 3\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n", (200, 400)),
            ("endless chunks", b"POST / HTTP/1.1\r\n" + host + b"Transfer-Encoding: chunked\r\n\r\nffffffffffff\r\n", (405, None)),
            ("an expectation", line + host + b"Expect: 100-continue\r\nContent-Length: 5\r\n\r\n", (200, 100, 417)),
            ("header injection", b"GET /%0d%0aX-Injected:%201 HTTP/1.1\r\n" + host + b"\r\n", (404, 400)),
        ):
            with self.subTest(name):
                status, headers, _ = studio.send(content)
                self.assertIn(status, allowed)
                self.assertNotIn("X-Injected", headers)
                if status not in (None, 100):
                    self.assert_strict(headers)
                self.assert_alive(studio)
        self.assertEqual(studio.stop(), (0, "", ""))

    def test_half_a_request_is_dropped(self):
        studio = self.serve()
        with socket.create_connection(("127.0.0.1", studio.port), timeout=150) as slow:
            slow.sendall(b"GET / HTTP/1.1\r\nHost: 127.")
            self.assert_alive(studio)
            while slow.recv(1 << 16):
                pass
        self.assert_alive(studio)

    def test_readers_that_leave_do_no_harm(self):
        studio = self.serve()
        for _ in range(20):
            with socket.create_connection(("127.0.0.1", studio.port)) as hasty:
                hasty.sendall(b"GET /assets/index-1a2b.js HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n")
        self.assert_alive(studio)


class StartAndStop(StudioTest):
    def test_signals_end_it_in_peace(self):
        for signal_number in (signal.SIGINT, signal.SIGTERM):
            self.assertEqual(self.serve().stop(signal_number), (0, "", ""))

    def test_ends_beside_open_connections(self):
        studio = self.serve()
        with socket.create_connection(("127.0.0.1", studio.port)), \
             socket.create_connection(("127.0.0.1", studio.port)) as half:
            half.sendall(b"GET / HTTP/1.1\r\nX: ")
            ended = threading.Event()
            sender = threading.Thread(target=self.go_on, args=(half, ended))
            sender.start()
            try:
                self.assertEqual(studio.stop()[0], 0)  # who waits for the end of the request never ends
            finally:
                ended.set()
                sender.join()

    @staticmethod
    def go_on(half, ended):
        """Never so long without a byte that the server gives the request up."""
        with contextlib.suppress(OSError):
            while not ended.wait(0.2):
                half.sendall(b"x")

    def test_two_do_not_share_a_port(self):
        first, second = self.serve(), self.serve()
        self.assertNotEqual(first.port, second.port)
        for studio in (first, second):
            self.assert_alive(studio)

    def test_takes_the_port_that_is_named(self):
        port = free_port()
        with Studio("--folder", self.web, "--port", port) as studio:
            self.assertEqual(studio.port, port)
            taken = run("studio", "--folder", self.web, "--port", port)
            self.assert_failure(taken, f"port {port}", "another program has it", "leave --port out")
        with Studio("--folder", self.web, "--port", port) as again:
            self.assert_alive(again)

    def test_any_port(self):
        self.assertGreater(self.serve("--port", 0).port, 0)

    def test_is_reached_from_this_machine_only(self):
        studio = self.serve()
        with open("/proc/net/tcp", encoding="ascii") as table:
            listening = [row.split()[1] for row in table if row.split()[3] == "0A"]
        self.assertEqual([place for place in listening if place.endswith(f":{studio.port:04X}")], [f"0100007F:{studio.port:04X}"])

    def test_ports_are_checked(self):
        for port in ("-1", "65536", "http", "80.5"):
            self.assert_mistake(run("studio", "--folder", self.web, f"--port={port}"), "--port", "linkwright studio --help")

    def test_the_folder_holds_a_workbench(self):
        (self.folder / "empty").mkdir()
        for folder in ("empty", "missing", "secret.txt"):
            self.assert_mistake(run("studio", "--folder", self.folder / folder), folder, "--folder", "no index.html")

    def test_says_where_nobody_can_read(self):
        with open("/dev/full", "wb") as full:
            done = subprocess.run([CLI, "studio", "--folder", str(self.web)], stdout=full, stderr=subprocess.PIPE, check=False, timeout=200)
        self.assertEqual(done.returncode, 1)
        self.assertIn(b"standard output", done.stderr)


class Installed(StudioTest):
    """The program finds its workbench beside itself."""

    def program_in(self, folder):
        (self.folder / folder).mkdir(parents=True)
        return shutil.copy2(CLI, self.folder / folder / "linkwright")

    def test_beside_the_installed_program(self):
        program = self.program_in("prefix/bin")
        shutil.copytree(self.web, self.folder / "prefix/share/linkwright/web", symlinks=True)
        link = self.folder / "linkwright"
        link.symlink_to(program)
        for name in (program, link):
            with Studio(program=name) as studio:
                self.assert_alive(studio)

    def test_in_the_tree_that_built_it(self):
        program = self.program_in("build/release/bin")
        self.write("build/release/CMakeCache.txt", "")
        shutil.copytree(self.web, self.folder / "build/web", symlinks=True)
        with Studio(program=program) as studio:
            self.assert_alive(studio)

    def test_not_in_a_folder_that_happens_to_be_called_web(self):
        program = self.program_in("home/local/bin")
        shutil.copytree(self.web, self.folder / "home/web", symlinks=True)
        done = subprocess.run([program, "studio"], capture_output=True, check=False, timeout=200)
        self.assert_failure((done.returncode, done.stdout.decode(), done.stderr.decode()), "not built", "script/build", "--folder")

    @unittest.skipUnless((ROOT / "build/web/index.html").exists(), "the workbench is not built")
    def test_the_built_page_loads_whole(self):
        with Studio("--folder", ROOT / "build/web") as studio:
            page = studio.request("/")[2].decode()
            named = re.findall(r'(?:src|href)="\./([^"#]+)"', page)
            self.assertTrue(named)
            for name in named:
                self.assertEqual(studio.request("/" + name)[0], 200, name)


if __name__ == "__main__":
    unittest.main()
