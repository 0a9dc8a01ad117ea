# SPDX-License-Identifier: GPL-2.0-or-later
# Sets LIGGGHTS_INCLUDE_DIR and LIGGGHTS_LIBRARY: the packaged ones, or those of a source tree with a shared library in it.
set(LIGGGHTS_SOURCE_DIR "" CACHE PATH "Source tree of a LIGGGHTS whose shared library is built; the packaged LIGGGHTS where it is empty")
if(NOT LIGGGHTS_SOURCE_DIR)
  find_path(LIGGGHTS_INCLUDE_DIR granular_pair_style.h PATH_SUFFIXES liggghts NO_PACKAGE_ROOT_PATH
            PATHS /usr/include/liggghts REQUIRED)
  find_library(LIGGGHTS_LIBRARY liggghts REQUIRED)
  return()
endif()

# Found anew for each tree, beside what an earlier one has left in the cache.
set(LIGGGHTS_INCLUDE_DIR ${LIGGGHTS_SOURCE_DIR}/src)
if(NOT EXISTS ${LIGGGHTS_INCLUDE_DIR}/granular_pair_style.h)
  message(FATAL_ERROR "LIGGGHTS_SOURCE_DIR: no src/granular_pair_style.h; expected the top folder of a source tree of "
                      "LIGGGHTS-PUBLIC 3.8 or a fork of it, got '${LIGGGHTS_SOURCE_DIR}'")
endif()
unset(LIGGGHTS_LIBRARY CACHE)
find_library(LIGGGHTS_LIBRARY liggghts NO_DEFAULT_PATH NO_CACHE
             PATHS ${LIGGGHTS_SOURCE_DIR}/build ${LIGGGHTS_SOURCE_DIR}/src ${LIGGGHTS_SOURCE_DIR}/src/build)
if(NOT LIGGGHTS_LIBRARY MATCHES "\\.so$")
  message(FATAL_ERROR "LIGGGHTS_SOURCE_DIR: no libliggghts.so in build/, src/ or src/build/ of '${LIGGGHTS_SOURCE_DIR}'; expected it to be "
                      "built, for example by\n"
                      "  cmake -S ${LIGGGHTS_SOURCE_DIR}/src -B ${LIGGGHTS_SOURCE_DIR}/build -DCMAKE_BUILD_TYPE=Release\n"
                      "  cmake --build ${LIGGGHTS_SOURCE_DIR}/build --target liggghts_shared\n"
                      "What recent compilers and CMake need for this stands in docs/platforms.md, 'A LIGGGHTS of your own'.")
endif()
