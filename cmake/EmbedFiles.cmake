# cmake -Dheader=FILE -Dnamespace=NAME "-Dfiles=name=path;..." -Doutput=X.cpp -P EmbedFiles.cmake
# Writes a source file with one function for each file, as the header declares them.

set(text "#include \"${header}\"\n\nnamespace ${namespace} {\n")
foreach(entry ${files})
  string(REGEX MATCH "^([^=]*)=(.*)$" all "${entry}")
  set(name ${CMAKE_MATCH_1})
  file(READ ${CMAKE_MATCH_2} hex HEX)
  string(REGEX REPLACE "(..)" "0x\\1," bytes "${hex}")
  string(APPEND text "\nstd::string_view ${name}() {\n  static const unsigned char bytes[] = {${bytes}};\n"
    "  return {reinterpret_cast<const char*>(bytes), sizeof bytes};\n}\n")
endforeach()
file(WRITE ${output} "${text}\n}  // namespace ${namespace}\n")
