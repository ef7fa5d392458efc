#pragma once

#include <sys/wait.h>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "io/scratch_folder.hpp"

namespace lepp::test {

using Json = nlohmann::json;

struct Outcome {
  int status = -1;  ///< exit status; 128 + signal where a signal ended it
  std::string out, err;
};

inline std::string content_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Runs the program `lepp` (or the one named) in `folder`, with a limit of 100 seconds.
inline Outcome run(const std::filesystem::path& folder, const std::string& arguments,
                   const std::string& program = LEPP_PROGRAM) {
  const auto err = folder / "stderr.txt";
  const std::string command = "cd '" + folder.string() + "' && timeout -s KILL 100 '" + program +
                              "' " + arguments + " 2> '" + err.string() + "'";
  Outcome outcome;
  FILE* pipe = ::popen(command.c_str(), "r");
  std::array<char, 4096> buffer;
  std::size_t n = 0;
  while ((n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0) {
    outcome.out.append(buffer.data(), n);
  }
  const int status = ::pclose(pipe);
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.err = content_of(err);
  std::filesystem::remove(err);
  return outcome;
}

inline std::string quoted(const std::filesystem::path& path) {
  std::string text(1, '\'');
  text += path.string();
  text += '\'';
  return text;
}

/// The measure of each group of a report, by dimension and name.
inline std::map<std::pair<int, std::string>, double> group_measures(const Json& report) {
  std::map<std::pair<int, std::string>, double> measures;
  for (const auto& g : report["groups"]) {
    const int dimension = g["dimension"];
    const char* key = dimension == 2 ? "area" : dimension == 1 ? "length" : "points";
    measures[{dimension, g["name"]}] = g.contains(key) ? g[key].get<double>() : 0.0;
  }
  return measures;
}

inline std::vector<std::string> files_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace lepp::test
