// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SPATIAL_FLOAT_PACKET_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SPATIAL_FLOAT_PACKET_H

#include <Eigen/Geometry>

#include <boost/config.hpp>

#include <cstddef>
#include <cstring>
#include <limits>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Number of places of a packet.
constexpr std::size_t packet_size = 8;

/// `N` numbers in single precision; operations are done with each. `N` is a multiple of four, which
/// fill a register.
///
/// The same instructions as for an Eigen array, but registers are named: expressions of arrays have
/// a type each, and to compile these took a quarter of the time of a program.
template <std::size_t N>
class Float_packet
{
  using Register = typename Eigen::internal::find_best_packet<float, N>::type;
  static constexpr std::size_t size =
    N / static_cast<std::size_t>(Eigen::internal::unpacket_traits<Register>::size);

public:
  using Scalar = float;

  Float_packet() = default;
  BOOST_FORCEINLINE Float_packet(float all)
  {
    for(std::size_t i = 0; i < size; ++i)
      registers_[i] = Eigen::internal::pset1<Register>(all);
  }

  static Float_packet Zero() { return 0.f; }
  static Float_packet Constant(float all) { return all; }

  float operator[](std::size_t k) const
  {
    float value;
    std::memcpy(&value, reinterpret_cast<const char*>(registers_) + k * sizeof(float),
                sizeof(float));
    return value;
  }
  void set(std::size_t k, float value)
  {
    std::memcpy(reinterpret_cast<char*>(registers_) + k * sizeof(float), &value, sizeof(float));
  }

  friend BOOST_FORCEINLINE Float_packet operator+(const Float_packet& a, const Float_packet& b)
  {
    Float_packet result;
    for(std::size_t i = 0; i < size; ++i)
      result.registers_[i] = Eigen::internal::padd(a.registers_[i], b.registers_[i]);
    return result;
  }
  friend BOOST_FORCEINLINE Float_packet operator-(const Float_packet& a, const Float_packet& b)
  {
    Float_packet result;
    for(std::size_t i = 0; i < size; ++i)
      result.registers_[i] = Eigen::internal::psub(a.registers_[i], b.registers_[i]);
    return result;
  }
  friend BOOST_FORCEINLINE Float_packet operator*(const Float_packet& a, const Float_packet& b)
  {
    Float_packet result;
    for(std::size_t i = 0; i < size; ++i)
      result.registers_[i] = Eigen::internal::pmul(a.registers_[i], b.registers_[i]);
    return result;
  }
  friend BOOST_FORCEINLINE Float_packet operator/(const Float_packet& a, const Float_packet& b)
  {
    Float_packet result;
    for(std::size_t i = 0; i < size; ++i)
      result.registers_[i] = Eigen::internal::pdiv(a.registers_[i], b.registers_[i]);
    return result;
  }
  BOOST_FORCEINLINE Float_packet operator-() const
  {
    Float_packet result;
    for(std::size_t i = 0; i < size; ++i)
      result.registers_[i] = Eigen::internal::pnegate(registers_[i]);
    return result;
  }
  BOOST_FORCEINLINE Float_packet& operator+=(const Float_packet& b) { return *this = *this + b; }
  BOOST_FORCEINLINE Float_packet& operator-=(const Float_packet& b) { return *this = *this - b; }
  BOOST_FORCEINLINE Float_packet& operator*=(const Float_packet& b) { return *this = *this * b; }

  BOOST_FORCEINLINE Float_packet min(const Float_packet& b) const
  {
    Float_packet result;
    for(std::size_t i = 0; i < size; ++i)
      result.registers_[i] = Eigen::internal::pmin(registers_[i], b.registers_[i]);
    return result;
  }
  BOOST_FORCEINLINE Float_packet max(const Float_packet& b) const
  {
    Float_packet result;
    for(std::size_t i = 0; i < size; ++i)
      result.registers_[i] = Eigen::internal::pmax(registers_[i], b.registers_[i]);
    return result;
  }
  BOOST_FORCEINLINE Float_packet sqrt() const
  {
    Float_packet result;
    for(std::size_t i = 0; i < size; ++i)
      result.registers_[i] = Eigen::internal::psqrt(registers_[i]);
    return result;
  }
  BOOST_FORCEINLINE Float_packet inverse() const { return 1.f / *this; }

  BOOST_FORCEINLINE float minCoeff() const
  {
    Register all = registers_[0];
    for(std::size_t i = 1; i < size; ++i)
      all = Eigen::internal::pmin(all, registers_[i]);
    return Eigen::internal::predux_min(all);
  }
  BOOST_FORCEINLINE float maxCoeff() const
  {
    Register all = registers_[0];
    for(std::size_t i = 1; i < size; ++i)
      all = Eigen::internal::pmax(all, registers_[i]);
    return Eigen::internal::predux_max(all);
  }
  BOOST_FORCEINLINE float mean() const
  {
    Register all = registers_[0];
    for(std::size_t i = 1; i < size; ++i)
      all = Eigen::internal::padd(all, registers_[i]);
    return Eigen::internal::predux(all) / static_cast<float>(N);
  }

private:
  Register registers_[size];
};

/// Returns 1 for each positive number, else 0.
template <std::size_t N>
BOOST_FORCEINLINE Float_packet<N> is_positive(const Float_packet<N>& values)
{
  return (values * (std::numeric_limits<float>::max)()).max(0).min(1);
}

/// `N` vectors, or places.
template <std::size_t N>
struct Vector_packet
{
  using Values = Float_packet<N>;

  Values x, y, z;

  /// The vectors from these places to a point.
  BOOST_FORCEINLINE Vector_packet to(const Eigen::Vector3f& p) const
  {
    return {p.x() - x, p.y() - y, p.z() - z};
  }

  BOOST_FORCEINLINE Values dot(const Eigen::Vector3f& v) const
  {
    return x * v.x() + y * v.y() + z * v.z();
  }
  BOOST_FORCEINLINE Values dot(const Vector_packet& v) const
  {
    return x * v.x + y * v.y + z * v.z;
  }
  BOOST_FORCEINLINE Values squared_norm() const { return x * x + y * y + z * z; }

  /// Whether a place is closer to a box than its given squared distance.
  bool is_any_closer(const Eigen::AlignedBox3f& box, const Values& squared_distance) const
  {
    const Eigen::Vector3f &lower = (box.min)(), &upper = (box.max)();
    const Vector_packet to_box{(lower.x() - x).max(x - upper.x()).max(0),
                               (lower.y() - y).max(y - upper.y()).max(0),
                               (lower.z() - z).max(z - upper.z()).max(0)};
    return (to_box.squared_norm() - squared_distance).minCoeff() < 0;
  }
};

/// A value and a vector for each place of a packet.
using Packet_values = Float_packet<packet_size>;
using Packet_vectors = Vector_packet<packet_size>;

/// Returns the packet of the vectors `vector(k)`, k < `N`.
template <std::size_t N = packet_size, typename Vector>
Vector_packet<N> packet_of(const Vector& vector)
{
  Vector_packet<N> result;
  for(std::size_t k = 0; k < N; ++k) {
    const Eigen::Vector3f v = vector(k);
    result.x.set(k, v.x());
    result.y.set(k, v.y());
    result.z.set(k, v.z());
  }
  return result;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_SPATIAL_FLOAT_PACKET_H
