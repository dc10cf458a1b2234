# SPDX-License-Identifier: MIT
# Run by every build: cmake -D GIT=... -D SOURCES=... -D HEADER=... -D PRINT_SOURCES=... -D ROOMS=... -P write_commit.cmake
# Only what becomes the programs makes them dirty: their rooms and build files, with new files among them, but no page to read.
set(BAKE_COMMIT "unknown")
set(BAKE_SOURCES "unknown")

# What decides the numbers of a run: one hash of what a compiler sees of the solver, whatever git knows of it.
execute_process(COMMAND ${PRINT_SOURCES} ${SOURCES}/solver OUTPUT_VARIABLE canonical RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${SOURCES}/solver: its sources cannot be read")
endif()
string(SHA256 BAKE_SOLVER "${canonical}")
string(SUBSTRING ${BAKE_SOLVER} 0 16 BAKE_SOLVER)

function(git result)
  execute_process(COMMAND ${GIT} --no-optional-locks -C ${SOURCES} ${ARGN} OUTPUT_VARIABLE output ERROR_QUIET RESULT_VARIABLE status
                  OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(status EQUAL 0)
    set(${result} "${output}" PARENT_SCOPE)
  else()
    set(${result} "unknown" PARENT_SCOPE)
  endif()
endfunction()

if(GIT)
  git(prefix rev-parse --show-prefix)
  if(prefix STREQUAL "")  # else unpacked inside some other repository: its commit says nothing of these sources
    git(BAKE_COMMIT rev-parse HEAD)
    git(changes status --porcelain -- ${ROOMS} CMakeLists.txt CMakePresets.json bake :!*.md)
    if(changes STREQUAL "")
      set(BAKE_SOURCES "clean")
    elseif(NOT changes STREQUAL "unknown")
      set(BAKE_SOURCES "dirty")
    endif()
  endif()
endif()

file(CONFIGURE OUTPUT ${HEADER} @ONLY CONTENT [[
// SPDX-License-Identifier: MIT
#pragma once
#define BAKE_COMMIT "@BAKE_COMMIT@"
#define BAKE_SOURCES "@BAKE_SOURCES@"
#define BAKE_SOLVER "@BAKE_SOLVER@"
]])
