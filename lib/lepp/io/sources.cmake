# lepp::io, files in and out. fmt and nlohmann-json are header-only here, so nothing is left to link.
add_library(lepp_io
  lepp/io/atomic_files.cpp
  lepp/io/boundary_loops.cpp
  lepp/io/classic_netcdf.cpp
  lepp/io/crs_wkt.cpp
  lepp/io/entity_table.cpp
  lepp/io/float_points.cpp
  lepp/io/gdal_process.cpp
  lepp/io/gdal_record.cpp
  lepp/io/geo.cpp
  lepp/io/geojson.cpp
  lepp/io/gmsh_chords.cpp
  lepp/io/gmsh_curve_fit.cpp
  lepp/io/gmsh_element_types.cpp
  lepp/io/gmsh_groups.cpp
  lepp/io/gmsh_import.cpp
  lepp/io/gmsh_mesh_cursor.cpp
  lepp/io/gmsh_mesh_entities.cpp
  lepp/io/gmsh_mesh_file.cpp
  lepp/io/gmsh_pieces.cpp
  lepp/io/gmsh_process.cpp
  lepp/io/gmsh_pslg.cpp
  lepp/io/gmsh_record.cpp
  lepp/io/gmsh_rules.cpp
  lepp/io/gmsh_script.cpp
  lepp/io/gmsh_soup.cpp
  lepp/io/gmsh_statements.cpp
  lepp/io/gmsh_tokens.cpp
  lepp/io/grid_asc.cpp
  lepp/io/grid_f32.cpp
  lepp/io/grid_file.cpp
  lepp/io/grid_npy.cpp
  lepp/io/grid_pgm.cpp
  lepp/io/grid_placement.cpp
  lepp/io/grid_stm.cpp
  lepp/io/header_words.cpp
  lepp/io/height_grid_read.cpp
  lepp/io/helper_process.cpp
  lepp/io/hillshade.cpp
  lepp/io/input_file.cpp
  lepp/io/line_reader.cpp
  lepp/io/loops.cpp
  lepp/io/msh.cpp
  lepp/io/msh_entities.cpp
  lepp/io/number_stream.cpp
  lepp/io/number_word.cpp
  lepp/io/picture.cpp
  lepp/io/places.cpp
  lepp/io/plot.cpp
  lepp/io/png.cpp
  lepp/io/poly_read.cpp
  lepp/io/poly_write.cpp
  lepp/io/raster_layout.cpp
  lepp/io/raster_samples.cpp
  lepp/io/record_archive.cpp
  lepp/io/report.cpp
  lepp/io/report_text.cpp
  lepp/io/sample_values.cpp
  lepp/io/selafin_write.cpp
  lepp/io/size_file.cpp
  lepp/io/svg_drawing.cpp
  lepp/io/terrain_lines.cpp
  lepp/io/terrain_report.cpp
  lepp/io/terrain_report_text.cpp
  lepp/io/text_file.cpp
  lepp/io/text_grid.cpp
  lepp/io/tin_solver_write.cpp
  lepp/io/tin_surface_write.cpp
  lepp/io/tin_write.cpp
  lepp/io/ugrid_write.cpp
  lepp/io/vtu.cpp)
add_library(lepp::io ALIAS lepp_io)
target_compile_features(lepp_io PUBLIC cxx_std_20)
target_include_directories(lepp_io PUBLIC
  $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}> $<INSTALL_INTERFACE:include>)
# $<BUILD_INTERFACE:> keeps the two out of the exported targets of a static build.
target_link_libraries(lepp_io PUBLIC lepp::core PRIVATE
  $<BUILD_INTERFACE:fmt::fmt-header-only> $<BUILD_INTERFACE:nlohmann_json::nlohmann_json>)
target_compile_options(lepp_io PRIVATE -ffp-contract=off)
set_target_properties(lepp_io PROPERTIES EXPORT_NAME io OUTPUT_NAME lepp_io
  VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} POSITION_INDEPENDENT_CODE ON)
