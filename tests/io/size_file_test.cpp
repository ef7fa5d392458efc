#include "lepp/io/size_file.hpp"

#include <doctest/doctest.h>

#include "io/scratch_folder.hpp"
#include "lepp/geometry/error.hpp"

using namespace lepp;
using test::contains;
using test::error_of;
using test::ScratchFolder;

namespace {

std::string size_error(const std::string& text) {
  const ScratchFolder folder;
  const auto path = folder.put("a.txt", text);
  return error_of<InputError>([&] { read_size_file(path); });
}

}  // namespace

TEST_CASE("numbers between commas are told from too few numbers") {
  CHECK(contains(size_error("0.5,0.5,0.1\n"), "not separated by blanks"));
  CHECK(contains(size_error("0.5\n"), "1 fields where 3 belong"));
}

TEST_CASE("a size file holds points with sizes, comments and empty lines") {
  const ScratchFolder folder;
  const auto path = folder.put("a.txt", "# x y h\n0 1 0.25\n\n  -1e3\t2 1e-3  # a well\r\n");
  const auto sources = read_size_file(path);
  REQUIRE(sources.size() == 2);
  CHECK(sources[0].at == Point{0, 1});
  CHECK(sources[0].size == 0.25);
  CHECK(sources[0].holds_around_it);
  CHECK(sources[1].at == Point{-1000, 2});
  CHECK(sources[1].size == 1e-3);
}

TEST_CASE("errors in a size file name the file and the line") {
  CHECK(contains(size_error("0 0 1\n0 0\n"), "a.txt, line 2"));
  CHECK(contains(size_error("0 0 1 2\n"), "a.txt, line 1"));
  CHECK(contains(size_error("0 0 zero\n"), "a.txt, line 1"));
  CHECK(contains(size_error("# h\n0 0 0\n"), "a.txt, line 2"));
  CHECK(contains(size_error("0 0 -1\n"), "not above 0"));
  CHECK(contains(size_error("0 0 nan\n"), "a.txt, line 1"));
  CHECK(contains(size_error("# nothing\n"), "holds no sizes"));
}
