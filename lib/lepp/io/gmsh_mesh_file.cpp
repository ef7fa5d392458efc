#include "lepp/io/gmsh_mesh_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "lepp/geometry/error.hpp"
#include "lepp/io/gmsh_element_types.hpp"
#include "lepp/io/gmsh_mesh_cursor.hpp"

namespace lepp {
namespace {

namespace fs = std::filesystem;

/// Walks through the sections of one .msh file.
class MeshFile {
 public:
  MeshFile(std::string_view bytes, const std::string& name) : cursor_(bytes, name) {}

  ElementGroups check() {
    while (!cursor_.at_end()) {
      const std::string_view line = cursor_.line();
      if (line.starts_with("$")) section(std::string(line.substr(1)));
    }
    if (version_ == 0) cursor_.fail("there is no $MeshFormat and no $NOD section");
    if (!nodes_seen_) cursor_.fail("there is no section of nodes");
    check_gmsh_elements(counts_, cursor_.name());
    return std::move(groups_);
  }

 private:
  void section(const std::string& name) {
    if (name == "MeshFormat") return format();
    if (name.starts_with("End") || name.starts_with("END"))
      cursor_.fail(fmt::format("${} ends a section that did not begin", name));
    if (name == "NOD" && version_ == 0) version_ = 1;
    const bool nodes = name == "Nodes" || name == "NOD",
               elements = name == "Elements" || name == "ELM";
    if ((nodes || elements) && version_ == 0)
      cursor_.fail("there is no $MeshFormat section before it");
    if (elements && !nodes_seen_)
      cursor_.fail("the elements come before the nodes", "put $Nodes before $Elements");
    if (nodes) binary_ ? binary_nodes() : text_nodes();
    if (elements) binary_ ? binary_elements() : text_elements();
    if (!binary_ && (name == "Entities" || name == "PhysicalNames")) check_first_counts();
    nodes_seen_ = nodes_seen_ || nodes || name == "ParametricNodes";
    all_nodes_listed_ = all_nodes_listed_ || (nodes && !binary_);
    cursor_.skip_past((name == "NOD" || name == "ELM" ? "$END" : "$End") + name);
  }

  void format() {
    std::string_view line = cursor_.data_line("the version");
    const std::string version_text(line.substr(0, line.find(' ')));
    version_ = cursor_.number<double>(line, "the version");
    const int type = cursor_.number<int>(line, "the file type");
    binary_ = type == 1;
    const bool known = version_ == 1 || (version_ >= 2 && version_ < 3) || version_ == 3 ||
                       version_ == 4 || version_ == 4.1;
    if (!known || (type != 0 && type != 1))
      cursor_.fail(fmt::format("MSH version {} is not supported", version_text),
                   "write the mesh as version 4.1 or 2.2");
    if (binary_) swapped_ = cursor_.binary<std::int32_t>(false) != 1;
    cursor_.skip_past("$EndMeshFormat");
  }

  void check_first_counts() {
    const std::size_t start = cursor_.position();
    std::string_view line = cursor_.data_line("its counts");
    while (!line.empty())
      cursor_.checked_count(cursor_.number<std::uint64_t>(line, "a count"), "entities", 2);
    cursor_.go_to(start);
  }

  std::uint64_t text_count(std::string_view& line, std::string_view what, std::uint64_t least) {
    const auto count = cursor_.number<std::uint64_t>(line, fmt::format("the number of {}", what));
    return cursor_.checked_count(count, what, least);
  }

