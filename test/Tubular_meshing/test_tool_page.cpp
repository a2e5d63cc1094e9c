// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The page and the picture of the command-line tool as files: test/Tubular_meshing/page opens the page in a browser.

#include "test_tool_helpers.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#ifdef TUBULAR_MESH_TOOL

namespace {

using namespace tool_test;

// The content of the script element of an id.
std::string script_of(const std::string& page, const std::string& id) {
  const std::size_t at = page.find("<script id=\"" + id + "\"");
  if (at == std::string::npos)
    return "";
  const std::size_t begin = page.find('>', at) + 1;
  return page.substr(begin, page.find("</script>", begin) - begin);
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
    ++n;
  return n;
}

/* A picture as it is in the file, read by another way than it was written: filters of PNG are undone here. */
struct Picture {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> bytes;

  std::array<int, 3> at(std::uint32_t x, std::uint32_t y) const {
    const std::uint8_t* p = bytes.data() + 3 * (std::size_t(y) * width + x);
    return {p[0], p[1], p[2]};
  }
  // The share of pixels of which it holds.
  template <class Holds> double share(const Holds& holds) const {
    std::size_t n = 0;
    for (std::uint32_t y = 0; y < height; ++y)
      for (std::uint32_t x = 0; x < width; ++x)
        n += holds(at(x, y));
    return double(n) / double(width) / double(height);
  }
};

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t n = 0;
  for (std::size_t i = 0; i < 4; ++i)
    n = n << 8 | static_cast<unsigned char>(bytes.at(at + i));
  return n;
}

Picture picture_in(const std::string& file) {
  const std::string png = bytes_of(file);
  Picture picture;
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  std::string packed;
  bool has_end = false;
  for (std::size_t at = 8; at + 12 <= png.size();) {
    const std::uint32_t size = number_at(png, at);
    const std::string type = png.substr(at + 4, 4), content = png.substr(at + 8, size);
    EXPECT_EQ(number_at(png, at + 8 + size), crc32(0, reinterpret_cast<const Bytef*>(png.data() + at + 4), size + 4));
    if (type == "IHDR") {
      picture.width = number_at(content, 0);
      picture.height = number_at(content, 4);
    }
    packed += type == "IDAT" ? content : "";
    has_end = type == "IEND";
    at += 12 + size;
  }
  EXPECT_TRUE(has_end);
  const std::size_t row = 3 * std::size_t(picture.width);
  std::vector<Bytef> rows((row + 1) * picture.height);
  uLongf size = uLongf(rows.size());
  EXPECT_EQ(uncompress(rows.data(), &size, reinterpret_cast<const Bytef*>(packed.data()), uLong(packed.size())), Z_OK);
  EXPECT_EQ(size, rows.size());
  picture.bytes.resize(row * picture.height);
  for (std::size_t y = 0; y < picture.height; ++y)
    for (std::size_t i = 0; i < row; ++i) {
      const int filter = rows[y * (row + 1)];
      const int before = filter == 1 && i >= 3  ? picture.bytes[y * row + i - 3]
                         : filter == 2 && y > 0 ? picture.bytes[(y - 1) * row + i]
                                                : 0;
      picture.bytes[y * row + i] = std::uint8_t(rows[y * (row + 1) + 1 + i] + before);
    }
  return picture;
}

bool is_white(const std::array<int, 3>& c) {
  return c[0] == 255 && c[1] == 255 && c[2] == 255;
}

// --- the page ---

TEST_F(Tool, Page_has_the_report_and_its_tables) {
  succeed(tube_run(*this) + Arguments{"-n", "8", "--report", out("page.html"), "--report", out("report.json")});
  const std::string page = bytes_of(out("page.html"));
  const Json report = json_in(out("report.json"));
  EXPECT_EQ(Json::parse(script_of(page, "report")), report);
  EXPECT_EQ(page.compare(0, 15, "<!DOCTYPE html>"), 0);
  EXPECT_EQ(page.substr(page.size() - 8), "</html>\n");
  for (const char* section : {"quality", "openings", "branches", "places", "times", "command"})
    EXPECT_EQ(count(page, std::string("<section id=\"") + section + "\">"), 1u) << section;
  EXPECT_EQ(count(page, "<svg class=\"still\""), 2u);
  EXPECT_GE(count(page, "<svg class=\"histogram\""), 2u);
  const std::string tables = page.substr(0, page.find("<script"));
  EXPECT_EQ(count(tables, "<tr>"), count(tables, "</tr>"));
  for (const auto& o : report["openings"])
    EXPECT_NE(page.find("<th scope=\"row\">" + o["name"].get<std::string>() + "</th>"), std::string::npos);
  EXPECT_NE(page.find("--report"), std::string::npos) << "the command";
  EXPECT_EQ(count(page, "src=\"http") + count(page, "href=\"http") + count(page, "<link"), 0u)
      << "it needs nothing else";
}

