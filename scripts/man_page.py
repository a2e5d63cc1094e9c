#!/usr/bin/env python3
# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Prints the manual page of a program, from what its --help and --version say:
#
#   scripts/man_page.py build/examples/Tubular_meshing/tubular_mesh > tubular_mesh.1

import re
import subprocess
import sys

from options_table import LINE, entries_of, help_of, parts_of

HOMEPAGE_NOTE = "Its manual, with the meaning of all labels in all formats, comes with the sources."


def roff(text):
    """Plain text as roff: no character of it is a command."""
    text = text.replace("\\", "\\e").replace("-", "\\-").replace("…", "...")
    return re.sub(r"^([.'])", r"\\&\1", text, flags=re.M)


def bold_options(text):
    """Names of options in bold face."""
    return re.sub(r"(?<![\w\\-])(\\-\\-[a-z0-9](?:\w|\\-)*\w)", r"\\fB\1\\fR", roff(text))


def entry_of(line):
    """The head and the text of an option."""
    found = LINE.match(line)
    if not found:
        raise SystemExit("error: this line of --help cannot be read: " + line)
    value = {"TEXT": "TEXT", "FLOAT": "NUMBER", "INT": "INTEGER", "UINT": "INTEGER"}.get(found["type"], "")
    names = found["names"].replace("{false}", "").split(",")
    head = ", ".join("\\fB" + roff(n) + "\\fR" for n in names)
    if value and names[0].startswith("-"):
        head += " \\fI" + value + "\\fR"
    text = bold_options(found["meaning"] or "")
    if found["default"]:
        text += " (default: " + roff(found["default"]) + ")"
    for key, words in (("needs", "Needs"), ("excludes", "Not with")):
        if found[key]:
            text += ". " + words + " " + bold_options(found[key].strip().replace(" --", ", --"))
    return head, text[:1].upper() + text[1:] + "."


def main():
    if len(sys.argv) != 2:
        raise SystemExit("usage: man_page.py PROGRAM > PAGE.1")
    before, groups, after = parts_of(help_of(sys.argv[1]))
    version = subprocess.run([sys.argv[1], "--version"], stdout=subprocess.PIPE, universal_newlines=True, check=True)
    name, number = version.stdout.split()
    usage = next(line for line in before if line.startswith("Usage:"))
    described = [line for line in before if line and not line.startswith("Usage:")]
    summary = described[0].rstrip(".")
    print('.TH %s 1 "" "%s %s" "User Commands"' % (name.upper(), name, number))
    print(".SH NAME\n%s \\- %s" % (roff(name), roff(summary[0].lower() + summary[1:])))
    print(".SH SYNOPSIS\n.B %s\n%s" % (roff(name), roff(usage.split(" ", 2)[2])))
    print(".SH DESCRIPTION\n" + bold_options(" ".join(described)))
    for heading, lines in groups:
        print(".SH " + heading.upper())
        for line in entries_of(lines):
            print(".TP\n%s\n%s" % entry_of(line))
    print(".SH EXIT STATUS")
    statuses = " ".join(after)
    for status in re.findall(r"(\d+) ((?:[^,(]|\([^)]*\))+)", re.sub(r"^Exit status: |\. .*", "", statuses)):
        print(".TP\n%s\n%s" % (status[0], roff(status[1].strip().rstrip("."))))
    rest = re.sub(r"^Exit status: [^.]*\. ?", "", statuses)
    if rest:
        print(".SH FILES\n" + roff(rest))
    print(".SH EXAMPLES")
    for command, meaning in (
        ("aorta.stl -o aorta.vtu", "A mesh of tetrahedra, with 20 points round each circumference."),
        ("aorta.stl --dry-run -n 30", "What the mesh would be, without making it."),
        ("aorta.stl -t hexahedral -o case --case openfoam --flow-rate 80", "Hexahedra, and all that OpenFOAM needs beside them."),
    ):
        print(".TP\n%s\n%s" % (roff(name + " " + command), roff(meaning)))
    print(".SH NOTES\n" + HOMEPAGE_NOTE)


if __name__ == "__main__":
    main()
