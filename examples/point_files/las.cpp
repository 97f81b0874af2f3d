// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "binary.h"
#include "formats.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace point_files {

namespace {

constexpr std::size_t header_size = 227;   // of versions 1.0 to 1.2: later ones begin alike
constexpr std::size_t header_size_4 = 375; // of version 1.4

// The header from its first byte on, by the offsets of the specification.
class Las_header
{
public:
  explicit Las_header(Input& input)
      : bytes_(header_size)
  {
    input.read(bytes_.data(), header_size);
    if(std::string(bytes_.data(), 4) != "LASF")
      throw Bad_file("it does not begin with LASF");
    size_ = number<std::uint16_t>(94);
    const std::size_t wanted = is_version_4() ? header_size_4 : header_size;
    if(size_ < wanted || data() < size_)
      throw Bad_file("its header is damaged");
    bytes_.resize(wanted);
    input.read(bytes_.data() + header_size, wanted - header_size);
    input.skip(data() - wanted);
  }

  template <typename Number>
  Number number(std::size_t offset) const
  {
    return decoded<Number>(bytes_.data() + offset, Byte_order::little);
  }

  std::uint8_t point_format() const { return number<std::uint8_t>(104); }
  std::uint16_t record_size() const { return number<std::uint16_t>(105); }

  std::uint64_t number_of_points() const
  {
    const std::uint64_t points = is_version_4() ? number<std::uint64_t>(247) : 0;
    return points != 0 ? points : number<std::uint32_t>(107);
  }

  double scale(std::size_t axis) const { return number<double>(131 + 8 * axis); }
  double offset(std::size_t axis) const { return number<double>(155 + 8 * axis); }

private:
  bool is_version_4() const
  {
    return number<std::uint8_t>(24) == 1 && number<std::uint8_t>(25) >= 4;
  }
  std::uint64_t data() const { return number<std::uint32_t>(96); }

  std::vector<char> bytes_;
  std::size_t size_ = 0;
};

void check(const Las_header& header)
{
  const int format = header.point_format();
  if(format >= 64) // LASzip marks its records by the upper bits
    throw Bad_file("it is compressed; unpack it, for instance by 'laszip -i FILE -o FILE.las'");
  if(format > 10)
    throw Bad_file("its point format " + std::to_string(format) + " is not one of 0 to 10");
  const std::size_t least = format < 6 ? 20 : 30;
  if(header.record_size() < least)
    throw Bad_file("its header is damaged: records of " + std::to_string(header.record_size()) +
                   " bytes");
  for(std::size_t k = 0; k < 3; ++k)
    if(!std::isfinite(header.scale(k)) || !std::isfinite(header.offset(k)))
      throw Bad_file("its header is damaged: a scale or offset is not finite");
}

} // namespace

void read_las(Input& input, Rows& rows)
{
  const Las_header header(input);
  check(header);
  std::array<char, 12> record;
  for(std::uint64_t i = 0; i < header.number_of_points(); ++i) {
    input.read(record.data(), record.size());
    input.skip(header.record_size() - record.size());
    std::array<double, 3> p;
    for(std::size_t k = 0; k < 3; ++k)
      p[k] = header.offset(k) +
             header.scale(k) * decoded<std::int32_t>(record.data() + 4 * k, Byte_order::little);
    rows.add_point(p[0], p[1], p[2]);
  }
}

} // namespace point_files
