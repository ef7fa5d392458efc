#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "lepp/geometry/pslg.hpp"

namespace lepp::demo {

/// Draws a PSLG with straight curves and named groups, one per curve and surface.
class Drawing {
 public:
  explicit Drawing(std::string source) { pslg_.source = std::move(source); }

  VertexId point(Point p);
  /// A chain of segments through these points, as a curve and a group of that name.
  CurveId curve(const std::string& name, std::initializer_list<VertexId> through);
  CurveId curve(const std::string& name, const std::vector<VertexId>& through);
  /// The closed area around `inside`, as a surface and a group of that name.
  SurfaceId surface(const std::string& name, Point inside);
  void hole(Point inside) { pslg_.holes.push_back(inside); }

  const Pslg& pslg() const { return pslg_; }

 private:
  GroupId group(int dimension, int tag, const std::string& name);
  Pslg pslg_;
};

}  // namespace lepp::demo
