# Debian packages of what `cmake --install` gives, for Debian 12 on processors of x86-64-v3:
#   cmake --preset portable && cmake --build build-portable && (cd build-portable && cpack)
#     similitude_<version>_amd64.deb       the program, its library, its models, the cases that ship, the pages of docs/
#     similitude-dev_<version>_amd64.deb   the SDK: headers, templates, similitude_add_plugin(), examples
# What the files need of other packages is asked of dpkg-shlibdeps (dpkg-dev).
install(DIRECTORY ${PROJECT_SOURCE_DIR}/configs DESTINATION ${CMAKE_INSTALL_DATADIR}/similitude COMPONENT program)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples DESTINATION ${CMAKE_INSTALL_DATADIR}/similitude COMPONENT development
  PATTERN build EXCLUDE PATTERN results EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/ DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/similitude COMPONENT program
  PATTERN "*.py" EXCLUDE PATTERN __pycache__ EXCLUDE PATTERN docs/validation EXCLUDE PATTERN docs/verification EXCLUDE)   # what makes the pages
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/similitude RENAME copyright COMPONENT program)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/similitude-dev RENAME copyright
  COMPONENT development)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME similitude)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "The Similitude authors <similitude@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX ${CMAKE_INSTALL_PREFIX})
set(CPACK_COMPONENTS_ALL program plugins development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_STRIP_FILES ON)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME similitude)
set(CPACK_DEBIAN_RUNTIME_DESCRIPTION "Spouted and fluidised beds, simulated as they are or in the smaller or coarser bed\nthat a scaling law prescribes.")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS paraview)

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME similitude-dev)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "Headers, templates and CMake functions for plugins: drag laws, contact laws, gas solvers,\nscaling laws and effects are built with it outside Similitude's source.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "similitude (= ${PROJECT_VERSION}), g++ (>= 4:12) | clang (>= 1:14), cmake (>= 3.19), make | ninja-build")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS libgtest-dev)

include(CPack)
cpack_add_component_group(runtime)
cpack_add_component_group(development)
cpack_add_component(program GROUP runtime)
cpack_add_component(plugins GROUP runtime)
cpack_add_component(development GROUP development)
