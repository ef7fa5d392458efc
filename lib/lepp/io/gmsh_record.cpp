#include "lepp/io/gmsh_record.hpp"

#include <cstring>
#include <type_traits>

namespace lepp {
namespace {

// Writer and Reader walk the same list of fields, so that both ends of the pipe agree. The pipe
// joins two programs of one machine: numbers travel in its own byte order.

template <class T>
concept Number = std::is_arithmetic_v<T> || std::is_enum_v<T>;

class Writer {
 public:
  template <class... T>
  void operator()(const T&... values) {
    (put(values), ...);
  }
  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  void put_bytes(const void* data, std::size_t size) {
    const auto* first = static_cast<const std::byte*>(data);
    bytes_.insert(bytes_.end(), first, first + size);
  }
  template <Number T>
  void put(const T& value) {
    put_bytes(&value, sizeof value);
  }
  void put(const std::string& text) {
    put(std::uint64_t{text.size()});
    put_bytes(text.data(), text.size());
  }
  template <class T>
  void put(const std::vector<T>& items) {
    put(std::uint64_t{items.size()});
    for (const T& item : items) put(item);
  }
  template <class T, std::size_t n>
  void put(const std::array<T, n>& items) {
    for (const T& item : items) put(item);
  }
  template <class T>
  void put(const std::optional<T>& item) {
    put(item.has_value());
    if (item) put(*item);
  }
  void put(const Curve& curve) {
    put(static_cast<std::uint8_t>(curve.index()));
    std::visit([this](const auto& shape) { put(shape); }, curve);
  }
  template <class T>
  void put(const T& structure) {
    fields(*this, structure);
  }

  std::vector<std::byte> bytes_;
};

class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  template <class... T>
  void operator()(T&... values) {
    (take(values), ...);
  }
  bool complete() const { return !failed_ && bytes_.empty(); }

 private:
  bool take_bytes(void* data, std::size_t size) {
    if (size > bytes_.size()) failed_ = true;
    if (failed_) return false;
    if (size != 0) std::memcpy(data, bytes_.data(), size);
    bytes_ = bytes_.subspan(size);
    return true;
  }
  template <Number T>
  void take(T& value) {
    take_bytes(&value, sizeof value);
  }
  void take(bool& value) {
    std::uint8_t byte = 0;
    take_bytes(&byte, 1);
    value = byte != 0;
  }
  /// A count that the bytes left can hold: every item takes at least one.
  std::size_t take_count() {
    std::uint64_t count = 0;
    take(count);
    if (count > bytes_.size()) failed_ = true;
    return failed_ ? 0 : static_cast<std::size_t>(count);
  }
  void take(std::string& text) {
    text.resize(take_count());
    take_bytes(text.data(), text.size());
  }
  template <class T>
  void take(std::vector<T>& items) {
    const std::size_t count = take_count();
    items.clear();
    for (std::size_t i = 0; i < count && !failed_; ++i) take(items.emplace_back());
  }
  template <class T, std::size_t n>
  void take(std::array<T, n>& items) {
    for (T& item : items) take(item);
  }
  template <class T>
  void take(std::optional<T>& item) {
    bool present = false;
    take(present);
    if (present && !failed_) take(item.emplace());
  }
  void take(Curve& curve) {
    std::uint8_t kind = 0;
    take(kind);
    if (kind == 1) take(curve.emplace<EllipseArc>());
    else if (kind == 2) take(curve.emplace<CubicPieces>());
    else if (kind != 0) failed_ = true;
    if (const auto* cubics = std::get_if<CubicPieces>(&curve); cubics != nullptr)
      if (cubics->pieces.empty() || cubics->knots.size() != cubics->pieces.size() + 1)
        failed_ = true;
  }
  template <class T>
  void take(T& structure) {
    fields(*this, structure);
  }

  std::span<const std::byte> bytes_;
  bool failed_ = false;
};

/// T or const T: fields() serves both directions.
template <class T, class U>
concept Is = std::is_same_v<std::remove_const_t<T>, U>;

void fields(auto& archive, Is<StraightCurve> auto&) { archive(); }
void fields(auto& archive, Is<Point> auto& p) { archive(p.x, p.y); }
void fields(auto& archive, Is<EllipseArc> auto& a) {
  archive(a.center, a.u, a.v, a.start, a.sweep);
}
void fields(auto& archive, Is<CubicPieces> auto& c) { archive(c.knots, c.pieces); }
void fields(auto& archive, Is<CurvePoint> auto& p) { archive(p.point, p.t); }
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

constexpr std::array<char, 8> magic = {'l', 'e', 'p', 'p', 'g', 'm', 's', 'h'};
constexpr std::uint32_t version = 2;

struct Envelope {
  std::array<char, 8> magic{};
  std::uint32_t version = 0;
  std::uint64_t length = 0;
};
constexpr std::size_t envelope_size = sizeof magic + sizeof version + sizeof(std::uint64_t);

void fields(auto& archive, Is<Envelope> auto& e) { archive(e.magic, e.version, e.length); }

/// FNV-1a: enough to notice a cut or damaged record; not a defence.
std::uint64_t checksum(std::span<const std::byte> bytes) {
  std::uint64_t sum = 0xcbf29ce484222325U;
  for (const std::byte b : bytes) sum = (sum ^ std::to_integer<std::uint64_t>(b)) * 0x100000001b3U;
  return sum;
}

}  // namespace

std::vector<std::byte> encode(const GmshRecord& record) {
  Writer payload_writer;
  payload_writer(record);
  const std::vector<std::byte> payload = payload_writer.take();
  Writer writer;
  writer(Envelope{magic, version, payload.size()});
  std::vector<std::byte> bytes = writer.take();
  bytes.insert(bytes.end(), payload.begin(), payload.end());
  Writer tail;
  tail(checksum(payload));
  const std::vector<std::byte> sum = tail.take();
  bytes.insert(bytes.end(), sum.begin(), sum.end());
  return bytes;
}

std::optional<GmshRecord> decode_gmsh_record(std::span<const std::byte> bytes) {
  constexpr std::size_t frame = envelope_size + sizeof(std::uint64_t);
  if (bytes.size() < frame) return std::nullopt;
  Envelope envelope;
  Reader(bytes.first(envelope_size))(envelope);
  if (envelope.magic != magic || envelope.version != version) return std::nullopt;
  if (envelope.length != bytes.size() - frame) return std::nullopt;
  const auto payload = bytes.subspan(envelope_size, static_cast<std::size_t>(envelope.length));
  std::uint64_t sum = 0;
  Reader(bytes.last(sizeof sum))(sum);
  if (sum != checksum(payload)) return std::nullopt;
  GmshRecord record;
  Reader reader(payload);
  reader(record);
  if (!reader.complete()) return std::nullopt;
  return record;
}

}  // namespace lepp
