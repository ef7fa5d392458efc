#include "lepp/io/atomic_files.hpp"

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <charconv>
#include <cmath>

#include "io/file_size_limit.hpp"
#include "io/scratch_folder.hpp"
#include "lepp/geometry/error.hpp"

using namespace lepp;
using test::contains;
using test::error_of;
using test::FileSizeLimit;
using test::ScratchFolder;

TEST_CASE("a committed file has the text that was written, and nothing else is left") {
  const ScratchFolder folder;
  AtomicFiles files;
  files.add(folder / "a.txt") << "x = " << 0.1 << ", n = " << 42 << ' ' << -7 << '\n';
  CHECK(folder.text("a.txt").empty());  // not there before commit
  files.commit();
  CHECK(folder.text("a.txt") == "x = 0.1, n = 42 -7\n");
  CHECK(folder.names() == std::set<std::string>{"a.txt"});
}

TEST_CASE("doubles are written so that they read back as the same double") {
  const ScratchFolder folder;
  for (const double x : {0.1, 1.0 / 3, 500000.12345678901, 5e-324, -1.7976931348623157e308, -0.0}) {
    AtomicFiles files;
    files.add(folder / "x") << x;
    files.commit();
    const std::string text = folder.text("x");
    double back = 1;
    std::from_chars(text.data(), text.data() + text.size(), back);
    CHECK(back == x);
    CHECK(std::signbit(back) == std::signbit(x));
  }
}

TEST_CASE("a set that is not committed leaves nothing, and the old file as it was") {
  const ScratchFolder folder;
  folder.put("a.txt", "old");
  {
    AtomicFiles files;
    files.add(folder / "a.txt") << "new";
    files.add(folder / "b.txt") << std::string(3 << 20, 'x');  // beyond the buffer
  }
  CHECK(folder.text("a.txt") == "old");
  CHECK(folder.names() == std::set<std::string>{"a.txt"});
}

TEST_CASE("a write that fails is an OutputError and the old file survives") {
  const ScratchFolder folder;
  folder.put("a.txt", "old");
  const auto write = [&] {
    const FileSizeLimit limit(4096);
    AtomicFiles files;
    files.add(folder / "a.txt") << std::string(100000, 'x');
    files.commit();
  };
  CHECK(contains(error_of<OutputError>(write), "limit on file size"));
  CHECK(folder.text("a.txt") == "old");
  CHECK(folder.names() == std::set<std::string>{"a.txt"});
}

TEST_CASE("a full device is an OutputError that says so") {
  const auto write = [] {
    AtomicFiles files;
    files.add("/dev/full") << "x";
    files.commit();
  };
  CHECK(contains(error_of<OutputError>(write), "No space left"));
  struct stat status {};
  ::stat("/dev/full", &status);
  CHECK(S_ISCHR(status.st_mode));  // written to, not replaced
}

TEST_CASE("a missing folder, a folder as target and an empty name are OutputErrors") {
  const ScratchFolder folder;
  const auto add = [](const std::filesystem::path& path) {
    return error_of<OutputError>([&] { AtomicFiles().add(path); });
  };
  CHECK(contains(add(folder / "no/such/a.txt"), "make the folder first"));
  CHECK(contains(add(folder / ""), "give the name of a file"));
  CHECK(contains(add(folder / "."), "give the name of a file"));
  CHECK(contains(add(""), "give the name of a file"));
  CHECK(folder.names().empty());
}

TEST_CASE("when one rename of a set fails, the files renamed before are brought back") {
  const ScratchFolder folder;
  folder.put("a.txt", "old a");
  AtomicFiles files;
  files.add(folder / "a.txt") << "new a";
  files.add(folder / "b.txt") << "new b";
  files.add(folder / "c.txt") << "new c";
  std::filesystem::create_directory(folder / "c.txt");  // a file cannot replace a folder
  CHECK_FALSE(error_of<OutputError>([&] { files.commit(); }).empty());
  CHECK(folder.text("a.txt") == "old a");
  CHECK(folder.names() == std::set<std::string>{"a.txt", "c.txt"});
}

TEST_CASE("a set replaces all its files and leaves no second names") {
  const ScratchFolder folder;
  folder.put("a.txt", "old a");
  folder.put("b.txt", "old b");
  AtomicFiles files;
  files.add(folder / "a.txt") << "new a";
  files.add(folder / "b.txt") << "new b";
  files.commit();
  CHECK(folder.text("a.txt") + folder.text("b.txt") == "new anew b");
  CHECK(folder.names() == std::set<std::string>{"a.txt", "b.txt"});
}

TEST_CASE("a symbolic link stays one, and its file gets the text and keeps its permissions") {
  const ScratchFolder folder;
  folder.put("real.txt", "old");
  std::filesystem::permissions(folder / "real.txt", std::filesystem::perms(0640));
  std::filesystem::create_symlink("real.txt", folder / "link.txt");
  AtomicFiles files;
  files.add(folder / "link.txt") << "new";
  files.commit();
  CHECK(std::filesystem::is_symlink(folder / "link.txt"));
  CHECK(folder.text("real.txt") == "new");
  CHECK(std::filesystem::status(folder / "real.txt").permissions() == std::filesystem::perms(0640));
}
