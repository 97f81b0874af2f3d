// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The binary formats, built byte by byte; text is tested with the program.

#include "catch2.h"

#include "read_file.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Corner = std::array<double, 3>;

// A file as bytes, little endian.
class Bytes
{
public:
  template <typename Number>
  Bytes& add(Number number)
  {
    return put(bytes_.size(), number);
  }

  template <typename Number>
  Bytes& put(std::size_t offset, Number number)
  {
    std::array<char, sizeof(Number)> native;
    std::memcpy(native.data(), &number, sizeof(Number)); // tests run on such machines
    bytes_.resize(std::max(bytes_.size(), offset + sizeof(Number)));
    bytes_.replace(offset, sizeof(Number), native.data(), sizeof(Number));
    return *this;
  }

  Bytes& add_text(const std::string& text)
  {
    bytes_ += text;
    return *this;
  }

  const std::string& string() const { return bytes_; }

private:
  std::string bytes_;
};

struct Found
{
  std::vector<Corner> points;
  std::vector<std::vector<std::size_t>> faces;
  std::size_t skipped = 0;
};

Found read(const std::string& bytes, const std::string& format, bool skip_invalid = false)
{
  std::stringbuf buffer(bytes);
  point_files::Input input(buffer, bytes.size());
  point_files::Reading_options options;
  options.format = format;
  options.skip_invalid = skip_invalid;
  Found found;
  point_files::Rows rows(
      [&found](double x, double y, double z) {
        found.points.push_back({{x, y, z}});
      },
      skip_invalid);
  rows.keep_faces();
  point_files::read_bytes(input, "file", options, rows);
  found.faces = rows.faces();
  found.skipped = rows.number_of_skipped();
  return found;
}

std::string las(std::uint8_t minor, std::uint8_t format, std::uint16_t record)
{
  const std::uint16_t header = minor >= 4 ? 375 : minor == 3 ? 235 : 227;
  const std::uint32_t extra = 100; // variable length records
  Bytes bytes;
  bytes.add_text("LASF").put<std::uint8_t>(24, 1).put(25, minor).put(94, header);
  bytes.put<std::uint32_t>(96, header + extra).put(104, format).put(105, record);
  bytes.put<std::uint32_t>(107, format < 6 ? 2 : 0);
  for(const std::size_t k : {0u, 1u, 2u}) {
    bytes.put(131 + 8 * k, 0.01);
    bytes.put(155 + 8 * k, 500000. * static_cast<double>(k));
  }
  if(minor >= 4)
    bytes.put<std::uint64_t>(247, 2);
  std::size_t place = header + extra;
  for(const std::int32_t i : {1, -1}) {
    for(const std::int32_t k : {0, 1, 2})
      bytes.put(place + 4 * static_cast<std::size_t>(k), i * (100 + k));
    bytes.put<std::uint8_t>(place + record - 1u, 0);
    place += record;
  }
  return bytes.string();
}

} // namespace

TEST_CASE("LAS of every version and point format")
{
  const std::vector<Corner> expected{{{1, 500000 + 1.01, 1000000 + 1.02}},
                                     {{-1, 500000 - 1.01, 1000000 - 1.02}}};
  const std::array<std::uint16_t, 11> records{{20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67}};
  for(std::uint8_t format = 0; format <= 10; ++format)
    for(std::uint8_t minor = format < 4 ? 0 : format < 6 ? 3 : 4; minor <= 4; ++minor)
      for(const int more : {0, 6}) { // extra bytes are allowed
        CAPTURE(static_cast<int>(format), static_cast<int>(minor), more);
        const std::string bytes =
            las(minor, format, static_cast<std::uint16_t>(records[format] + more));
        CHECK(read(bytes, "las").points == expected);
        CHECK_THROWS_WITH(read(bytes.substr(0, bytes.size() - 1), "las"),
                          ContainsSubstring("breaks off or is damaged after 1 points"));
      }
  CHECK_THROWS_WITH(read(las(2, 128, 20), "laz"), ContainsSubstring("compressed"));
  CHECK_THROWS_WITH(read(las(2, 11, 20), "las"), ContainsSubstring("point format 11"));
  CHECK_THROWS_WITH(read(las(2, 0, 19), "las"), ContainsSubstring("damaged"));
}