TEST_F(Tool, Page_takes_names_as_text) {
  const std::string name = "a'b & </script><script>alert(1)</script>\xc3\xbc";
  succeed(tube_run(*this) + Arguments{"-n", "8", "--report", out("page.html"), "--rename", "inlet=" + name});
  const std::string page = bytes_of(out("page.html"));
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  EXPECT_EQ(count(page, "<script"), count(page, "</script>"));
  EXPECT_EQ(Json::parse(script_of(page, "report"))["openings"][0]["name"], name);
  EXPECT_NE(page.find("a'b &amp; &lt;/script&gt;&lt;script&gt;alert(1)&lt;/script&gt;\xc3\xbc"), std::string::npos);
}

// Names of files and patches are bytes: those that are no letters in UTF-8 have no place in JSON, XML and pages.
TEST_F(Tool, Names_need_not_be_UTF_8) {
  const Sample s = tube();
  succeed({make("ar\xeate.off", s.surface), "-c", make("lines.vtk", s.lines), "-n", "8", "--rename",
           "inlet=entr\xe9"
           "e",
           "-o", out("mesh.vtu"), "--report", out("report.json"), "--report", out("page.html"), "--write-0d",
           out("model.json")});
  const Json report = json_in(out("report.json"));
  EXPECT_NE(report["input"].get<std::string>().find("ar\xef\xbf\xbdte.off"), std::string::npos);
  EXPECT_EQ(report["openings"][0]["name"], "entr\xef\xbf\xbd"
                                           "e");
  EXPECT_EQ(Json::parse(script_of(bytes_of(out("page.html")), "report")), report);
  EXPECT_NE(bytes_of(out("mesh.vtu"))
                .find("Name=\"entr\xef\xbf\xbd"
                      "e\""),
            std::string::npos);
  EXPECT_EQ(json_in(out("model.json"))["boundary_conditions"][0]["bc_name"], "entr\xef\xbf\xbd"
                                                                             "e");
  succeed({in("ar\xeate.off"), "--dry-run", "--report", out("dry.json")});
  EXPECT_EQ(json_in(out("dry.json"))["input"], report["input"]);
}

TEST_F(Tool, Page_leaves_cells_out_that_do_not_fit) {
  const Arguments arguments = tube_run(*this) + Arguments{"-n", "16", "--report", out("page.html")};
  succeed(arguments);
  const std::string whole = bytes_of(out("page.html"));
  NEEDS("npm, for the viewer", !script_of(whole, "scene").empty());
  const Json all = Json::parse(script_of(whole, "scene"));
  EXPECT_EQ(all["cells"], all["cells_of_mesh"]);
  succeed(arguments + Arguments{"--report-budget", "0.1"});
  const std::string small = bytes_of(out("page.html"));
  const Json some = Json::parse(script_of(small, "scene"));
  EXPECT_EQ(some["cells"], 0);
  EXPECT_EQ(some["cells_of_mesh"], all["cells_of_mesh"]);
  EXPECT_EQ(some["facets"]["triangles"], all["facets"]["triangles"]);
  EXPECT_LT(small.size(), whole.size());
}

TEST_F(Tool, Page_is_whole_or_not_there) {
  Limits limits;
  limits.file_size = 40000; // the mesh has room
  const Outcome outcome = run(tube_run(*this) + Arguments{"-n", "8", "--report", out("page.html")}, limits);
  EXPECT_EQ(outcome.status, meshing);
  expect_one_sentence(outcome, {"page.html"});
  EXPECT_EQ(names_in(output_directory()), std::set<std::string>());
}

// --- the picture ---

TEST_F(Tool, Picture_shows_the_mesh) {
  succeed(tube_run(*this) + Arguments{"-n", "10", "--picture", out("mesh.png"), "--picture-size", "320x200"});
  const Picture picture = picture_in(out("mesh.png"));
  EXPECT_EQ(picture.width, 320u);
  EXPECT_EQ(picture.height, 200u);
  EXPECT_TRUE(is_white(picture.at(0, 0)));
  EXPECT_FALSE(is_white(picture.at(160, 100)));
  // a tube of length 6 and radius 1, from its side, in 94 % of the width or of the height
  const double across = 0.94 * (320 > 3 * 200 ? 320 : 200) / 320;
  EXPECT_GT(picture.share([](const auto& c) { return !is_white(c); }), 0.2 * across);
}

