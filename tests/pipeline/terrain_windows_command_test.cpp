// lepp terrain: windows of a raster, and grids that were cut apart before.

#include <doctest/doctest.h>

#include "pipeline/obj_tin.hpp"

using namespace lepp;
using namespace lepp::test;
namespace fs = std::filesystem;

namespace {

// A raster in several forms. All begin at (100, 350) and have cells of 10, or know nothing of that.
constexpr std::uint32_t columns = 45, rows = 30;

float height_at(std::uint32_t column, std::uint32_t row) {
  const double beside = 4 * std::abs(double(column) - 20) * ((row * 7 + column * 3) % 5);
  return static_cast<float>(std::round(100 * std::sin(0.3 * row) + beside));
}

// The samples of a window, row by row.
std::string floats_of(const GridWindow& w) {
  std::string bytes;
  for (std::uint32_t row = w.row; row < w.row + w.rows; ++row) {
    for (std::uint32_t column = w.column; column < w.column + w.columns; ++column) {
      const float height = height_at(column, row);
      bytes.append(reinterpret_cast<const char*>(&height), sizeof height);
    }
  }
  return bytes;
}

std::string asc_of(const GridWindow& w) {
  std::ostringstream out;
  out << "ncols " << w.columns << "\nnrows " << w.rows << "\nxllcenter " << 100 + 10 * w.column
      << "\nyllcenter " << 50 + 10 * (rows - w.row - w.rows) << "\ncellsize 10\n";
  for (std::uint32_t row = w.row; row < w.row + w.rows; ++row) {
    for (std::uint32_t column = w.column; column < w.column + w.columns; ++column) {
      out << height_at(column, row) << ' ';
    }
    out << '\n';
  }
  return out.str();
}

std::string f32_of(const GridWindow& w) {
  return "F32 " + std::to_string(w.columns) + ' ' + std::to_string(w.rows) + " -9999\n" +
         floats_of(w);
}

std::string npy_of(const GridWindow& w) {
  std::string head = "{'descr': '<f4', 'fortran_order': False, 'shape': (" +
                     std::to_string(w.rows) + ", " + std::to_string(w.columns) + "), }";
  head.resize(117, ' ');
  return std::string("\x93NUMPY\x01\x00\x76\x00", 10) + head + '\n' + floats_of(w);
}

#ifdef LEPP_HAS_GDAL
// Read by GDAL: a text that says where the samples are.
std::string vrt_of(const GridWindow& w, const std::string& samples) {
  const std::string width = std::to_string(w.columns);
  return "<VRTDataset rasterXSize=\"" + width + "\" rasterYSize=\"" + std::to_string(w.rows) +
         "\"><GeoTransform>" + std::to_string(95 + 10 * w.column) + ", 10, 0, " +
         std::to_string(345 - 10 * w.row) +
         ", 0, -10</GeoTransform><VRTRasterBand dataType=\"Float32\" band=\"1\" "
         "subClass=\"VRTRawRasterBand\"><SourceFilename relativetoVRT=\"1\">" +
         samples + "</SourceFilename><PixelOffset>4</PixelOffset><LineOffset>" +
         std::to_string(4 * w.columns) +
         "</LineOffset><ByteOrder>LSB</ByteOrder></VRTRasterBand></VRTDataset>";
}
#endif

double largest_difference(const ObjTin& tin, const ObjTin& other, const Place& shift) {
  REQUIRE(tin.vertices.size() == other.vertices.size());
  double largest = 0;
  for (std::size_t i = 0; i < tin.vertices.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double difference = tin.vertices[i][k] - (other.vertices[i][k] + shift[k]);
      largest = std::max(largest, std::abs(difference));
    }
  }
  return largest;
}

constexpr GridWindow all{0, 0, columns, rows};

std::string text_of(const GridWindow& w) {
  std::string text;
  for (const std::uint32_t n : {w.column, w.row, w.columns, w.rows}) {
    text += ' ';
    text += std::to_string(n);
  }
  return text;
}

}  // namespace

