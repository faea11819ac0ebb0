# Builds the site: the tool writes what Doxygen reads beside the pages, then Doxygen, then KaTeX beside
# the pages, and the tool completes them.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND ${tool} --root ${root} prepare ${theme} ${site} COMMAND_ERROR_IS_FATAL ANY)

file(REMOVE_RECURSE ${site}/html)
execute_process(COMMAND ${doxygen} ${doxyfile} RESULT_VARIABLE status)
if(status)
  message(FATAL_ERROR "the site is not built, see above")
endif()

file(COPY ${katex}/katex.min.js ${katex}/katex.min.css ${katex}/fonts DESTINATION ${site}/html/katex
  FOLLOW_SYMLINK_CHAIN)
file(COPY ${moving}/ DESTINATION ${site}/html/moving)
execute_process(COMMAND ${tool} --root ${root} finish ${site} RESULT_VARIABLE status)
if(status)
  message(FATAL_ERROR "the site is not complete, see above")
endif()
message(STATUS "The book: ${site}/html/index.html")

# The site is read offline: nothing in it may ask the network.
file(GLOB_RECURSE files ${site}/html/*.html ${site}/html/*.css ${site}/html/*.js)
set(loads "((src|srcset|data|poster) *= *|<link[^>]*href *= *|url\\(|@import |fetch\\(|import\\()[\"']?(https?:)?//")
foreach(file IN LISTS files)
  file(STRINGS ${file} requests REGEX "${loads}" ENCODING UTF-8)
  if(requests)
    message(FATAL_ERROR "${file} would ask the network: ${requests}")
  endif()
endforeach()
