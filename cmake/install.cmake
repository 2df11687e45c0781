# What `cmake --install` puts where, and what find_package(Supple) finds there.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# The library of packages: the objects of the archive in a shared library that binds its own functions. A program
# has inline functions of the same headers, compiled with flags of its own; in an archive the linker would take one
# of the two for both, and results would depend on the program's flags.
file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/shared.cpp CONTENT "// Its objects are those of the archive.\n")
add_library(supple_shared SHARED ${CMAKE_BINARY_DIR}/shared.cpp)
set_target_properties(supple_shared PROPERTIES
  OUTPUT_NAME supple EXPORT_NAME supple VERSION ${PROJECT_VERSION}
  SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
  LINK_DEPENDS ${CMAKE_SOURCE_DIR}/cmake/exported.map)
target_compile_features(supple_shared INTERFACE cxx_std_20)
target_include_directories(supple_shared INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_link_libraries(supple_shared PRIVATE $<LINK_LIBRARY:WHOLE_ARCHIVE,supple_lib> INTERFACE fmt::fmt)
target_link_options(supple_shared PRIVATE
  -Wl,-Bsymbolic-functions -Wl,--version-script=${CMAKE_SOURCE_DIR}/cmake/exported.map)

install(TARGETS supple_shared EXPORT SuppleTargets)
if(TARGET supple)
  install(TARGETS supple)
endif()

# Not the headers that show what files are written and read with, nor how registers are used.
install(DIRECTORY ${CMAKE_SOURCE_DIR}/src/supple TYPE INCLUDE FILES_MATCHING PATTERN "*.hpp"
  PATTERN hdf5_calls.hpp EXCLUDE PATTERN case_reader.hpp EXCLUDE PATTERN json_node.hpp EXCLUDE
  PATTERN held_keys_json.hpp EXCLUDE PATTERN packing_layout.hpp EXCLUDE PATTERN lane_vectors.hpp EXCLUDE
  PATTERN block.hpp EXCLUDE PATTERN block_rows.hpp EXCLUDE PATTERN block_factorisation.hpp EXCLUDE PATTERN pivot.hpp EXCLUDE)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/examples DESTINATION ${CMAKE_INSTALL_DATADIR}/supple)
install(FILES LICENSE CITATION.cff README.md CHANGELOG.md TYPE DOC)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Supple)
install(EXPORT SuppleTargets NAMESPACE Supple:: DESTINATION ${package_folder})
configure_package_config_file(${CMAKE_SOURCE_DIR}/cmake/SuppleConfig.cmake.in
  ${CMAKE_BINARY_DIR}/SuppleConfig.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/SuppleConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/SuppleConfig.cmake ${CMAKE_BINARY_DIR}/SuppleConfigVersion.cmake
  DESTINATION ${package_folder})
install(CODE "message(STATUS \"Supple for processors: ${SUPPLE_ARCH}\")")
