# What `cmake --install` puts where for programs that use the library. A component has the name of its Debian package.
include(CMakePackageConfigHelpers)
set(cmake_files ${CMAKE_INSTALL_LIBDIR}/cmake/Glissade)
set(made ${CMAKE_CURRENT_BINARY_DIR}/library)

install(TARGETS glissade_shared EXPORT GlissadeTargets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT libglissade0 NAMELINK_COMPONENT libglissade-dev)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/engine/api/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  COMPONENT libglissade-dev)
install(FILES ${CMAKE_BINARY_DIR}/generated/glissade/version.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/glissade
  COMPONENT libglissade-dev)

install(EXPORT GlissadeTargets NAMESPACE Glissade:: DESTINATION ${cmake_files} COMPONENT libglissade-dev)
configure_package_config_file(${CMAKE_CURRENT_SOURCE_DIR}/library/GlissadeConfig.cmake.in ${made}/GlissadeConfig.cmake
  INSTALL_DESTINATION ${cmake_files})
# Before version 1, a minor version may change the interface.
write_basic_package_version_file(${made}/GlissadeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${made}/GlissadeConfig.cmake ${made}/GlissadeConfigVersion.cmake DESTINATION ${cmake_files}
  COMPONENT libglissade-dev)

file(RELATIVE_PATH prefix_from_pkgconfig /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(library/glissade.pc.in ${made}/glissade.pc @ONLY)
install(FILES ${made}/glissade.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT libglissade-dev)

if(TARGET glissade_python)
  set(dist_packages lib/python3/dist-packages/glissade)
  set(python_sources ${CMAKE_SOURCE_DIR}/engine/python/glissade)
  install(TARGETS glissade_python LIBRARY DESTINATION ${dist_packages} COMPONENT python3-glissade)
  install(DIRECTORY ${python_sources}/ DESTINATION ${dist_packages} COMPONENT python3-glissade
    PATTERN __pycache__ EXCLUDE)
endif()

# What each Debian package has to have.
foreach(package libglissade0 libglissade-dev python3-glissade)
  install(FILES ${changes} DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${package})
  install(FILES ${CMAKE_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} RENAME copyright
    COMPONENT ${package})
endforeach()

# Pages of the public names; a name without a description is an error.
find_program(DOXYGEN doxygen)
if(DOXYGEN)
  set(api_pages ${CMAKE_BINARY_DIR}/api-pages)
  configure_file(library/Doxyfile.in ${made}/Doxyfile @ONLY)
  file(MAKE_DIRECTORY ${api_pages})
  add_custom_target(glissade_api_pages COMMAND ${DOXYGEN} ${made}/Doxyfile VERBATIM)
  install(DIRECTORY ${api_pages}/html DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libglissade-dev OPTIONAL
    COMPONENT libglissade-dev)
  if(GLISSADE_TESTS)
    add_test(NAME Installed.EveryPublicNameIsDescribed COMMAND ${DOXYGEN} ${made}/Doxyfile)
    set_tests_properties(Installed.EveryPublicNameIsDescribed PROPERTIES TIMEOUT 60)
  endif()
endif()
