#include "lepp/io/gmsh_record.hpp"

#include "lepp/io/record_archive.hpp"

namespace lepp {

void fields(auto& archive, Is<StraightCurve> auto&) { archive(); }
void fields(auto& archive, Is<Point> auto& p) { archive(p.x, p.y); }
void fields(auto& archive, Is<EllipseArc> auto& a) {
  archive(a.center, a.u, a.v, a.start, a.sweep);
}
void fields(auto& archive, Is<CubicPieces> auto& c) { archive(c.knots, c.pieces); }
void fields(auto& archive, Is<CurvePoint> auto& p) { archive(p.point, p.t); }
void fields(RecordWriter& archive, const Curve& curve) {
  archive(static_cast<std::uint8_t>(curve.index()));
  std::visit([&](const auto& shape) { archive(shape); }, curve);
}
void fields(RecordReader& archive, Curve& curve) {
  std::uint8_t kind = 0;
  archive(kind);
  if (kind == 1) archive(curve.emplace<EllipseArc>());
  else if (kind == 2) archive(curve.emplace<CubicPieces>());
  else if (kind != 0) archive.fail();
  if (const auto* cubics = std::get_if<CubicPieces>(&curve); cubics != nullptr)
    if (cubics->pieces.empty() || cubics->knots.size() != cubics->pieces.size() + 1) archive.fail();
}
void fields(auto& archive, Is<GmshGroup> auto& g) { archive(g.dimension, g.tag, g.name); }
void fields(auto& archive, Is<GmshPoint> auto& p) { archive(p.tag, p.position, p.z, p.groups); }
void fields(auto& archive, Is<GmshCurve> auto& c) {
  archive(c.tag, c.begin, c.end, c.groups, c.geometry, c.z_low, c.z_high, c.length, c.inner);
}
void fields(auto& archive, Is<GmshSurface> auto& s) {
  archive(s.tag, s.groups, s.boundary, s.embedded_points, s.embedded_curves, s.z_low, s.z_high);
}
void fields(auto& archive, Is<GmshTriangle> auto& t) { archive(t.tag, t.nodes, t.surface); }
void fields(auto& archive, Is<GmshLine> auto& l) { archive(l.tag, l.nodes, l.curve); }
void fields(auto& archive, Is<GmshNodeOfPoint> auto& p) { archive(p.tag, p.node, p.point); }
void fields(auto& archive, Is<GmshSizeAt> auto& s) { archive(s.position, s.size); }
void fields(auto& archive, Is<GmshMesh> auto& m) {
  archive(m.node_tags, m.coordinates, m.triangles, m.lines, m.points);
}
void fields(auto& archive, Is<GmshFailure> auto& f) {
  archive(f.kind, f.where, f.problem, f.remedy);
}
void fields(auto& archive, Is<GmshRecord> auto& r) {
  archive(r.failure, r.warnings, r.groups, r.points, r.curves, r.surfaces, r.mesh, r.own_points,
          r.largest_size, r.inner_sizes);
}

namespace {

constexpr RecordKind kind = {{'l', 'e', 'p', 'p', 'g', 'm', 's', 'h'}, 2};

}  // namespace

std::vector<std::byte> encode(const GmshRecord& record) {
  RecordWriter payload;
  payload(record);
  return framed(kind, payload.take());
}

std::optional<GmshRecord> decode_gmsh_record(std::span<const std::byte> bytes) {
  const auto payload = payload_of(kind, bytes);
  if (!payload) return std::nullopt;
  GmshRecord record;
  RecordReader reader(*payload);
  reader(record);
  if (!reader.complete()) return std::nullopt;
  return record;
}

}  // namespace lepp
