// What nearly every test includes and what is slow to compile. A test still includes what it uses.
// Without Catch2, which test_main.cpp includes with another configuration than the tests.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <Eigen/Dense>
#include <boost/graph/adjacency_list.hpp>
