# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The settings of the workflow, the rows of its folder or table, and what is asked for of each surface."""
import collections
import csv
import fnmatch
import hashlib
import json
import os
import re
import shlex
import shutil
import subprocess

ENDINGS = (".stl", ".off", ".obj", ".ply", ".vtp", ".vtu", ".vtk", ".msh", ".mesh")
DEFAULTS = {"surfaces": "", "pattern": "*", "output": "meshes", "tool": "", "options": "", "format": "vtu", "threads": 1,
            "timeout": 7200, "mem_mb": 4000, "limit_memory": False, "page_mb": 5, "retry": ""}

# The output of each format, where it is not the name with the format as its ending.
OUTPUTS = {"gmsh": "{}.msh", "medit": "{}.mesh", "abaqus": "{}.inp", "febio": "{}.feb", "fluent": "{}.cas",
           "exodus": "{}.exo", "openfoam": "case", "openfoam-binary": "case",
           "openfoam-regions": "case", "openfoam-regions-binary": "case", "svmultiphysics": "mesh-complete"}
FORMATS = set(OUTPUTS) | {"vtu", "su2", "xdmf", "cgns"}
SURFACE_FORMATS = {"stl", "vtp", "ply", "off", "obj", "vtk"}

SHORT_OPTIONS = {"-o": "--output", "-t": "--type", "-n": "--points-per-circumference", "-c": "--centerlines",
                 "-v": "--verbose", "-q": "--quiet"}
FILE_OPTIONS = {"--centerlines", "--seeds"}
SET_HERE = {"--output", "--report", "--report-budget", "--picture", "--threads", "--format"}


class Usage_error(Exception):
    """What is wrong with the settings or the table, in a sentence: nothing is run then."""


def stamp(path):
    """What tells a changed file from the one that there was; None of one that is not there."""
    try:
        s = os.stat(path)
        return [s.st_mtime_ns, s.st_size]
    except OSError:
        return None


def digest(value):
    return hashlib.sha256(json.dumps(value, sort_keys=True).encode()).hexdigest()[:16]


# ---- settings


class Settings:
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
        self.surfaces = os.path.abspath(values["surfaces"])
        self.pattern = values["pattern"]
        self.output = os.path.abspath(values["output"])
        self.format = values["format"].lstrip(".")
        if self.format not in FORMATS | SURFACE_FORMATS:
            raise Usage_error("format: %s is not among %s; and, of surfaces, %s"
                              % (self.format, ", ".join(sorted(FORMATS)), ", ".join(sorted(SURFACE_FORMATS))))
        self.retry = values["retry"] == "failed"
        self.threads = number(values, "threads", 1)
        self.timeout = number(values, "timeout", 0)
        self.mem_mb = number(values, "mem_mb", 1)
        self.page_mb = number(values, "page_mb", 0)
        self.memory_limit = self.mem_mb if truth(values, "limit_memory") else 0
        self.options = split_options(values["options"], os.getcwd())
        if self.options.problem:
            raise Usage_error("options: " + self.options.problem)
        self.tool = find_tool(values["tool"], tree)
        self.version = version_of(self.tool)

    def minutes(self):
        """What a scheduler is asked for: more than the run's own limit, so that it is the run that says so."""
        return self.timeout // 60 + 5 if self.timeout else 7 * 24 * 60


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


