#!/usr/bin/env python3
# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Prints the options of a program as Markdown tables, from what its --help says, group by group:
#
#   scripts/options_table.py build/examples/Tubular_meshing/tubular_mesh > doc/Tubular_meshing/options.md
#
# It reads the form that CLI11 gives to --help: `  -n,--name TYPE=default Needs: --other   description`.

import re
import subprocess
import sys

LINE = re.compile(
    r"(?P<names>\S+)"
    r"(?: (?P<type>TEXT|FLOAT|INT|UINT|BOOLEAN)(?::(?P<check>\w+ in \[[^\]]*\]))?(?:=(?P<default>\S*))?)?"
    r"(?P<required> REQUIRED)?"
    r"(?: x \d+)?(?: \.\.\.)?"
    r"(?: Needs:(?P<needs>(?: --\S+)+))?"
    r"(?: Excludes:(?P<excludes>(?: --\S+)+))?"
    r"(?: +(?P<meaning>.*))?$"
)
TYPES = {"TEXT": " *text*", "FLOAT": " *number*", "INT": " *integer*", "UINT": " *integer*", "BOOLEAN": " *true or false*"}


def help_of(program):
    """The lines that `program --help` prints."""
    run = subprocess.run([program, "--help"], stdout=subprocess.PIPE, universal_newlines=True, check=True)
    return run.stdout.splitlines()


def is_heading(line):
    """Whether the line begins a group of options, or of positional arguments."""
    return bool(re.match(r"\S.*:$", line))


def entries_of(lines):
    """The options of one group, each with the lines that go on with its description joined to it."""
    entries = []
    for line in lines:
        if re.match(r"  \S", line):
            entries.append(line.strip())
        elif line.strip():
            entries[-1] += " " + line.strip()
    return entries


def parts_of(lines):
    """Splits the help into what is said before, the groups (heading and lines), and what is said after them."""
    before, groups, after = [], [], []
    for line in lines:
        if after:
            after.append(line)
        elif is_heading(line):
            groups.append((line[:-1], []))
        elif not groups:
            before.append(line)
        elif line and not line.startswith(" "):
            after.append(line)
        else:
            groups[-1][1].append(line)
    return before, groups, after


def marked_up(text):
    """Plain text as Markdown: names of options, of values with an underscore, and file extensions are code."""
    text = text.replace("<", "&lt;").replace("|", "\\|")
    text = re.sub(r"(?<![\w`-])(--[a-z][\w-]*|\.[a-z][a-z0-9]*\b(?!\.))", r"`\1`", text)
    return re.sub(r"(?<![\w`])([a-z]\w*_\w+)\b", r"`\1`", text)


def row_of(entry):
    """The cells of one option: its names and type, its meaning, its default."""
    found = LINE.match(entry)
    if not found:
        raise SystemExit("error: this line of --help cannot be read: " + entry)
    meaning = found["meaning"] or ""
    default = "required" if found["required"] else found["default"] or ""
    in_words = re.search(r" \(default: ((?:[^()]|\([^()]*\))*)\)$", meaning)
    if in_words:
        meaning, default = meaning[: in_words.start()], in_words[1]
    notes = []
    if found["check"]:
        notes.append(re.sub(r".*\[(\S+) - (\S+)\]", r"from \1 to \2", found["check"]))
    if found["needs"]:
        notes.append("needs " + found["needs"].strip().replace(" --", ", --"))
    if found["excludes"]:
        notes.append("not with " + found["excludes"].strip().replace(" --", ", --"))
    meaning = "; ".join([meaning] + notes)
    # of a flag and its negation, CLI11 adds the value that the latter stands for
    names = ", ".join("`" + name.replace("{false}", "") + "`" for name in found["names"].split(","))
    value = TYPES.get(found["type"], "") if found["names"].startswith("-") else ""
    return [names + value, marked_up(meaning), marked_up(default)]


def print_table(lines):
    print("| option | meaning | default |")
    print("|---|---|---|")
    for entry in entries_of(lines):
        print(re.sub(" +", " ", "| " + " | ".join(row_of(entry)) + " |"))


def paragraph(lines):
    print("\n".join(marked_up(line) for line in lines if line and not line.startswith("Usage:")))


def main():
    if len(sys.argv) != 2:
        raise SystemExit("usage: options_table.py PROGRAM > TABLE.md")
    before, groups, after = parts_of(help_of(sys.argv[1]))
    usage = next(line for line in before if line.startswith("Usage:"))
    print("# Options of " + usage.split()[1])
    print()
    print("<!-- Made by scripts/options_table.py from what --help prints: edit the program, not this file. -->")
    print()
    paragraph(before)
    print()
    print("    " + usage.split(" ", 1)[1])
    for heading, lines in groups:
        print()
        print("## " + heading[0].upper() + heading[1:].lower())
        print()
        print_table(lines)
    print()
    paragraph(after)


if __name__ == "__main__":
    main()