  // ---- text
  // --------------------------------------------------------------------------------------
  void text_nodes() {
    std::string_view line = cursor_.data_line("the number of nodes");
    if (version_ < 4) {
      const std::uint64_t count = text_count(line, "nodes", 7);
      for (std::uint64_t i = 0; i < count; ++i) {
        std::string_view node = cursor_.data_line(fmt::format("node {} of {}", i + 1, count));
        nodes_.insert(cursor_.number<std::int64_t>(node, "the number of a node"));
      }
      return;
    }
    const std::uint64_t blocks = text_count(line, "blocks of nodes", 8);
    text_count(line, "nodes", 7);
    for (std::uint64_t block = 0; block < blocks; ++block) {
      std::string_view header = cursor_.data_line(fmt::format("block {} of nodes", block + 1));
      std::array<std::int64_t, 3> numbers{};  // 4.1: dimension, tag; 4.0: tag, dimension
      for (std::int64_t& number : numbers)
        number = cursor_.number<std::int64_t>(header, "the header of a block");
      const std::uint64_t n = text_count(header, "nodes", 7);
      const std::int64_t dimension = std::clamp<std::int64_t>(numbers[version_ > 4 ? 0 : 1], 0, 3);
      const std::int64_t parameters = numbers[2] != 0 ? dimension : 0;
      cursor_.skip_words(n * static_cast<std::uint64_t>(4 + parameters),
                         "the end of a block of nodes");
    }
  }

  void text_elements() {
    std::string_view line = cursor_.data_line("the number of elements");
    if (version_ < 4) {
      const std::uint64_t count = text_count(line, "elements", 7);
      for (std::uint64_t i = 0; i < count; ++i)
        text_element(cursor_.data_line(fmt::format("element {} of {}", i + 1, count)));
      return;
    }
    const std::uint64_t blocks = text_count(line, "blocks of elements", 8);
    text_count(line, "elements", 4);
    for (std::uint64_t block = 0; block < blocks; ++block) {
      std::string_view header = cursor_.data_line(fmt::format("block {} of elements", block + 1));
      for (int i = 0; i < 2; ++i) cursor_.number<std::int64_t>(header, "the header of a block");
      const int type = cursor_.number<int>(header, "the type of a block of elements");
      const std::uint64_t n = text_count(header, "elements", 4);
      counts_[type] += n;
      const std::string_view end = "the end of a block of elements";
      if (const auto nodes = nodes_of_gmsh_type(type)) {
        cursor_.skip_words(n * (1 + *nodes), end);
      } else {
        for (std::uint64_t i = 0; i < n; ++i) cursor_.data_line(end);
      }
    }
  }

  /// Version 1: number, type, physical tag, elementary tag, number of nodes, nodes.
  /// Version 2: number, type, number of tags, tags (the physical one first), nodes.
  void text_element(std::string_view line) {
    const auto number = cursor_.number<std::int64_t>(line, "the number of an element");
    const int type = cursor_.number<int>(line, "the type of an element");
    ++counts_[type];
    const auto expected = nodes_of_gmsh_type(type);
    if (!expected || version_ >= 3) return;
    auto tags = version_ == 1 ? 3 : cursor_.number<std::int64_t>(line, "a number of tags");
    int physical = 0;
    for (std::int64_t i = 0; i < tags; ++i) {
      const int tag = cursor_.number<int>(line, "a tag of an element");
      if (i == 0) physical = tag;
    }
    groups_[number] = physical;
    std::vector<std::int64_t> nodes;
    while (line.find_first_not_of(" \t") != line.npos)
      nodes.push_back(cursor_.number<std::int64_t>(line, "a node of an element"));
    if (nodes.size() != *expected)
      cursor_.fail(fmt::format("element {} has {} node numbers, its type {} has {}", number,
                               nodes.size(), type, *expected));
    for (const std::int64_t node : nodes)
      if (all_nodes_listed_ && !nodes_.contains(node))
        cursor_.fail(
            fmt::format("element {} refers to node {}, which is not defined", number, node));
  }

  // ---- binary
  // ------------------------------------------------------------------------------------
  std::int32_t integer() { return cursor_.binary<std::int32_t>(swapped_); }
  std::uint64_t count(std::string_view what, std::uint64_t least_bytes) {
    return cursor_.checked_count(cursor_.binary<std::uint64_t>(swapped_), what, least_bytes);
  }

