# How a student's file is compiled and linked, by the judge and by the build alike.

# What is never set has a mark instead of what was in memory before, so that every compiler gives the same
# wrong answer; an index behind the end of a std::vector ends the program. A loop without end stays one,
# whatever the language allows.
get_target_property(eigen_folders Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
set(TUMBLE_STUDENT_FLAGS -std=c++20 -O1 -ffp-contract=off -fno-finite-loops -DEIGEN_DONT_VECTORIZE
  -ftrivial-auto-var-init=pattern -DEIGEN_INITIALIZE_MATRICES_BY_NAN -D_GLIBCXX_ASSERTIONS
  -Wall -Wextra -Wfloat-conversion -Wno-unused-parameter -Werror=return-type)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU") # clang stops after twenty by itself
  list(APPEND TUMBLE_STUDENT_FLAGS -fmax-errors=20)
endif()
foreach(folder IN LISTS eigen_folders)
  list(APPEND TUMBLE_STUDENT_FLAGS -isystem ${folder})
endforeach()

# How a worker is linked. On Linux it is one static file, a function that a student defines as well as
# the course counts once, and main is ours. Elsewhere earlier solutions come from an archive, which gives
# only what is undefined.
if(TUMBLE_PORTABLE_WORKER)
  set(TUMBLE_LINK_FLAGS)
  set(TUMBLE_LINK_CONFINED)
  set(TUMBLE_LINK_FIRST_COUNTS)
else()
  list(APPEND TUMBLE_STUDENT_FLAGS -fno-pie)
  set(TUMBLE_LINK_FLAGS -no-pie)
  set(TUMBLE_LINK_CONFINED -static)
  set(TUMBLE_LINK_FIRST_COUNTS -Wl,-z,muldefs)
endif()

# What the compiler is told besides, where a crash is to be located: line numbers, and checks in what it
# makes.
set(TUMBLE_SANITIZER_FLAGS -g1 -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)

# What every student's file includes anyway, compiled once; and once more with sanitizers, for a compiler
# takes such a header with the same flags only.
set(TUMBLE_STUDENT_HEADER ${PROJECT_BINARY_DIR}/student/precompiled.hpp)
set(TUMBLE_SANITIZED_HEADER ${PROJECT_BINARY_DIR}/student/sanitized.hpp)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(precompiled gch)
else()
  set(precompiled pch)
endif()
set(TUMBLE_STUDENT_PCH ${TUMBLE_STUDENT_HEADER}.${precompiled})
set(TUMBLE_SANITIZED_PCH ${TUMBLE_SANITIZED_HEADER}.${precompiled})

# The quickest linker that is there.
include(CheckLinkerFlag)
set(TUMBLE_STUDENT_LINKER)
foreach(linker IN ITEMS mold lld)
  check_linker_flag(CXX -fuse-ld=${linker} TUMBLE_LINKS_WITH_${linker})
  if(TUMBLE_LINKS_WITH_${linker} AND NOT TUMBLE_STUDENT_LINKER)
    set(TUMBLE_STUDENT_LINKER ${linker})
  endif()
endforeach()

# An object that is linked into workers, compiled as the student's file is. Workers are linked
# statically, which sanitizers cannot be. All share the precompiled header of the first. An object's path
# tells what it is: never merged with others.
function(tumble_student_object target source)
  add_library(${target} OBJECT ${source})
  set_target_properties(${target} PROPERTIES UNITY_BUILD OFF)
  target_compile_options(${target} PRIVATE ${TUMBLE_STUDENT_FLAGS} ${TUMBLE_UNSANITIZED})
  target_include_directories(${target} PRIVATE ${ARGN})
  get_property(first GLOBAL PROPERTY tumble_first_student_object)
  if(first)
    target_precompile_headers(${target} REUSE_FROM ${first})
  else()
    set_property(GLOBAL PROPERTY tumble_first_student_object ${target})
    target_precompile_headers(${target} PRIVATE ${PROJECT_SOURCE_DIR}/tests/judge/worker/serve.hpp)
  endif()
endfunction()

# The object files of such targets. With a precompiled header there are others: ours has `part` in its path.
function(tumble_object_files out part)
  list(TRANSFORM ARGN REPLACE "(.+)" "$<FILTER:$<TARGET_OBJECTS:\\1>,INCLUDE,${part}>")
  set(${out} "${ARGN}" PARENT_SCOPE)
endfunction()

# What calls a unit's function in the student's process.
function(tumble_add_worker target root chapter name)
  set(exercises ${root}/exercises/${chapter})
  string(REGEX REPLACE "^[0-9]+_" "" namespace ${chapter})
  set(worker ${CMAKE_CURRENT_BINARY_DIR}/workers/${chapter}/${name}.cpp)
  configure_file(${tumble_judge_folder}/worker/main.cpp.in ${worker} @ONLY)
  tumble_student_object(${target} ${worker} ${PROJECT_SOURCE_DIR}/tests ${exercises} ${root}/exercises)
endfunction()
