#include "lepp/io/classic_netcdf.hpp"

#include <algorithm>
#include <utility>

namespace lepp {

namespace {

constexpr std::int32_t dimension_list = 0x0A, variable_list = 0x0B, attribute_list = 0x0C;

// The header as bytes: big-endian numbers, names and values padded to four bytes.
class Bytes {
 public:
  template <class Number>
  void put(Number number) {
    const auto bytes = bytes_of<std::endian::big>(number);
    text_.append(bytes.data(), bytes.size());
  }
  void count(std::size_t n) { put(static_cast<std::int32_t>(n)); }
  void padded(std::string_view text) {
    text_ += text;
    text_.append((4 - text.size() % 4) % 4, '\0');
  }
  void name(std::string_view name) {
    count(name.size());
    padded(name);
  }
  // What a list starts with; one of nothing has tag 0.
  void list(std::int32_t tag, std::size_t n) {
    put(n == 0 ? std::int32_t{0} : tag);
    count(n);
  }
  void attributes(const std::vector<ClassicNetcdf::Attribute>& attributes);
  std::string take() && { return std::move(text_); }

 private:
  std::string text_;
};

void put_value(Bytes& bytes, const std::string& value) {
  bytes.count(value.size());
  bytes.padded(value);
}

template <class Number>
void put_value(Bytes& bytes, Number value) {
  bytes.count(1);
  bytes.put(value);
}

void Bytes::attributes(const std::vector<ClassicNetcdf::Attribute>& attributes) {
  constexpr ClassicNetcdf::Type types[] = {ClassicNetcdf::Type::text, ClassicNetcdf::Type::integer,
                                           ClassicNetcdf::Type::real};
  list(attribute_list, attributes.size());
  for (const auto& [attribute, value] : attributes) {
    name(attribute);
    put(static_cast<std::int32_t>(types[value.index()]));
    std::visit([&](const auto& v) { put_value(*this, v); }, value);
  }
}

}  // namespace

std::size_t ClassicNetcdf::add_dimension(std::string name, std::size_t length) {
  dimensions_.push_back({std::move(name), length});
  return dimensions_.size() - 1;
}

// Always a multiple of four: no padding between variables.
std::uint64_t ClassicNetcdf::bytes_of_values(const Variable& variable) const {
  std::uint64_t bytes = variable.type == Type::real ? 8 : 4;
  for (const std::size_t d : variable.dimensions) bytes *= dimensions_[d].length;
  return bytes;
}

std::uint64_t ClassicNetcdf::largest_variable() const {
  std::uint64_t largest = 0;
  for (const Variable& v : variables_) largest = std::max(largest, bytes_of_values(v));
  return largest;
}

std::string ClassicNetcdf::header(std::uint64_t first_value) const {
  Bytes bytes;
  bytes.padded("CDF\x02");
  bytes.count(0);  // records
  bytes.list(dimension_list, dimensions_.size());
  for (const auto& [name, length] : dimensions_) {
    bytes.name(name);
    bytes.count(length);
  }
  bytes.attributes(attributes_);
  bytes.list(variable_list, variables_.size());
  for (const Variable& v : variables_) {
    bytes.name(v.name);
    bytes.count(v.dimensions.size());
    for (const std::size_t d : v.dimensions) bytes.count(d);
    bytes.attributes(v.attributes);
    bytes.put(static_cast<std::int32_t>(v.type));
    bytes.put(static_cast<std::uint32_t>(bytes_of_values(v)));
    bytes.put(first_value);
    first_value += bytes_of_values(v);
  }
  return std::move(bytes).take();
}

void ClassicNetcdf::write(OutputFile& out) const {
  out << header(header(0).size());  // its length does not depend on the offsets in it
  Numbers numbers(out);
  for (const Variable& v : variables_) v.write(numbers);
}

}  // namespace lepp
