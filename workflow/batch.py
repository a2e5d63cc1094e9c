# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The settings of the workflow as a command `tubular_mesh --batch ...`, which reads the table, makes each row, and writes
the index: Snakemake only tells it when."""
import json
import os
import shlex
import shutil
import subprocess

DEFAULTS = {"surfaces": "", "pattern": "*", "output": "meshes", "tool": "", "options": "", "format": "", "threads": 1,
            "timeout": 7200, "mem_mb": 4000, "limit_memory": False, "page_mb": 5, "retry": ""}


class Usage_error(Exception):
    """What is wrong with the settings or the table, in a sentence: nothing is run then."""


class Batch:
    """The configuration of Snakemake, checked; paths are absolute."""

    def __init__(self, config, tree):
        unknown = sorted(set(config) - set(DEFAULTS))
        if unknown:
            raise Usage_error("there is no setting %s; there are %s" % (unknown[0], ", ".join(DEFAULTS)))
        values = {k: DEFAULTS[k] if config.get(k) in (None, "") else config[k] for k in DEFAULTS}
        for key in ("surfaces", "pattern", "output", "tool", "options", "format", "retry"):
            if isinstance(values[key], (dict, list)):
                raise Usage_error("%s: text is wanted, in quotes where it has brackets or a colon" % key)
            values[key] = str(values[key])
        if not values["surfaces"]:
            raise Usage_error("name a folder or a table of surfaces: --config surfaces=...")
        if values["retry"] not in ("", "failed"):
            raise Usage_error("retry: %s is neither failed nor empty" % values["retry"])
        self.threads = number(values, "threads", 1)
        self.timeout = number(values, "timeout", 0)
        self.mem_mb = number(values, "mem_mb", 1)
        self.output = os.path.abspath(values["output"])
        self.command = [find_tool(values["tool"], tree)] + options_of(values, self.timeout, self.mem_mb)
        plan = self.plan()
        self.status_files = {row["id"]: row["status_file"] for row in plan["rows"]}
        self.pages, self.shown = plan["pages"], plan["shown"]

    def minutes(self):
        """What a scheduler is asked for: more than the run's own limit, so that it is the run that says so."""
        return self.timeout // 60 + 5 if self.timeout else 7 * 24 * 60

    def shell(self):
        """The command, for a shell."""
        return " ".join(map(shlex.quote, self.command))

    def plan(self):
        run = subprocess.run(self.command + ["--batch-step", "plan"], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                             stdin=subprocess.DEVNULL)
        if run.returncode != 0:
            said = run.stderr.decode("utf-8", "replace").strip()
            raise Usage_error(said or "%s ended with status %d" % (self.command[0], run.returncode))
        return json.loads(run.stdout.decode("utf-8"))


def options_of(values, timeout, mem_mb):
    try:
        options = shlex.split(values["options"])
    except ValueError as error:
        raise Usage_error("options: %s (%s)" % (values["options"], str(error).lower()))
    options = ["--batch", os.path.abspath(values["surfaces"]), "--output", os.path.abspath(values["output"]),
               "--pattern", values["pattern"], *options]
    options += ["--format", values["format"].lstrip(".")] if values["format"] else []
    options += ["--job-timeout", str(timeout)] if timeout else []
    options += ["--job-memory", str(mem_mb)] if truth(values, "limit_memory") else []
    page_mb = number(values, "page_mb", 0)
    options += ["--report-budget", str(page_mb)] if page_mb else ["--no-pages"]
    return options + (["--retry-failed"] if values["retry"] else [])


def number(values, key, least):
    try:
        value = int(str(values[key]))
    except ValueError:
        value = least - 1
    if value < least:
        raise Usage_error("%s: %s is not an integer from %d" % (key, values[key], least))
    return value


def truth(values, key):
    text = str(values[key]).lower()
    if text not in ("true", "false"):
        raise Usage_error("%s: %s is neither true nor false" % (key, values[key]))
    return text == "true"


def find_tool(name, tree):
    built = os.path.join(tree, "build", "examples", "Tubular_meshing", "tubular_mesh")
    for candidate in [name] if name else [built, "tubular_mesh"]:
        found = shutil.which(candidate)
        if found:
            return os.path.abspath(found)
    if name:
        raise Usage_error("tool: there is no program %s" % name)
    raise Usage_error("there is no tubular_mesh, neither in build/ nor on the PATH; build it, or name it by "
                      "--config tool=...")
