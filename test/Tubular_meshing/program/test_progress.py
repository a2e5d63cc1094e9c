# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""How the program tells what it does, and how it ends when it is stopped."""

import json
import os
import pty
import re
import shutil
import signal
import subprocess
import time
import unittest

from program import TOOL, ProgramTest

POLY_MESH = ("boundary", "faces", "neighbour", "owner", "points")


class Log(ProgramTest):
    def events_of(self, text):
        events = [json.loads(line) for line in text.splitlines()]
        for event in events:
            self.assertGreaterEqual(event["elapsed"], 0)
        self.assertEqual([e["elapsed"] for e in events], sorted(e["elapsed"] for e in events))
        return events

    def test_tells_stages_and_the_end(self):
        self.succeed(self.surface("tube"), "-o", "mesh.vtu", "-q", "--log-json", "log.jsonl", "--report", "report.json")
        events = self.events_of((self.out / "log.jsonl").read_text())
        report = json.loads((self.out / "report.json").read_text())
        begin, end = events[0], events[-1]
        self.assertEqual((begin["event"], begin["output"], begin["type"]), ("begin", "mesh.vtu", "isotropic"))
        self.assertEqual((end["event"], end["status"]), ("end", 0))
        self.assertEqual(end["outputs"], ["mesh.vtu", "report.json"])
        self.assertEqual(end["cells"], report["cells"])
        stages = [e["stage"] for e in events if e["event"] == "stage"]
        self.assertEqual(set(stages), set(report["times"]))
        self.assertEqual(stages, [e["stage"] for e in events if e["event"] == "stage_end"])
        for event in events:
            if event["event"] in ("stage", "progress"):
                self.assertTrue(event["fraction"] is None or 0 <= event["fraction"] <= 1)
                self.assertTrue(event["remaining"] is None or event["remaining"] >= 0)
        known = [e["fraction"] for e in events if e["event"] == "stage" and e["fraction"] is not None]
        self.assertGreater(len(known), 3)
        self.assertEqual(known, sorted(known))

    def test_goes_to_standard_error_alone(self):
        run = self.succeed(self.surface("tube"), "-o", "mesh.vtu", "--log-json", "-")
        events = self.events_of(run.stderr)  # and nothing else
        self.assertEqual(events[-1]["event"], "end")
        self.assertIn("opening", run.stdout)

    def test_tells_of_an_error(self):
        run = self.run_tool("absent.stl", "-o", "mesh.vtu", "--log-json", "log.jsonl")
        self.assertEqual(run.returncode, 3)
        end = self.events_of((self.out / "log.jsonl").read_text())[-1]
        self.assertEqual((end["event"], end["status"]), ("end", 3))
        self.assertIn("absent.stl", end["sentence"])

    def test_is_no_file_that_is_read_or_written_as_well(self):
        surface = self.surface("tube")
        with open(surface, "rb") as file:
            before = file.read()
        for name in (surface, "mesh.vtu"):
            run = self.run_tool(surface, "-o", "mesh.vtu", "--log-json", name)
            self.assertEqual(run.returncode, 2)
            self.assertIn("named twice", run.stderr)
        with open(surface, "rb") as file:
            self.assertEqual(file.read(), before)

    def test_needs_a_file_that_can_be_written(self):
        run = self.run_tool(self.surface("tube"), "-o", "mesh.vtu", "--log-json", "absent/log.jsonl")
        self.assertEqual(run.returncode, 2)
        self.assertIn("absent/log.jsonl", run.stderr)


class Terminal(ProgramTest):
    def on_terminal(self, *arguments):
        """What the program writes on a terminal of 80 columns, and its status."""
        master, slave = pty.openpty()
        process = subprocess.Popen([TOOL, *arguments], cwd=self.out, stdout=subprocess.DEVNULL, stderr=slave)
        os.close(slave)
        text = b""
        while True:
            try:
                chunk = os.read(master, 4096)
            except OSError:  # closed at the other end
                break
            if not chunk:
                break
            text += chunk
        os.close(master)
        return text.decode(), process.wait()

    def test_shows_one_line_that_goes(self):
        text, status = self.on_terminal(self.surface("y"), "-o", "mesh.vtu", "-n", "16")
        self.assertEqual(status, 0)
        lines = [line for line in text.split("\r\033[K") if line]
        self.assertNotIn("\n", text)
        self.assertTrue(text.endswith("\r\033[K"), "the line is still there")
        for line in lines:
            self.assertLess(len(line), 80)
        stages = [m.group(1) for m in map(re.compile(r"^ *(?:\d+ %)? +([^,]+), \d+ s").match, lines) if m]
        self.assertEqual(len(stages), len(lines), lines)
        self.assertIn("surface mesh", stages)
        with_percent = [line for line in lines if re.match(r" *\d+ %  .*, about \d+ s left$", line)]
        self.assertGreater(len(with_percent), 3, lines)

    def test_shows_nothing_when_quiet(self):
        text, status = self.on_terminal(self.surface("tube"), "-o", "mesh.vtu", "-q")
        self.assertEqual((text, status), ("", 0))