TEST_CASE("a window is meshed as if it had been cut out by hand") {
  const ScratchFolder folder;
  const GridWindow window{7, 4, 21, 17};
  folder.put("all.asc", asc_of(all));
  folder.put("cut.asc", asc_of(window));
  folder.put("all.f32", f32_of(all));
  folder.put("cut.f32", f32_of(window));
  folder.put("all.npy", npy_of(all));
  folder.put("cut.npy", npy_of(window));
  std::vector<std::string> kinds{"asc", "f32", "npy"};
#ifdef LEPP_HAS_GDAL
  folder.put("all.raw", floats_of(all));
  folder.put("cut.raw", floats_of(window));
  folder.put("all.vrt", vrt_of(all, "all.raw"));
  folder.put("cut.vrt", vrt_of(window, "cut.raw"));
  kinds.push_back("vrt");
#endif
  for (const std::string& kind : kinds) {
    CAPTURE(kind);
    const std::string end = " --max-error 4% --levels 20% --force -q --json - ";
    const Outcome made =
        run(folder.path(), "terrain all." + kind + " -o all.obj --window" + text_of(window) + end);
    CAPTURE(made.err);
    REQUIRE(made.status == 0);
    REQUIRE(run(folder.path(), "terrain cut." + kind + " -o cut.obj" + end).status == 0);
    const Json report = Json::parse(made.out);
    CHECK(report["columns"] == 21);
    CHECK(report["asked_for"]["window"] == Json({7, 4, 21, 17}));
    const std::uint32_t column = report["error"]["column"], row = report["error"]["row"];
    CHECK((column >= 7 && column < 28 && row >= 4 && row < 21));  // of the file
    // Without a georeference places are counted from the corner of the whole.
    const bool placed = kind == "asc" || kind == "vrt";
    const Place shift = placed ? Place{0, 0, 0} : Place{7, double(rows - 4 - 17), 0};
    for (const std::string level : {"", ".level1"}) {
      const ObjTin found = read_obj(folder / ("all" + level + ".obj"));
      const ObjTin cut = read_obj(folder / ("cut" + level + ".obj"));
      CHECK(largest_difference(found, cut, shift) < 1e-9);
      CHECK(found.triangles == cut.triangles);
    }
  }
}

#ifdef LEPP_HAS_GDAL
TEST_CASE("the parts of a mosaic are inputs too") {
  const ScratchFolder folder;
  folder.put("part.obj", floats_of(all));
  folder.put("all.vrt", vrt_of(all, "part.obj"));
  for (const std::string options : {"-o part.obj", "-o x.obj --json part.obj"}) {
    const Outcome made = run(folder.path(), "terrain all.vrt --max-error 5 --force -q " + options);
    CHECK(made.status == 5);
    CHECK(has(made.err, "is also a part of the input"));
    CHECK(folder.text("part.obj") == floats_of(all));
  }
}
#endif

TEST_CASE(
    "windows that share a line of samples fit together, and with tiles made of the same ones") {
  const ScratchFolder folder;
  folder.put("all.asc", asc_of(all));
  for (const std::string by : {"lepp", "greedy"}) {
    CAPTURE(by);
    const std::string end = " --max-error 6 --levels 60 --force -q --by " + by;
    REQUIRE(
        run(folder.path(), "terrain all.asc -o west.obj --border-error 6 --window 0 0 23 30" + end)
            .status == 0);
    REQUIRE(
        run(folder.path(), "terrain all.asc -o east.obj --border-error 6 --window 22 0 23 30" + end)
            .status == 0);
    const auto shared = on_line(read_obj(folder / "west.obj"), 0, 320);
    CHECK(shared.size() > 8);
    CHECK(shared == on_line(read_obj(folder / "east.obj"), 0, 320));
    CHECK(shared == on_line(read_obj(folder / "east.level1.obj"), 0, 320));
    REQUIRE(run(folder.path(), "terrain all.asc -o t.obj --tiles 1x2" + end).status == 0);
    CHECK(content_of(folder / "t_0_0.obj") == content_of(folder / "west.obj"));
    CHECK(content_of(folder / "t_0_1.obj") == content_of(folder / "east.obj"));
    CHECK(content_of(folder / "t_0_1.level1.obj") == content_of(folder / "east.level1.obj"));
  }
}

TEST_CASE("a window says how many samples it leaves to its neighbours") {
  const ScratchFolder folder;
  // Those at column 2, rows 1 and 3, are in cells with the samples east of them alone.
  folder.put("g.asc",
             "ncols 5\nnrows 4\nxllcenter 0\nyllcenter 0\ncellsize 1\nnodata_value -9\n"
             "1 2 -9 3 4\n2 -9 5 1 2\n3 -9 -9 2 2\n1 2 4 3 1\n");
  const std::string start =
      "terrain g.asc -o t.obj --force --max-error 1 --json - --window 0 0 3 4";
  const Outcome alone = run(folder.path(), start),
                beside = run(folder.path(), start + " --border-error 1");
  REQUIRE(alone.status == 0);
  REQUIRE(beside.status == 0);
  const std::size_t samples = Json::parse(alone.out)["samples"];
  const std::string warning = " samples on the border of the window are left to the windows beside";
  CHECK_FALSE(has(alone.err, warning));
  CHECK(has(beside.err, "warning: 2" + warning));
  CHECK(Json::parse(beside.out)["samples"] == samples - 2);
}

