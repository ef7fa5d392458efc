#include "terrain_arguments.hpp"

#include "validators.hpp"

namespace lepp::cli {

namespace {

void add_goals(CLI::App& app, TerrainCommand& command) {
  app.add_option(
         "--max-error", command.max_error,
         "largest difference from any sample, in the unit of heights, or of their range: 2%")
      ->check(height_or_percent());
  app.add_option("--max-vertices", command.max_vertices, "no more vertices than this")
      ->check(whole_number_from(3));
  app.add_option("--by", command.by,
                 "lepp: angles are bounded; greedy: fewest vertices (default lepp)")
      ->transform(
          choice_of<SimplifyBy>({{"lepp", SimplifyBy::lepp}, {"greedy", SimplifyBy::greedy}}));
  app.add_option("--min-angle", command.min_angle_deg,
                 "smallest angle wanted, by lepp (default 30)")
      ->check(number_from(0, 34));
  app.add_option("--effort", command.effort,
                 "fast, normal or best: time spent on fewer vertices, by lepp (default normal)")
      ->transform(choice_of<Effort>(
          {{"fast", Effort::fast}, {"normal", Effort::normal}, {"best", Effort::best}}));
  app.add_option("--metric", command.metric,
                 "planar: lengths and angles of the map; surface: those in space (default planar)")
      ->transform(choice_of<TerrainMetric>(
          {{"planar", TerrainMetric::planar}, {"surface", TerrainMetric::surface}}));
  app.add_option("--levels", command.level_errors,
                 "errors of coarser levels, descending: 10%,5% or 50,20; level i is written as "
                 "NAME.level<i>.EXT, the coarsest being 1")
      ->delimiter(',')
      ->check(height_or_percent());
  app.add_option("--level-vertices", command.level_vertices,
                 "numbers of vertices of coarser levels, ascending")
      ->delimiter(',')
      ->check(whole_number_from(3));
  app.add_flag(
      "--fit-heights", command.fit_heights,
      "Move the heights of vertices, within the bound, to where the root mean square of the "
      "error is least (not with --metric surface)");
  app.add_flag("--nonobtuse", command.nonobtuse,
               "leave no obtuse angle opposite an edge of the outline, so that the Voronoi boxes "
               "are admissible for finite volumes (by lepp in the planar metric, without "
               "--max-vertices, levels, --tiles and --border-error)");
}

void add_inputs(CLI::App& app, TerrainCommand& command) {
  app.add_option(
         "--cell", command.cell,
         "width and height of a cell; of a file with coordinates these stay, and lengths and "
         "angles go by the given cells")
      ->expected(2)
      ->check(number_above_zero());
  app.add_option("--nodata", command.nodata,
                 "value of the file, before scale and offset, that means no data");
  app.add_option(
         "--origin", command.origin,
         "X Y: subtracted from all coordinates that are written or reported, for cells that "
         "are small beside them")
      ->expected(2)
      ->check(finite_number());
  app.add_option("--clip", command.clip,
                 "polygons outside of which nothing is meshed: GeoJSON, or what GDAL reads; may be "
                 "given again");
  app.add_option("--breaklines", command.breaklines,
                 "lines kept as edges, with the heights of the file if it has any, else with those "
                 "of the grid; may be given again");
  app.add_option("--soft-breaklines", command.soft_breaklines,
                 "the same, always with the heights of the grid");
}

void add_tiles(CLI::App& app, TerrainCommand& command) {
  app.add_option("--window", command.window,
                 "COLUMN ROW WIDTH HEIGHT in samples, row 0 the first of the file: nothing else is "
                 "read and meshed")
      ->expected(4)
      ->check(whole_number_from(0));
  app.add_option(
         "--tiles", command.tiles,
         "ROWSxCOLUMNS: the raster is read and meshed piece by piece; tile (row, column) is "
         "written as NAME_<row>_<column>.EXT, row 0 the first of the file")
      ->check(rows_by_columns());
  app.add_option("--tile-output", command.tile_output,
                 "files: one per tile; mesh: all tiles joined in one; both (default files)")
      ->transform(choice_of<TileOutput>(
          {{"files", TileOutput::files}, {"mesh", TileOutput::mesh}, {"both", TileOutput::both}}));
  app.add_option("--border-error", command.border_error,
                 "vertices on the sides of the raster depend on nothing but the samples there and "
                 "this error, so that neighbours match (with --tiles: of each tile, default "
                 "--max-error; with --window: of the window)")
      ->check(height_or_percent());
}

void add_outputs(CLI::App& app, TerrainCommand& command) {
  app.add_option("--picture", command.picture, "hill-shaded picture, .svg or .png; one per level");
  app.add_option("--picture-width", command.picture_width, "its longest side")
      ->check(number_from(1, 20'000))
      ->capture_default_str();
  app.add_option("--json", command.json, "write the report as JSON to a file, or - for stdout");
  app.add_flag("--prefix-errors", command.prefix_errors,
               "the report has the largest error with the first n vertices for each n, by greedy "
               "(with --json)");
  app.add_option("--format", command.format,
                 "of .msh: msh41 (default) or msh22; of .slf: serafind (default) or serafin, of "
                 "single precision")
      ->check(CLI::IsMember({"msh41", "msh22", "serafind", "serafin"}));
  app.add_flag("--allow-unfinished", command.allow_unfinished,
               "write a valid TIN even if the goal was not reached (status 3)");
  app.add_flag("--force", command.output.force, "overwrite outputs");
  app.add_flag("-q,--quiet", command.quiet, "no report on the terminal");
}

}  // namespace

void add_terrain_arguments(CLI::App& app, TerrainCommand& command) {
  app.add_option("DEM", command.input,
                 ".asc, .stm, .pgm, .npy, .f32, or what GDAL reads: .tif, ...")
      ->required();
  app.add_option("-o,--output", command.output.target, tin_file_kinds())->required();
  add_goals(app, command);
  add_inputs(app, command);
  add_tiles(app, command);
  add_outputs(app, command);
  app.footer(
      "Examples:\n"
      "  lepp terrain dem.tif -o dem.ply --max-error 2\n"
      "  lepp terrain dem.asc -o fort.14 --max-error 1% --picture dem.png --json report.json\n"
      "  lepp terrain dem.stm -o dem.obj --cell 30 30 --max-error 5 --levels 100,30 --by greedy\n"
      "  lepp terrain dem.tif -o valley.nc --max-error 1 --clip valley.geojson --breaklines "
      "rivers.shp\n"
      "  lepp terrain catchment.asc -o catchment.msh --max-error 1 --nonobtuse\n"
      "  lepp terrain large.f32 -o large.2dm --max-error 2 --tiles 4x4");
}

}  // namespace lepp::cli
