// SPDX-License-Identifier: GPL-2.0-or-later
//
// lepp-gmsh FILE own-points|ends CPU-SECONDS MEMORY-BYTES
// Reads one file of the current folder with the Gmsh SDK and writes one record to descriptor 3.

#include <gmsh.h>
#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <new>
#include <string>
#include <string_view>

#include "boundary_points.hpp"
#include "inner_sizes.hpp"
#include "limits.hpp"
#include "read_geometry.hpp"
#include "read_mesh.hpp"

namespace {

using namespace lepp;
using namespace lepp::gmsh_helper;

constexpr int record_descriptor = 3;

struct Arguments {
  std::string file;
  bool own_points = false;
  std::uint64_t cpu_seconds = 0, memory_bytes = 0;
};

bool parse_count(std::string_view text, std::uint64_t& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && value > 0;
}

bool parse(int count, char** words, Arguments& arguments) {
  if (count != 5) return false;
  arguments.file = words[1];
  arguments.own_points = std::string_view(words[2]) == "own-points";
  return parse_count(words[3], arguments.cpu_seconds) &&
         parse_count(words[4], arguments.memory_bytes);
}

void start_gmsh() {
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::option::setNumber("General.NumThreads", 1);
  gmsh::logger::start();
}

/// What Gmsh says about the geometry beside errors.
void add_warnings(GmshRecord& record) {
  std::vector<std::string> log;
  gmsh::logger::get(log);
  constexpr std::string_view mark = "Warning: ";
  constexpr std::size_t enough = 20;
  auto& warnings = record.warnings;
  for (const std::string& line : log) {
    if (!line.starts_with(mark) || warnings.size() >= enough) continue;
    const std::string sentence = line.substr(mark.size());
    if (std::find(warnings.begin(), warnings.end(), sentence) == warnings.end())
      warnings.push_back(sentence);
  }
}

void read_file(const Arguments& arguments, GmshRecord& record) {
  gmsh::open(arguments.file);
  std::string error;
  gmsh::logger::getLastError(error);
  if (!error.empty()) throw error;  // with a changed General.AbortOnError nothing is thrown
  add_groups(record);
  if (arguments.file.ends_with(".msh")) {
    add_mesh(record);
  } else {
    add_geometry(record);
    if (arguments.own_points && !record.surfaces.empty()) {
      add_own_points(record);
      add_inner_sizes(record);
    }
  }
  add_warnings(record);
}

GmshRecord failed(GmshFailure failure) {
  GmshRecord record;
  record.failure = std::move(failure);
  return record;
}

GmshRecord read_guarded(const Arguments& arguments) {
  const std::string fix = "correct the file; Gmsh itself shows where";
  try {
    GmshRecord record;
    read_file(arguments, record);
    return record;
  } catch (const GmshFailure& failure) {
    return failed(failure);
  } catch (const std::string& message) {  // Gmsh throws strings
    return failed({ErrorKind::input, "", message, fix});
  } catch (const std::bad_alloc&) {
    return failed({ErrorKind::refused, "",
                   "reading it takes more than " + std::to_string(arguments.memory_bytes >> 20) +
                       " MiB of memory",
                   "simplify its lists, sizes and Transfinite numbers, or allow more memory"});
  } catch (const std::exception& error) {
    return failed({ErrorKind::input, "", error.what(), fix});
  }
}

bool send(const std::vector<std::byte>& bytes) {
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t n = ::write(record_descriptor, bytes.data() + sent, bytes.size() - sent);
    if (n < 0 && errno != EINTR) return false;
    if (n > 0) sent += static_cast<std::size_t>(n);
  }
  return true;
}

}  // namespace

int main(int count, char** words) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // nobody is left to read the record
  Arguments arguments;
  if (!parse(count, words, arguments)) return 1;
  limit_resources(arguments.cpu_seconds, arguments.memory_bytes);
  GmshRecord record;
  try {
    start_gmsh();
    forbid_writing();
    record = read_guarded(arguments);
  } catch (...) {
    record =
        failed({ErrorKind::refused, "", "Gmsh cannot start within the limits on memory and time",
                "allow more memory"});
  }
  const bool complete = send(encode(record));
  ::_exit(complete ? 0 : 1);  // Gmsh's own way out would write a preferences file
}
