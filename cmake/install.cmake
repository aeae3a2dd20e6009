# install, find_package(linkwright), pkg-config, and the Debian packages that CPack makes: the component `program` is the
# package linkwright, `development` liblinkwright-dev, `step` linkwright-step, `mpi` linkwright-mpi.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/linkwright")
set(pkgconfig_dir "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
set(data_dir "${CMAKE_INSTALL_DATADIR}/linkwright")

# The library.

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)
install(TARGETS linkwright EXPORT linkwright_targets FILE_SET HEADERS)
install(EXPORT linkwright_targets FILE linkwrightTargets.cmake NAMESPACE linkwright:: DESTINATION "${package_dir}")

configure_package_config_file(cmake/linkwrightConfig.cmake.in "${PROJECT_BINARY_DIR}/linkwrightConfig.cmake"
                              INSTALL_DESTINATION "${package_dir}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/linkwrightConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/linkwrightConfig.cmake" "${PROJECT_BINARY_DIR}/linkwrightConfigVersion.cmake"
        DESTINATION "${package_dir}")

file(RELATIVE_PATH prefix_from_pkgconfig "/${pkgconfig_dir}" "/")
configure_file(cmake/linkwright.pc.in "${PROJECT_BINARY_DIR}/linkwright.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/linkwright.pc" DESTINATION "${pkgconfig_dir}")
install(FILES cmake/copyright DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/liblinkwright-dev")

# The program, its page, its manual.

if(NOT TARGET linkwright_cli)
  return()
endif()
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME program)
install(TARGETS linkwright_cli)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/build/web/" DESTINATION "${data_dir}/web" OPTIONAL)
install(DIRECTORY schema DESTINATION "${data_dir}")
install(DIRECTORY examples DESTINATION "${CMAKE_INSTALL_DOCDIR}")
install(FILES cmake/copyright CHANGELOG.md DESTINATION "${CMAKE_INSTALL_DOCDIR}")

# Manual pages and completion of a program, by the component that it is installed with.
find_package(Python3 COMPONENTS Interpreter)
add_custom_target(linkwright_manual ALL)
function(linkwright_manual_of target program component)
  if(NOT Python3_FOUND)
    return()
  endif()
  set(manual "${PROJECT_BINARY_DIR}/manual/${program}")
  add_custom_command(
    OUTPUT "${manual}/${program}"
    COMMAND "${Python3_EXECUTABLE}" "${PROJECT_SOURCE_DIR}/script/manual.py" "$<TARGET_FILE:${target}>" "${PROJECT_VERSION}"
            "${manual}"
    DEPENDS ${target} "${PROJECT_SOURCE_DIR}/script/manual.py"
    VERBATIM)
  add_custom_target(${target}_manual DEPENDS "${manual}/${program}")
  add_dependencies(linkwright_manual ${target}_manual)
  install(DIRECTORY "${manual}/man1" DESTINATION "${CMAKE_INSTALL_MANDIR}" COMPONENT ${component} OPTIONAL)
  install(FILES "${manual}/${program}" DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions"
          COMPONENT ${component} OPTIONAL)
endfunction()
linkwright_manual_of(linkwright_cli linkwright program)

if(TARGET linkwright_step)
  set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME step)
  install(TARGETS linkwright_step LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}/linkwright")
  install(FILES cmake/copyright DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/linkwright-step")
endif()

if(TARGET linkwright_mpi)
  set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME mpi)
  install(TARGETS linkwright_mpi)
  linkwright_manual_of(linkwright_mpi linkwright-mpi mpi)
  install(FILES cmake/copyright DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/linkwright-mpi")
endif()

include(cmake/debian.cmake)
