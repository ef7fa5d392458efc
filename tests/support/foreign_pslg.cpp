#include "support/foreign_pslg.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "lepp/io/poly.hpp"

namespace lepp::test {

namespace {

using Json = nlohmann::json;

Point point_from(const Json& pair) { return {pair[0].get<double>(), pair[1].get<double>()}; }

std::vector<Point> points_from(const Json& list) {
  std::vector<Point> points;
  for (const Json& pair : list) points.push_back(point_from(pair));
  return points;
}

void add_segment(Pslg& pslg, std::size_t a, std::size_t b) {
  pslg.segments.push_back({VertexId(a), VertexId(b), {}, 0, 1});
}

void add_line(Pslg& pslg, const std::vector<Point>& points) {
  const std::size_t first = pslg.points.size();
  pslg.points.insert(pslg.points.end(), points.begin(), points.end());
  for (std::size_t i = 1; i < points.size(); ++i) add_segment(pslg, first + i - 1, first + i);
}

void add_ring(Pslg& pslg, std::vector<Point> points) {
  if (points.size() > 1 && points.front() == points.back()) points.pop_back();
  const std::size_t first = pslg.points.size();
  add_line(pslg, points);
  if (points.size() > 2) add_segment(pslg, pslg.points.size() - 1, first);
}

void add_polygon(Pslg& pslg, const Json& rings) {
  for (const Json& ring : rings) add_ring(pslg, points_from(ring));
}

void add_geojson(Pslg& pslg, const Json& root) {
  std::vector<const Json*> pending{&root};
  while (!pending.empty()) {  // each turn takes one node of a finite tree
    const Json& node = *pending.back();
    pending.pop_back();
    if (node.is_null()) continue;
    const std::string type = node.at("type");
    const auto children = [&](const char* key) {
      const Json& list = node.at(key);
      for (auto child = list.rbegin(); child != list.rend(); ++child) pending.push_back(&*child);
    };
    if (type == "FeatureCollection") children("features");
    else if (type == "GeometryCollection") children("geometries");
    else if (type == "Feature") pending.push_back(&node.at("geometry"));
    else if (type == "Polygon") add_polygon(pslg, node.at("coordinates"));
    else if (type == "LineString") add_line(pslg, points_from(node.at("coordinates")));
    else if (type == "MultiPolygon") {
      for (const Json& polygon : node.at("coordinates")) add_polygon(pslg, polygon);
    }
  }
}

void add_edges(Pslg& pslg, const Json& points, const Json& edges) {
  pslg.points = points_from(points);
  for (const Json& edge : edges) {
    add_segment(pslg, edge[0].get<std::size_t>(), edge[1].get<std::size_t>());
  }
}

void add_instance(Pslg& pslg, const Json& instance) {
  const Json &x = instance.at("points_x"), &y = instance.at("points_y");
  for (std::size_t i = 0; i < x.size(); ++i) {
    pslg.points.push_back({x[i].get<double>(), y[i].get<double>()});
  }
  const auto boundary = instance.at("region_boundary").get<std::vector<std::size_t>>();
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    add_segment(pslg, boundary[i], boundary[(i + 1) % boundary.size()]);
  }
  for (const Json& pair : instance.at("additional_constraints")) {
    add_segment(pslg, pair[0].get<std::size_t>(), pair[1].get<std::size_t>());
  }
}

void add_overlay(Pslg& pslg, const Json& overlay) {
  add_polygon(pslg, overlay.at("subjPaths"));
  add_polygon(pslg, overlay.at("clipPaths"));
}

// True for [points, edges]: the second list holds pairs of indices into the first.
bool is_points_and_edges(const Json& list) {
  if (list.size() != 2 || list[0].size() < 3 || list[1].empty()) return false;
  return std::ranges::all_of(list[1], [&](const Json& pair) {
    return pair.size() == 2 && std::ranges::all_of(pair, [&](const Json& index) {
             return index.is_number_unsigned() && index.get<std::size_t>() < list[0].size();
           });
  });
}

void add_json(Pslg& pslg, const Json& json) {
  if (json.is_object()) {
    if (json.contains("points_x")) add_instance(pslg, json);
    else if (json.contains("subjPaths")) add_overlay(pslg, json);
    else if (json.contains("type")) add_geojson(pslg, json);
    else add_edges(pslg, json.at("points"), json.value("edges", Json::array()));
  } else if (json.at(0).is_number()) {
    for (std::size_t i = 0; i + 1 < json.size(); i += 2) {
      pslg.points.push_back({json[i].get<double>(), json[i + 1].get<double>()});
    }
  } else if (json[0].at(0).is_number()) {
    pslg.points = points_from(json);
  } else if (is_points_and_edges(json)) {
    add_edges(pslg, json[0], json[1]);
  } else {
    add_polygon(pslg, json);
  }
}

void add_dat(Pslg& pslg, std::istream& in) {
  std::vector<Point> ring;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    Point p;
    if (words >> p.x >> p.y) {
      ring.push_back(p);
    } else if (words.clear(), words.seekg(0), !(words >> std::ws).eof()) {
      add_ring(pslg, ring);
      ring.clear();
    }
  }
  if (!ring.empty()) add_ring(pslg, ring);
}

