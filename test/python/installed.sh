#!/bin/sh
# What the backend named in pyproject.toml does after building, without it: the component `python`
# is installed into a folder, and the module is used from there.
# Usage: installed.sh CMAKE BUILD PYTHON
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$1" --install "$2" --component python --prefix "$folder" > /dev/null
cd "$folder"
installed=$(ls)
[ "$installed" = point_set_skeletonization ] || { echo "wrongly installed: $installed"; exit 1; }
"$3" -c '
import pathlib, numpy, point_set_skeletonization as pss
folder = pathlib.Path(pss.__file__).parent
assert folder.parent == pathlib.Path.cwd(), folder
assert (folder / "py.typed").exists() and (folder / "__init__.pyi").exists()
assert len(pss.skeletonize(numpy.zeros((9, 3))).vertices) == 1'
