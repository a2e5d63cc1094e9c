#!/usr/bin/env python3
# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes one surface of a cohort, in the folder of the results, and writes what became of it.

    mesh_surface.py --tool PROGRAM [--threads N] [--timeout SECONDS] [--memory MB] REQUEST STATUS.json

REQUEST is JSON, as cohort.Request has it. All that the program writes goes into a folder of its own, which becomes
meshes/ID when the program has ended with status 0. If it has not, there is no meshes/ID afterwards. Either way
STATUS.json is written last, and the exit status is 0. If this program is interrupted it writes nothing.
"""
import argparse
import json
import os
import re
import resource
import shlex
import shutil
import signal
import subprocess
import sys
import time

TIMED_OUT = 124 # as of timeout(1)


class Interrupted(Exception):
    pass


def on_signal(number, frame):
    raise Interrupted(number)


def remove(path):
    """A folder, at once: under another name while its files go."""
    if os.path.lexists(path):
        doomed = path + ".removed"
        shutil.rmtree(doomed, ignore_errors=True)
        os.rename(path, doomed)
        shutil.rmtree(doomed)


def write_whole(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path + ".part", "w", encoding="utf-8", errors="backslashreplace") as file:
        file.write(text)
    os.replace(path + ".part", path)


def command_of(arguments, request):
    command = [arguments.tool, request["surface"]] + request["options"]
    command += ["--threads", str(arguments.threads), "--report", request["id"] + ".json", "-o", request["output"]]
    if request["page_mb"] > 0:
        command += ["--report", request["id"] + ".html", "--report-budget", str(request["page_mb"])]
    command += ["--picture", request["id"] + ".png"]
    if not any(word.split("=")[0] == "--picture-size" for word in request["options"]):
        command += ["--picture-size", "320x240"]
    return command + (["--format", request["format"]] if request["format"] else [])


def run(command, folder, timeout, memory):
    """Its exit status, as a shell has it, and what it said on both channels."""
    def limit():
        resource.setrlimit(resource.RLIMIT_DATA, (memory << 20, memory << 20))
    said = []
    with open(os.path.join(folder, ".out"), "w+b") as out, open(os.path.join(folder, ".err"), "w+b") as err:
        process = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=out, stderr=err,
                                   preexec_fn=limit if memory else None)
        try:
            status = process.wait(timeout or None)
        except subprocess.TimeoutExpired:
            status = TIMED_OUT
        finally:
            if process.poll() is None:
                process.kill()
                process.wait()
        for channel in (out, err):
            channel.seek(0)
            said.append(channel.read().decode("utf-8", "replace"))
    os.remove(os.path.join(folder, ".out"))
    os.remove(os.path.join(folder, ".err"))
    return (128 - status if status < 0 else status), said[0], said[1]


def sentence_of(status, errors, arguments):
    """What the program says is wrong, or what is known where it could not say so."""
    stages = re.findall(r"^ *[0-9.]+ s  (.+)$", errors, re.MULTILINE)
    where = ", in the stage %s" % stages[-1].strip() if stages else ""
    if status == TIMED_OUT:
        return "The program was ended after %d s, the limit of time%s." % (arguments.timeout, where)
    said = re.findall(r"^tubular_mesh: (.+)$", errors, re.MULTILINE)
    if said:
        return said[-1].strip()
    if status == 128 + signal.SIGKILL:
        return "The program was killed, as the system does where memory runs out%s." % where
    if status > 128:
        return "The program was ended by signal %d%s." % (status - 128, where)
    if status == 0:
        return "The program wrote no mesh."
    lines = errors.strip().splitlines()
    return lines[-1].strip() if lines else "The program ended with status %d, and said nothing." % status


def make(request, arguments, scratch):
    """The mesh in the folder scratch: what is known of it."""
    result = {"status": 2, "sentence": request["problem"], "seconds": 0.0, "peak_memory_mb": 0.0}
    if request["problem"]:
        return result
    output = os.path.join(scratch, request["output"])
    command = command_of(arguments, request)
    begin = time.monotonic()
    try:
        status, out, errors = run(command, scratch, arguments.timeout, arguments.memory)
    except (OSError, ValueError) as error: # ValueError: of a null character in a path
        status, out, errors = 127, "", "The program cannot be run (%s)." % error
    result["seconds"] = round(time.monotonic() - begin, 3)
    result["peak_memory_mb"] = round(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024, 1)
    shown = " ".join(shlex.quote(word) for word in command)
    write_whole(os.path.join("logs", request["id"] + ".txt"), "%s\n\n%s%s" % (shown, errors, out))
    is_done = status == 0 and os.path.exists(output)
    result["status"] = status or (0 if is_done else 4)
    result["sentence"] = "" if is_done else sentence_of(status, errors, arguments)
    return result


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--tool", required=True)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--timeout", type=int, default=0)
    parser.add_argument("--memory", type=int, default=0)
    parser.add_argument("request")
    parser.add_argument("status")
    arguments = parser.parse_args()
    request = json.loads(arguments.request)
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, on_signal)

    scratch = os.path.abspath(os.path.join(".work", request["id"]))
    home = os.path.join("meshes", request["id"])
    try:
        shutil.rmtree(scratch, ignore_errors=True)
        os.makedirs(scratch)
        result = make(request, arguments, scratch)
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            signal.signal(number, signal.SIG_IGN) # what is left takes no time
        remove(home)
        if result["status"] == 0:
            os.makedirs("meshes", exist_ok=True)
            os.rename(scratch, home)
        result["files"] = sorted(os.listdir(home)) if result["status"] == 0 else []
    except Interrupted as interrupted:
        return 128 + interrupted.args[0]
    finally:
        shutil.rmtree(scratch, ignore_errors=True)
    result.update({key: request[key] for key in ("id", "name", "given", "options", "output", "program")})
    result["time"] = time.strftime("%Y-%m-%d %H:%M:%S")
    write_whole(arguments.status, json.dumps(result, indent=1) + "\n")
    for name in os.listdir(os.path.dirname(arguments.status)):
        if name != os.path.basename(arguments.status): # of another request, or of an attempt before
            os.remove(os.path.join(os.path.dirname(arguments.status), name))
    print("%s: %s" % (request["id"], result["sentence"] or "meshed in %.1f s" % result["seconds"]))
    return 0


if __name__ == "__main__":
    sys.exit(main())
