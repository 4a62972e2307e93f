# xabsl_header(target agents.xabsl HEADER path/Name.h [NAMESPACE robot::behavior]
#              [ENUMERATIONS name=Type ...] [REGISTERED name=Type ...] [INCLUDES header.h ...])
# Generates a C++ header with the symbols of a behavior (`xabsl header`) whenever they change, and lets the target include
# it by its path; the target <target>_symbols does only that. ENUMERATIONS names C++ types that stand for enumerations of
# the behavior, REGISTERED those whose elements the program registers itself, INCLUDES where they are declared.
function(xabsl_header target agents)
  cmake_parse_arguments(ARG "" "HEADER;NAMESPACE" "ENUMERATIONS;REGISTERED;INCLUDES" ${ARGN})
  get_filename_component(agents ${agents} ABSOLUTE)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/xabsl/${target})
  set(header ${folder}/${ARG_HEADER})
  set(options)
  if(ARG_NAMESPACE)
    list(APPEND options --namespace ${ARG_NAMESPACE})
  endif()
  foreach(enumeration ${ARG_ENUMERATIONS})
    list(APPEND options --enumeration ${enumeration})
  endforeach()
  foreach(enumeration ${ARG_REGISTERED})
    list(APPEND options --registered ${enumeration})
  endforeach()
  foreach(include ${ARG_INCLUDES})
    list(APPEND options --include ${include})
  endforeach()
  add_custom_command(OUTPUT ${header}
    COMMAND ${XABSL_PROGRAM} header ${agents} -o ${header} --depfile ${header}.d ${options}
    DEPENDS ${agents} ${XABSL_PROGRAM}
    DEPFILE ${header}.d
    COMMENT "Generating ${ARG_HEADER}"
    VERBATIM)
  add_custom_target(${target}_symbols DEPENDS ${header})
  target_sources(${target} PRIVATE ${header})
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${folder}>)
endfunction()
