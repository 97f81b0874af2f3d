#!/bin/sh
# Builds the program and skeletonises CGAL's sample models: a skeleton, a page and a picture of each.
set -eu
cd "$(dirname "$0")/.."
sh cmake/prepare.sh program
echo "== Building the program"
cmake --build build --target skeletonize_point_set

results=build/sample_skeletons
mkdir -p "$results"
# Each with its vertical axis.
for model_up in dino:z elephant:y armadillo:y camel:y man:z knot2:y eight:z; do
  model=${model_up%:*}
  echo "== $model"
  build/examples/skeletonize_point_set "build/cgal_data/data/meshes/$model.off" --sample 20000 \
    --up "${model_up#*:}" -o "$results/$model.ply" -o "$results/$model.html" \
    -o "$results/$model.png" --stats
done
echo "Skeletons (.ply), pages to turn (.html) and pictures (.png) are in $PWD/$results"
