#include "lepp/io/gmsh_mesh_cursor.hpp"

#include <fmt/format.h>

#include "lepp/geometry/error.hpp"

namespace lepp {

std::string_view MeshCursor::line() {
  const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
  std::string_view line = bytes_.substr(at_, end - at_);
  line_start_ = at_;
  at_ = std::min(end + 1, bytes_.size());
  while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
  while (!line.empty() && (line.front() == ' ' || line.front() == '\t')) line.remove_prefix(1);
  return line;
}

std::string_view MeshCursor::data_line(std::string_view what) {
  std::string_view found;
  do {
    if (at_end()) fail(fmt::format("the file ends before {}", what));
    found = line();
  } while (found.empty());
  if (found.front() == '$') fail(fmt::format("the section ends before {}", what));
  return found;
}

void MeshCursor::skip_words(std::uint64_t count, std::string_view what) {
  const auto is_space = [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); };
  for (std::uint64_t i = 0; i < count; ++i) {
    while (!at_end() && is_space(bytes_[at_])) ++at_;
    line_start_ = at_;
    if (at_end()) fail(fmt::format("the file ends before {}", what));
    if (bytes_[at_] == '$') fail(fmt::format("the section ends before {}", what));
    while (!at_end() && !is_space(bytes_[at_])) ++at_;
  }
}

void MeshCursor::skip_past(std::string_view mark) {
  const std::size_t found = bytes_.find(mark, at_);
  if (found == bytes_.npos) fail(fmt::format("{} is missing: the file is cut short", mark));
  at_ = found;
  line();
}

void MeshCursor::skip_bytes(std::uint64_t count, std::uint64_t bytes_each, std::string_view what) {
  checked_count(count, what, bytes_each);
  at_ += static_cast<std::size_t>(count * bytes_each);
}

std::uint64_t MeshCursor::checked_count(std::uint64_t count, std::string_view what,
                                        std::uint64_t least_bytes) const {
  const std::size_t left = bytes_.size() - at_;
  if (count > left / least_bytes)
    fail(fmt::format("{} {} are announced, but only {} bytes are left in the file", count, what,
                     left));
  return count;
}

void MeshCursor::fail(const std::string& problem, const std::string& remedy) const {
  const auto lines =
      std::count(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(line_start_), '\n');
  throw InputError(fmt::format("{}, line {}", name_, lines + 1), problem, remedy);
}

}  // namespace lepp
