# What `cmake --install` puts where: the program, its helpers, both libraries, the headers that
# users include, and what find_package() and pkg-config need. The installed tree may be moved.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

target_sources(lepp_core PUBLIC FILE_SET HEADERS
  BASE_DIRS ${CMAKE_CURRENT_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR}/generated FILES
  ${CMAKE_CURRENT_BINARY_DIR}/generated/lepp/version.hpp
  lepp/geometry/curve.hpp
  lepp/geometry/entities.hpp
  lepp/geometry/error.hpp
  lepp/geometry/growing_array.hpp
  lepp/geometry/ids.hpp
  lepp/geometry/memory_access.hpp
  lepp/geometry/point.hpp
  lepp/geometry/predicates.hpp
  lepp/geometry/pslg.hpp
  lepp/geometry/triangle_measures.hpp
  lepp/triangulation/constrained_delaunay.hpp
  lepp/triangulation/dual_graph.hpp
  lepp/triangulation/dual_graph_bgl.hpp  # the one that needs Boost; no other includes it
  lepp/triangulation/edge_records.hpp
  lepp/triangulation/edges_by_group.hpp
  lepp/triangulation/encroached.hpp
  lepp/triangulation/flip.hpp
  lepp/triangulation/lepp.hpp
  lepp/triangulation/locate.hpp
  lepp/triangulation/locator.hpp
  lepp/triangulation/mesh.hpp
  lepp/triangulation/mesh_fan.hpp
  lepp/triangulation/quality.hpp
  lepp/triangulation/remove_vertex.hpp
  lepp/triangulation/split.hpp
  lepp/triangulation/unfinished.hpp
  lepp/triangulation/validate.hpp
  lepp/refine/refine.hpp
  lepp/refine/size_field.hpp
  lepp/refine/steiner_point.hpp
  lepp/nonobtuse/nonobtuse.hpp
  lepp/bisection/forest.hpp
  lepp/bisection/polygon_area.hpp
  lepp/bisection/refine_where.hpp
  lepp/bisection/region.hpp
  lepp/bisection/remesh_transfer.hpp
  lepp/bisection/transfer.hpp
  lepp/bisection/transfer_matrix.hpp  # the one that needs Eigen; no other includes it
  lepp/bisection/vertices_made.hpp
  lepp/terrain/fit_heights.hpp
  lepp/terrain/grid_part.hpp
  lepp/terrain/height_grid.hpp
  lepp/terrain/heights.hpp
  lepp/terrain/join_tins.hpp
  lepp/terrain/nonobtuse_tin.hpp
  lepp/terrain/sample_set.hpp
  lepp/terrain/samples_inside.hpp
  lepp/terrain/simplify.hpp
  lepp/terrain/surface_report.hpp
  lepp/terrain/terrain_domain.hpp
  lepp/terrain/tile_border.hpp
  lepp/terrain/tin.hpp
  lepp/terrain/validate_surface.hpp
  lepp/terrain/world_tin.hpp
  lepp/voronoi/admissible.hpp
  lepp/voronoi/voronoi_boxes.hpp)
target_sources(lepp_io PUBLIC FILE_SET HEADERS
  BASE_DIRS ${CMAKE_CURRENT_SOURCE_DIR} FILES
  lepp/io/gdal_options.hpp
  lepp/io/geo.hpp
  lepp/io/gmsh_import.hpp
  lepp/io/grid_placement.hpp
  lepp/io/height_grid_read.hpp
  lepp/io/hillshade.hpp
  lepp/io/msh.hpp
  lepp/io/picture.hpp
  lepp/io/plot.hpp
  lepp/io/poly.hpp
  lepp/io/report.hpp
  lepp/io/terrain_lines.hpp
  lepp/io/terrain_report.hpp
  lepp/io/tin_files.hpp
  lepp/io/vtu.hpp)

# Shared libraries are found from where the program and the libraries themselves are.
file(RELATIVE_PATH lepp_bin_to_lib ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
set_target_properties(lepp_program PROPERTIES INSTALL_RPATH $ORIGIN/${lepp_bin_to_lib})
set_target_properties(lepp_io PROPERTIES INSTALL_RPATH $ORIGIN)

set(lepp_config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/lepp)
install(TARGETS lepp_program RUNTIME)  # each helper's folder installs its own
install(TARGETS lepp_core lepp_io EXPORT leppTargets FILE_SET HEADERS)
install(EXPORT leppTargets NAMESPACE lepp:: DESTINATION ${lepp_config_folder})

configure_package_config_file(cmake/leppConfig.cmake.in leppConfig.cmake
  INSTALL_DESTINATION ${lepp_config_folder} PATH_VARS CMAKE_INSTALL_LIBEXECDIR)
write_basic_package_version_file(leppConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/leppConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/leppConfigVersion.cmake DESTINATION ${lepp_config_folder})

file(RELATIVE_PATH lepp_pc_to_prefix
  ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" lepp_pc_to_prefix "${lepp_pc_to_prefix}")
foreach(package lepp lepp-io)
  configure_file(cmake/${package}.pc.in ${package}.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${package}.pc
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endforeach()
