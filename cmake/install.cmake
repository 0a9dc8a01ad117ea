# SPDX-License-Identifier: GPL-2.0-or-later
# What `cmake --install build --prefix PREFIX` puts where, and the package that `cpack` makes of it.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# Programs, and the plug-in that lmp-disc and other LAMMPS load.
set(programs mikromakro)
foreach(program liggghts-disc lmp-disc)
  if(TARGET ${program})
    list(APPEND programs ${program})
  endif()
endforeach()
set_target_properties(${programs} PROPERTIES INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}" INSTALL_RPATH_USE_LINK_PATH ON)
install(TARGETS ${programs} RUNTIME)
if(TARGET mikromakro_lammps)
  set_target_properties(mikromakro_lammps PROPERTIES INSTALL_RPATH_USE_LINK_PATH ON)
  install(TARGETS mikromakro_lammps LIBRARY NAMELINK_SKIP)
endif()

# The library, its headers, the contact laws, and their CMake package. Headers are included as in the tree: "io/frames/frame_stream.h".
set(headers ${CMAKE_INSTALL_INCLUDEDIR}/mikromakro)
set_target_properties(mikromakro_postproc PROPERTIES EXPORT_NAME postproc)
set_target_properties(mikromakro_physics PROPERTIES EXPORT_NAME physics)
target_include_directories(mikromakro_postproc INTERFACE $<INSTALL_INTERFACE:${headers}>)
target_include_directories(mikromakro_physics INTERFACE $<INSTALL_INTERFACE:${headers}>)
install(TARGETS mikromakro_postproc mikromakro_physics EXPORT mikromakro-targets ARCHIVE)
foreach(room model statistics joining fields io averaging fit audit drawing report)
  install(DIRECTORY postproc/${room} DESTINATION ${headers} FILES_MATCHING PATTERN "*.h" PATTERN hdf5_calls.h EXCLUDE)
endforeach()
install(DIRECTORY lammps_plugins/physics DESTINATION ${headers} FILES_MATCHING PATTERN "*.h")
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/mikromakro)
install(EXPORT mikromakro-targets NAMESPACE mikromakro:: DESTINATION ${package})
configure_package_config_file(cmake/mikromakro-config.cmake.in ${CMAKE_BINARY_DIR}/mikromakro-config.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/mikromakro-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/mikromakro-config.cmake ${CMAKE_BINARY_DIR}/mikromakro-config-version.cmake DESTINATION ${package})

# Man pages and completion, from the options themselves.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(pages ${CMAKE_BINARY_DIR}/man/mikromakro.1)
set(completion ${CMAKE_BINARY_DIR}/completions/mikromakro)
add_custom_command(OUTPUT ${pages} ${completion}
  COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/cmake/describe_options.py $<TARGET_FILE:mikromakro> ${CMAKE_BINARY_DIR}
  DEPENDS mikromakro ${CMAKE_CURRENT_SOURCE_DIR}/cmake/describe_options.py VERBATIM)
add_custom_target(option_pages ALL DEPENDS ${pages} ${completion})
install(DIRECTORY ${CMAKE_BINARY_DIR}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 FILES_MATCHING PATTERN "*.1")
install(FILES ${completion} DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)

# The Python module, where the Python of Debian looks: below /usr/local in the folder of its version.
if(TARGET mikromakro_python)
  install(CODE "set(python_folder python3)
    if(CMAKE_INSTALL_PREFIX STREQUAL \"/usr/local\")
      set(python_folder python${MIKROMAKRO_PYTHON_VERSION})
    endif()")
  set(dist_packages "lib/\${python_folder}/dist-packages")
  install(TARGETS mikromakro_python LIBRARY DESTINATION ${dist_packages}/mikromakro)
  install(DIRECTORY ${CMAKE_BINARY_DIR}/python/mikromakro DESTINATION ${dist_packages} FILES_MATCHING PATTERN "*.py" PATTERN "*.pyi" PATTERN py.typed
    PATTERN __pycache__ EXCLUDE)
endif()

# Scenes, sweeps over them, and the scripts that report on them.
install(DIRECTORY inputs DESTINATION ${CMAKE_INSTALL_DATADIR}/mikromakro)
set(scripts ${CMAKE_INSTALL_DATADIR}/mikromakro/scripts)
install(PROGRAMS scripts/sweep scripts/couette_report scripts/biaxial_report scripts/compare_rings DESTINATION ${scripts})
install(FILES scripts/appearance.py scripts/student_t.py DESTINATION ${scripts})
install(DIRECTORY scripts/sweeping DESTINATION ${scripts} FILES_MATCHING PATTERN "*.py")
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} FILES_MATCHING PATTERN "*.md" PATTERN "*.bib" REGEX "/examples/[a-z_]*\\.py$")
install(FILES README.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME mikromakro)
set(CPACK_PACKAGE_CONTACT "The mikromakro developers")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_BINARY_DIR}/lib)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "python3-matplotlib, python3-pandas, python3-xarray, python3-h5py")
if(TARGET mikromakro_python)
  string(REPLACE "3." "" minor ${MIKROMAKRO_PYTHON_VERSION})
  math(EXPR next "${minor} + 1")
  set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3 (>= 3.${minor}), python3 (<< 3.${next}~), python3-numpy")
endif()
include(CPack)
