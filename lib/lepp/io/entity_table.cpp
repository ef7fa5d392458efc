#include "lepp/io/entity_table.hpp"

#include <cmath>
#include <limits>
#include <set>

namespace lepp {

namespace {

bool is_tag(double attribute) {
  return std::trunc(attribute) == attribute &&
         std::abs(attribute) <= std::numeric_limits<int>::max();
}

}  // namespace

CurveId EntityTable::curve(int marker) {
  if (marker == last_curve_.first && marker != 0) return last_curve_.second;
  const auto [known, is_new] = curves_.try_emplace(marker, entities_.curves.size());
  if (is_new) entities_.curves.push_back({marker, group(1, marker), StraightCurve{}, {}});
  last_curve_ = *known;
  return known->second;
}

SurfaceId EntityTable::surface(double attribute, double max_area) {
  const auto [known, is_new] =
      surfaces_.try_emplace({attribute, max_area}, entities_.surfaces.size());
  if (is_new) entities_.surfaces.push_back({0, {}, attribute, max_area});
  return known->second;
}

Entities EntityTable::finish() {
  std::set<int> used;
  for (const SurfaceEntity& s : entities_.surfaces) {
    if (is_tag(s.attribute)) used.insert(static_cast<int>(s.attribute));
  }
  std::map<double, int> tag_of;  // of attributes that are not whole
  int next = 1;
  for (SurfaceEntity& s : entities_.surfaces) {
    if (is_tag(s.attribute)) {
      s.tag = static_cast<int>(s.attribute);
    } else {
      const auto [known, is_new] = tag_of.try_emplace(s.attribute, 0);
      if (is_new) {
        while (used.contains(next)) ++next;
        known->second = next++;
      }
      s.tag = known->second;
    }
    s.groups = group(2, s.tag);
  }
  return std::move(entities_);
}

std::vector<GroupId> EntityTable::group(int dimension, int tag) {
  if (tag <= 0) return {};
  const auto [known, is_new] = groups_.try_emplace({dimension, tag}, entities_.groups.size());
  if (is_new) entities_.groups.push_back({dimension, tag, {}});
  return {known->second};
}

}  // namespace lepp
