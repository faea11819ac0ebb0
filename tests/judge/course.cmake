# A course: chapters of units under exercises/, solutions/ and tests/. The one place that lists an
# exercise is its heading in a contract, `// == 4.1 product: what it is`. From there everything follows:
#   exercises/04_quaternions/product.cpp   the stub            tests/04_quaternions/product.cpp   the spec
#   solutions/04_quaternions/product.cpp   the answer          <build>/workers/…   who asks the student's code

set(tumble_judge_folder ${CMAKE_CURRENT_LIST_DIR})

# What a student's file is compiled with, by the judge and by the build alike. What is never set has a
# mark instead of what was in memory before, so that every compiler gives the same wrong answer; an index
# behind the end of a std::vector ends the program. A loop without end stays one, whatever the language allows.
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

# A list as the elements of a JSON array.
function(tumble_json_list out)
  list(TRANSFORM ARGN REPLACE "(.+)" "\"\\1\"")
  list(JOIN ARGN ", " joined)
  set(${out} "${joined}" PARENT_SCOPE)
endfunction()

# What every student's file includes anyway, compiled once.
set(TUMBLE_STUDENT_HEADER ${PROJECT_BINARY_DIR}/student/precompiled.hpp)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(TUMBLE_STUDENT_PCH ${TUMBLE_STUDENT_HEADER}.gch)
else()
  set(TUMBLE_STUDENT_PCH ${TUMBLE_STUDENT_HEADER}.pch)
endif()

# The quickest linker that is there.
include(CheckLinkerFlag)
set(TUMBLE_STUDENT_LINKER)
foreach(linker IN ITEMS mold lld)
  check_linker_flag(CXX -fuse-ld=${linker} TUMBLE_LINKS_WITH_${linker})
  if(TUMBLE_LINKS_WITH_${linker} AND NOT TUMBLE_STUDENT_LINKER)
    set(TUMBLE_STUDENT_LINKER ${linker})
  endif()
endforeach()

include(${CMAKE_CURRENT_LIST_DIR}/units.cmake)

function(tumble_require_file file what)
  if(NOT EXISTS ${file})
    message(FATAL_ERROR "${what} is missing: ${file}")
  endif()
endfunction()

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

# What calls a unit's function in the student's process.
function(tumble_add_worker target root chapter name)
  set(exercises ${root}/exercises/${chapter})
  string(REGEX REPLACE "^[0-9]+_" "" namespace ${chapter})
  set(worker ${CMAKE_CURRENT_BINARY_DIR}/workers/${chapter}/${name}.cpp)
  file(CONFIGURE OUTPUT ${worker} CONTENT [[
#include "judge/worker/serve.hpp"
#include "contract.hpp"

int main() { return tumble::judge::serve(@namespace@::@name@); }
]] @ONLY)
  tumble_student_object(${target} ${worker} ${PROJECT_SOURCE_DIR}/tests ${exercises} ${root}/exercises)
endfunction()

# The same check for those who live in an IDE: a target check.04.product, and a ctest with the labels
# exercise and ch04. Presets leave these out: a stub that nobody has filled in is no defect.
function(tumble_add_check target chapter name number)
  if(NOT target STREQUAL "tumble_judge")
    return()
  endif()
  string(SUBSTRING ${chapter} 0 2 digits)
  add_custom_target(check.${digits}.${name} COMMAND ${target} check ${number} USES_TERMINAL COMMENT "")
  add_dependencies(check.${digits}.${name} spec.${chapter}.${name})
  add_test(NAME exercise/${chapter}/${name} COMMAND ${target} check ${number})
  set_tests_properties(exercise/${chapter}/${name} PROPERTIES LABELS "exercise;ch${digits}")
endfunction()

