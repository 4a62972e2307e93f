# Debian packages of what was built (make release): gt2003 with the programs and their data, gt2003-workbench, xabsl with compiler and
# library, python3-gt2003. What a package needs of others is read from its programs.
set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_COMPONENTS_ALL programs data workbench xabsl python)
set(CPACK_COMPONENT_PROGRAMS_GROUP gt2003)
set(CPACK_COMPONENT_DATA_GROUP gt2003)
set(CPACK_COMPONENT_WORKBENCH_GROUP workbench)
set(CPACK_COMPONENT_XABSL_GROUP xabsl)
set(CPACK_COMPONENT_PYTHON_GROUP python)

set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/packages)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PACKAGE_CONTACT "The GT2003 authors <gt2003@localhost>")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)

set(CPACK_DEBIAN_GT2003_PACKAGE_NAME gt2003)
set(CPACK_COMPONENT_GT2003_DESCRIPTION
  "robot soccer of the GermanTeam 2003: simulator and robots\n The complete robot-soccer system of the GermanTeam 2003: robots that see, find\n themselves, decide and walk, their simulator, logs, experiments and tournaments.")
set(CPACK_DEBIAN_GT2003_PACKAGE_RECOMMENDS "graphviz, xabsl")

set(same "gt2003 (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_WORKBENCH_PACKAGE_NAME gt2003-workbench)
set(CPACK_COMPONENT_WORKBENCH_DESCRIPTION
  "robot soccer of the GermanTeam 2003: workbench\n RobotControl shows what simulated and real robots, and logs, see, think and do,\n and changes it.")
set(CPACK_DEBIAN_WORKBENCH_PACKAGE_DEPENDS "${same}")

set(CPACK_DEBIAN_XABSL_PACKAGE_NAME xabsl)
set(CPACK_DEBIAN_XABSL_PACKAGE_SECTION devel)
set(CPACK_DEBIAN_XABSL_PACKAGE_RECOMMENDS "cmake, g++, graphviz, libxml2-dev")
set(CPACK_COMPONENT_XABSL_DESCRIPTION
  "behavior language of hierarchical state machines\n Compiler, language server, tests, documentation, and the engine as a library for\n C++20.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-gt2003)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_COMPONENT_PYTHON_DESCRIPTION
  "robot soccer of the GermanTeam 2003: Python package\n Matches, values, modules, logs, environments for learning, and tournaments from\n Python.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${same}, python3 (>= 3.11), python3 (<< 3.12), python3-numpy")
# What Python compiles when it is used goes with the package.
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/cmake/debian/postinst ${PROJECT_SOURCE_DIR}/cmake/debian/prerm)
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-pandas")

foreach(package gt2003:programs gt2003-workbench:workbench xabsl:xabsl python3-gt2003:python)
  string(REPLACE ":" ";" package ${package})
  list(GET package 0 name)
  list(GET package 1 component)
  install(FILES LICENSE RENAME copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT ${component} EXCLUDE_FROM_ALL)
  install(FILES CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT ${component} EXCLUDE_FROM_ALL)
endforeach()
if(TARGET gt2003_python_package)
  set(place lib/python3/dist-packages)
  install(TARGETS gt2003_python LIBRARY DESTINATION ${place}/gt2003 COMPONENT python EXCLUDE_FROM_ALL)
  install(DIRECTORY python/gt2003/ DESTINATION ${place}/gt2003 COMPONENT python EXCLUDE_FROM_ALL
    FILES_MATCHING PATTERN *.py PATTERN py.typed PATTERN __pycache__ EXCLUDE)
  install(DIRECTORY ${CMAKE_BINARY_DIR}/python/gt2003/ DESTINATION ${place}/gt2003 COMPONENT python EXCLUDE_FROM_ALL
    FILES_MATCHING PATTERN *.pyi PATTERN __pycache__ EXCLUDE)
  file(CREATE_LINK ../../../../share/gt2003 ${CMAKE_BINARY_DIR}/python/data SYMBOLIC)
  install(FILES ${CMAKE_BINARY_DIR}/python/data DESTINATION ${place}/gt2003 COMPONENT python EXCLUDE_FROM_ALL)
  file(WRITE ${CMAKE_BINARY_DIR}/python/program "#!/bin/sh\nexec python3 -m gt2003 \"$@\"\n")
  install(PROGRAMS ${CMAKE_BINARY_DIR}/python/program DESTINATION ${CMAKE_INSTALL_BINDIR} RENAME gt2003 COMPONENT python EXCLUDE_FROM_ALL)
endif()
include(CPack)
if(TARGET gt2003_python_package AND TARGET robotcontrol AND NOT GT_SANITIZE)
  add_test(NAME packages COMMAND ${PROJECT_SOURCE_DIR}/tests/installed/make-packages ${CMAKE_BINARY_DIR} ${CMAKE_CPACK_COMMAND})
endif()
