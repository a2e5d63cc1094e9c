# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
import os
import subprocess
import sys
import threading
import time

import numpy as np
import pytest
from shapes import tube

import tubular_meshing as tm


def test_progress_has_the_stages(straight):
    stages = []
    tm.mesh(straight, points_per_circumference=10, progress=stages.append)
    assert "surface mesh" in stages and stages[-1] == "check"
    assert len(stages) > 4


def test_progress_of_each_step():
    stages = []
    surface, _ = tm.repair(tm.Surface(*tube()), progress=stages.append)
    assert stages == ["repair"]
    tm.Model(surface, progress=stages.append)
    assert stages == ["repair", "centerlines"]


def test_progress_may_raise(straight):
    class Enough(Exception):
        pass

    def stop(stage):
        if stage == "surface mesh":
            raise Enough

    with pytest.raises(Enough):
        tm.mesh(straight, points_per_circumference=10, progress=stop)
    assert len(tm.mesh(straight, points_per_circumference=10).points) > 100


def test_others_run_meanwhile(arch):
    """A thread that counts goes on counting while a mesh is made."""
    counts, done = [0], threading.Event()

    def count():
        while not done.is_set():
            counts[0] += 1
            time.sleep(0.001)

    counter = threading.Thread(target=count)
    counter.start()
    start = time.perf_counter()
    tm.mesh(arch, points_per_circumference=20, threads=1)
    seconds = time.perf_counter() - start
    during = counts[0]
    done.set()
    counter.join()
    assert during > 50 * seconds


def test_two_meshes_at_once(arch, straight):
    expected = [tm.mesh(m, points_per_circumference=10) for m in (arch, straight)]
    results = {}

    def make(i, model):
        results[i] = tm.mesh(model, points_per_circumference=10)

    threads = [threading.Thread(target=make, args=(i, (arch, straight)[i % 2])) for i in range(4)]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    for i in range(4):
        assert np.array_equal(results[i].points, expected[i % 2].points)
        assert np.array_equal(results[i].cells["tetra"], expected[i % 2].cells["tetra"])


INTERRUPTED = """
import os, signal, sys, threading, time
import tubular_meshing as tm
sys.path.insert(0, {folder!r})
from shapes import tube
model = tm.Model(tm.Surface(*tube(length=30)))
sent = []

def press():
    sent.append(time.process_time())
    os.kill(os.getpid(), signal.SIGINT)

def watch(stage):
    if stage == {stage!r}:
        threading.Timer(0.2, press).start()

try:
    tm.mesh(model, points_per_circumference=60, progress=watch)
except KeyboardInterrupt:
    print("interrupted", time.process_time() - sent[0])
print("and on", len(tm.mesh(model, points_per_circumference=8).points))
"""


@pytest.mark.parametrize("stage", ["surface mesh", "tetrahedra", "optimization"])
def test_ctrl_c_is_a_keyboard_interrupt(stage):
    """Long before the stage would end, by processor time; and the model can be used again."""
    code = INTERRUPTED.format(folder=os.path.dirname(__file__), stage=stage)
    result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    first, second = result.stdout.splitlines()
    assert first.startswith("interrupted") and second.startswith("and on")
    assert float(first.split()[1]) < 1.5
