// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Rows.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace point_files {

void Rows::add_point(double x, double y, double z)
{
  if(std::isfinite(x) && std::isfinite(y) && std::isfinite(z)) {
    use_(x, y, z);
    ++rows_;
  }
  else if(skip_invalid_)
    skip();
  else
    throw std::invalid_argument("point " + std::to_string(rows_) +
                                " is not finite; --skip-invalid leaves such points out");
}

void Rows::add_invalid(const std::string& why)
{
  if(!skip_invalid_)
    throw Bad_file(why);
  skip();
}

void Rows::skip()
{
  if(keeps_faces_)
    skipped_.push_back(rows_);
  ++number_of_skipped_;
  ++rows_;
}

void Rows::add_face(const Face& face)
{
  for(const std::size_t v : face)
    if(v > greatest_) {
      greatest_ = v;
      face_of_greatest_ = number_of_faces_;
    }
  if(!face.empty())
    ++number_of_faces_;
  if(keeps_faces_)
    faces_.push_back(face);
}

void Rows::finish()
{
  if(number_of_faces_ > 0 && greatest_ >= rows_)
    throw Bad_file("face " + std::to_string(face_of_greatest_) + " names vertex " +
                   std::to_string(greatest_) + " of " + std::to_string(rows_));
  if(skipped_.empty())
    return;
  const auto was_skipped = [this](const Face& face) {
    return std::any_of(face.begin(), face.end(), [this](std::size_t v) {
      return std::binary_search(skipped_.begin(), skipped_.end(), v);
    });
  };
  faces_.erase(std::remove_if(faces_.begin(), faces_.end(), was_skipped), faces_.end());
  for(Face& face : faces_)
    for(std::size_t& v : face)
      v -= static_cast<std::size_t>(std::lower_bound(skipped_.begin(), skipped_.end(), v) -
                                    skipped_.begin());
}

} // namespace point_files
