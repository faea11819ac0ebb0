# Specs: modules that share headers, and objects with their judge.

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

# For a target on the judge's side: it begins with what every spec includes. Where that has other options, with
# the assertions alone.
function(tumble_use_spec_headers target)
  if(CMAKE_DISABLE_PRECOMPILE_HEADERS OR TUMBLE_COMPUTES_LITTLE)
    # Its options, and not the library itself, which tumble_judge_parts would meet as one to link only.
    target_compile_options(${target} PRIVATE $<TARGET_PROPERTY:tumble_eigen_throws,INTERFACE_COMPILE_OPTIONS>)
    return()
  endif()
  tumble_add_spec_headers()
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_precompile_headers(${target} REUSE_FROM tumble_spec_headers)
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
