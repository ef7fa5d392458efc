#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace lepp {

/// One word of a .geo script.
struct GeoToken {
  enum class Kind {
    name,    ///< letters, digits and underscores, not starting with a digit
    number,  ///< digits, with fraction and exponent
    string,  ///< between single or double quotes; `text` is what is between them
    symbol,  ///< any other single character
  };
  Kind kind = Kind::symbol;
  std::string_view text;
  std::size_t begin = 0, end = 0;  ///< bytes of the script it covers, quotes included
  std::size_t line = 1;

  bool is(std::string_view word) const { return kind != Kind::string && text == word; }
};

/// The words of a .geo script as Gmsh's own scanner cuts them: comments left out, no escapes in
/// strings. \pre `script` outlives the result
std::vector<GeoToken> geo_tokens(std::string_view script);

}  // namespace lepp
