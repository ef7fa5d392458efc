#include "support/real_inputs.hpp"

namespace lepp::test {

namespace {

// One counter per test program, told at its end.
std::size_t skipped = 0;

}  // namespace

std::optional<std::filesystem::path> real_input(const std::string& name) {
  const std::filesystem::path folder(LEPP_TEST_DATA);
  if (!folder.empty() && std::filesystem::exists(folder / name)) return folder / name;
  ++skipped;
  return std::nullopt;
}

bool has_real_inputs() { return !std::string(LEPP_TEST_DATA).empty(); }

std::size_t skipped_files() { return skipped; }

}  // namespace lepp::test
