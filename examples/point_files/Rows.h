// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_POINT_FILES_ROWS_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_POINT_FILES_ROWS_H

#include "Input.h"

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace point_files {

/// Takes what a reader finds, row by row in the order of the file: points, and the faces between
/// them. Rows that are no finite points are left out and counted, or an error.
class Rows
{
public:
  using Use_point = std::function<void(double x, double y, double z)>;
  using Face = std::vector<std::size_t>;

  /// Without memory for points: `use` gets them. Faces are checked only.
  Rows(Use_point use, bool skip_invalid)
      : use_(std::move(use))
      , skip_invalid_(skip_invalid)
  {}

  /// Also keeps the faces.
  void keep_faces() { keeps_faces_ = true; }

  /// \throw std::invalid_argument if it is not finite and must not be skipped
  void add_point(double x, double y, double z);

  /// A row that is no point at all. \throw Bad_file that says `why`, unless it is skipped
  void add_invalid(const std::string& why);

  /// A face by the rows of its vertices, which may follow.
  void add_face(const Face& face);

  /// To be called at the end. Faces with a vertex that was skipped are skipped, and the others are
  /// renumbered. \throw Bad_file if a face has a vertex that is not there
  void finish();

  std::size_t number_of_rows() const { return rows_; }
  std::size_t number_of_points() const { return rows_ - number_of_skipped_; }
  std::size_t number_of_skipped() const { return number_of_skipped_; }
  std::vector<Face>& faces() { return faces_; }

private:
  void skip();

  Use_point use_;
  bool skip_invalid_;
  bool keeps_faces_ = false;
  std::size_t rows_ = 0;
  std::size_t number_of_skipped_ = 0;
  std::vector<std::size_t> skipped_; ///< Rows, ascending, if faces are kept.
  std::size_t number_of_faces_ = 0;
  std::size_t greatest_ = 0, face_of_greatest_ = 0;
  std::vector<Face> faces_;
};

} // namespace point_files

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_POINT_FILES_ROWS_H
