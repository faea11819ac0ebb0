# What a project installs that has tumble as a part: its own files, and none of tumble's.
# Variables: source, build, prefix, root, compiler
file(REMOVE_RECURSE ${build} ${prefix})
foreach(step IN ITEMS
    "-S;${source};-B;${build};-G;${generator};-DCMAKE_CXX_COMPILER=${compiler};-DTUMBLE_ROOT=${root}"
    "--build;${build};--target;embedded"
    "--install;${build};--prefix;${prefix}")
  execute_process(COMMAND ${CMAKE_COMMAND} ${step} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endforeach()
execute_process(COMMAND ${build}/embedded OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE installed RELATIVE ${prefix} ${prefix}/*)
if(NOT installed STREQUAL "share/CMakeLists.txt")
  message(FATAL_ERROR "installed beside the project's own file: ${installed}")
endif()
