# Builds the sources of a target a folder at a time: most of the time goes into reading headers, and so they are read once
# a folder. Names in unnamed namespaces are therefore unique within a folder. `per_unit`: how many sources go together at
# most. Sources with SKIP_UNITY_BUILD_INCLUSION stay by themselves.
option(LINKWRIGHT_UNITY_BUILD "Compile the sources of a folder together" ON)

function(linkwright_unity_build target per_unit)
  if(NOT LINKWRIGHT_UNITY_BUILD)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # g++ lets a large unit grow by 40 % only, and so would leave small functions uninlined that it inlines in a small one.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:--param=inline-unit-growth=200>)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  list(SORT sources)
  set(last_folder "")
  foreach(source IN LISTS sources)
    # The name of a unit is compiled into it: that of the checkout would hide it from the cache of another checkout.
    cmake_path(ABSOLUTE_PATH source OUTPUT_VARIABLE path)
    cmake_path(RELATIVE_PATH path BASE_DIRECTORY "${PROJECT_SOURCE_DIR}")
    cmake_path(GET path PARENT_PATH folder)
    if(NOT folder STREQUAL last_folder)
      set(last_folder "${folder}")
      set(unit 0)
      set(held 0)
    elseif(held EQUAL per_unit)
      math(EXPR unit "${unit} + 1")
      set(held 0)
    endif()
    math(EXPR held "${held} + 1")
    string(REPLACE "/" "_" group "${folder}_${unit}")
    set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${group}")
  endforeach()
endfunction()
