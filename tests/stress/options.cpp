#include "stress/options.hpp"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <string_view>

namespace lepp::test {

namespace {

constexpr const char* usage =
    "usage: lepp_stress [--seed N] [--count N] [--seconds N] [--family NAME] [--threads N]\n"
    "                   [--folder PATH] [--refuse] [--predicates] [--save]\n";

template <class Number>
bool read(std::string_view text, Number& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

bool read_family(std::string_view text, std::optional<Family>& family) {
  const auto found = std::find(family_names.begin(), family_names.end(), text);
  if (found == family_names.end()) return false;
  family = static_cast<Family>(found - family_names.begin());
  return true;
}

bool read_value(std::string_view name, std::string_view value, StressOptions& options) {
  if (name == "--seed") return read(value, options.seed);
  if (name == "--count") return read(value, options.count);
  if (name == "--seconds") return read(value, options.seconds);
  if (name == "--threads") return read(value, options.threads) && options.threads > 0;
  if (name == "--family") return read_family(value, options.family);
  if (name == "--folder") return !(options.folder = value).empty();
  return false;
}

}  // namespace

std::optional<StressOptions> parse_stress_options(int argc, char** argv) {
  StressOptions options;
  for (int i = 1; i < argc; ++i) {
    const std::string_view name = argv[i];
    if (name == "--predicates") {
      options.predicates = true;
    } else if (name == "--refuse") {
      options.split = false;
    } else if (name == "--save") {
      options.save = true;
    } else if (i + 1 == argc || !read_value(name, argv[++i], options)) {
      std::fprintf(stderr, "%s", usage);
      for (const std::string_view family : family_names) {
        std::fprintf(stderr, "  family %.*s\n", static_cast<int>(family.size()), family.data());
      }
      return std::nullopt;
    }
  }
  return options;
}

}  // namespace lepp::test
