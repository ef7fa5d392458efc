#include <cmath>
#include <string>

#include "lepp/geometry/text.hpp"
#include "lepp/io/atomic_files.hpp"
#include "lepp/io/places.hpp"
#include "lepp/io/poly.hpp"
#include "lepp/triangulation/for_each_edge.hpp"

namespace lepp {

namespace {

namespace fs = std::filesystem;

int marker_of(const Mesh& mesh, HalfEdge e) {
  for (const SegmentId s : mesh.segments_of(e)) {
    const auto curve = mesh.segments()[s.index()].curve;
    if (curve && mesh.entities()[*curve].tag != 0) return mesh.entities()[*curve].tag;
  }
  return 1;
}

struct MarkedEdge {
  VertexId a, b;
  int marker = 0;
};

std::vector<MarkedEdge> constrained_edges(const Mesh& mesh) {
  std::vector<MarkedEdge> edges;
  for_each_edge(mesh, [&](HalfEdge e) {
    if (!mesh.is_constrained(e)) return;
    edges.push_back({mesh.origin(e), mesh.destination(e), marker_of(mesh, e)});
  });
  return edges;
}

std::vector<MarkedEdge> marked_segments(const Pslg& pslg) {
  std::vector<MarkedEdge> edges;
  for (const Segment& s : pslg.segments) {
    edges.push_back({s.a, s.b, s.curve ? pslg.entities[*s.curve].tag : 0});
  }
  return edges;
}

// A surface that no entity describes counts as its index.
double attribute_of(const Entities& entities, SurfaceId s) {
  return s.index() < entities.surfaces.size() ? entities[s].attribute : s.value;
}

double area_limit_of(const Entities& entities, SurfaceId s) {
  const double limit = s.index() < entities.surfaces.size() ? entities[s].max_area : -1;
  return std::isfinite(limit) ? limit : -1;
}

// The sections of one file; each record starts with its number, counted from `base`.
class Sections {
 public:
  Sections(OutputFile& out, std::int64_t base) : out_(out), base_(base) {}

  // with one attribute each, or none
  void vertices(std::span<const Point> points, std::span<const double> attributes = {}) {
    out_ << points.size() << (attributes.empty() ? " 2 0 0\n" : " 2 1 0\n");
    for (std::size_t i = 0; i < points.size(); ++i) {
      out_ << number(i) << ' ' << points[i].x << ' ' << points[i].y;
      if (!attributes.empty()) out_ << ' ' << attributes[i];
      out_ << '\n';
    }
  }

  void segments(const std::vector<MarkedEdge>& edges) {
    out_ << edges.size() << " 1\n";
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const auto& [a, b, marker] = edges[i];
      out_ << number(i) << ' ' << number(a.index()) << ' ' << number(b.index()) << ' ' << marker
           << '\n';
    }
  }

  void holes(const std::vector<Point>& holes) {
    out_ << holes.size() << '\n';
    for (std::size_t i = 0; i < holes.size(); ++i) {
      out_ << number(i) << ' ' << holes[i].x << ' ' << holes[i].y << '\n';
    }
  }

  void regions(const Entities& entities, const std::vector<RegionSeed>& seeds) {
    out_ << seeds.size() << '\n';
    for (std::size_t i = 0; i < seeds.size(); ++i) {
      const auto& [at, surface] = seeds[i];
      out_ << number(i) << ' ' << at.x << ' ' << at.y << ' ' << attribute_of(entities, surface)
           << ' ' << area_limit_of(entities, surface) << '\n';
    }
  }

  void triangles(const Mesh& mesh, bool with_regions) {
    std::vector<std::string> attributes;  // as text: few regions, many triangles
    for (std::size_t s = 0; s < mesh.entities().surfaces.size(); ++s) {
      attributes.push_back(to_text(attribute_of(mesh.entities(), SurfaceId(s))));
    }
    out_ << mesh.triangle_count() << (with_regions ? " 3 1\n" : " 3 0\n");
    for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
      const TriangleId t(i);
      out_ << number(i);
      for (const VertexId v : mesh.vertices(t)) out_ << ' ' << number(v.index());
      if (with_regions) {
        const std::size_t region = mesh.region(t).index();
        out_ << ' ';
        if (region < attributes.size()) out_ << attributes[region];
        else out_ << attribute_of(mesh.entities(), mesh.region(t));
      }
      out_ << '\n';
    }
  }

 private:
  std::int64_t number(std::size_t i) const { return base_ + static_cast<std::int64_t>(i); }

  OutputFile& out_;
  std::int64_t base_;
};

std::int64_t base_for_file(std::int64_t base) { return base == 0 ? 0 : 1; }

// Segments, holes and regions of a mesh.
void write_outline(Sections& sections, const Mesh& mesh) {
  sections.segments(constrained_edges(mesh));
  sections.holes(places_of_holes(mesh));
  std::vector<RegionSeed> seeds;
  for (const Place& place : places_of_parts(mesh)) seeds.push_back({place.at, place.region});
  sections.regions(mesh.entities(), seeds);
}

bool says_what_curves_bound(const Pslg& pslg) {
  for (const CurveEntity& curve : pslg.entities.curves) {
    if (!curve.bounds.empty()) return true;
  }
  return false;
}

}  // namespace

void write_poly(const Pslg& pslg, const fs::path& path) {
  AtomicFiles files;
  Sections sections(files.add(path), base_for_file(pslg.base));
  if (says_what_curves_bound(pslg)) {
    const Mesh mesh = constrained_delaunay(pslg).mesh;
    sections.vertices(mesh.points());
    write_outline(sections, mesh);
  } else {
    sections.vertices(pslg.points);
    sections.segments(marked_segments(pslg));
    sections.holes(pslg.holes);
    sections.regions(pslg.entities, pslg.seeds);
  }
  files.commit();
}

void write_ele(const Mesh& mesh, const fs::path& path, std::span<const double> heights) {
  const std::int64_t base = base_for_file(mesh.base());
  AtomicFiles files;
  const auto beside = [&](const char* extension) -> OutputFile& {
    return files.add(fs::path(path).replace_extension(extension));
  };
  Sections(beside(".node"), base).vertices(mesh.points(), heights);
  const bool is_plain_tin = !heights.empty() && mesh.entities().surfaces.size() <= 1;
  Sections(files.add(path), base).triangles(mesh, !is_plain_tin);
  Sections poly(beside(".poly"), base);
  poly.vertices({});
  write_outline(poly, mesh);
  files.commit();
}

std::vector<std::filesystem::path> ele_files(const std::filesystem::path& path) {
  std::filesystem::path node = path, poly = path;
  return {node.replace_extension(".node"), path, poly.replace_extension(".poly")};
}

}  // namespace lepp
