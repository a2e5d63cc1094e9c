# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The index of a batch, as tests read it; and twelve surfaces with awkward names, one of them broken."""

import csv
import html.parser
import json
import os

COHORT = (("tube.stl", "tube"), ("curved.off", "curved"), ("y.stl", "y"), ("p 1/aorta.stl", "tube --noise 0.01"),
          ("p 2/aorta.stl", "y --capped"), ("it's \"quoted\" {x}.stl", "tube --capped"), ("broken.stl", "y"),
          ("Gefäß.ply", "curved --capped"), ("<i>&amp;.obj", "tube --sag 0.05"), ("$HOME.vtp", "y --noise 0.01 --seed 2"),
          ("-n.stl", "curved --noise 0.01"), ("arch.stl", "arch"))


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def index_of(folder):
    """The rows of index.csv, in their order."""
    with open(os.path.join(folder, "index.csv"), encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def made(folder):
    """When what is known of each surface was written."""
    times = {}
    for place, _, names in os.walk(os.path.join(folder, ".status")):
        for name in names:
            path = os.path.join(place, name)
            if name.endswith(".json"): # others are being written
                times[json.loads(read(path))["name"]] = os.stat(path).st_mtime_ns
    return times


class Page(html.parser.HTMLParser):
    """The cells of the page's rows by their labels, its links, and the tags that are not closed."""

    def __init__(self, folder):
        super().__init__()
        self.rows, self.links, self.pictures, self.open, self.label = [], [], [], [], None
        self.tags = set()
        self.feed(read(os.path.join(folder, "index.html")))

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.tags.add(tag)
        if tag not in ("meta", "img"):
            self.open.append(tag)
        if tag == "tr":
            self.rows.append({"class": attributes.get("class")})
        if tag == "td":
            self.label = attributes["data-label"]
            self.rows[-1][self.label] = ""
        if tag == "a":
            self.links.append(attributes["href"])
        if tag == "img":
            self.pictures.append(attributes["src"])

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, tag
        if tag == "td":
            self.label = None

    def handle_data(self, data):
        if self.label:
            self.rows[-1][self.label] += data
