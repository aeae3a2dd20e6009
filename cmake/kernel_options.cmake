# The region kernel exists once per instruction set, one file each; the best one is chosen when the program runs. Only
# these files may use more than the baseline of the architecture. They guard themselves by #if, so that they compile to
# nothing elsewhere.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64|amd64")
  set_source_files_properties(src/region/kernel_avx2.cpp PROPERTIES COMPILE_OPTIONS "-mavx2;-mfma")
  set_source_files_properties(
    src/region/kernel_avx512.cpp
    PROPERTIES COMPILE_OPTIONS "-mavx512f;-mavx512dq;-mavx512bw;-mavx512vl;-mavx2;-mprefer-vector-width=512")
endif()
# Nor can they share a precompiled header with the others.
file(GLOB kernel_sources RELATIVE "${PROJECT_SOURCE_DIR}" src/region/kernel_*.cpp)
set_source_files_properties(${kernel_sources} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
