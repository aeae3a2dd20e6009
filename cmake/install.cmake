# install and find_package(linkwright).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/linkwright")

install(TARGETS linkwright EXPORT linkwright_targets FILE_SET HEADERS)
if(TARGET linkwright_cli)
  install(TARGETS linkwright_cli)
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/build/web/" DESTINATION "${CMAKE_INSTALL_DATADIR}/linkwright/web" OPTIONAL)
endif()
if(TARGET linkwright_step)
  install(TARGETS linkwright_step LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}/linkwright")
endif()
install(EXPORT linkwright_targets FILE linkwrightTargets.cmake NAMESPACE linkwright:: DESTINATION "${package_dir}")

configure_package_config_file(cmake/linkwrightConfig.cmake.in "${PROJECT_BINARY_DIR}/linkwrightConfig.cmake"
                              INSTALL_DESTINATION "${package_dir}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/linkwrightConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/linkwrightConfig.cmake" "${PROJECT_BINARY_DIR}/linkwrightConfigVersion.cmake"
        DESTINATION "${package_dir}")
