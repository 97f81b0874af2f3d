#!/bin/sh
# Builds the program and skeletonises CGAL's sample models: a skeleton and a picture of each.
set -eu
cd "$(dirname "$0")/.."
sh cmake/prepare.sh program
echo "== Building the program"
cmake --build build --target skeletonize_point_set

results=build/sample_skeletons
mkdir -p "$results"
# Each with its vertical axis, for the picture.
for model_up in dino:z elephant:y armadillo:y camel:y man:z knot2:y eight:z; do
  model=${model_up%:*}
  echo "== $model"
  build/examples/skeletonize_point_set "build/cgal_data/data/meshes/$model.off" --sample 20000 \
    --points "$results/$model.points.xyz" -o "$results/$model.ply" \
    -o "$results/$model.polylines.txt" --stats
  /usr/bin/python3 examples/draw_skeleton.py "$results/$model.ply" "$results/$model.points.xyz" \
    "$results/$model.png" --up "${model_up#*:}"
done
echo "Skeletons (.ply, .polylines.txt) and pictures (.png) are in $PWD/$results"
