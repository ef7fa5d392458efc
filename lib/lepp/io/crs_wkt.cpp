#include "lepp/io/crs_wkt.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <utility>
#include <vector>

namespace lepp {

namespace {

// A member of a list: a number, a "text", or a word with a list of its own in brackets.
struct Member {
  std::string_view word;
  std::string_view list;
};

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == text.npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

// The first of these characters outside of texts and of brackets that open at `from` or later.
std::size_t find_at_level(std::string_view text, std::string_view wanted, std::size_t from) {
  std::size_t depth = 0;
  bool quoted = false;
  for (std::size_t i = from; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') quoted = !quoted;  // "" within a text ends and begins it
    if (quoted) continue;
    if (depth == 0 && wanted.find(c) != wanted.npos) return i;
    if (c == '[' || c == '(') ++depth;
    if ((c == ']' || c == ')') && depth > 0) --depth;
  }
  return text.npos;
}

Member member_of(std::string_view text) {
  const std::size_t open = find_at_level(text, "[(", 0);
  if (open == text.npos) return {trimmed(text), {}};
  const std::size_t close = find_at_level(text, "])", open + 1);
  if (close == text.npos) return {};
  return {trimmed(text.substr(0, open)), text.substr(open + 1, close - open - 1)};
}

std::vector<Member> members_of(std::string_view list) {
  std::vector<Member> members;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(find_at_level(list, ",", begin), list.size());
    members.push_back(member_of(list.substr(begin, end - begin)));
    begin = end + 1;
  }
  return members;
}

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::ranges::find(words, word) != words.end();
}

// The first of them; with an empty word if there is none.
Member find(const std::vector<Member>& members, std::initializer_list<std::string_view> words) {
  const auto found =
      std::ranges::find_if(members, [&](const Member& m) { return is_one_of(m.word, words); });
  return found == members.end() ? Member() : *found;
}

template <class Number>
std::optional<Number> number_in(std::string_view word) {
  if (word.size() > 2 && word.front() == '"') word = word.substr(1, word.size() - 2);
  Number number{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool is_number = error == std::errc() && end == word.data() + word.size();
  return is_number ? std::optional(number) : std::nullopt;
}

// AUTHORITY["EPSG","32608"], ID["EPSG",32608]
std::optional<int> code_in(const std::vector<Member>& system) {
  for (const Member& member : system) {
    if (!is_one_of(member.word, {"AUTHORITY", "ID"})) continue;
    const auto parts = members_of(member.list);
    if (parts.size() >= 2 && parts[0].word == "\"EPSG\"") return number_in<int>(parts[1].word);
  }
  return std::nullopt;
}

// UNIT["metre",1], of the system or else of its first axis.
std::optional<double> unit_in(const std::vector<Member>& system) {
  const auto factor_in = [](const std::vector<Member>& members) -> std::optional<double> {
    const auto parts = members_of(find(members, {"UNIT", "LENGTHUNIT", "ANGLEUNIT"}).list);
    return parts.size() >= 2 ? number_in<double>(parts[1].word) : std::nullopt;
  };
  if (const auto factor = factor_in(system)) return factor;
  return factor_in(members_of(find(system, {"AXIS"}).list));
}

}  // namespace

std::optional<std::string> name_of_unit(std::optional<double> metres) {
  constexpr std::array<std::pair<double, const char*>, 4> known = {
      {{1, "m"}, {1000, "km"}, {0.3048, "ft"}, {1200.0 / 3937, "US_survey_foot"}}};
  for (const auto& [size, name] : known) {
    if (metres && std::abs(*metres / size - 1) < 1e-9) return name;
  }
  return std::nullopt;
}

CrsWkt parse_crs_wkt(std::string_view wkt) {
  Member root = member_of(wkt);
  CrsWkt crs;
  crs.epsg = code_in(members_of(root.list));
  while (root.word == "BOUNDCRS" || root.word == "SOURCECRS") {
    const auto inside = members_of(root.list);
    root = root.word == "BOUNDCRS" ? find(inside, {"SOURCECRS"}) : inside.front();
  }
  if (is_one_of(root.word, {"COMPD_CS", "COMPOUNDCRS"})) {
    const auto parts = members_of(root.list);
    const Member vertical = find(parts, {"VERT_CS", "VERTCRS", "VERTICALCRS", "VERTCS"});
    crs.height_unit = unit_in(members_of(vertical.list));
    root = parts.size() > 1 ? parts[1] : Member();  // behind the name
  }
  crs.is_geographic =
      is_one_of(root.word, {"GEOGCS", "GEOGCRS", "GEODCRS", "GEOGRAPHICCRS", "GEODETICCRS"});
  crs.unit = unit_in(members_of(root.list));
  return crs;
}

}  // namespace lepp
