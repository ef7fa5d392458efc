#include "pipe.hpp"

#include <unistd.h>

#include <cerrno>

namespace lepp::gdal_helper {

void send(std::span<const std::byte> bytes) {
  constexpr int record_descriptor = 3;
  while (!bytes.empty()) {
    const ssize_t n = ::write(record_descriptor, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) ::_exit(1);
    bytes = bytes.subspan(static_cast<std::size_t>(n));
  }
}

}  // namespace lepp::gdal_helper
