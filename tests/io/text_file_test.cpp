#include "lepp/io/text_file.hpp"

#include <doctest/doctest.h>

#include "io/scratch_folder.hpp"
#include "lepp/geometry/error.hpp"

using namespace lepp;
using test::contains;
using test::error_of;
using test::ScratchFolder;

TEST_CASE("a byte-order mark is not part of the text") {
  const ScratchFolder folder;
  CHECK(read_text_file(folder.put("a",
                                  "\xEF\xBB\xBF"
                                  "4 2\n"))
            .text == "4 2\n");
  CHECK(read_text_file(folder.put("b", "4 2\n")).text == "4 2\n");
}

TEST_CASE("files that are no text are refused with a reason") {
  const ScratchFolder folder;
  const auto read = [](const std::filesystem::path& path) {
    return error_of<InputError>([&] { read_text_file(path); });
  };
  CHECK(contains(read(folder / "missing"), "No such file"));
  CHECK(contains(read(folder.put("empty", "")), "the file is empty"));
  CHECK(contains(read(folder.put("nul", std::string("1\n2\n\0", 5))), "nul, line 3: a NUL byte"));
  CHECK(contains(read(folder.put("utf16",
                                 "\xFF\xFE"
                                 "4")),
                 "UTF-16"));
  CHECK(contains(read(folder / "."), "is a folder, not a file"));
  CHECK(contains(read("/dev/zero"), "is a device, not a file"));
}

TEST_CASE("a file beyond the size limit is refused before it is read") {
  const ScratchFolder folder;
  const auto path = folder.put("a", "12345");
  CHECK(read_text_file(path, 5).text == "12345");
  CHECK(contains(error_of<RefusedError>([&] { read_text_file(path, 4); }),
                 "has 5 bytes, the limit is 4"));
}
