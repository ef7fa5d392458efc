#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "lepp/io/atomic_files.hpp"
#include "lepp/io/binary_numbers.hpp"

namespace lepp {

/// A file of the classic netCDF format with 64-bit offsets (CDF-2), as far as meshes need it:
/// dimensions of fixed length, variables of integers and doubles, attributes.
/// Source: "NetCDF Classic Format Specification", netCDF user's guide, appendix B.
class ClassicNetcdf {
 public:
  using Numbers = BinaryFile<std::endian::big>;
  enum class Type : std::int32_t { text = 2, integer = 4, real = 6 };

  struct Attribute {
    std::string name;
    std::variant<std::string, std::int32_t, double> value;
  };
  struct Variable {
    std::string name;
    Type type = Type::integer;
    std::vector<std::size_t> dimensions;  ///< as add_dimension() numbered them; none: a scalar
    std::vector<Attribute> attributes;
    std::function<void(Numbers&)> write;  ///< puts all values, the last dimension fastest
  };

  std::size_t add_dimension(std::string name, std::size_t length);
  void add_attribute(Attribute attribute) { attributes_.push_back(std::move(attribute)); }
  void add_variable(Variable variable) { variables_.push_back(std::move(variable)); }

  /// The largest variable in bytes; the format holds less than 2^32 - 4.
  std::uint64_t largest_variable() const;

  /// \pre  largest_variable() < 2^32 - 4
  void write(OutputFile& out) const;

 private:
  struct Dimension {
    std::string name;
    std::size_t length;
  };
  std::uint64_t bytes_of_values(const Variable& variable) const;
  std::string header(std::uint64_t first_value) const;

  std::vector<Dimension> dimensions_;
  std::vector<Attribute> attributes_;
  std::vector<Variable> variables_;
};

}  // namespace lepp
