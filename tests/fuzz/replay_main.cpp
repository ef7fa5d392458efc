// Runs files, and all files of folders, through a fuzz target: fuzz_replay TARGET PATH...

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <vector>

#include "fuzz/target.hpp"

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_of(int argc, char** argv) {
  std::vector<fs::path> files;
  for (int i = 2; i < argc; ++i) {
    if (!fs::is_directory(argv[i])) {
      files.emplace_back(argv[i]);
      continue;
    }
    for (const auto& entry : fs::recursive_directory_iterator(argv[i])) {
      if (entry.is_regular_file()) files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

int main(int argc, char** argv) {
  using Target = void (*)(std::span<const std::uint8_t>);
  const std::string_view name = argc > 1 ? argv[1] : "";
  const Target target = name == "pslg_to_cdt"   ? lepp::test::fuzz_pslg_to_cdt
                        : name == "poly_reader" ? lepp::test::fuzz_poly_reader
                                                : nullptr;
  const std::vector<fs::path> files = files_of(argc, argv);
  if (target == nullptr || files.empty()) {
    std::fprintf(stderr, "usage: fuzz_replay pslg_to_cdt|poly_reader FILE_OR_FOLDER...\n");
    return 2;
  }
  for (const fs::path& file : files) {
    std::ifstream in(file, std::ios::binary);
    const std::vector<char> text{std::istreambuf_iterator<char>(in), {}};
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    std::fprintf(stderr, "%s\n", file.c_str());  // the last one named is the one that broke
    target(bytes);
  }
  std::printf("%zu inputs of %s: no failure\n", files.size(), argv[1]);
  return 0;
}