TEST_CASE("a window in tiles reads nothing else") {
  const ScratchFolder folder;
  folder.put("all.asc", asc_of(all));
  const Outcome made = run(folder.path(),
                           "terrain all.asc -o t.obj --max-error 5 --window 10 5 21 21 "
                           "--tiles 2x2 --tile-output mesh -q --json -");
  REQUIRE(made.status == 0);
  const ObjTin tin = read_obj(folder / "t.obj");
  folder.put("cut.asc", asc_of({10, 5, 21, 21}));
  const Found found = measured(tin, read_height_grid(folder / "cut.asc"));
  CHECK(found.error <= 5 + 1e-9);
  CHECK(found.outside == 0);
  CHECK(on_line(tin, 0, 200).size() >= 2);
  CHECK(on_line(tin, 0, 400).size() >= 2);
  for (const Place& v : tin.vertices) CHECK((v[0] >= 200 && v[0] <= 400));
  for (const std::string window : {"40 0 6 10", "0 21 45 10", "45 0 2 2"}) {
    const Outcome out =
        run(folder.path(), "terrain all.asc -o x.obj --max-error 5 -q --window " + window);
    CHECK(out.status == 2);
    CHECK(has(out.err, "is not inside its 45 x 30"));
  }
}

TEST_CASE("two grids cut apart agree on the line they share, whatever lies beside it") {
  const ScratchFolder folder;
  const auto cut = [&](const std::string& name, int first, int last, double slope) {
    std::ofstream out(folder / name);
    out << "ncols " << last - first + 1 << "\nnrows 30\nxllcenter " << 100 + 10 * first
        << "\nyllcenter 50\ncellsize 10\n";
    for (int row = 0; row < 30; ++row) {
      for (int c = first; c <= last; ++c) {
        const double beside = slope * std::abs(c - 20) * ((row * 7 + c * 3) % 5);
        out << std::round(100 * std::sin(0.3 * row) + beside) << ' ';
      }
      out << '\n';
    }
  };
  cut("west.asc", 0, 20, 4);
  cut("east.asc", 20, 45, 0.1);
  for (const std::string by : {"lepp", "greedy"}) {
    for (const std::string side : {"west", "east"}) {
      const Outcome made =
          run(folder.path(), "terrain " + side + ".asc -o " + side +
                                 ".obj --force --max-error 6 --border-error 6 -q --by " + by);
      CHECK(made.status == 0);
    }
    const auto shared = on_line(read_obj(folder / "west.obj"), 0, 300);
    CHECK(shared.size() > 8);
    CHECK(shared == on_line(read_obj(folder / "east.obj"), 0, 300));
  }
}

TEST_CASE("grids cut apart never overlap, whatever stands alone on the line they share") {
  const ScratchFolder folder;
  // On the shared line (x = 6): data on one side, on the other, on both, on none, and a chain.
  const std::vector<std::string> picture = {"777777......", "77777.555555", "......5.....",
                                            "............", "777...555555", "777...555555",
                                            "......5.....", "7.7.7.5.5.5.", "......555555",
                                            "777777755555", "777777755555", "......5....."};
  const auto cut = [&](const std::string& name, std::size_t first, std::size_t count) {
    std::ofstream out(folder / name);
    out << "ncols " << count << "\nnrows 12\nxllcenter " << first << "\nyllcenter 0\ncellsize 1\n";
    for (const std::string& row : picture) {
      for (const char c : row.substr(first, count)) {
        out << (c == '.' ? "-9999" : std::string(1, c)) << ' ';
      }
      out << '\n';
    }
  };
  cut("west.asc", 0, 7);
  cut("east.asc", 6, 6);
  cut("all.asc", 0, 12);
  const HeightGrid grid = read_height_grid(folder / "all.asc");
  for (const std::string by : {"lepp", "greedy"}) {
    ObjTin both;
    for (const std::string side : {"west", "east"}) {
      CAPTURE(side);
      const Outcome made = run(folder.path(), "terrain " + side + ".asc -o " + side +
                                                  ".obj --force --max-error 0 --border-error 0 "
                                                  "--allow-unfinished -q --by " +
                                                  by);
      CAPTURE(made.err);
      CHECK(made.status == 0);
      const ObjTin tin = read_obj(folder / (side + ".obj"));
      CHECK(measured(tin, read_height_grid(folder / (side + ".asc"))).outside == 0);
      for (const Place& v : tin.vertices) CHECK((side == "west" ? v[0] <= 6 : v[0] >= 6));
      for (const Place& v : on_line(tin, 0, 6)) CHECK(v[1] == std::floor(v[1]));  // at samples
      const std::size_t before = both.vertices.size();
      both.vertices.insert(both.vertices.end(), tin.vertices.begin(), tin.vertices.end());
      for (const auto& [a, b, c] : tin.triangles) {
        both.triangles.push_back({a + before, b + before, c + before});
      }
    }
    const Found found = measured(both, grid);
    CHECK(found.outside == 0);
    CHECK(found.covered == 0);
    CHECK(found.error < 1e-9);
  }
}