void add_txt(Pslg& pslg, std::istream& in) {
  std::size_t vertices = 0, edges = 0;
  in >> vertices >> edges;
  for (Point p; pslg.points.size() < vertices && in >> p.x >> p.y;) pslg.points.push_back(p);
  for (std::size_t a = 0, b = 0; pslg.segments.size() < edges && in >> a >> b;) {
    add_segment(pslg, a, b);
  }
}

std::string rest_of(std::istream& in) {
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

// The points of "x y, x y z, ..."; none if there is anything else.
std::vector<Point> points_in(const std::string& text) {
  std::vector<Point> points;
  std::istringstream tuples(text);
  for (std::string tuple; std::getline(tuples, tuple, ',');) {
    std::istringstream words(tuple);
    Point p;
    if (!(words >> p.x >> p.y)) return {};
    points.push_back(p);
  }
  return points;
}

void add_chain(Pslg& pslg, const std::vector<Point>& points) {
  if (points.size() > 1 && points.front() == points.back()) add_ring(pslg, points);
  else add_line(pslg, points);
}

// Whatever innermost parentheses hold points is a chain; binary geometries are left out.
void add_well_known_text(Pslg& pslg, std::istream& in) {
  const std::string text = rest_of(in);
  for (auto open = text.find('('); open != std::string::npos; open = text.find('(', open + 1)) {
    const auto end = text.find_first_of("()", open + 1);
    if (end == std::string::npos || text[end] == '(') continue;
    add_chain(pslg, points_in(text.substr(open + 1, end - open - 1)));
  }
}

// Lines "x,y, x,y, ..." below headings; below one that ends in OPEN they are no rings.
void add_clipper(Pslg& pslg, std::istream& in) {
  bool open = false;
  for (std::string line; std::getline(in, line);) {
    if (line.find_first_of("0123456789") != 0 && !line.starts_with('-')) {
      open = line.find("OPEN") != std::string::npos;
      continue;
    }
    std::ranges::replace(line, ',', ' ');
    std::istringstream words(line);
    std::vector<Point> points;
    for (Point p; words >> p.x >> p.y;) points.push_back(p);
    if (open) add_line(pslg, points);
    else add_ring(pslg, points);
  }
}

}  // namespace

Pslg read_foreign_pslg(const std::filesystem::path& path) {
  const std::string kind = path.extension().string();
  if (kind == ".poly" || kind == ".node") return read_poly(path);
  Pslg pslg;
  pslg.source = path.filename().string();
  std::ifstream in(path);
  if (kind == ".json" || kind == ".geojson") add_json(pslg, Json::parse(in));
  else if (kind == ".dat") add_dat(pslg, in);
  else if (kind == ".txt" && in.peek() == 'C') add_clipper(pslg, in);
  else if (kind == ".txt") add_txt(pslg, in);
  else if (kind == ".xml") add_well_known_text(pslg, in);
  else throw InputError(path.string(), "is of no known kind", "give one of those listed");
  return pslg;
}

}  // namespace lepp::test
