# A kernel, src/<folder>/<noun>_kernel.cpp, is compiled once for each instruction set, as a file of its own; the best one is
# chosen when the program runs. Only these files may use more than the baseline of the architecture, and they cannot be
# compiled together with others.
file(GLOB kernels CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}/src" src/*/*_kernel.cpp)

function(linkwright_compile_kernels instruction_set lanes)
  foreach(kernel IN LISTS kernels)
    get_filename_component(name "${kernel}" NAME_WE)
    set(source "${PROJECT_BINARY_DIR}/generated/kernels/${name}_${instruction_set}.cpp")
    configure_file(cmake/kernel.cpp.in "${source}" @ONLY)
    set_source_files_properties("${source}" PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON COMPILE_OPTIONS "${ARGN}")
    target_sources(linkwright PRIVATE "${source}")
  endforeach()
endfunction()

linkwright_compile_kernels(baseline 2)
# In WebAssembly there is no other, and the page chooses none (src/core/kernels.hpp).
if(NOT EMSCRIPTEN)
  linkwright_compile_kernels(scalar 1)
endif()
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64|amd64")
  linkwright_compile_kernels(avx2 4 -mavx2 -mfma)
  linkwright_compile_kernels(avx512 8 -mavx512f -mavx512dq -mavx512bw -mavx512vl -mavx2 -mprefer-vector-width=512)
endif()
