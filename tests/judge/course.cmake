# A course: chapters of units under exercises/, solutions/ and tests/. The one place that lists an
# exercise is its heading in a contract, `// == 4.1 product: what it is`. From there everything follows:
#   exercises/04_quaternions/product.cpp   the stub            tests/04_quaternions/product.cpp   the spec
#   solutions/04_quaternions/product.cpp   the answer          <build>/workers/…   who asks the student's code

set(tumble_judge_folder ${CMAKE_CURRENT_LIST_DIR})
foreach(part IN ITEMS units student spec)
  include(${tumble_judge_folder}/${part}.cmake)
endforeach()

# A list as the elements of a JSON array.
function(tumble_json_list out)
  list(TRANSFORM ARGN REPLACE "(.+)" "\"\\1\"")
  list(JOIN ARGN ", " joined)
  set(${out} "${joined}" PARENT_SCOPE)
endfunction()

function(tumble_require_file file what)
  if(NOT EXISTS ${file})
    message(FATAL_ERROR "${what} is missing: ${file}")
  endif()
endfunction()

# What the contract promises of a unit is there. (A hand-out has no solutions.)
function(tumble_require_unit root chapter name unit)
  tumble_require_file(${root}/exercises/${chapter}/${name}.cpp "the stub of ${unit}")
  if(EXISTS ${root}/solutions)
    tumble_require_file(${root}/solutions/${chapter}/${name}.cpp "the solution of ${unit}")
  endif()
  tumble_require_file(${root}/tests/${chapter}/${name}.cpp "the spec of ${unit}")
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

# The judge's program. Its course is a path, in a file of its own.
function(tumble_add_judge_program target course_json)
  set(course_file ${CMAKE_CURRENT_BINARY_DIR}/${target}_course_file.cpp)
  configure_file(${tumble_judge_folder}/commands/course_file.cpp.in ${course_file} @ONLY)
  add_executable(${target} ${course_file} $<TARGET_OBJECTS:tumble_mark_of_judge>)
  set_target_properties(${target} PROPERTIES UNITY_BUILD OFF ENABLE_EXPORTS ON) # specs use what it has
  target_link_libraries(${target} PRIVATE tumble_judge_core tumble_judge_commands)
endfunction()

# What a worker of this unit is linked with beside the student's file, as JSON: the solutions of earlier
# units, each a target.
function(tumble_add_earlier id all_of_unit solutions out)
  tumble_object_files(files /solutions/ ${solutions})
  if(TUMBLE_PORTABLE_WORKER AND files)
    add_library(${id}_earlier STATIC ${files})
    set_target_properties(${id}_earlier PROPERTIES LINKER_LANGUAGE CXX)
    add_dependencies(${all_of_unit} ${id}_earlier)
    set(files $<TARGET_FILE:${id}_earlier>)
  endif()
  tumble_json_list(files ${files})
  set(${out} "${files}" PARENT_SCOPE)
endfunction()

# All that judging a unit needs. The judge's properties tumble_solutions and tumble_units, targets and JSON,
# grow by it: the units come in their order.
function(tumble_add_unit target root prefix chapter unit)
  string(REGEX REPLACE " .*" "" number "${unit}")
  string(REGEX REPLACE ".* " "" name "${unit}")
  tumble_require_unit(${root} ${chapter} ${name} "${unit}")
  get_property(earlier TARGET ${target} PROPERTY tumble_solutions)
  set(id ${target}_${chapter}_${name})
  set(all_of_unit ${prefix}spec.${chapter}.${name})

  tumble_add_worker(${id}_worker ${root} ${chapter} ${name})
  tumble_add_spec(${id}_spec ${target} ${chapter}/${name} ${root}/tests/${chapter}/${name}.cpp ${root}/exercises)
  add_custom_target(${all_of_unit})
  add_dependencies(${all_of_unit} ${target} ${id}_spec ${id}_worker ${earlier} tumble_worker tumble_student_pch)
  add_dependencies(${prefix}all_specs ${all_of_unit})

  set(solution ${root}/solutions/${chapter}/${name}.cpp)
  set(solution_object)
  if(EXISTS ${solution})
    tumble_student_object(${id}_solution ${solution} ${root}/exercises/${chapter} ${root}/exercises)
    add_dependencies(${prefix}all_specs ${id}_solution)
    set_property(TARGET ${target} APPEND PROPERTY tumble_solutions ${id}_solution)
    tumble_object_files(solution_object /solutions/ ${id}_solution)
  endif()
  tumble_add_check(${target} ${chapter} ${name} ${number})

  tumble_object_files(worker_object /workers/ ${id}_worker)
  tumble_add_earlier(${id} ${all_of_unit} "${earlier}" earlier_json)
  string(CONFIGURE [[
    {"number": "@number@", "chapter": "@chapter@", "name": "@name@",
     "worker": "@worker_object@",
     "spec": "$<TARGET_FILE:@id@_spec>", "solution": "@solution_object@", "earlier": [@earlier_json@]}]] json @ONLY)
  set_property(TARGET ${target} APPEND PROPERTY tumble_units "${json}")
