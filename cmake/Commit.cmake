# Writes the commit of the sources into a header, if it has changed: cmake -DSOURCES=… -DHEADER=… -P Commit.cmake
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND git describe --always --dirty --abbrev=12 WORKING_DIRECTORY ${SOURCES}
  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
file(CONFIGURE OUTPUT ${HEADER} CONTENT "namespace gt {\nconstexpr const char* builtCommit = \"@commit@\";\n}\n" @ONLY)
