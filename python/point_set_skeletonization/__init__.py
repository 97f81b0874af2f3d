# Copyright (c) 2026 The Point_set_skeletonization_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Curve skeletons from raw point clouds: no normals, no mesh needed.

    skeleton = skeletonize(points)
    skeleton.save("skeleton.vtp")
"""

from ._core import (
    Branch,
    MixtureBuilder,
    Skeleton,
    __version__,
    skeletonize,
    skeletonize_as_published,
)

__all__ = ["Branch", "MixtureBuilder", "Skeleton", "skeletonize", "skeletonize_as_published"]
