# What every target of the project is compiled with.
function(linkwright_target_options target)
  set_target_properties(${target} PROPERTIES CXX_STANDARD 20 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF)
  target_compile_options(
    ${target}
    PRIVATE -ffp-contract=off # same bits on every machine: no fused multiply-add behind our back
            -fno-math-errno # lets sqrt become one instruction; nobody reads errno
            -Wall
            -Wextra
            -Wpedantic
            # Sources that are compiled together see each other's constants.
            $<$<CXX_COMPILER_ID:GNU>:-Wshadow=local>
            -Wcast-align
            -Wnon-virtual-dtor
            -Woverloaded-virtual
            -Wmissing-declarations
            -Wfloat-conversion
            -Wno-missing-field-initializers # designated initializers name what they set
            # What g++ 12 finds where nothing is: in every string + literal (its bug 105651), in fmt's buffers under -O3.
            $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-array-bounds;-Wno-stringop-overflow;-Wno-stringop-overread>
            $<$<CXX_COMPILER_ID:Clang>:-Wno-bitwise-instead-of-logical> # masks of packs of one are bools
            # Other compilers find other things, which should keep nobody from building.
            $<$<AND:$<BOOL:${LINKWRIGHT_WERROR}>,$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Werror>)
endfunction()
