#!/usr/bin/env python3
# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The radius along the vessels of a surface, as a plot.

    radius_along_vessel.py SURFACE [--output PLOT.png] [--spacing S]

From the inlet to each outlet: the radius of the disk that has the area of the lumen's cross-section, and that of the
largest ball in the lumen; the narrowest section is marked. Lengths are in the unit of the surface.

Exit status: 0 done, 77 there is no matplotlib (Debian: python3-matplotlib).
"""

import argparse
import sys

import numpy as np

import tubular_meshing as tm


def way_to(branches, last):
    """The branches from the inlet to the end of one of them."""
    way = [last]
    while branches[way[0]].parents:
        parent = branches[way[0]].parents[0]
        if parent in way:  # vessels that rejoin
            break
        way.insert(0, parent)
    return way


def along(way, branches, sections):
    """Distance from the inlet, section and inscribed radius of the sections of a way.

    Beside a bifurcation a section may run along the other vessel: its area is no vessel's, and left out (not a number).
    """
    distance, rows, before = [], [], 0.0
    for b in way:
        of_branch = np.flatnonzero((sections.branch == b) & (sections.area > 0))
        distance.append(before + sections.abscissa[of_branch])
        rows.append(of_branch)
        before += branches[b].length
    index = np.concatenate(rows)
    radius, inscribed = sections.radius[index], sections.inscribed_radius[index]
    return np.concatenate(distance), np.where(radius < 2 * inscribed, radius, np.nan), inscribed


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("surface")
    parser.add_argument("--output", default="radius.png")
    parser.add_argument("--spacing", type=float, default=0.2, help="of the sections, in local radii")
    arguments = parser.parse_args()
    try:
        import matplotlib

        matplotlib.use("Agg")
        from matplotlib import pyplot
    except ImportError as missing:
        print(f"Skipped: {missing}")
        return 77

    model = tm.Model(arguments.surface)
    branches, sections = model.branches, model.sections(arguments.spacing)
    outlets = [o for o in model.openings[1:] if o.branch is not None]
    figure, axes = pyplot.subplots(len(outlets), 1, figsize=(8, 2.4 * len(outlets)), squeeze=False, sharex=True)
    for outlet, ax in zip(outlets, axes[:, 0]):
        way = way_to(branches, outlet.branch)
        distance, radius, inscribed = along(way, branches, sections)
        ax.plot(distance, radius, label="of the cross-section's area")
        ax.plot(distance, inscribed, "--", label="of the largest ball")
        narrowest = np.nanargmin(radius)
        ax.plot(distance[narrowest], radius[narrowest], "v", color="black")
        ax.annotate(f"{radius[narrowest]:.3g}", (distance[narrowest], radius[narrowest]), (0, 10), textcoords="offset points",
                    ha="center", bbox={"facecolor": "white", "edgecolor": "none", "pad": 1})
        for end in np.cumsum([branches[b].length for b in way])[:-1]:
            ax.axvline(end, color="0.8", zorder=0)
        ax.set_ylim(0)
        ax.set_ylabel("radius")
        ax.set_title(f"{model.openings[0].name} to {outlet.name}", fontsize=10)
        print(f"{outlet.name}: {distance[-1]:.4g} long, narrowest {radius[narrowest]:.4g} at {distance[narrowest]:.4g}")
    axes[0, 0].legend()
    axes[-1, 0].set_xlabel("distance from the inlet; grey lines: bifurcations")
    figure.tight_layout()
    figure.savefig(arguments.output, dpi=120)
    return 0


if __name__ == "__main__":
    sys.exit(main())