def version_of(tool):
    try:
        run = subprocess.run([tool, "--version"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, timeout=60,
                             stdin=subprocess.DEVNULL)
        text = run.stdout.decode("utf-8", "replace").strip()
    except (OSError, subprocess.TimeoutExpired) as error:
        raise Usage_error("tool: %s cannot be run (%s)" % (tool, error))
    if run.returncode != 0 or not text.startswith("tubular_mesh "):
        raise Usage_error("tool: %s is not tubular_mesh" % tool)
    return text


# ---- options


class Options:
    """Options of the program: groups of an option's name and its words, the files among these, and what is wrong."""

    def __init__(self):
        self.groups, self.files, self.problem = [], [], ""

    def names(self):
        return {name for name, words in self.groups}

    def words(self):
        return [word for name, words in self.groups for word in words]


def split_options(text, folder):
    """Words as a shell splits them; files that are read are looked for in the folder."""
    options = Options()
    try:
        words = shlex.split(text)
    except ValueError as error:
        options.problem = "these options cannot be split into words: %s (%s)" % (text, str(error).lower())
        return options
    for word in words:
        found = re.match(r"(--[a-z][\w-]*)(?:=(.*))?$|(-[a-zA-Z])(.*)$", word, re.DOTALL)
        if found:
            name = found.group(1) or SHORT_OPTIONS.get(found.group(3), found.group(3))
            value = found.group(2) if found.group(1) else found.group(4) or None
            options.groups.append((name, [found.group(1) or found.group(3)] + ([] if value is None else [value])))
        elif not options.groups:
            options.problem = "an option is wanted where there is %s" % word
            return options
        else:
            options.groups[-1][1].append(word)
    for name, words in options.groups:
        if name in SET_HERE:
            options.problem = "%s is set by the workflow: see its settings" % name
        if name in FILE_OPTIONS:
            words[1:] = [os.path.join(folder, word) for word in words[1:]]
            options.files += words[1:]
    return options


def combined(common, own):
    """The own options replace those of the same name."""
    result = Options()
    result.groups = [g for g in common.groups if g[0] not in own.names()] + own.groups
    result.files = [w for name, words in result.groups if name in FILE_OPTIONS for w in words[1:]]
    result.problem = own.problem
    return result


# ---- rows


class Row:
    """A surface: its name, its path as the table or the folder has it, and the other values of the table."""

    def __init__(self, folder, given, name="", options="", columns=(), place=""):
        self.given = given
        self.surface = os.path.join(folder, given)
        self.name = name or os.path.splitext(given)[0].lstrip("/")
        self.options = options
        self.columns = dict(columns)
        self.folder = folder
        self.place = place
        self.id = id_of(self.name)

    def shown(self):
        return [self.id, self.name, self.given, self.options, self.columns]


def id_of(name):
    """A name for files: the name itself if it is fit for that, else what is fit of it and a digest."""
    if re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9._-]{0,99}", name):
        return name
    fit = re.sub(r"[^A-Za-z0-9._-]+", "_", name).strip("._-")[-60:].lstrip("._-")
    return (fit + "-" if fit else "surface-") + hashlib.sha256(name.encode("utf-8", "surrogateescape")).hexdigest()[:8]


def read_rows(settings):
    """The rows of the folder or of the table, in its order. No two have the same name."""
    if os.path.isdir(settings.surfaces):
        rows = rows_of_folder(settings.surfaces, settings.pattern, settings.output)
    else:
        rows = rows_of_table(settings.surfaces)
    first = {}
    for row in rows:
        other = first.setdefault(row.id, row)
        if other is not row:
            raise Usage_error("%s and %s have the same name, %s; give each a name of its own in the column name"
                              % (other.place, row.place, row.name))
    return rows


def rows_of_folder(folder, pattern, output):
    if folder == output:
        raise Usage_error("the results would be among the surfaces: name another folder by output")

    def is_searched(path):
        return not (os.path.basename(path).startswith(".") or path == output
                    or os.path.isdir(os.path.join(path, ".status"))) # the last: of results of another run
    found = []
    for place, folders, files in os.walk(folder):
        folders[:] = [f for f in folders if is_searched(os.path.join(place, f))]
        for name in files:
            given = os.path.relpath(os.path.join(place, name), folder)
            if name.lower().endswith(ENDINGS) and not name.startswith(".") and fnmatch.fnmatch(given, pattern):
                found.append(given)
    if not found:
        raise Usage_error('the folder "%s" has no surfaces%s: %s'
                          % (folder, "" if pattern == "*" else " of the pattern " + pattern, " ".join(ENDINGS)))
    found.sort()
    number = collections.Counter(os.path.splitext(given)[0] for given in found)
    return [Row(folder, given, name=given if number[os.path.splitext(given)[0]] > 1 else "", place=given)
            for given in found]


