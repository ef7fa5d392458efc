#include "lepp/io/gmsh_statements.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <span>
#include <string_view>

#include "lepp/geometry/error.hpp"
#include "lepp/io/gmsh_tokens.hpp"

namespace lepp {
namespace {

using Tokens = std::span<const GeoToken>;

template <std::size_t n>
bool is_one_of(const GeoToken& token, const std::array<std::string_view, n>& words) {
  return std::any_of(words.begin(), words.end(), [&](auto word) { return token.is(word); });
}

// Statements that would run programs, write files or end the reader.
constexpr std::array<std::string_view, 8> refused = {
    "SystemCall", "System",  "NonBlockingSystemCall", "OnelabRun", "CreateDir", "Exit",
    "SyncModel",  "NewModel"};
// Statements that make or write meshes: blanked. The mesh is ours to make.
constexpr std::array<std::string_view, 13> blanked = {
    "Mesh",         "Save",         "Print",     "SetOrder",      "RefineMesh",
    "OptimizeMesh", "RelocateMesh", "AdaptMesh", "PartitionMesh", "RecombineMesh",
    "Compound",     "Sleep",        "Draw"};
constexpr std::array<std::string_view, 11> size_options = {"MeshSizeMin",
                                                           "MeshSizeMax",
                                                           "MeshSizeFactor",
                                                           "MeshSizeFromCurvature",
                                                           "CharacteristicLengthMin",
                                                           "CharacteristicLengthMax",
                                                           "CharacteristicLengthFactor",
                                                           "CharacteristicLengthFromCurvature",
                                                           "MinimumCirclePoints",
                                                           "MinimumCurvePoints",
                                                           "MinimumElementsPerTwoPi"};

/// The tokens after index i, as many as there are.
Tokens from(Tokens tokens, std::size_t i) { return tokens.subspan(std::min(i, tokens.size())); }

bool starts_with(Tokens tokens, std::initializer_list<std::string_view> words) {
  if (tokens.size() < words.size()) return false;
  return std::equal(words.begin(), words.end(), tokens.begin(),
                    [](auto word, const GeoToken& token) { return token.is(word); });
}

/// Index just past the bracket that closes the one at `open`, or the end.
std::size_t past_bracket(Tokens tokens, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < tokens.size(); ++i) {
    if (tokens[i].is("{") || tokens[i].is("(") || tokens[i].is("[")) ++depth;
    if (tokens[i].is("}") || tokens[i].is(")") || tokens[i].is("]")) --depth;
    if (depth == 0) return i + 1;
  }
  return tokens.size();
}

/// The parts of "{a, b, ...}" between its own commas.
std::vector<Tokens> list_items(Tokens braces) {
  std::vector<Tokens> items;
  std::size_t begin = 1;
  for (std::size_t i = 1; i < braces.size();) {
    if (braces[i].is(",") || i + 1 == braces.size()) {
      items.push_back(braces.subspan(begin, i - begin));
      begin = ++i;
    } else if (braces[i].is("{") || braces[i].is("(") || braces[i].is("[")) {
      i = past_bracket(braces, i);
    } else {
      ++i;
    }
  }
  return items;
}

std::optional<double> as_number(Tokens item) {
  if (item.size() != 1 || item[0].kind != GeoToken::Kind::number) return std::nullopt;
  double value = 0;
  const auto [end, error] =
      std::from_chars(item[0].text.data(), item[0].text.data() + item[0].text.size(), value);
  return error == std::errc() ? std::optional(value) : std::nullopt;
}

std::optional<int> as_tag(Tokens item) {
  if (!item.empty() && item[0].is("-")) item = item.subspan(1);
  const auto value = as_number(item);
  if (!value || *value < 0 || *value > 2e9) return std::nullopt;
  return static_cast<int>(*value);
}

/// Point(n) = {x, y, z, size}. A size written as 0 or 1e22 means none.
bool is_sized_point(Tokens tokens) {
  if (!starts_with(tokens, {"Point", "("})) return false;
  const std::size_t equals = past_bracket(tokens, 1);
  if (!starts_with(from(tokens, equals), {"=", "{"})) return false;
  const std::size_t end = past_bracket(tokens, equals + 1);
  const auto items = list_items(tokens.subspan(equals + 1, end - equals - 1));
  if (items.size() != 4) return false;
  const auto size = as_number(items[3]);
  return !size || (*size > 0 && *size < 1e22);
}

bool sets_size(Tokens tokens) {
  return is_sized_point(tokens) || starts_with(tokens, {"Characteristic", "Length"}) ||
         starts_with(tokens, {"MeshSize", "{"}) || starts_with(tokens, {"Transfinite", "Line"}) ||
         starts_with(tokens, {"Transfinite", "Curve"}) || starts_with(tokens, {"Field", "["}) ||
         starts_with(tokens, {"Field", "("}) || starts_with(tokens, {"Layers", "{"}) ||
         starts_with(tokens, {"Background", "Field"}) ||
         (starts_with(tokens, {"Mesh", "."}) && tokens.size() > 2 &&
          is_one_of(tokens[2], size_options));
}

/// Curve Loop(7) = {1, 2, -3}, if it is written with plain numbers.
std::optional<CurveLoopText> curve_loop(Tokens tokens) {
  if (!starts_with(tokens, {"Curve", "Loop", "("}) && !starts_with(tokens, {"Line", "Loop", "("}))
    return std::nullopt;
  const std::size_t equals = past_bracket(tokens, 2);
  if (!starts_with(from(tokens, equals), {"=", "{"})) return std::nullopt;
  CurveLoopText loop;
  const auto tag = as_tag(tokens.subspan(3, equals - 4));
  if (!tag) return std::nullopt;
  loop.tag = *tag;
  const std::size_t end = past_bracket(tokens, equals + 1);
  for (const Tokens item : list_items(tokens.subspan(equals + 1, end - equals - 1))) {
    const auto curve = as_tag(item);
    if (!curve) return std::nullopt;
    loop.curves.push_back(*curve);
  }
  return loop;
}

/// Number of tokens up to and with the semicolon.
std::size_t statement_length(Tokens tokens) {
  std::size_t i = 0;
  while (i < tokens.size() && !tokens[i].is(";")) ++i;
  return std::min(i + 1, tokens.size());
}

bool writes_with_printf(Tokens tokens) {
  if (!starts_with(tokens, {"Printf", "("})) return false;
  return from(tokens, past_bracket(tokens, 1)).size() > 0 &&
         tokens[past_bracket(tokens, 1)].is(">");
}

bool is_blanked(Tokens tokens) {
  if (writes_with_printf(tokens)) return true;
  if (!is_one_of(tokens[0], blanked) || tokens.size() < 2) return false;
  // Options and members ("Mesh.Algorithm = 6") have the same first word.
  const GeoToken& next = tokens[1];
  return !next.is(".") && !next.is("=") && !next.is("[") && !next.is("(");
}

class Inspector {
 public:
  Inspector(std::string& text, const std::string& name, GmshScript& script)
      : text_(text), original_(text), name_(name), script_(script) {}

