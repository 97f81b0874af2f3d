// What nearly every test includes and what is slow to compile. A test still includes what it uses.
#include "catch2.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <Eigen/Dense>
#include <boost/graph/adjacency_list.hpp>