// The parts of the width and of the height that are not white.
std::array<double, 2> extents(const Picture& picture) {
  std::array<std::uint32_t, 2> low = {picture.width, picture.height}, high = {0, 0};
  for (std::uint32_t y = 0; y < picture.height; ++y)
    for (std::uint32_t x = 0; x < picture.width; ++x)
      if (!is_white(picture.at(x, y))) {
        const std::array<std::uint32_t, 2> at = {x, y};
        for (std::size_t k = 0; k < 2; ++k) {
          low[k] = (std::min)(low[k], at[k]);
          high[k] = (std::max)(high[k], at[k]);
        }
      }
  return {double(high[0] + 1 - low[0]) / picture.width, double(high[1] + 1 - low[1]) / picture.height};
}

TEST_F(Tool, Picture_cuts_whole_cells) {
  const Arguments arguments =
      tube_run(*this) + Arguments{"-n", "10", "--picture-view", "x", "--picture-size", "200x200"};
  const auto half = [&](const char* clip) {
    succeed(arguments + Arguments{"--picture", out("cut.png"), clip});
    return picture_in(out("cut.png"));
  };
  succeed(arguments + Arguments{"--picture", out("mesh.png")});
  const auto is_bluish = [](const std::array<int, 3>& c) {
    return c[2] > c[0] + 5;
  }; // as the lumen is; the wall is not
  const double without = picture_in(out("mesh.png")).share(is_bluish);
  const Picture cut = half("--clip=x");
  EXPECT_GT(cut.share(is_bluish), without + 0.1);
  const Picture other = half("--clip=-x"); // one sees the outside of what is left
  EXPECT_LT(other.share(is_bluish), without + 0.02);
  // of a tube six times as long as its radius a third is left, which fills the picture
  const std::array<double, 2> whole = extents(picture_in(out("mesh.png"))), part = extents(half("--clip=0,0,2,0,0,1"));
  EXPECT_NEAR(whole[1], 0.94, 0.03);
  EXPECT_NEAR(whole[0], 0.94 / 3, 0.05);
  EXPECT_GT(part[0], 2 * whole[0]);
  EXPECT_NEAR((std::max)(part[0], part[1]), 0.94, 0.03);
}

TEST_F(Tool, Picture_is_the_same_again) {
  const Arguments arguments =
      tube_run(*this) + Arguments{"-n", "8", "--picture", out("mesh.png"), "--picture-color", "size"};
  succeed(arguments);
  const std::string first = bytes_of(out("mesh.png"));
  succeed(arguments + reproducibly);
  EXPECT_TRUE(first == bytes_of(out("mesh.png")));
}

TEST_F(Tool, Picture_and_page_options_are_checked) {
  const Arguments arguments = tube_run(*this);
  expect_refused(*this, arguments + Arguments{"--picture", out("mesh.jpg")}, {"mesh.jpg", ".png"});
  expect_refused(*this, arguments + Arguments{"--clip", "x"}, {"--picture"});
  expect_refused(*this, arguments + Arguments{"--picture", out("a.png"), "--clip", "w"}, {"--clip", "w"});
  expect_refused(*this, arguments + Arguments{"--picture", out("a.png"), "--clip", "1,2,3,0,0,0"}, {"--clip"});
  expect_refused(*this, arguments + Arguments{"--picture", out("a.png"), "--picture-size", "9x9"}, {"9x9"});
  expect_refused(*this, arguments + Arguments{"--picture", out("a.png"), "--picture-size", "100x0x20"}, {"100x0x20"});
  expect_refused(*this, arguments + Arguments{"--picture", out("a.png"), "--picture-view", "0,0,0"}, {"0,0,0"});
  expect_refused(*this, arguments + Arguments{"--picture", out("a.png"), "--picture-color", "red"}, {"red"});
  expect_refused(*this, arguments + Arguments{"--report-budget", "5"}, {"--report"});
  expect_refused(*this, arguments + Arguments{"--report", out("a.html"), "--report-budget", "-1"}, {"budget"});
  expect_refused(*this, arguments + Arguments{"--report", out("a.html"), "--report", out("a.html")}, {"a.html"});
}

} // namespace

#endif // TUBULAR_MESH_TOOL
