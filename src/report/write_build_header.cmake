cmake_minimum_required(VERSION 3.25)
# Writes HEADER with VERSION and the git commit of SOURCE_DIR; touches it only when it changes.
#   cmake -D SOURCE_DIR=... -D HEADER=... -D VERSION=... -P write_build_header.cmake
set(commit "unknown")
find_package(Git QUIET)
if(GIT_FOUND)
  execute_process(COMMAND ${GIT_EXECUTABLE} rev-parse HEAD WORKING_DIRECTORY ${SOURCE_DIR}
    OUTPUT_VARIABLE head OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(NOT failed)
    execute_process(COMMAND ${GIT_EXECUTABLE} status --porcelain WORKING_DIRECTORY ${SOURCE_DIR}
      OUTPUT_VARIABLE changes ERROR_QUIET)
    set(commit "${head}")
    if(changes)
      string(APPEND commit "+")
    endif()
  endif()
endif()
file(CONFIGURE OUTPUT ${HEADER} CONTENT
"#pragma once
#define VIEWCOVER_VERSION \"@VERSION@\"
#define VIEWCOVER_COMMIT \"@commit@\"
" @ONLY)