# What every spec includes anyway, compiled once for all of them.
function(tumble_add_spec_headers)
  if(TARGET tumble_spec_headers)
    return()
  endif()
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/spec_headers.cpp CONTENT "")
  add_library(tumble_spec_headers OBJECT ${CMAKE_CURRENT_BINARY_DIR}/spec_headers.cpp)
  set_target_properties(tumble_spec_headers PROPERTIES POSITION_INDEPENDENT_CODE ON UNITY_BUILD OFF)
  target_include_directories(tumble_spec_headers PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_options(tumble_spec_headers PRIVATE $<$<CONFIG:Release>:-O1>)
  target_link_libraries(tumble_spec_headers PRIVATE tumble_support doctest::doctest nlohmann_json::nlohmann_json)
  target_precompile_headers(tumble_spec_headers PRIVATE
    ${tumble_judge_folder}/protocol/eigen_assertions.hpp ${tumble_judge_folder}/spec/spec.hpp <Eigen/LU>)
endfunction()

# A spec and its judge share objects: a spec that older headers have laid out otherwise would end the judge.
function(tumble_add_header_mark)
  if(TARGET tumble_mark_of_spec)
    return()
  endif()
  file(GLOB headers CONFIGURE_DEPENDS ${tumble_judge_folder}/spec/*.hpp ${tumble_judge_folder}/protocol/*.hpp
    ${PROJECT_SOURCE_DIR}/lib/support/random.hpp)
  set(script ${tumble_judge_folder}/spec/header_mark.cmake)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/header_mark)
  add_custom_command(OUTPUT ${folder}/mark_of_judge.cpp ${folder}/mark_of_spec.cpp
    COMMAND ${CMAKE_COMMAND} "-DHEADERS=${headers}" -DFOLDER=${folder} -P ${script}
    DEPENDS ${headers} ${script} VERBATIM)
  foreach(side IN ITEMS judge spec)
    add_library(tumble_mark_of_${side} OBJECT ${folder}/mark_of_${side}.cpp)
    set_target_properties(tumble_mark_of_${side} PROPERTIES POSITION_INDEPENDENT_CODE ON UNITY_BUILD OFF)
  endforeach()
  add_dependencies(tumble_mark_of_spec tumble_mark_of_judge) # one of them has both files written
endfunction()

# The spec of a unit: a module that the judge loads when it is asked for that unit.
function(tumble_add_spec target judge unit spec)
  tumble_add_spec_headers()
  add_library(${target} MODULE ${spec} $<TARGET_OBJECTS:tumble_mark_of_spec>)
  set_target_properties(${target} PROPERTIES PREFIX "" UNITY_BUILD OFF)
  target_compile_definitions(${target} PRIVATE TUMBLE_UNIT="${unit}")
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/tests ${ARGN})
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  target_link_libraries(${target} PRIVATE ${judge} tumble_support doctest::doctest nlohmann_json::nlohmann_json)
  target_precompile_headers(${target} REUSE_FROM tumble_spec_headers)
  if(CMAKE_DISABLE_PRECOMPILE_HEADERS) # they begin with it
    target_link_libraries(${target} PRIVATE tumble_eigen_throws)
  endif()
endfunction()

# Writes ${target}.json, which tells the judge what there is.
function(tumble_write_course target root engine die json)
  tumble_json_list(flags ${TUMBLE_STUDENT_FLAGS})
  tumble_json_list(link ${TUMBLE_LINK_FLAGS})
  tumble_json_list(link_confined ${TUMBLE_LINK_CONFINED})
  tumble_json_list(link_first_counts ${TUMBLE_LINK_FIRST_COUNTS})
  file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${target}.json CONTENT
"{
  \"root\": \"${root}\",
  \"state\": \"${CMAKE_CURRENT_BINARY_DIR}/${target}.state\",
  \"compiler\": \"${CMAKE_CXX_COMPILER}\", \"compiler_id\": \"${CMAKE_CXX_COMPILER_ID}\",
  \"flags\": [${flags}],
  \"precompiled\": \"${TUMBLE_STUDENT_PCH}\",
  \"linker\": \"${TUMBLE_STUDENT_LINKER}\",
  \"link\": [${link}], \"link_confined\": [${link_confined}], \"link_first_counts\": [${link_first_counts}],
  \"engine\": \"${engine}\", \"die\": \"${die}\",
  \"mine\": \"$<TARGET_FILE:tumble_judge_mine>\",
  \"runtime\": \"$<TARGET_FILE:tumble_worker>\",
  \"units\": [${json}
  ]
}
")
endfunction()

# Adds `target`, the judge of the course under `root`, and for each unit a target that builds all that
# judging it needs: spec.04_quaternions.product (with a prefix, if one is given). all_specs builds all of
# them. Writes ${target}.json, which tells the judge what there is.
function(tumble_add_judge target root)
  set(prefix ${ARGN})
  set(course_file ${CMAKE_CURRENT_BINARY_DIR}/${target}_course_file.cpp) # a path, in a file of its own
  set(course_json ${CMAKE_CURRENT_BINARY_DIR}/${target}.json)
  file(CONFIGURE OUTPUT ${course_file} CONTENT [[
#include "judge/commands/course_file.hpp"

const char* const tumble::judge::course_file = "@course_json@";
]] @ONLY)
  tumble_add_header_mark()
  add_executable(${target} ${tumble_judge_folder}/commands/main.cpp ${tumble_judge_folder}/spec/doctest.cpp
    ${course_file} $<TARGET_OBJECTS:tumble_mark_of_judge>)
  set_target_properties(${target} PROPERTIES UNITY_BUILD OFF ENABLE_EXPORTS ON) # specs use what it has
  target_link_libraries(${target} PRIVATE tumble_judge_core tumble_judge_commands)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  add_custom_target(${prefix}all_specs)
  add_dependencies(${prefix}all_specs grading_tools) # who grades a class has archives

  set(json)
  set(earlier)
  set(earlier_objects)
  set(whole TRUE)
  file(GLOB contracts ${root}/exercises/[0-9]*/contract.hpp)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${root}/exercises)
  list(SORT contracts)
  foreach(contract IN LISTS contracts)
    cmake_path(GET contract PARENT_PATH exercises)
    cmake_path(GET exercises FILENAME chapter)
    if(NOT EXISTS ${root}/tests/${chapter})
      set(whole FALSE)
      continue() # a hand-out has this contract only because others speak of its types
    endif()
    tumble_units_of(${contract} units)
    foreach(unit IN LISTS units)
      string(REGEX REPLACE " .*" "" number "${unit}")
      string(REGEX REPLACE ".* " "" name "${unit}")
      set(spec ${root}/tests/${chapter}/${name}.cpp)
      set(solution ${root}/solutions/${chapter}/${name}.cpp)
      tumble_require_file(${exercises}/${name}.cpp "the stub of ${unit}")
      if(EXISTS ${root}/solutions)
        tumble_require_file(${solution} "the solution of ${unit}")
      endif()
      tumble_require_file(${spec} "the spec of ${unit}")

      set(id ${target}_${chapter}_${name})
      tumble_add_worker(${id}_worker ${root} ${chapter} ${name})
      tumble_add_spec(${id}_spec ${target} ${chapter}/${name} ${spec} ${root}/exercises)
      set(all_of_unit ${prefix}spec.${chapter}.${name})
      add_custom_target(${all_of_unit})
      add_dependencies(${all_of_unit} ${target} ${id}_spec ${id}_worker ${solutions}
        tumble_worker tumble_student_pch)
      add_dependencies(${prefix}all_specs ${all_of_unit})
      set(solution_object "\"\"") # of a hand-out
      if(EXISTS ${solution})
        tumble_student_object(${id}_solution ${solution} ${exercises} ${root}/exercises)
        list(APPEND solutions ${id}_solution)
        add_dependencies(${prefix}all_specs ${id}_solution)
        set(solution_object "\"$<FILTER:$<TARGET_OBJECTS:${id}_solution>,INCLUDE,/solutions/>\"")
      endif()

      tumble_add_check(${target} ${chapter} ${name} ${number})

      if(TUMBLE_PORTABLE_WORKER AND earlier)
        add_library(${id}_earlier STATIC ${earlier_objects})
        set_target_properties(${id}_earlier PROPERTIES LINKER_LANGUAGE CXX)
        add_dependencies(${all_of_unit} ${id}_earlier)
        set(earlier_json "\"$<TARGET_FILE:${id}_earlier>\"")
      else()
        list(JOIN earlier "," earlier_json)
      endif()
      string(APPEND json "${separator}
    {\"number\": \"${number}\", \"chapter\": \"${chapter}\", \"name\": \"${name}\",
     \"worker\": \"$<FILTER:$<TARGET_OBJECTS:${id}_worker>,INCLUDE,/workers/>\",
     \"spec\": \"$<TARGET_FILE:${id}_spec>\", \"solution\": ${solution_object}, \"earlier\": [${earlier_json}]}")
      set(separator ",")
      if(EXISTS ${solution})
        list(APPEND earlier ${solution_object})
        list(APPEND earlier_objects $<FILTER:$<TARGET_OBJECTS:${id}_solution>,INCLUDE,/solutions/>)
      endif()
    endforeach()
  endforeach()

  # What makes engines of a student's functions: ./tumble mine.
  foreach(name IN ITEMS engine die)
    set(${name})
    set(source ${root}/tests/judge/mine/student/${name}.cpp)
    if(EXISTS ${source} AND whole)
      tumble_student_object(${target}_${name} ${source} ${PROJECT_SOURCE_DIR}/tests ${root}/exercises)
      add_dependencies(${prefix}all_specs ${target}_${name} tumble_judge_mine)
      set(${name} "$<FILTER:$<TARGET_OBJECTS:${target}_${name}>,INCLUDE,/${name}.cpp>")
    endif()
  endforeach()

  tumble_write_course(${target} ${root} "${engine}" "${die}" "${json}")
endfunction()
