# Writes the two sides of a mark that stands for HEADERS: a judge defines it, and its specs need it. So the
# loader of modules refuses a spec that was built with other headers than the judge.
set(hashes)
foreach(header IN LISTS HEADERS)
  file(SHA256 ${header} hash)
  string(APPEND hashes ${hash})
endforeach()
string(SHA256 mark "${hashes}")
string(SUBSTRING ${mark} 0 16 mark)
file(WRITE ${FOLDER}/mark_of_judge.cpp
"extern \"C\" {
extern const int tumble_spec_headers_${mark};
const int tumble_spec_headers_${mark} = 0;
}
")
file(WRITE ${FOLDER}/mark_of_spec.cpp
"extern \"C\" {
extern const int tumble_spec_headers_${mark};
extern const int* const tumble_judge_of_spec;
const int* const tumble_judge_of_spec = &tumble_spec_headers_${mark};
}
")
