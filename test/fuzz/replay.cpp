// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Every file of the corpus, as the fuzzers see it: with any compiler. Usage: replay CORPUS

#include "fuzzed_points.h"
#include "fuzzed_reader.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

int main(int, char** argv)
{
  std::size_t files = 0;
  for(const auto& folder : std::filesystem::directory_iterator(argv[1]))
    for(const auto& entry : std::filesystem::directory_iterator(folder)) {
      std::ifstream file(entry.path(), std::ios::binary);
      const std::vector<char> bytes(std::istreambuf_iterator<char>(file), {});
      const std::vector<std::uint8_t> data(bytes.begin(), bytes.end());
      const std::string target = folder.path().filename().string();
      std::cout << entry.path() << std::endl; // the last one is the culprit
      if(target == "points")
        fuzzed::fuzz_points(data.data(), data.size());
      else
        fuzz_reader(data.data(), data.size(), target);
      ++files;
    }
  std::cout << files << " files\n";
  return files > 0 ? 0 : 1;
}
