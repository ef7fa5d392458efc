#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace lepp::test {

/// A file of the folder LEPP_TEST_DATA, or nothing if that is not set: then the test that asked
/// does without, and the file counts as skipped in the summary.
std::optional<std::filesystem::path> real_input(const std::string& name);

/// True if LEPP_TEST_DATA is set.
bool has_real_inputs();

std::size_t skipped_files();

}  // namespace lepp::test
