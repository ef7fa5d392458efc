#include "lepp/io/record_archive.hpp"

namespace lepp {
namespace {

/// FNV-1a: enough to notice a cut or damaged record; not a defence.
std::uint64_t checksum(std::span<const std::byte> bytes) {
  std::uint64_t sum = 0xcbf29ce484222325U;
  for (const std::byte b : bytes) sum = (sum ^ std::to_integer<std::uint64_t>(b)) * 0x100000001b3U;
  return sum;
}

}  // namespace

std::vector<std::byte> framed(const RecordKind& kind, std::span<const std::byte> payload) {
  RecordWriter head;
  head(kind.magic, kind.version, std::uint64_t{payload.size()});
  std::vector<std::byte> bytes = head.take();
  bytes.insert(bytes.end(), payload.begin(), payload.end());
  RecordWriter tail;
  tail(checksum(payload));
  const std::vector<std::byte> sum = tail.take();
  bytes.insert(bytes.end(), sum.begin(), sum.end());
  return bytes;
}

std::optional<std::uint64_t> announced_length(const RecordKind& kind,
                                              std::span<const std::byte, record_head> head) {
  RecordKind found;
  std::uint64_t length = 0;
  RecordReader reader(head);
  reader(found.magic, found.version, length);
  if (found != kind) return std::nullopt;
  return length;
}

std::optional<std::span<const std::byte>> payload_of(const RecordKind& kind,
                                                     std::span<const std::byte> record) {
  if (record.size() < record_head + record_tail) return std::nullopt;
  const auto length = announced_length(kind, record.first<record_head>());
  if (!length || *length != record.size() - record_head - record_tail) return std::nullopt;
  const auto payload = record.subspan(record_head, static_cast<std::size_t>(*length));
  std::uint64_t sum = 0;
  RecordReader tail(record.last(record_tail));
  tail(sum);
  if (sum != checksum(payload)) return std::nullopt;
  return payload;
}

}  // namespace lepp
