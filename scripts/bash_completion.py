#!/usr/bin/env python3
# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Prints what completes the options of a program in bash, and the values of those that have a few: from what its --help
# says, and, of such values, from what it says of a wrong one.
#
#   scripts/bash_completion.py build/examples/Tubular_meshing/tubular_mesh > tubular_mesh

import os
import re
import subprocess
import sys
import tempfile

from options_table import LINE, entries_of, help_of, parts_of

SURFACES = "stl|off|obj|ply|vtp|vtu|vtk|msh|mesh"
FUNCTION = """# bash completion of {name}, made from its --help

_{name}()
{{
    local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}}
    COMPREPLY=()
    compopt -o filenames 2>/dev/null
    case $previous in
{values}
        {files})
            mapfile -t COMPREPLY < <(compgen -f -- "$current")
            return ;;
        {others})
            return ;;
    esac
    if [[ $current == -* ]]; then
        compopt +o filenames 2>/dev/null
        mapfile -t COMPREPLY < <(compgen -W "{options}" -- "$current")
        return
    fi
    local file
    while IFS= read -r file; do
        [[ -d $file || $file =~ \\.({surfaces})$ ]] && COMPREPLY+=("$file")
    done < <(compgen -f -- "$current")
}}
complete -F _{name} {name}
"""


def values_of(program, option):
    """The values that an option takes, where a wrong one is answered by a list of them."""
    command = [os.path.abspath(program), "no_such_file", "-o", "no_such_file.vtu", option, "no:such:value"]
    with tempfile.TemporaryDirectory() as folder:  # which takes a log of that name with it
        said = subprocess.run(command, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, universal_newlines=True,
                              cwd=folder).stderr
    found = re.search(r"is not in \{([^}]*)\}", said) or re.search(r"the types are: ([^.]*)\.", said)
    return [v.strip() for v in found.group(1).split(",")] if found else []


def main():
    if len(sys.argv) != 2:
        raise SystemExit("usage: bash_completion.py PROGRAM > COMPLETION")
    program = sys.argv[1]
    groups = parts_of(help_of(program))[1]
    options, values, files, others = [], [], [], []
    for _, lines in groups:
        for line in entries_of(lines):
            found = LINE.match(line)
            names = [n for n in found["names"].replace("{false}", "").split(",") if n.startswith("-")]
            options += names
            if not names or not found["type"]:
                continue
            choices = values_of(program, names[-1]) if found["type"] == "TEXT" else []
            if choices:
                values.append('        %s)\n            compopt +o filenames 2>/dev/null\n            mapfile -t COMPREPLY < <(compgen -W "%s" -- "$current")\n            return ;;'
                              % ("|".join(names), " ".join(choices)))
            elif found["type"] == "TEXT" and re.search(r"\bfile\b|write|\.vt[kp]\b", found["meaning"] or ""):
                files += names
            else:
                others += names
    name = re.sub(r".*/", "", program)
    print(FUNCTION.format(name=name, values="\n".join(values), files="|".join(files), others="|".join(others),
                          options=" ".join(options), surfaces=SURFACES), end="")


if __name__ == "__main__":
    main()
