// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry.h"

#include "l1_medial.h"
#include "l1_medial_published.h"
#include "l1_wlop.h"
#include "lapcon08_ec.h"
#include "lapcon08_vc.h"
#include "lapcon10.h"
#include "mcf.h"
#include "poisson_mcf.h"
#include "rosa.h"
#include "tangent_ball.h"
#include "teasar.h"
#include "wave_fronts.h"
#include "wrap_mcf.h"

#include <algorithm>
#include <stdexcept>

const std::vector<Registered_method>& registered_methods()
{
  static const std::vector<Registered_method> methods = {
      {"l1_medial", Needs::points, l1_medial, "this package"},
      {"l1_medial_published", Needs::points, l1_medial_published, "Lengauer et al."},
      {"l1_medial_published_tuned", Needs::points, l1_medial_published_tuned,
       "Lengauer et al., other parameters"},
      {"mcf", Needs::mesh, mcf, "CGAL, Tagliasacchi et al. 2012"},
      {"wrap_mcf", Needs::points, wrap_mcf, "CGAL, Portaneri et al. 2022, then mcf"},
      {"poisson_mcf", Needs::points_and_normals, poisson_mcf,
       "CGAL, Kazhdan et al. 2006, then mcf"},
      {"l1_wlop", Needs::points, l1_wlop, "Huang et al. 2013"},
      {"rosa", Needs::points_and_normals, rosa, "Tagliasacchi et al. 2009"},
      {"lapcon10", Needs::points, lapcon10, "Cao et al. 2010"},
      {"lapcon08_vc", Needs::mesh, lapcon08_vc, "Au et al. 2008, vertex clustering"},
      {"lapcon08_ec", Needs::mesh, lapcon08_ec, "Au et al. 2008, edge collapse"},
      {"wave_fronts", Needs::mesh, wave_fronts, "Lengauer et al., section 4.1"},
      {"teasar", Needs::mesh, teasar, "Sato et al. 2000"},
      {"tangent_ball", Needs::points_and_normals, tangent_ball, "Ma et al. 2012"},
  };
  return methods;
}

std::vector<Registered_method> methods_named(const std::vector<std::string>& names)
{
  const std::vector<Registered_method>& all = registered_methods();
  std::vector<Registered_method> methods;
  for(const std::string& name : names) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&name](const auto& method) { return method.name == name; });
    if(found == all.end())
      throw std::runtime_error("there is no method '" + name + "'");
    methods.push_back(*found);
  }
  return methods;
}
