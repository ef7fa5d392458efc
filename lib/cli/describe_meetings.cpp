#include "describe_meetings.hpp"

#include <algorithm>
#include <set>

#include "lepp/geometry/text.hpp"

namespace lepp::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t shown = 5;  // of each kind

class Describer {
 public:
  Describer(const Pslg& pslg, const SegmentMeetings& found) : pslg_(pslg), found_(found) {}

  Json run() {
    const auto& points = pslg_.points;
    Json all;
    all["duplicate_points"] = list(found_.duplicate_points, [&](const auto& pair) -> Json {
      return {{"points", {number(pair.first), number(pair.second)}},
              {"at", place(points[pair.first.index()])}};
    });
    all["zero_length_segments"] = list(found_.zero_length, [&](SegmentId s) -> Json {
      const VertexId end = pslg_.segments[s.index()].a;
      return {{"segments", {number(s)}}, {"at", place(points[end.index()])}};
    });
    all["repeated_segments"] = list(found_.repeated_segments, [&](const auto& pair) -> Json {
      const VertexId end = pslg_.segments[pair.first.index()].a;
      return {{"segments", {number(pair.first), number(pair.second)}},
              {"at", place(points[end.index()])}};
    });
    all["crossings"] = pairs(SegmentMeeting::crossing);
    all["overlaps"] = pairs(SegmentMeeting::overlapping);
    all["points_on_segments"] = list(points_on_segments(), [&](const PointOnSegment& p) -> Json {
      return {{"points", {number(p.point)}},
              {"segments", {number(p.segment)}},
              {"at", place(points[p.point.index()])}};
    });
    return all;
  }

 private:
  std::int64_t number(VertexId v) const { return pslg_.point_number(v); }
  std::int64_t number(SegmentId s) const { return pslg_.segment_number(s); }
  static Json place(Point p) { return {p.x, p.y}; }

  template <class List, class Describe>
  static Json list(const List& items, Describe describe) {
    Json first = Json::array();
    for (std::size_t i = 0; i < std::min(shown, items.size()); ++i) {
      first.push_back(describe(items[i]));
    }
    return {{"count", items.size()}, {"first", first}};
  }

  Json pairs(SegmentMeeting kind) const {
    std::vector<SegmentPair> of_kind;
    std::ranges::copy_if(found_.pairs, std::back_inserter(of_kind),
                         [&](const SegmentPair& pair) { return pair.meeting == kind; });
    return list(of_kind, [&](const SegmentPair& pair) -> Json {
      return {{"segments", {number(pair.first), number(pair.second)}},
              {"at", place(meeting_point(pslg_, pair))}};
    });
  }

  // Lone points, and the ends of segments that touch or overlap another.
  std::vector<PointOnSegment> points_on_segments() const {
    const std::vector<VertexId> first = first_copies(pslg_.points);
    std::set<PointOnSegment> all(found_.points_on_segments.begin(),
                                 found_.points_on_segments.end());
    const auto add_ends = [&](SegmentId of, SegmentId on) {
      const Segment& s = pslg_.segments[on.index()];
      const Point a = pslg_.points[s.a.index()], b = pslg_.points[s.b.index()];
      for (const VertexId v : {pslg_.segments[of.index()].a, pslg_.segments[of.index()].b}) {
        const Point p = pslg_.points[v.index()];
        if (p != a && p != b && is_on_segment(p, a, b)) all.insert({first[v.index()], on});
      }
    };
    for (const SegmentPair& pair : found_.pairs) {
      if (pair.meeting == SegmentMeeting::crossing) continue;
      add_ends(pair.first, pair.second);
      add_ends(pair.second, pair.first);
    }
    return {all.begin(), all.end()};
  }

  const Pslg& pslg_;
  const SegmentMeetings& found_;
};

std::string numbers(const Json& list, const std::string& one) {
  if (list.size() == 1) return one + " " + list[0].dump();
  return one + "s " + list[0].dump() + " and " + list[1].dump();
}

std::string example(const Json& item) {
  std::string text;
  if (item.contains("points")) text = numbers(item["points"], "point");
  if (item.contains("segments")) {
    if (!text.empty()) text += " on ";
    text += numbers(item["segments"], "segment");
  }
  return text + " at " + to_text(Point{item["at"][0], item["at"][1]});
}

}  // namespace

nlohmann::ordered_json describe_meetings(const Pslg& pslg, const SegmentMeetings& found) {
  return Describer(pslg, found).run();
}

std::string text_of_meetings(const nlohmann::ordered_json& meetings) {
  std::string text;
  for (const auto& [kind, list] : meetings.items()) {
    if (list["count"] == 0) continue;
    std::string name = kind;
    std::ranges::replace(name, '_', ' ');
    text += name + "  " + list["count"].dump() + "\n";
    for (const auto& item : list["first"]) text += "              " + example(item) + "\n";
    const std::size_t more = list["count"].get<std::size_t>() - list["first"].size();
    if (more > 0) text += "              and " + std::to_string(more) + " more\n";
  }
  return text;
}

}  // namespace lepp::cli
