// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "histogram.h"

#include "../view/Color.h"
#include "html.h"

#include <algorithm>
#include <cmath>

using html::number;

// Bars grow with the square root of the number, so that a few bad elements are seen beside a million.
std::string histogram(const std::vector<double>& counts, const std::string& title) {
  const double width = 300, height = 110, left = 6, top = 22, bottom = 20;
  const double most = counts.empty() ? 0 : *std::max_element(counts.begin(), counts.end());
  std::string bars;
  const double step = (width - 2 * left) / double((std::max)(counts.size(), std::size_t(1)));
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (!(counts[i] > 0))
      continue;
    const double h = (std::max)(1., std::sqrt(counts[i] / most) * (height - top - bottom));
    const double from = double(i) / double(counts.size()), to = double(i + 1) / double(counts.size());
    bars += "<rect x=\"" + number(left + step * double(i)) + "\" y=\"" + number(height - bottom - h, 5) +
            "\" width=\"" + number(step - 1) + "\" height=\"" + number(h, 5) + "\" fill=\"" +
            color_on_scale((from + to) / 2).text() + "\" stroke=\"#888\" stroke-width=\".5\"><title>" + number(from) +
            " to " + number(to) + ": " + number(counts[i], 12) + "</title></rect>";
  }
  std::string axis;
  for (double x : {0., 0.5, 1.})
    axis += "<text x=\"" + number(left + x * (width - 2 * left)) + "\" y=\"" + number(height - 5) +
            "\" text-anchor=\"" +
            (x == 0   ? "start"
             : x == 1 ? "end"
                      : "middle") +
            "\">" + number(x) + "</text>";
  return "<svg class=\"histogram\" role=\"img\" viewBox=\"0 0 " + number(width) + " " + number(height) + "\" width=\"" +
         number(width) + "\" height=\"" + number(height) + "\"><title>" + html::escaped_for_xml(title) +
         ": histogram from 0 to 1, heights by the square root of the number</title><text x=\"" + number(left) +
         "\" y=\"14\">" + html::escaped_for_xml(title) + "</text>" + bars + "<path d=\"M" + number(left) + " " +
         number(height - bottom + 0.5) + "H" + number(width - left) + "\" stroke=\"currentColor\"/>" + axis +
         "</svg>\n";
}
