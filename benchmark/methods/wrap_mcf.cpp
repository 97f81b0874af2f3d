// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wrap_mcf.h"

#include "alpha_wrap.h"
#include "mcf.h"

Method_result wrap_mcf(const Method_input& input)
{
  Method_result result;
  Method_input wrapped;
  wrapped.components = timed_stage(result, "wrap", [&] { return fine_alpha_wrap(input.points); });
  return after(result, mcf(wrapped));
}