def rows_of_table(path):
    try:
        with open(path, encoding="utf-8-sig", newline="") as table:
            text = table.read()
    except OSError as error:
        raise Usage_error('"%s" cannot be read (%s)' % (path, error.strerror))
    except UnicodeDecodeError:
        raise Usage_error('the table "%s" is not in UTF-8' % path)
    header_line = text.lstrip("\r\n").split("\n", 1)[0]
    columns = []
    for separator in ",;\t":
        columns = [c.strip() for c in next(csv.reader([header_line], delimiter=separator), [])]
        if "surface" in columns:
            break
    else:
        raise Usage_error('the table "%s" has no column surface; its first line is: %s'
                          % (path, header_line.strip()[:200] or "empty"))
    for column in columns:
        if column and columns.count(column) > 1:
            raise Usage_error('the table "%s" has two columns %s' % (path, column))
    reader = csv.reader(text.splitlines(True), delimiter=separator)
    rows, is_header = [], True
    try:
        for values in reader:
            values = [v.strip() for v in values]
            if not any(values):
                continue
            if is_header:
                is_header = False
                continue
            rows.append(row_of_table(path, columns, values, reader.line_num))
    except csv.Error as error:
        raise Usage_error('line %d of the table "%s" cannot be read (%s)' % (reader.line_num, path, error))
    if not rows:
        raise Usage_error('the table "%s" has no rows' % path)
    return rows


def row_of_table(path, columns, values, line):
    if len(values) > len(columns) and any(values[len(columns):]):
        raise Usage_error('line %d of the table "%s" has %d values for %d columns; values with a separator in them need '
                          'double quotes' % (line, path, len(values), len(columns)))
    row = dict(zip(columns, values))
    if not row.get("surface"):
        raise Usage_error('line %d of the table "%s" names no surface' % (line, path))
    others = [(c, row.get(c, "")) for c in columns if c and c not in ("surface", "name", "options")]
    return Row(os.path.dirname(os.path.abspath(path)), row["surface"], row.get("name", ""), row.get("options", ""), others,
               "line %d" % line)


# ---- requests


class Request:
    """All on which the mesh of a row depends, and which of the attempts at it is the one to have."""

    def __init__(self, settings, row):
        options = combined(settings.options, split_options(row.options, row.folder))
        form = settings.format
        self.data = {
            "id": row.id, "name": row.name, "surface": row.surface, "given": row.given, "stamp": stamp(row.surface),
            "options": options.words(), "files": [[f, stamp(f)] for f in options.files], "problem": options.problem,
            "output": OUTPUTS.get(form, "{}." + form).format(row.id), "format": form if form in FORMATS else "",
            "page_mb": settings.page_mb, "program": settings.version}
        self.digest = digest({k: v for k, v in self.data.items() if k not in ("name", "surface")})
        self.attempt = attempt_of(row.id, self.digest, settings)

    def json(self):
        return json.dumps(self.data, sort_keys=True)

    def status_file(self):
        return ".status/%s/%s-%d.json" % (self.data["id"], self.digest, self.attempt)


def requests(settings, rows):
    return {row.id: Request(settings, row) for row in rows}


def read_status(output, id):
    """What was written of the row last: the digest of the request, the attempt, and the status; None if nothing."""
    folder = os.path.join(output, ".status", id)
    latest = None
    try:
        for name in os.listdir(folder):
            found = re.fullmatch(r"([0-9a-f]+)-([0-9]+)\.json", name)
            if not found:
                continue
            path = os.path.join(folder, name)
            age = os.stat(path).st_mtime_ns
            if latest is None or age > latest[0]:
                with open(path, encoding="utf-8") as file:
                    latest = age, found.group(1), int(found.group(2)), json.load(file)
    except (OSError, ValueError):
        pass # as if it had not been made
    return latest[1:] if latest else None


def attempt_of(id, wanted, settings):
    """That which there is, unless it failed and is to be made again, or its files are not there any more."""
    known = read_status(settings.output, id)
    if known is None or known[0] != wanted:
        return 0
    status = known[2]
    folder = os.path.join(settings.output, "meshes", id)
    if status["status"] == 0:
        is_wanted = any(not os.path.exists(os.path.join(folder, file)) for file in status["files"])
    else:
        is_wanted = settings.retry
    return known[1] + is_wanted
