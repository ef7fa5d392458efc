#include "lepp/io/gmsh_tokens.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace lepp;

namespace {

std::vector<std::string> words(std::string_view script) {
  std::vector<std::string> result;
  for (const GeoToken& token : geo_tokens(script)) result.emplace_back(token.text);
  return result;
}

}  // namespace

TEST_CASE("names, numbers and symbols are words of their own") {
  CHECK(words("Point(1)={0,1.5e-3,-.5};") == std::vector<std::string>{"Point", "(", "1", ")", "=",
                                                                      "{", "0", ",", "1.5e-3", ",",
                                                                      "-", ".5", "}", ";"});
  CHECK(words("Mesh.Algorithm=6") == std::vector<std::string>{"Mesh", ".", "Algorithm", "=", "6"});
}

TEST_CASE("comments are left out, also at the end of the script") {
  CHECK(words("a // b\nc /* d\n e */ f // g") == std::vector<std::string>{"a", "c", "f"});
  CHECK(words("a /* never closed") == std::vector<std::string>{"a"});
}

TEST_CASE("strings end at their own quote and know no escapes") {
  const auto tokens = geo_tokens("'it\"s' \"// no comment\" \"a\\\" b");
  REQUIRE(tokens.size() == 4);
  CHECK(tokens[0].text == "it\"s");
  CHECK(tokens[1].text == "// no comment");
  CHECK(tokens[2].text == "a\\");
  CHECK(tokens[3].text == "b");
  CHECK_FALSE(geo_tokens("\"Mesh\"")[0].is("Mesh"));
}

TEST_CASE("words know their line and place") {
  const auto tokens = geo_tokens("a\n\n/* \n */ b");
  CHECK(tokens[1].line == 4);
  CHECK(tokens[1].begin == 11);
}
