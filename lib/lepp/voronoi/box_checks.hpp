#pragma once

#include <utility>
#include <vector>

#include "lepp/geometry/compensated_sum.hpp"
#include "lepp/voronoi/admissible.hpp"

namespace lepp {

/// V2 and V3 (admissible.hpp) of boxes that come a part at a time, so that nobody needs to keep all
/// of them.
class BoxChecks {
 public:
  explicit BoxChecks(const Mesh& mesh);

  void add(const VoronoiBoxes& some);

  /// Once all boxes were added: what is wrong with them, in the order of the rules.
  void report(Certificate& result) const;

 private:
  using VertexAndRegion = std::pair<VertexId, SurfaceId>;

  void check_area(const VoronoiBoxes& boxes, const VoronoiBox& box);
  void check_pieces(const VoronoiBoxes& boxes, const VoronoiBox& box);
  void report_region_areas(Certificate& result) const;
  void report_one_box_per_region(Certificate& result) const;
  std::vector<VertexAndRegion> boxes_wanted() const;

  const Mesh& mesh_;
  std::vector<CompensatedSum> covered_;     // V2: area of the boxes of each region
  std::vector<BoxViolation> wrong_areas_;   // V2
  std::vector<VertexAndRegion> found_;      // V3: of each box
  std::vector<BoxViolation> wrong_pieces_;  // V3
};

}  // namespace lepp
