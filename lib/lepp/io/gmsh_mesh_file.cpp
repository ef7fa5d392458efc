#include "lepp/io/gmsh_mesh_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <fstream>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "lepp/geometry/error.hpp"
#include "lepp/io/gmsh_element_types.hpp"

namespace lepp {
namespace {

namespace fs = std::filesystem;

/// Walks through the sections of one .msh file.
class MeshFile {
 public:
  MeshFile(std::string_view bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {}

  void check() {
    while (at_ < bytes_.size()) {
      const std::string_view line = next_line();
      if (line.starts_with("$")) section(std::string(line.substr(1)));
    }
    if (version_ == 0) fail("there is no $MeshFormat and no $NOD section", "give a .msh file");
    if (!nodes_seen_) fail("there is no section of nodes", "write the mesh again");
    check_gmsh_elements(counts_, name_);
  }

 private:
  // ---- words and lines
  // ---------------------------------------------------------------------------
  std::string_view next_line() {
    std::size_t end = bytes_.find('\n', at_);
    if (end == bytes_.npos) end = bytes_.size();
    std::string_view line = bytes_.substr(at_, end - at_);
    line_start_ = at_;
    at_ = std::min(end + 1, bytes_.size());
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
    while (!line.empty() && (line.front() == ' ' || line.front() == '\t')) line.remove_prefix(1);
    return line;
  }

  /// The next line that is not blank; a '$' ends the section too early.
  std::string_view data_line(std::string_view what) {
    std::string_view line;
    do {
      if (at_ >= bytes_.size()) fail(fmt::format("the file ends before {}", what), again);
      line = next_line();
    } while (line.empty());
    if (line.front() == '$') fail(fmt::format("the section ends before {}", what), again);
    return line;
  }

  template <class Number>
  Number word(std::string_view& line, std::string_view what) {
    while (!line.empty() && (line.front() == ' ' || line.front() == '\t')) line.remove_prefix(1);
    Number value{};
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), value);
    if (error != std::errc()) fail(fmt::format("{} is not a number", what), again);
    line.remove_prefix(static_cast<std::size_t>(end - line.data()));
    return value;
  }

  /// Goes behind `count` words; how they are spread over lines does not matter.
  void skip_words(std::uint64_t count, std::string_view what) {
    const auto is_space = [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); };
    for (std::uint64_t i = 0; i < count; ++i) {
      while (at_ < bytes_.size() && is_space(bytes_[at_])) ++at_;
      line_start_ = at_;
      if (at_ >= bytes_.size()) fail(fmt::format("the file ends before {}", what), again);
      if (bytes_[at_] == '$') fail(fmt::format("the section ends before {}", what), again);
      while (at_ < bytes_.size() && !is_space(bytes_[at_])) ++at_;
    }
  }

  /// A count of records of at least `least_bytes` each, checked against what is left of the file.
  std::uint64_t checked_count(std::uint64_t count, std::string_view what, std::size_t least_bytes) {
    const std::size_t left = bytes_.size() - at_;
    if (count > left / least_bytes)
      fail(fmt::format("{} {} are announced, but only {} bytes are left in the file", count, what,
                       left),
           again);
    return count;
  }

