// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_BYTE_ARCHIVE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_BYTE_ARCHIVE_H

#include <boost/crc.hpp>
#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <ostream>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

// Archives in the sense of Boost.Serialization, for numbers, arrays of numbers and strings. Those
// of Boost are not for files that go from machine to machine: the binary one depends on the
// machine, the text one is three times as large, and a newer Boost writes what an older one
// refuses.

/// The numbers that archives take: each has 64 bits.
template <typename T>
constexpr bool is_archived =
    std::is_same<T, std::uint64_t>::value || std::is_same<T, double>::value;

/// Writes numbers to a stream, the lowest byte first on any machine, and their checksum behind
/// them.
class Byte_writer
{
public:
  using is_saving = std::true_type;
  using is_loading = std::false_type;

  explicit Byte_writer(std::ostream& os) : os_(os) {}

  template <typename Number>
  std::enable_if_t<is_archived<Number>, Byte_writer&> operator&(const Number& x)
  {
    return *this & std::array<Number, 1>{{x}};
  }

  template <typename Number, std::size_t n>
  Byte_writer& operator&(const std::array<Number, n>& numbers)
  {
    static_assert(is_archived<Number>, "numbers of 64 bits");
    std::array<unsigned char, 8 * n> bytes;
    for(std::size_t i = 0; i < n; ++i)
      boost::endian::endian_store<Number, 8, boost::endian::order::little>(&bytes[8 * i],
                                                                           numbers[i]);
    write(bytes.data(), bytes.size());
    return *this;
  }

  Byte_writer& operator&(const std::string& text)
  {
    *this & std::uint64_t(text.size());
    write(text.data(), text.size());
    return *this;
  }

  /// Writes the checksum of all that was written. Nothing may follow.
  void write_checksum() { *this & std::uint64_t(checksum_.checksum()); }

private:
  void write(const void* bytes, std::size_t size)
  {
    checksum_.process_bytes(bytes, size);
    os_.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(size));
  }

  std::ostream& os_;
  boost::crc_32_type checksum_;
};

/// Reads what a `Byte_writer` wrote. \throws std::runtime_error where the stream ends too early
class Byte_reader
{
public:
  using is_saving = std::false_type;
  using is_loading = std::true_type;

  explicit Byte_reader(std::istream& is) : is_(is) {}

  template <typename Number>
  std::enable_if_t<is_archived<Number>, Byte_reader&> operator&(Number& x)
  {
    std::array<Number, 1> numbers;
    *this & numbers;
    x = numbers[0];
    return *this;
  }

  template <typename Number, std::size_t n>
  Byte_reader& operator&(std::array<Number, n>& numbers)
  {
    static_assert(is_archived<Number>, "numbers of 64 bits");
    std::array<unsigned char, 8 * n> bytes;
    read(bytes.data(), bytes.size());
    for(std::size_t i = 0; i < n; ++i)
      numbers[i] =
          boost::endian::endian_load<Number, 8, boost::endian::order::little>(&bytes[8 * i]);
    return *this;
  }

  Byte_reader& operator&(std::string& text)
  {
    std::uint64_t size;
    *this & size;
    text.clear();
    while(size > 0) { // a damaged size asks for no more memory than there are bytes
      std::array<char, 256> part;
      const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(size, part.size()));
      read(part.data(), count);
      text.append(part.data(), count);
      size -= count;
    }
    return *this;
  }

  /// \throws std::runtime_error if the checksum is not that of what was read, or is not the end
  void check_checksum()
  {
    const std::uint64_t expected = checksum_.checksum();
    std::uint64_t found;
    *this & found;
    if(found != expected || is_.peek() != std::istream::traits_type::eof())
      throw std::runtime_error("it is damaged: its checksum is wrong");
  }

private:
  void read(void* bytes, std::size_t size)
  {
    if(!is_.read(static_cast<char*>(bytes), static_cast<std::streamsize>(size)))
      throw std::runtime_error("it breaks off");
    checksum_.process_bytes(bytes, size);
  }

  std::istream& is_;
  boost::crc_32_type checksum_;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_BYTE_ARCHIVE_H