  void binary_nodes() {
    if (version_ < 4) {
      std::string_view line = cursor_.data_line("the number of nodes");
      const std::uint64_t n = text_count(line, "nodes", 4 + 3 * 8);
      return cursor_.skip_bytes(n, 4 + 3 * 8, "nodes");
    }
    const std::uint64_t blocks = count("blocks of nodes", 20);
    count("nodes", 24);
    if (version_ > 4) cursor_.skip_bytes(2, 8, "numbers");  // least and largest tag
    for (std::uint64_t block = 0; block < blocks; ++block) {
      const std::int32_t first = integer(), second = integer(), parametric = integer();
      const int dimension = std::clamp(version_ > 4 ? first : second, 0, 3);
      const auto numbers = static_cast<std::uint64_t>(3 + (parametric != 0 ? dimension : 0));
      const std::uint64_t bytes = (version_ > 4 ? 8 : 4) + 8 * numbers;
      cursor_.skip_bytes(count("nodes", bytes), bytes, "nodes");
    }
  }

  void binary_elements() {
    if (version_ < 4) return old_binary_elements();
    const std::uint64_t blocks = count("blocks of elements", 20);
    count("elements", 8);
    if (version_ > 4) cursor_.skip_bytes(2, 8, "numbers");
    for (std::uint64_t block = 0; block < blocks; ++block) {
      cursor_.skip_bytes(2, 4, "numbers");
      const std::int32_t type = integer();
      const std::uint64_t n = count("elements", 4);
      cursor_.skip_bytes(n, (version_ > 4 ? 8 : 4) * (1 + nodes_of(type, n)), "elements");
      counts_[type] += n;
    }
  }

  void old_binary_elements() {
    std::string_view line = cursor_.data_line("the number of elements");
    const std::uint64_t total = text_count(line, "elements", 8);
    for (std::uint64_t seen = 0; seen < total;) {
      const std::int32_t type = integer();
      const auto n = static_cast<std::uint64_t>(std::max(1, integer()));
      const auto tags = static_cast<std::uint64_t>(std::max(0, integer()));
      const std::uint64_t nodes = nodes_of(type, n);
      cursor_.checked_count(n, "elements", 4 * (1 + tags + nodes));
      for (std::uint64_t i = 0; i < n; ++i) {
        const std::int32_t number = integer();
        if (tags > 0) groups_[number] = integer();
        cursor_.skip_bytes(nodes + (tags > 0 ? tags - 1 : 0), 4, "numbers");
      }
      counts_[type] += n;
      seen += n;
    }
  }

  /// An element type whose size is not known cannot be stepped over; it is named at once.
  std::uint64_t nodes_of(int type, std::uint64_t n) {
    if (const auto nodes = nodes_of_gmsh_type(type)) return *nodes;
    check_gmsh_elements({{2, 1}, {type, std::max<std::uint64_t>(n, 1)}}, cursor_.name());
    return 0;
  }

  MeshCursor cursor_;
  double version_ = 0;
  bool binary_ = false, swapped_ = false, nodes_seen_ = false, all_nodes_listed_ = false;
  std::unordered_set<std::int64_t> nodes_;
  GmshElementCounts counts_;
  ElementGroups groups_;
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

/// Where the first word starts, behind blanks and a byte-order mark.
std::size_t first_word(std::string_view bytes) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  const std::size_t start = bytes.starts_with(mark) ? mark.size() : 0;
  return std::min(bytes.find_first_not_of(" \t\r\n", start), bytes.size());
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

ElementGroups copy_mesh_file(const fs::path& file, const fs::path& private_folder) {
  const std::string bytes = read_bytes(file);
  const std::string_view mesh = std::string_view(bytes).substr(first_word(bytes));
  if (mesh.empty()) throw InputError(file.string(), "the file is empty", "give a file with data");
  if (!mesh.starts_with("$"))
    throw InputError(file.string() + ", line 1", "does not begin like a .msh file",
                     "give a mesh that starts with $MeshFormat, or name a script .geo");
  ElementGroups groups = MeshFile(mesh, file.string()).check();
  const fs::path target = private_folder / private_mesh_name;
  std::ofstream out(target, std::ios::binary);
  out << mesh;
  if (mesh.back() != '\n') out << '\n';
  out.close();
  if (!out)
    throw OutputError(target.string(), "cannot write the private copy of the input",
                      "make room in the folder for temporary files (TMPDIR)");
  return groups;
}

}  // namespace lepp
