#include "drawing.hpp"

namespace lepp::demo {

VertexId Drawing::point(Point p) {
  pslg_.points.push_back(p);
  return VertexId(pslg_.points.size() - 1);
}

CurveId Drawing::curve(const std::string& name, const std::vector<VertexId>& through) {
  const CurveId id(pslg_.entities.curves.size());
  const int tag = static_cast<int>(id.value) + 1;
  pslg_.entities.curves.push_back({tag, {group(1, tag, name)}, StraightCurve{}, {}});
  const double pieces = static_cast<double>(through.size() - 1);
  for (std::size_t i = 0; i + 1 < through.size(); ++i) {
    const double t = static_cast<double>(i);
    pslg_.segments.push_back({through[i], through[i + 1], id, t / pieces, (t + 1) / pieces});
  }
  return id;
}

CurveId Drawing::curve(const std::string& name, std::initializer_list<VertexId> through) {
  return curve(name, std::vector<VertexId>(through));
}

SurfaceId Drawing::surface(const std::string& name, Point inside) {
  const SurfaceId id(pslg_.entities.surfaces.size());
  const int tag = static_cast<int>(id.value) + 1;
  SurfaceEntity entity;
  entity.tag = tag;
  entity.groups = {group(2, tag, name)};
  entity.attribute = tag;
  pslg_.entities.surfaces.push_back(entity);
  pslg_.seeds.push_back({inside, id});
  return id;
}

GroupId Drawing::group(int dimension, int tag, const std::string& name) {
  pslg_.entities.groups.push_back({dimension, tag, name});
  return GroupId(pslg_.entities.groups.size() - 1);
}

}  // namespace lepp::demo
