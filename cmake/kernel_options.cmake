# A kernel exists once per instruction set, one file each; the best one is chosen when the program runs. Only these files
# may use more than the baseline of the architecture. They guard themselves by #if, so that they compile to nothing
# elsewhere.
file(GLOB kernel_sources RELATIVE "${PROJECT_SOURCE_DIR}" src/*/*kernel_scalar.cpp src/*/*kernel_baseline.cpp)
file(GLOB avx2_sources RELATIVE "${PROJECT_SOURCE_DIR}" src/*/*kernel_avx2.cpp)
file(GLOB avx512_sources RELATIVE "${PROJECT_SOURCE_DIR}" src/*/*kernel_avx512.cpp)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64|amd64")
  set_source_files_properties(${avx2_sources} PROPERTIES COMPILE_OPTIONS "-mavx2;-mfma")
  set_source_files_properties(
    ${avx512_sources} PROPERTIES COMPILE_OPTIONS
                                 "-mavx512f;-mavx512dq;-mavx512bw;-mavx512vl;-mavx2;-mprefer-vector-width=512")
endif()
# Nor can they be compiled together with others.
set_source_files_properties(${kernel_sources} ${avx2_sources} ${avx512_sources} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