endfunction()

# One of the objects that make an engine of a student's functions (./tumble mine).
function(tumble_add_engine_part target root prefix name out)
  set(${out} "" PARENT_SCOPE)
  set(source ${root}/tests/judge/mine/student/${name}.cpp)
  if(EXISTS ${source})
    tumble_student_object(${target}_${name} ${source} ${PROJECT_SOURCE_DIR}/tests ${root}/exercises)
    add_dependencies(${prefix}all_specs ${target}_${name} tumble_judge_mine)
    tumble_object_files(object /${name}.cpp ${target}_${name})
    set(${out} ${object} PARENT_SCOPE)
  endif()
endfunction()

# Writes ${target}.json, which tells the judge what there is. Parts of an engine may be empty.
function(tumble_write_course target root course_json engine die)
  get_property(units TARGET ${target} PROPERTY tumble_units)
  list(JOIN units ",\n" units)
  tumble_json_list(flags ${TUMBLE_STUDENT_FLAGS})
  tumble_json_list(sanitizer_flags ${TUMBLE_SANITIZER_FLAGS})
  tumble_json_list(link ${TUMBLE_LINK_FLAGS})
  tumble_json_list(link_confined ${TUMBLE_LINK_CONFINED})
  tumble_json_list(link_first_counts ${TUMBLE_LINK_FIRST_COUNTS})
  configure_file(${tumble_judge_folder}/course/course.json.in ${course_json}.in @ONLY)
  file(GENERATE OUTPUT ${course_json} INPUT ${course_json}.in)
endfunction()

# Adds `target`, the judge of the course under `root`, and for each unit a target that builds all that
# judging it needs: spec.04_quaternions.product (with a prefix, if one is given). all_specs builds all of
# them. Writes ${target}.json, which tells the judge what there is.
function(tumble_add_judge target root)
  set(prefix ${ARGN})
  set(course_json ${CMAKE_CURRENT_BINARY_DIR}/${target}.json)
  tumble_add_header_mark()
  tumble_add_judge_program(${target} ${course_json})
  add_custom_target(${prefix}all_specs)
  add_dependencies(${prefix}all_specs grading_tools tumble_judge_grading) # who grades a class has archives

  file(GLOB contracts ${root}/exercises/[0-9]*/contract.hpp)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${root}/exercises)
  list(SORT contracts)
  set(engine_parts engine die)
  foreach(contract IN LISTS contracts)
    cmake_path(GET contract PARENT_PATH exercises)
    cmake_path(GET exercises FILENAME chapter)
    if(NOT EXISTS ${root}/tests/${chapter})
      set(engine_parts) # they need all chapters
      continue() # a hand-out has this contract only because others speak of its types
    endif()
    tumble_units_of(${contract} units)
    foreach(unit IN LISTS units)
      tumble_add_unit(${target} ${root} "${prefix}" ${chapter} "${unit}")
    endforeach()
  endforeach()

  # What judging any unit needs: it can be built beside the judge, before one knows which units.
  get_property(first_student_object GLOBAL PROPERTY tumble_first_student_object)
  add_custom_target(${prefix}any_spec)
  add_dependencies(${prefix}any_spec ${target} tumble_worker tumble_student_pch tumble_spec_headers
    ${first_student_object})

  set(engine)
  set(die)
  foreach(part IN LISTS engine_parts)
    tumble_add_engine_part(${target} ${root} "${prefix}" ${part} ${part})
  endforeach()
  tumble_write_course(${target} ${root} ${course_json} "${engine}" "${die}")
endfunction()
