// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_CHOSEN_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_CHOSEN_H

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

/// What has the names that were asked for; all if none were.
/// \param name_of a function of an item \param kind of item, for the message
/// \throw std::runtime_error if a name is not known
template <typename Item, typename Name_of>
std::vector<Item> chosen(const std::vector<std::string>& names, const std::vector<Item>& all,
                         const Name_of& name_of, const std::string& kind)
{
  if(names.empty())
    return all;
  std::vector<Item> result;
  for(const std::string& name : names) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const Item& item) { return name_of(item) == name; });
    if(found == all.end())
      throw std::runtime_error("there is no " + kind + " '" + name + "'");
    result.push_back(*found);
  }
  return result;
}

/// The same for names.
inline std::vector<std::string> chosen(const std::vector<std::string>& names,
                                       const std::vector<std::string>& all, const std::string& kind)
{
  return chosen(
      names, all, [](const std::string& name) { return name; }, kind);
}

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_CHOSEN_H
