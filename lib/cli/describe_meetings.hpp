#pragma once

#include <nlohmann/json.hpp>

#include "lepp/geometry/segment_meetings.hpp"

namespace lepp::cli {

/// What `lepp info` says about points and segments that P3 and P4 forbid: for each kind how many
/// there are, and the first few with the user's numbers and coordinates.
///
/// Copies are counted apart, so each place and each pair of places is compared once: a point counts
/// as on a segment once per place and segment, whether it is an end of another segment or not.
nlohmann::ordered_json describe_meetings(const Pslg& pslg, const SegmentMeetings& found);

/// The same for people, one line for each kind that there is.
std::string text_of_meetings(const nlohmann::ordered_json& meetings);

}  // namespace lepp::cli
