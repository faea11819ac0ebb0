# tumble_program_options: what every program and test of the project is compiled with.
option(TUMBLE_WARNINGS_AS_ERRORS "Stop at the first warning" OFF)

add_library(tumble_program_options INTERFACE)
target_compile_options(tumble_program_options INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wnon-virtual-dtor
  -Wold-style-cast -Woverloaded-virtual
  $<$<BOOL:${TUMBLE_WARNINGS_AS_ERRORS}>:-Werror>)
# Where the files of a target are compiled as one, a local may have the name of another file's constant.
target_compile_options(tumble_program_options INTERFACE
  $<$<NOT:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>>:-Wshadow>)
# gcc sees uninitialised members where an Eigen quaternion or a std::variant is moved (its bug 105593; gcc 14
# still does), and gcc 12 an overlap where a literal is added in front of a temporary string (105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(tumble_program_options INTERFACE -Wno-maybe-uninitialized
    $<$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>:-Wno-restrict>)
endif()

# By default gcc 12 first looks for what it no longer needs when it has 130 MB, and again each time it has
# twice as much as was left: an eighth to a fourth of its time, where Eigen is. A student's laptop has
# memory for this much; on a large machine you can give it more.
set(TUMBLE_GCC_HEAP "" CACHE STRING "kB that gcc takes before it collects garbage; empty: 300000")
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(gcc_heap 300000)
  if(TUMBLE_GCC_HEAP)
    set(gcc_heap ${TUMBLE_GCC_HEAP})
  endif()
  target_compile_options(tumble_program_options INTERFACE --param=ggc-min-heapsize=${gcc_heap})
endif()

# For what cannot be linked with sanitizers, or is not worth their time; empty where there are none.
set(TUMBLE_UNSANITIZED)
# For what computes little: with sanitizers it costs more to compile than to run.
set(TUMBLE_COMPUTES_LITTLE)
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  set(TUMBLE_UNSANITIZED -fno-sanitize=all)
  set(TUMBLE_COMPUTES_LITTLE -O0)
endif()

# The same numbers to the last digit from every compiler: no fused multiply-add behind our back, no
# reordering of a sum by vector lanes.
target_compile_options(tumble_program_options INTERFACE -ffp-contract=off)
target_compile_definitions(tumble_program_options INTERFACE EIGEN_DONT_VECTORIZE)
