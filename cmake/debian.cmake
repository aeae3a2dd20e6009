# cpack -G DEB in build/release: linkwright, liblinkwright-dev and, where OpenCASCADE and MPI are found, linkwright-step
# and linkwright-mpi.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME linkwright)
set(CPACK_PACKAGE_VENDOR Linkwright)
set(CPACK_PACKAGE_CONTACT "Linkwright contributors <nobody@linkwright.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
                                                WORLD_EXECUTE)

set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME linkwright)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "linkwright-step, linkwright-mpi, liblinkwright-dev, bash-completion")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
    "Linkwright finds all four-bar linkages that guide a body through three, four or
five positions, six-bars through four, spherical four-bars, generators of
functions and of straight lines. It classifies them in one diagram, the solution
region, and returns the ones that meet your requirements. With its workbench, a
page for the browser that `linkwright studio` serves on this machine only.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME liblinkwright-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libfmt-dev, libtbb-dev, zlib1g-dev, libpugixml-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
    "The library behind the program linkwright: headers that need only the standard
library, a static library, and its descriptions for CMake and pkg-config.")

if(TARGET linkwright_step)
  list(APPEND CPACK_COMPONENTS_ALL step)
  set(CPACK_DEBIAN_STEP_PACKAGE_NAME linkwright-step)
  set(CPACK_DEBIAN_STEP_PACKAGE_SECTION science)
  set(CPACK_DEBIAN_STEP_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_STEP_PACKAGE_DEPENDS "linkwright (= ${PROJECT_VERSION})")
  set(CPACK_COMPONENT_STEP_DESCRIPTION
      "The component of Linkwright that writes linkages as STEP assemblies for CAD, by
OpenCASCADE: linkwright export RESULT --format step.")
endif()

if(TARGET linkwright_mpi)
  list(APPEND CPACK_COMPONENTS_ALL mpi)
  set(CPACK_DEBIAN_MPI_PACKAGE_NAME linkwright-mpi)
  set(CPACK_DEBIAN_MPI_PACKAGE_SECTION science)
  set(CPACK_DEBIAN_MPI_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_MPI_PACKAGE_DEPENDS openmpi-bin)
  set(CPACK_DEBIAN_MPI_PACKAGE_SUGGESTS linkwright)
  set(CPACK_COMPONENT_MPI_DESCRIPTION
      "Sweeps of Linkwright on a cluster: mpirun linkwright-mpi sweep does what
linkwright sweep does, with many processes, by Open MPI.")
endif()

include(CPack)