  [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const {
    const auto line =
        1 +
        std::count(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(line_start_), '\n');
    throw InputError(fmt::format("{}, line {}", name_, line), problem, remedy);
  }

  // ---- sections
  // ----------------------------------------------------------------------------------
  void section(const std::string& name) {
    if (name == "MeshFormat") return format();
    if (name == "NOD" && version_ == 0) version_ = 1;
    if (name == "Nodes" || name == "NOD" || name == "ParametricNodes") {
      need_version();
      nodes_seen_ = true;
      if (name == "ParametricNodes") return skip(name);
      binary_ ? binary_nodes() : text_nodes();
      all_nodes_listed_ = true;
    } else if (name == "Elements" || name == "ELM") {
      need_version();
      if (!nodes_seen_) fail("the elements come before the nodes", "put $Nodes before $Elements");
      binary_ ? binary_elements() : text_elements();
    } else {
      if (!binary_ && (name == "Entities" || name == "PhysicalNames")) check_first_counts();
      return skip(name);
    }
    skip(name);
  }

  void need_version() const {
    if (version_ == 0) fail("there is no $MeshFormat section before it", again);
  }

  /// Goes behind the end of a section. Old readers do without $End lines, so does this one.
  void skip(const std::string& name) {
    const std::string end = name == "NOD" || name == "ELM" ? "$END" + name : "$End" + name;
    const std::size_t found = bytes_.find(end, at_);
    if (found == bytes_.npos) fail(fmt::format("{} is missing: the file is cut short", end), again);
    at_ = found;
    next_line();
  }

  void format() {
    std::string_view line = data_line("the version");
    const std::string version_text(line.substr(0, line.find(' ')));
    version_ = word<double>(line, "the version");
    const int type = word<int>(line, "the file type");
    binary_ = type == 1;
    const bool known = version_ == 1 || (version_ >= 2 && version_ < 3) || version_ == 3 ||
                       version_ == 4 || version_ == 4.1;
    if (!known || (type != 0 && type != 1))
      fail(fmt::format("MSH version {} is not supported", version_text),
           "write the mesh as version 4.1 or 2.2");
    if (binary_) {
      need_bytes(4);
      std::int32_t one = 0;
      std::memcpy(&one, bytes_.data() + at_, 4);
      at_ += 4;
      swapped_ = one != 1;
    }
    skip("MeshFormat");
  }

  void check_first_counts() {
    const std::size_t start = at_;
    std::string_view line = data_line("its counts");
    while (!line.empty()) {
      const auto count = word<std::uint64_t>(line, "a count");
      checked_count(count, "entities", 2);
    }
    at_ = start;
  }

  // ---- text
  // --------------------------------------------------------------------------------------
  void text_nodes() {
    std::string_view line = data_line("the number of nodes");
    auto count = word<std::uint64_t>(line, "the number of nodes");
    if (version_ < 4) {
      checked_count(count, "nodes", 7);
      for (std::uint64_t i = 0; i < count; ++i) {
        std::string_view node = data_line(fmt::format("node {} of {}", i + 1, count));
        nodes_.insert(word<std::int64_t>(node, "the number of a node"));
      }
      return;
    }
    const std::uint64_t blocks = checked_count(count, "blocks of nodes", 8);
    checked_count(word<std::uint64_t>(line, "the number of nodes"), "nodes", 7);
    for (std::uint64_t block = 0; block < blocks; ++block) {
      std::string_view header =
          data_line(fmt::format("block {} of {} of nodes", block + 1, blocks));
      std::array<std::int64_t, 3> numbers{};  // 4.1: dimension, tag; 4.0: tag, dimension
      for (std::int64_t& number : numbers)
        number = word<std::int64_t>(header, "the header of a block");
      const auto n =
          checked_count(word<std::uint64_t>(header, "the header of a block"), "nodes", 7);
      const std::int64_t dimension = std::clamp<std::int64_t>(numbers[version_ > 4 ? 0 : 1], 0, 3);
      const std::int64_t parameters = numbers[2] != 0 ? dimension : 0;
      skip_words(n * static_cast<std::uint64_t>(4 + parameters), "the end of a block of nodes");
    }
  }

  void text_elements() {
    std::string_view line = data_line("the number of elements");
    const auto count = word<std::uint64_t>(line, "the number of elements");
    if (version_ < 4) {
      checked_count(count, "elements", 7);
      for (std::uint64_t i = 0; i < count; ++i)
        text_element(data_line(fmt::format("element {} of {}", i + 1, count)));
      return;
    }
    const std::uint64_t blocks = checked_count(count, "blocks of elements", 8);
    checked_count(word<std::uint64_t>(line, "the number of elements"), "elements", 4);
    for (std::uint64_t block = 0; block < blocks; ++block) {
      std::string_view header =
          data_line(fmt::format("block {} of {} of elements", block + 1, blocks));
      for (int i = 0; i < 2; ++i) word<std::int64_t>(header, "the header of a block");
      const int type = word<int>(header, "the type of a block of elements");
      const auto n =
          checked_count(word<std::uint64_t>(header, "the header of a block"), "elements", 4);
      counts_[type] += n;
      const std::string_view end = "the end of a block of elements";
      if (const auto nodes = nodes_of_gmsh_type(type)) {
        skip_words(n * (1 + *nodes), end);
      } else {
        for (std::uint64_t i = 0; i < n; ++i) data_line(end);
      }
    }
  }

  /// Versions 1 and 2: number, type, tags and nodes on one line.
  void text_element(std::string_view line) {
    const auto number = word<std::int64_t>(line, "the number of an element");
    const int type = word<int>(line, "the type of an element");
    ++counts_[type];
    const auto expected = nodes_of_gmsh_type(type);
    if (!expected || version_ >= 3) return;
    auto tags = word<std::int64_t>(line, "the number of tags of an element");
    if (version_ == 1) tags = 2;  // that was the physical tag; two more words follow
    for (std::int64_t i = 0; i < tags; ++i) word<std::int64_t>(line, "a tag of an element");
    std::vector<std::int64_t> nodes;
    while (line.find_first_not_of(" \t") != line.npos)
      nodes.push_back(word<std::int64_t>(line, "a node of an element"));
    if (nodes.size() != *expected)
      fail(fmt::format("element {} has {} node numbers, its type {} has {}", number, nodes.size(),
                       type, *expected),
           again);
    for (const std::int64_t node : nodes)
      if (all_nodes_listed_ && !nodes_.contains(node))
        fail(fmt::format("element {} refers to node {}, which is not defined", number, node),
             again);
  }

  // ---- binary
  // ------------------------------------------------------------------------------------
  void need_bytes(std::uint64_t count) const {
    if (count > bytes_.size() - at_) fail("the file is cut short", again);
  }

  template <class Number>
  Number binary() {
    need_bytes(sizeof(Number));
    std::array<char, sizeof(Number)> raw;
    std::memcpy(raw.data(), bytes_.data() + at_, raw.size());
    if (swapped_) std::reverse(raw.begin(), raw.end());
    at_ += raw.size();
    Number value;
    std::memcpy(&value, raw.data(), raw.size());
    return value;
  }

  void jump(std::uint64_t count, std::uint64_t bytes_each, std::string_view what) {
    checked_count(count, what, static_cast<std::size_t>(bytes_each));
    at_ += static_cast<std::size_t>(count * bytes_each);
  }

  void binary_nodes() {
    if (version_ < 4) {
      std::string_view line = data_line("the number of nodes");
      return jump(word<std::uint64_t>(line, "the number of nodes"), 4 + 3 * 8, "nodes");
    }
    const auto blocks = checked_count(binary<std::uint64_t>(), "blocks of nodes", 20);
    checked_count(binary<std::uint64_t>(), "nodes", 24);
    if (version_ > 4) jump(2, 8, "numbers");  // least and largest tag
    for (std::uint64_t block = 0; block < blocks; ++block) {
      const auto first = binary<std::int32_t>(), second = binary<std::int32_t>();
      const auto parametric = binary<std::int32_t>();
      const auto dimension =
          static_cast<std::uint64_t>(std::clamp(version_ > 4 ? first : second, 0, 3));
      const auto n = binary<std::uint64_t>();
      jump(n, (version_ > 4 ? 8 : 4) + 8 * (3 + (parametric != 0 ? dimension : 0)), "nodes");
    }
  }

  void binary_elements() {
    if (version_ < 4) return old_binary_elements();
    const auto blocks = checked_count(binary<std::uint64_t>(), "blocks of elements", 20);
    checked_count(binary<std::uint64_t>(), "elements", 8);
    if (version_ > 4) jump(2, 8, "numbers");
    for (std::uint64_t block = 0; block < blocks; ++block) {
      jump(2, 4, "numbers");
      const auto type = binary<std::int32_t>();
      const auto n = binary<std::uint64_t>();
      jump(n, (version_ > 4 ? 8 : 4) * (1 + nodes_of(type, n)), "elements");
      counts_[type] += n;
    }
  }

  void old_binary_elements() {
    std::string_view line = data_line("the number of elements");
    const auto count =
        checked_count(word<std::uint64_t>(line, "the number of elements"), "elements", 8);
    for (std::uint64_t seen = 0; seen < count;) {
      const auto type = binary<std::int32_t>();
      const auto n = static_cast<std::uint64_t>(std::max(1, binary<std::int32_t>()));
      const auto tags = static_cast<std::uint64_t>(std::max(0, binary<std::int32_t>()));
      jump(n, 4 * (1 + tags + nodes_of(type, n)), "elements");
      counts_[type] += n;
      seen += n;
    }
  }

  /// An element type whose size is not known cannot be stepped over; it is named at once.
  std::uint64_t nodes_of(int type, std::uint64_t count) {
    if (const auto nodes = nodes_of_gmsh_type(type)) return *nodes;
    check_gmsh_elements({{2, 1}, {type, count}}, name_);
    return 0;
  }

  static constexpr const char* again = "write the mesh again, or correct it";

  std::string_view bytes_;
  std::string name_;
  std::size_t at_ = 0, line_start_ = 0;
  double version_ = 0;
  bool binary_ = false, swapped_ = false, nodes_seen_ = false, all_nodes_listed_ = false;
  std::unordered_set<std::int64_t> nodes_;
  GmshElementCounts counts_;
};

std::string read_bytes(const fs::path& file) {
  constexpr std::uint64_t most = std::uint64_t{4} << 30;
  std::ifstream in(file, std::ios::binary);
  std::error_code error;
  const auto size = fs::file_size(file, error);
  if (!in || error)
    throw InputError(file.string(), "cannot be read", "give a file that exists and may be read");
  if (size > most)
    throw RefusedError(file.string(),
                       fmt::format("the file has {} bytes, more than {}", size, most),
                       "give a smaller mesh");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  return bytes;
}

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

std::size_t first_word(std::string_view bytes) {
  const std::size_t mark = bytes.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
  return std::min(bytes.find_first_not_of(" \t\r\n", mark), bytes.size());
}

}  // namespace

bool looks_like_msh(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string start(256, '\0');
  in.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(in.gcount()));
  const std::size_t first = first_word(start);
  return first < start.size() && start[first] == '$';
}

void copy_mesh_file(const fs::path& file, const fs::path& private_folder) {
  const std::string bytes = read_bytes(file);
  const std::string_view mesh = std::string_view(bytes).substr(first_word(bytes));
  if (!mesh.starts_with("$"))
    throw InputError(file.string() + ", line 1", "does not begin like a .msh file",
                     "give a mesh that starts with $MeshFormat, or name a script .geo");
  MeshFile(mesh, file.string()).check();
  const fs::path target = private_folder / private_mesh_name;
  std::ofstream out(target, std::ios::binary);
  out << mesh;
  if (mesh.back() != '\n') out << '\n';
  out.close();
  if (!out)
    throw OutputError(target.string(), "cannot write the private copy of the input",
                      "make room in the folder for temporary files (TMPDIR)");
}

}  // namespace lepp