TEST_CASE("PCD as text, binary and compressed")
{
  const auto header = [](const std::string& data) {
    return "# .PCD v.7\nVERSION .7\nFIELDS intensity x y z\nSIZE 2 4 4 8\nTYPE U F F F\n"
           "COUNT 2 1 1 1\nWIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA " +
           data + "\n";
  };
  const std::vector<Corner> expected{{{1.5, 2.5, 3.25}}, {{-1, -2, 1e300}}};
  CHECK(read(header("ascii") + "7 8 1.5 2.5 3.25\n9 9 -1 -2 1e300\n", "pcd").points == expected);

  Bytes binary;
  for(const Corner& p : expected) {
    binary.add<std::uint16_t>(7).add<std::uint16_t>(8);
    binary.add(static_cast<float>(p[0])).add(static_cast<float>(p[1])).add(p[2]);
  }
  CHECK(read(header("binary") + binary.string(), "pcd").points == expected);

  Bytes columns; // those of all points one after the other
  for(int i = 0; i < 4; ++i)
    columns.add<std::uint16_t>(7);
  for(const std::size_t k : {0u, 1u})
    for(const Corner& p : expected)
      columns.add(static_cast<float>(p[k]));
  for(const Corner& p : expected)
    columns.add(p[2]);
  // Four equal numbers: one as it is, and a copy of two bytes further back for the six bytes of the
  // others; the rest as it is.
  const std::string rest = columns.string().substr(8);
  const std::string compressed = std::string("\1\7\0\200\1\037", 6) + rest;
  Bytes sizes;
  sizes.add(static_cast<std::uint32_t>(compressed.size()));
  sizes.add(static_cast<std::uint32_t>(columns.string().size()));
  CHECK(read(header("binary_compressed") + sizes.string() + compressed, "pcd").points == expected);
  const std::string damaged = std::string("\1\7\0\200\3\037", 6) + rest; // back before the begin
  CHECK_THROWS_WITH(read(header("binary_compressed") + sizes.string() + damaged, "pcd"),
                    ContainsSubstring("damaged"));
}

TEST_CASE("STL as text and binary: corners at one place are one vertex")
{
  const std::vector<Corner> expected{{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{1, 1, 0}}};
  const std::vector<std::vector<std::size_t>> faces{{0, 1, 2}, {2, 1, 3}};
  std::string text = "solid name\n";
  Bytes binary;
  binary.add_text("solid" + std::string(75, ' ')).add<std::uint32_t>(2);
  for(const auto& face : faces) {
    text += "facet normal 0 0 1\nouter loop\n";
    binary.add(0.f).add(0.f).add(1.f);
    for(const std::size_t v : face) {
      text += "vertex";
      for(const double x : expected[v]) {
        text += ' ' + std::to_string(x);
        binary.add(static_cast<float>(x));
      }
      text += '\n';
    }
    text += "endloop\nendfacet\n";
    binary.add<std::uint16_t>(0);
  }
  for(const std::string& bytes : {text + "endsolid name\n", binary.string()}) {
    const Found found = read(bytes, "stl");
    CHECK(found.points == expected);
    CHECK(found.faces == faces);
  }
  CHECK_THROWS(read(text, "stl"));
}

TEST_CASE("OBJ: places from the first and from the last vertex")
{
  const Found found =
      read("v 0 0 0\nv 1 0 0\nv 0 1 0 1\nvn 0 0 1\nf 1//1 2//1 3//1\nf -3 -2 -1\n", "obj");
  CHECK(found.points.size() == 3);
  CHECK(found.faces == std::vector<std::vector<std::size_t>>{{0, 1, 2}, {0, 1, 2}});
  CHECK_THROWS_WITH(read("v 0 0 0\nf -2 1 1\n", "obj"), ContainsSubstring("line 2 names no vertex"));
  CHECK_THROWS_WITH(read("v 0 0 0\nf 0 1 1\n", "obj"), ContainsSubstring("line 2 names no vertex"));
  CHECK_THROWS_WITH(read("v 0 0 0\nf 1 1 2\n", "obj"),
                    ContainsSubstring("face 0 names vertex 1 of 1"));
}

TEST_CASE("OFF and PLY, binary, of any type and byte order")
{
  Bytes off; // big endian
  off.add_text("CNOFF BINARY\n");
  const auto big = [&off](std::uint32_t bits) {
    for(int shift = 24; shift >= 0; shift -= 8)
      off.add(static_cast<std::uint8_t>(bits >> shift));
  };
  for(const std::uint32_t word : {1u, 1u, 0u, 0x3f800000u, 0x40000000u, 0xc0400000u})
    big(word);
  for(int i = 0; i < 7; ++i)
    big(0); // normal and colour
  for(const std::uint32_t word : {1u, 0u, 0u})
    big(word);
  const Found found = read(off.string(), "off");
  CHECK(found.points == std::vector<Corner>{{{1, 2, -3}}});
  CHECK(found.faces == std::vector<std::vector<std::size_t>>{{0}});

  Bytes ply;
  ply.add_text("ply\nformat binary_little_endian 1.0\nelement camera 1\nproperty list uchar int a\n"
               "element vertex 2\nproperty uchar red\nproperty int z\nproperty short x\n"
               "property double y\nelement edge 1000000000\nproperty int v\nend_header\n");
  ply.add<std::uint8_t>(2).add<std::int32_t>(0).add<std::int32_t>(0);
  for(const int i : {1, -1})
    ply.add<std::uint8_t>(255)
        .add<std::int32_t>(3 * i)
        .add(static_cast<std::int16_t>(i))
        .add(2. * i);
  CHECK(read(ply.string(), "ply").points == std::vector<Corner>{{{1, 2, 3}}, {{-1, -2, -3}}});
}
