#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lepp/geometry/ids.hpp"

namespace lepp {

/// The input segments that share a constrained edge: almost always one, more where collinear
/// input segments overlap.
using SegmentSetId = Id<struct SegmentSetOfMesh>;

/// The side table of constrained edges, from the two vertices of an edge (in either order) to the
/// segments that own it and, where an edge has been split or shared, its own curve parameters.
///
/// A hash table with open addressing and linear probing: 16 bytes an edge at a load of 0.4 to 0.8,
/// no allocation per edge, and removal that leaves no marks behind.
class EdgeRecords {
 public:
  /// Curve parameters at the end with the smaller VertexId, and at the other end.
  using Parameters = std::array<double, 2>;
  struct Record {
    SegmentSetId segments;
    std::optional<Parameters> parameters;  ///< nothing: those of the segment
  };

  std::size_t size() const { return size_; }
  void reserve(std::size_t edges);
  /// As long as there are at most so many more records than now, set() and erase() cannot fail.
  /// Room at least doubles where there is not enough. \throw std::bad_alloc; nothing has changed
  void make_room_for(std::size_t more);
  std::optional<Record> find(VertexId a, VertexId b) const;
  /// Asks the memory for the place of edge ab, which will be looked up soon.
  void prefetch(VertexId a, VertexId b) const;
  /// Adds the record of edge ab, or replaces it.
  void set(VertexId a, VertexId b, const Record& record);
  /// Removes the record of edge ab, if there is one.
  void erase(VertexId a, VertexId b);
  /// Vertex v becomes vertex `number_of[v]`: parameters stay at their ends. O(edges)
  void renumber(std::span<const std::uint32_t> number_of);

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFFU;
  struct Slot {
    std::uint32_t low = none, high = none;  // none: free
    std::uint32_t segments = 0;
    std::uint32_t parameters = none;
  };

  std::size_t home(std::uint32_t low, std::uint32_t high) const;
  std::size_t after(std::size_t slot) const { return slot + 1 == slots_.size() ? 0 : slot + 1; }
  /// The slot of edge (low, high), or the free one where it belongs. \pre a slot is free
  std::size_t slot_of(std::uint32_t low, std::uint32_t high) const;
  void resize(std::size_t slots);
  void store(Slot& slot, const Record& record);

  std::vector<Slot> slots_;
  std::vector<Parameters> parameters_;
  std::vector<std::uint32_t> free_parameters_;
  std::size_t size_ = 0;
};

}  // namespace lepp
