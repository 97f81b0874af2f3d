# Copyright (c) 2026 The Point_set_skeletonization_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later

import os
from typing import Any, Callable, List, Optional, Sequence, Set, Union

import numpy
from numpy.typing import ArrayLike, NDArray

__version__: str

class Branch:
    vertices: NDArray[numpy.int64]
    parent: Optional[int]
    axis: int
    order: int
    closes_cycle: bool
    length: float
    chord: float
    mean_radius: float
    volume: float
    angle: float

class Skeleton:
    @property
    def vertices(self) -> NDArray[numpy.float64]: ...
    @property
    def radius(self) -> NDArray[numpy.float64]: ...
    @property
    def edges(self) -> NDArray[numpy.int64]: ...
    @property
    def point_map(self) -> NDArray[numpy.int64]: ...
    @property
    def branches(self) -> List[Branch]: ...
    def branches_from(self, roots: Sequence[int]) -> List[Branch]: ...
    def to_networkx(self) -> Any: ...
    def save(
        self, filename: Union[str, "os.PathLike[str]"], roots: Sequence[int] = ...
    ) -> None: ...

class MixtureBuilder:
    def __init__(self, box: Sequence[float], *, maximum_cells: int = ...) -> None: ...
    @property
    def box(self) -> List[float]: ...
    @property
    def sources(self) -> Set[str]: ...
    @property
    def number_of_points(self) -> int: ...
    @property
    def number_of_cells(self) -> int: ...
    def insert(self, points: ArrayLike, *, source: Optional[str] = ...) -> None: ...
    def merge(self, other: "MixtureBuilder") -> None: ...
    def save(self, filename: Union[str, "os.PathLike[str]"]) -> None: ...
    @staticmethod
    def load(filename: Union[str, "os.PathLike[str]"]) -> "MixtureBuilder": ...
    def skeletonize(
        self,
        *,
        single_component: bool = ...,
        is_tree: bool = ...,
        smallest_feature: Optional[float] = ...,
        threads: Optional[int] = ...,
        progress: Optional[Callable[[float], Optional[bool]]] = ...,
    ) -> Skeleton: ...

def skeletonize(
    points: ArrayLike,
    *,
    single_component: bool = ...,
    is_tree: bool = ...,
    maximum_cells: int = ...,
    smallest_feature: Optional[float] = ...,
    threads: Optional[int] = ...,
    progress: Optional[Callable[[float], Optional[bool]]] = ...,
) -> Skeleton: ...
def skeletonize_as_published(
    points: ArrayLike,
    *,
    tuned: bool = ...,
    halt: bool = ...,
    number_of_iterations: Optional[int] = ...,
    random_seed: int = ...,
    h_0: Optional[float] = ...,
    delta_h: Optional[float] = ...,
    mu: Optional[float] = ...,
    samples: Optional[int] = ...,
    alpha: Optional[float] = ...,
    levels: Optional[int] = ...,
    flatness: Optional[float] = ...,
    sample_flatness: Optional[float] = ...,
    alpha_min: Optional[float] = ...,
    b_min: Optional[int] = ...,
    d_max: Optional[float] = ...,
    threads: Optional[int] = ...,
    progress: Optional[Callable[[float], Optional[bool]]] = ...,
) -> Skeleton: ...
