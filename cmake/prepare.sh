# Sourced by examples/run.sh and test/run.sh in the top folder: installs what is missing, unpacks
# CGAL's sample models and configures the folder build/.
sh cmake/install_prerequisites.sh
sh cmake/unpack_cgal_data.sh build/cgal_data
cmake -S . -B build -G Ninja