class Interruption(ProgramTest):
    def interrupt(self, arguments, when, number=signal.SIGINT):
        """Sends a signal as soon as the log tells of a stage; what the program then says, and how it ended."""
        process = subprocess.Popen([TOOL, *arguments, "--log-json", "-"], cwd=self.out, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, universal_newlines=True)
        said = []
        sent = None
        for line in process.stderr:
            said.append(line)
            if sent is None and '"event":"stage"' in line and f'"stage":"{when}"' in line:
                process.send_signal(number)
                sent = time.monotonic()
        process.stdout.close()
        process.stderr.close()
        status = process.wait()
        self.assertIsNotNone(sent, said)
        self.assertLess(time.monotonic() - sent, 10)
        return said, status

    def interrupt_in_time(self, arguments, when):
        """Interrupts a stage. A short one may have ended before the signal gets there: the run is then a whole one, and
        another is tried."""
        for _ in range(10):
            said, status = self.interrupt(arguments, when)
            if status != 0:
                return said, status
            for name in ("r.json", *(f"new/folder/polyMesh/{part}" for part in POLY_MESH)):
                self.assertIn(name, self.files())
            shutil.rmtree(self.out / "new")
            (self.out / "r.json").unlink()
        self.fail(f"{when}: ended before the signal came, each time")

    def test_leaves_nothing_behind(self):
        surface = self.surface("arch")
        for stage in ("centerlines", "surface mesh", "tetrahedra", "write"):
            with self.subTest(stage):
                said, status = self.interrupt_in_time([surface, "-o", "new/folder/polyMesh", "-n", "24", "--report", "r.json"],
                                                      stage)
                self.assertEqual(status, -signal.SIGINT)  # 130 in a shell
                self.assertEqual(self.files(), [])
                if said[-1].startswith("{"):  # ended by force, in a stage that cannot be left
                    continue
                self.assertEqual(said[-1], "tubular_mesh: Interrupted; nothing was written.\n")
                end = json.loads(said[-2])
                self.assertEqual((end["event"], end["status"]), ("end", 130))

    def test_keeps_what_was_there(self):
        (self.out / "mesh.vtu").write_text("of yesterday")
        self.interrupt([self.surface("arch"), "-o", "mesh.vtu", "-n", "24"], "tetrahedra")
        self.assertEqual((self.out / "mesh.vtu").read_text(), "of yesterday")
        self.assertEqual(self.files(), ["mesh.vtu"])

    def test_has_the_status_of_the_signal_in_a_shell(self):
        surface = self.surface("arch")
        for number, status in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            script = '"$0" "$@"; echo $?'
            shell = subprocess.Popen(["bash", "-c", script, TOOL, surface, "-o", "mesh.vtu", "-n", "40", "-q", "--log-json",
                                      "log.jsonl"], cwd=self.out, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                                     universal_newlines=True)
            log = self.out / "log.jsonl"
            while not log.exists() or '"event":"stage"' not in log.read_text():
                time.sleep(0.05)
            with open(f"/proc/{shell.pid}/task/{shell.pid}/children") as children:
                os.kill(int(children.read().split()[0]), number)
            self.assertEqual(shell.communicate()[0].strip(), str(status))
            self.assertEqual(self.files(), ["log.jsonl"])
            log.unlink()

    def test_heeds_no_signal_that_is_ignored(self):
        surface = self.surface("tube")
        script = f'trap "" HUP; "{TOOL}" "{surface}" -o mesh.vtu -q & pid=$!; kill -HUP $pid; wait $pid; echo $?'
        run = subprocess.run(["bash", "-c", script], cwd=self.out, stdout=subprocess.PIPE, universal_newlines=True)
        self.assertEqual(run.stdout.strip(), "0")
        self.assertEqual(self.files(), ["mesh.vtu"])


if __name__ == "__main__":
    unittest.main()