  GeoStatements run() {
    const std::vector<GeoToken> all = geo_tokens(original_);
    for (std::size_t i = 0; i < all.size();)
      i += visit(Tokens(all).subspan(i), i > 0 ? &all[i - 1] : nullptr);
    return std::move(result_);
  }

 private:
  /// Looks at what starts here; returns how many tokens are dealt with.
  std::size_t visit(Tokens tokens, const GeoToken* before) {
    const GeoToken& first = tokens[0];
    if (first.kind != GeoToken::Kind::name || (before != nullptr && before->is("."))) return 1;
    if (before != nullptr && before->is("Physical")) return 1;  // Physical Point(1) = {1, 2, 3, 4}
    if (is_one_of(first, refused)) refuse(first);
    if (starts_with(tokens, {"Plugin", "("})) refuse(first);
    if (is_blanked(tokens)) return blank(tokens);
    if (first.is("Include") || first.is("Merge")) return note_included(tokens);
    if (sets_size(tokens)) script_.sets_sizes = true;
    if (starts_with(tokens, {"Background", "Field"})) script_.sets_field = true;
    if (auto loop = curve_loop(tokens)) script_.loops.push_back(std::move(*loop));
    warn_of_quads(tokens);
    return 1;
  }

  std::string where(const GeoToken& token) const {
    return name_ + ", line " + std::to_string(token.line);
  }

  [[noreturn]] void refuse(const GeoToken& token) const {
    throw InputError(where(token), "the statement " + std::string(token.text) + " is not allowed",
                     "remove it: a geometry file may describe geometry, not run or write anything");
  }

  std::size_t blank(Tokens tokens) {
    const std::size_t count = statement_length(tokens);
    for (std::size_t i = tokens[0].begin; i < tokens[count - 1].end; ++i)
      if (text_[i] != '\n') text_[i] = ' ';
    warn(tokens[0], "has no effect here");
    return count;
  }

  std::size_t note_included(Tokens tokens) {
    if (tokens.size() < 3 || tokens[1].kind != GeoToken::Kind::string || !tokens[2].is(";")) {
      throw InputError(where(tokens[0]),
                       std::string(tokens[0].text) + " needs the name of one file in quotes",
                       "write it out, for example Include \"part.geo\";");
    }
    result_.included.push_back({std::string(tokens[1].text), tokens[0].line});
    return 3;
  }

  void warn_of_quads(Tokens tokens) {
    const bool recombine =
        tokens[0].is("Recombine") || starts_with(tokens, {"Mesh", ".", "RecombineAll"});
    if (recombine)
      warn(tokens[0].is("Mesh") ? tokens[2] : tokens[0],
           "is ignored: meshes are made of triangles");
    if (starts_with(tokens, {"Transfinite", "Surface"}))
      warn(tokens[0], "Surface has no effect inside the surface");
  }

  /// One warning per statement word and script is enough.
  void warn(const GeoToken& token, const std::string& what) {
    const std::string word = std::string(token.text) + " " + what;
    if (std::find(warned_.begin(), warned_.end(), word) != warned_.end()) return;
    warned_.push_back(word);
    script_.warnings.push_back(where(token) + ": " + word);
  }

  std::string& text_;
  const std::string original_;  // the tokens point into it while text_ is blanked
  const std::string& name_;
  GmshScript& script_;
  GeoStatements result_;
  std::vector<std::string> warned_;
};

}  // namespace

GeoStatements inspect_geo(std::string& text, const std::string& name, GmshScript& script) {
  return Inspector(text, name, script).run();
}

}  // namespace lepp
