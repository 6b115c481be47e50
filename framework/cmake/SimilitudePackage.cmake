# What an installation gives to authors of plugins, beside the program and its models:
#   include/similitude/             the SDK; include/similitude/framework/ what fluid plugins may see of the framework
#   lib/cmake/similitude/           find_package(similitude) with similitude::sdk, similitude::framework and
#                                   similitude_add_plugin()
#   share/similitude/templates/     what `similitude plugins new` copies
# Test libraries are in none of it. All of it is the component `development`, the rest is `program` and `plugins`:
# SimilitudeDebian.cmake makes a package of each.
include(CMakePackageConfigHelpers)

set(SIMILITUDE_PACKAGE_DIRECTORY ${CMAKE_INSTALL_LIBDIR}/cmake/similitude)
set(framework_folder ${CMAKE_CURRENT_LIST_DIR}/..)
set(framework_headers ${CMAKE_INSTALL_INCLUDEDIR}/similitude/framework)

install(DIRECTORY ${framework_folder}/sdk/include/similitude DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development
  FILES_MATCHING PATTERN "*.h")
install(DIRECTORY ${framework_folder}/sdk/templates DESTINATION ${CMAKE_INSTALL_DATADIR}/similitude COMPONENT development
  PATTERN templates/README.md EXCLUDE)
install(DIRECTORY ${framework_folder}/fluid DESTINATION ${framework_headers} COMPONENT development FILES_MATCHING PATTERN "*.h")
install(FILES ${framework_folder}/scene/scene.h DESTINATION ${framework_headers}/scene COMPONENT development)   # a grid is made from a scene
target_include_directories(similitude INTERFACE $<INSTALL_INTERFACE:${framework_headers}>)

# Two sets, so that a header-only plugin needs no library of ours at all.
set_target_properties(similitude_sdk PROPERTIES EXPORT_NAME sdk)
set_target_properties(similitude PROPERTIES EXPORT_NAME framework)
install(TARGETS similitude_sdk EXPORT similitude_sdk)
install(TARGETS similitude EXPORT similitude_framework
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT program NAMELINK_COMPONENT development)
foreach(component sdk framework)
  install(EXPORT similitude_${component} NAMESPACE similitude:: FILE similitude-${component}-targets.cmake
    DESTINATION ${SIMILITUDE_PACKAGE_DIRECTORY} COMPONENT development)
endforeach()

# Sources of plugins for 1.x build with the headers of 1.y, y >= x.
write_basic_package_version_file(${CMAKE_BINARY_DIR}/similitude-config-version.cmake COMPATIBILITY SameMajorVersion)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/similitude-config.cmake.in ${CMAKE_BINARY_DIR}/similitude-config.cmake
  INSTALL_DESTINATION ${SIMILITUDE_PACKAGE_DIRECTORY} PATH_VARS CMAKE_INSTALL_BINDIR NO_SET_AND_CHECK_MACRO)
install(FILES
  ${CMAKE_BINARY_DIR}/similitude-config.cmake
  ${CMAKE_BINARY_DIR}/similitude-config-version.cmake
  ${CMAKE_CURRENT_LIST_DIR}/SimilitudeAddPlugin.cmake
  ${CMAKE_CURRENT_LIST_DIR}/similitude_plugin.map
  DESTINATION ${SIMILITUDE_PACKAGE_DIRECTORY} COMPONENT development)
