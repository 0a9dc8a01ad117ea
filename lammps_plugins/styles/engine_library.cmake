# SPDX-License-Identifier: GPL-2.0-or-later
# engine_library(NAME STATIC|SHARED SOURCE...): a library of the styles for one engine, of which the caller's folder holds
# dialect.h and the sources that it has for itself. A library, so that tests can hold an engine of their own in the process.
configure_file(${CMAKE_CURRENT_LIST_DIR}/version.h.in ${CMAKE_CURRENT_BINARY_DIR}/generated/mikromakro_version.h @ONLY)
set(styles_folder ${CMAKE_CURRENT_LIST_DIR})
set(styles_generated ${CMAKE_CURRENT_BINARY_DIR}/generated)

function(engine_library name kind)
  file(GLOB_RECURSE shared CONFIGURE_DEPENDS ${styles_folder}/*.cpp)
  list(REMOVE_ITEM shared ${styles_folder}/program/launcher.cpp)
  add_library(${name} ${kind} ${shared} ${ARGN})
  # Loops over discs and pairs: vectorised only without errno and floating-point traps, which nothing reads.
  set(loops motion/fix_nve_disc.cpp motion/fix_nve_disc_open.cpp law/packed_discs.cpp law/pair_lists.cpp law/pair_loop.cpp
            law/skin_budget.cpp)
  list(TRANSFORM loops PREPEND ${styles_folder}/)
  set_source_files_properties(${loops} PROPERTIES COMPILE_OPTIONS
                              "-fno-math-errno;-fno-trapping-math;-ffp-contract=off;-Wno-psabi")
  # Error lines name the source file, not the machine it was built on.
  target_compile_options(${name} PRIVATE "-fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=")
  target_include_directories(${name} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR} ${styles_folder} ${styles_generated})
  target_link_libraries(${name} PUBLIC mikromakro_physics mikromakro_options MPI::MPI_CXX ${CMAKE_DL_LIBS})
endfunction()
