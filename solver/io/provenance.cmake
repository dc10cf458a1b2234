# SPDX-License-Identifier: MIT
# What provenance.cpp is told of the build, by two headers: bake_build.h, made here, and bake_commit.h, made anew by every
# build but changed only when the state of the sources has changed (then only provenance.cpp is compiled again).
set(generated ${CMAKE_BINARY_DIR}/generated)
string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
get_target_property(options bake_flags INTERFACE_COMPILE_OPTIONS)
list(JOIN options " " options)
string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}} ${BAKE_SOLVER_FLAGS} ${options}" BAKE_FLAGS)
string(REPLACE "\"" "\\\"" BAKE_FLAGS "${BAKE_FLAGS}")
configure_file(${CMAKE_CURRENT_LIST_DIR}/bake_build.h.in ${generated}/bake_build.h @ONLY)

# What the identity of the solver is the hash of, and whether two solvers are the same machine code (./bake restamp).
add_executable(bake_sources identity/canonical_source.cpp identity/print_sources.cpp)
target_link_libraries(bake_sources PRIVATE bake_flags)
add_executable(bake_same_code identity/same_code.cpp)
target_link_libraries(bake_same_code PRIVATE bake_flags)
set_target_properties(bake_same_code PROPERTIES OUTPUT_NAME bake-same-code RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR})

find_package(Git QUIET)
add_custom_target(bake_commit
  COMMAND ${CMAKE_COMMAND} -D GIT=${GIT_EXECUTABLE} -D SOURCES=${CMAKE_SOURCE_DIR} -D HEADER=${generated}/bake_commit.h
          -D PRINT_SOURCES=$<TARGET_FILE:bake_sources> "-DROOMS=${BAKE_ROOMS}"
          -P ${CMAKE_CURRENT_LIST_DIR}/write_commit.cmake
  DEPENDS bake_sources
  BYPRODUCTS ${generated}/bake_commit.h
  COMMENT "asking git for the state of the sources"
  VERBATIM)
add_dependencies(bake_io bake_commit)
target_include_directories(bake_io PRIVATE ${generated})
