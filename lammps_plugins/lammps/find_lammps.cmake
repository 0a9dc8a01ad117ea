# SPDX-License-Identifier: GPL-2.0-or-later
# Sets LAMMPS_LIBRARY (a file, or the target of an installed LAMMPS), LAMMPS_HEADERS and LAMMPS_SIZES (how wide its integers
# are), and `lammps_missing` to what is missing. Pair styles with history need headers that an installed LAMMPS has or lacks,
# Debian's lacks them: they come from a source tree of the same version.
set(LAMMPS_SOURCE_DIR "" CACHE PATH "Source tree of LAMMPS, of the version of LAMMPS_LIBRARY; that of scripts/setup where it is empty")
set(lammps_missing "")
set(LAMMPS_SIZES LAMMPS_SMALLBIG)  # as Debian has built it
set(lammps_source ${LAMMPS_SOURCE_DIR})
if(NOT lammps_source)
  set(lammps_source ${CMAKE_BINARY_DIR}/lammps_source)
endif()
set(LAMMPS_HEADERS ${lammps_source}/src)
if(LAMMPS_DIR)
  # The one that the user names.
  find_package(LAMMPS REQUIRED CONFIG)
  set(LAMMPS_LIBRARY LAMMPS::lammps)
  get_target_property(LAMMPS_SIZES LAMMPS::lammps INTERFACE_COMPILE_DEFINITIONS)
  if(NOT LAMMPS_SIZES)
    set(LAMMPS_SIZES "")
  endif()
  get_target_property(installed LAMMPS::lammps INTERFACE_INCLUDE_DIRECTORIES)
  foreach(folder ${installed} ${installed}/lammps)
    if(NOT LAMMPS_SOURCE_DIR AND EXISTS ${folder}/fix_neigh_history.h)
      set(LAMMPS_HEADERS ${folder})
    endif()
  endforeach()
else()
  find_library(LAMMPS_LIBRARY lammps)
endif()
if(NOT LAMMPS_LIBRARY)
  set(lammps_missing "liblammps-dev is not installed")
elseif(NOT EXISTS ${LAMMPS_HEADERS}/fix_neigh_history.h)
  set(lammps_missing "no fix_neigh_history.h in ${LAMMPS_HEADERS} (scripts/setup fetches the tree of the packaged LAMMPS; for another one -DLAMMPS_SOURCE_DIR=)")
endif()
