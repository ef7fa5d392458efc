#include "lepp/triangulation/edge_records.hpp"

#include <algorithm>
#include <utility>

#include "lepp/geometry/memory_access.hpp"

namespace lepp {

// Multiplies by an odd constant and maps the high half to [0, slots) without a division. The low
// vertex alone would do for most meshes, but a vertex with many edges must not become one long run.
std::size_t EdgeRecords::home(std::uint32_t low, std::uint32_t high) const {
  std::uint64_t h = (std::uint64_t{low} << 32 | high) * 0x9E3779B97F4A7C15U;
  h = (h ^ h >> 32) * 0xD6E8FEB86659FD93U;
  return static_cast<std::size_t>((h >> 32) * slots_.size() >> 32);
}

std::size_t EdgeRecords::slot_of(std::uint32_t low, std::uint32_t high) const {
  std::size_t i = home(low, high);
  while (slots_[i].low != none && (slots_[i].low != low || slots_[i].high != high)) i = after(i);
  return i;
}

void EdgeRecords::resize(std::size_t slots) {
  std::vector<Slot> old(slots);
  old.swap(slots_);
  for (const Slot& slot : old) {
    if (slot.low != none) slots_[slot_of(slot.low, slot.high)] = slot;
  }
}

void EdgeRecords::reserve(std::size_t edges) {
  const std::size_t slots = edges + edges / 4 + 8;
  if (slots > slots_.size()) resize(slots);
}

// Parameters are as many as the records that use some and those that are free. A new one is made
// when none is free, so there are never more than there were records.
void EdgeRecords::make_room_for(std::size_t more) {
  const std::size_t edges = size_ + more;
  if (5 * (edges + 1) > 4 * slots_.size()) {
    resize(std::max(2 * slots_.size() + 8, edges + edges / 4 + 8));
  }
  if (edges > parameters_.capacity()) parameters_.reserve(2 * edges);
  if (parameters_.capacity() > free_parameters_.capacity()) {
    free_parameters_.reserve(parameters_.capacity());
  }
}

std::optional<EdgeRecords::Record> EdgeRecords::find(VertexId a, VertexId b) const {
  if (slots_.empty()) return std::nullopt;
  const auto [low, high] = std::minmax(a.value, b.value);
  const Slot& slot = slots_[slot_of(low, high)];
  if (slot.low == none) return std::nullopt;
  Record record{SegmentSetId(slot.segments), {}};
  if (slot.parameters != none) record.parameters = parameters_[slot.parameters];
  return record;
}

void EdgeRecords::prefetch(VertexId a, VertexId b) const {
  const auto [low, high] = std::minmax(a.value, b.value);
  lepp::prefetch(&slots_[home(low, high)]);
}

void EdgeRecords::store(Slot& slot, const Record& record) {
  slot.segments = record.segments.value;
  if (!record.parameters) {
    if (slot.parameters != none) free_parameters_.push_back(slot.parameters);
    slot.parameters = none;
    return;
  }
  if (slot.parameters == none) {
    if (free_parameters_.empty()) {
      slot.parameters = static_cast<std::uint32_t>(parameters_.size());
      parameters_.emplace_back();
    } else {
      slot.parameters = free_parameters_.back();
      free_parameters_.pop_back();
    }
  }
  parameters_[slot.parameters] = *record.parameters;
}

void EdgeRecords::set(VertexId a, VertexId b, const Record& record) {
  if (5 * (size_ + 1) > 4 * slots_.size()) resize(2 * slots_.size() + 8);
  const auto [low, high] = std::minmax(a.value, b.value);
  Slot& slot = slots_[slot_of(low, high)];
  if (slot.low == none) {
    slot = {low, high, 0, none};
    ++size_;
  }
  store(slot, record);
}

void EdgeRecords::erase(VertexId a, VertexId b) {
  if (slots_.empty()) return;
  const auto [low, high] = std::minmax(a.value, b.value);
  std::size_t hole = slot_of(low, high);
  if (slots_[hole].low == none) return;
  if (slots_[hole].parameters != none) free_parameters_.push_back(slots_[hole].parameters);
  --size_;
  // Later entries of the run move up where their home does not lie behind the hole.
  for (std::size_t i = after(hole); slots_[i].low != none; i = after(i)) {
    const std::size_t wanted = home(slots_[i].low, slots_[i].high);
    const bool stays = hole < i ? hole < wanted && wanted <= i : hole < wanted || wanted <= i;
    if (stays) continue;
    slots_[hole] = slots_[i];
    hole = i;
  }
  slots_[hole] = {};
}

void EdgeRecords::renumber(std::span<const std::uint32_t> number_of) {
  std::vector<Slot> old(slots_.size());
  old.swap(slots_);
  for (Slot slot : old) {
    if (slot.low == none) continue;
    slot.low = number_of[slot.low];
    slot.high = number_of[slot.high];
    if (slot.low > slot.high) {
      std::swap(slot.low, slot.high);
      if (slot.parameters != none) std::ranges::reverse(parameters_[slot.parameters]);
    }
    slots_[slot_of(slot.low, slot.high)] = slot;
  }
}

}  // namespace lepp
