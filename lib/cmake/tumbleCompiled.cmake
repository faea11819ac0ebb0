# tumble::compiled: the bodies of tumble::tumble, compiled once, with the options of the folder that calls this.

# headers: the folder in which tumble/ lies
function(tumble_add_compiled headers)
  file(GLOB_RECURSE bodies CONFIGURE_DEPENDS ${headers}/tumble/*.inl)
  set_source_files_properties(${bodies} PROPERTIES LANGUAGE CXX) # CMake doesn't know the ending
  add_library(tumble_compiled STATIC EXCLUDE_FROM_ALL ${bodies})
  add_library(tumble::compiled ALIAS tumble_compiled)
  # Warnings and linters are for those who work on tumble: they see the same bodies in its headers.
  set_target_properties(tumble_compiled PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 16
    POSITION_INDEPENDENT_CODE ON CXX_CLANG_TIDY "" CXX_INCLUDE_WHAT_YOU_USE "")
  target_compile_options(tumble_compiled PRIVATE -w)
  target_link_libraries(tumble_compiled PUBLIC tumble::tumble)
  target_compile_definitions(tumble_compiled PUBLIC TUMBLE_COMPILED)
endfunction()
