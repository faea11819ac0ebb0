# Builds the site: Doxygen's own header with our scripts instead of its (which would ask the network),
# then Doxygen, then KaTeX beside the pages.
cmake_minimum_required(VERSION 3.25)
file(MAKE_DIRECTORY ${site})
execute_process(COMMAND ${doxygen} -w html ${site}/header.html ${site}/footer.html ${site}/style.css
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(READ ${site}/header.html header)
string(REGEX REPLACE "^<!DOCTYPE[^>]*>" "<!DOCTYPE html>" header "${header}")
string(REPLACE "$mathjax" [[
<meta name="viewport" content="width=device-width, initial-scale=1"/>
<link rel="stylesheet" href="$relpath^katex/katex.min.css"/>
<script src="$relpath^katex/katex.min.js"></script>
<script src="$relpath^katex/contrib/auto-render.js"></script>
<script src="$relpath^doxygen-awesome-darkmode-toggle.js"></script>
<script src="$relpath^doxygen-awesome-fragment-copy-button.js"></script>
<script src="$relpath^doxygen-awesome-paragraph-link.js"></script>
<script src="$relpath^book.js"></script>
]] header "${header}")
if(NOT header MATCHES "katex.min.js")
  message(FATAL_ERROR "Doxygen's header has no place for our scripts")
endif()
file(WRITE ${site}/header.html "${header}")

file(REMOVE_RECURSE ${site}/html)
execute_process(COMMAND ${doxygen} ${doxyfile} RESULT_VARIABLE status)
if(status)
  message(FATAL_ERROR "the site is not built, see above")
endif()

execute_process(COMMAND ${tool} --root ${root} figures ${site}/html COMMAND_ERROR_IS_FATAL ANY)
file(COPY ${katex}/katex.min.js ${katex}/katex.min.css ${katex}/fonts DESTINATION ${site}/html/katex
  FOLLOW_SYMLINK_CHAIN)
file(COPY ${katex}/contrib/auto-render.js DESTINATION ${site}/html/katex/contrib FOLLOW_SYMLINK_CHAIN)
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
