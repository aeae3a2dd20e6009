# What the WebAssembly build does without or finds elsewhere. Emscripten searches its own system root only, and /usr/include
# as a whole would bring the host's C library along: the header-only libraries come through a folder of links.
set(linkwright_host_headers "${PROJECT_BINARY_DIR}/host_headers")
file(MAKE_DIRECTORY "${linkwright_host_headers}")
function(linkwright_link_headers header folder)
  find_path(found "${header}" PATHS /usr/include /usr/include/eigen3 /usr/local/include NO_DEFAULT_PATH
                                    NO_CMAKE_FIND_ROOT_PATH NO_CACHE REQUIRED)
  file(CREATE_LINK "${found}/${folder}" "${linkwright_host_headers}/${folder}" SYMBOLIC)
endfunction()
linkwright_link_headers(Eigen/SVD Eigen)
linkwright_link_headers(fmt/format.h fmt)
linkwright_link_headers(nlohmann/json.hpp nlohmann)

foreach(target IN ITEMS Eigen3::Eigen fmt::fmt nlohmann_json::nlohmann_json)
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${target} SYSTEM INTERFACE "${linkwright_host_headers}")
endforeach()
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)

# Exceptions are WebAssembly's own; the paths of this machine stay out of the module. Emscripten's clang 14 makes wrong
# code of six_bar_walk.cpp when it packs neighbouring statements into vectors (-fslp-vectorize); loops are not concerned.
add_compile_options(-msimd128 -fno-slp-vectorize -fwasm-exceptions "-ffile-prefix-map=${PROJECT_SOURCE_DIR}=."
                    "-ffile-prefix-map=${PROJECT_BINARY_DIR}=build")
add_link_options(-fwasm-exceptions)

# Pictures with a PNG inside need zlib; the page paints the region itself. STEP files are OpenCASCADE's.
set(linkwright_not_in_webassembly src/drawing/png_image.cpp src/drawing/region_picture.cpp src/drawing/region_figure.cpp
                                  src/machine/step_file.cpp)
# The page asks for each file by itself.
list(APPEND linkwright_not_in_webassembly src/machine/machine_export.cpp)
# Browsers read XML.
list(APPEND linkwright_not_in_webassembly src/files/outline/drawing_text.cpp)
# Sweeps are for programs that run for hours.
file(GLOB linkwright_sweep_sources RELATIVE "${PROJECT_SOURCE_DIR}" src/sweep/*.cpp)
list(APPEND linkwright_not_in_webassembly ${linkwright_sweep_sources})

# For its size: what is soon run, and a visit waits for all of it. Values that clang 14 takes for dead must not give their
# place on the stack to others: with -Os and -Oz it made wrong code of attitude_reply.cpp so.
set(linkwright_small -Oz "SHELL:-mllvm -no-stack-coloring")

# Sources of a target, in a folder and named like that, are compiled so.
function(linkwright_make_small target folder named)
  get_target_property(sources ${target} SOURCES)
  set(small ${sources})
  list(FILTER small INCLUDE REGEX "^src/${folder}/.*${named}\\.cpp$")
  list(REMOVE_ITEM sources ${small})
  set_target_properties(${target} PROPERTIES SOURCES "${sources}")
  add_library(${target}_${folder} OBJECT ${small})
  linkwright_target_options(${target}_${folder})
  target_compile_options(${target}_${folder} PRIVATE ${linkwright_small})
  foreach(property IN ITEMS INCLUDE_DIRECTORIES COMPILE_DEFINITIONS)
    set_target_properties(${target}_${folder} PROPERTIES ${property} "$<TARGET_PROPERTY:${target},${property}>")
  endforeach()
  target_link_libraries(${target}_${folder} PRIVATE fmt::fmt nlohmann_json::nlohmann_json)
  linkwright_unity_build(${target}_${folder} 12)
  target_sources(${target} PRIVATE $<TARGET_OBJECTS:${target}_${folder}>)
endfunction()
