# SPDX-License-Identifier: MIT
# Run by every build: cmake -D GIT=... -D SOURCES=... -D HEADER=... -P write_commit.cmake
# Only what becomes the program makes it dirty: its sources and build files, with new files among them.
set(BAKE_COMMIT "unknown")
set(BAKE_SOURCES "unknown")

# What decides the numbers of a run: one hash of the solver's own files, whatever git knows of them.
file(GLOB_RECURSE files RELATIVE ${SOURCES}/solver ${SOURCES}/solver/*)
list(FILTER files EXCLUDE REGEX "^program/")
list(SORT files)
foreach(file ${files})
  file(SHA256 ${SOURCES}/solver/${file} hash)
  string(APPEND hashes "${file} ${hash}\n")
endforeach()
string(SHA256 BAKE_SOLVER "${hashes}")
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
    git(changes status --porcelain -- solver analysis experiments reference meshing cli CMakeLists.txt)
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
