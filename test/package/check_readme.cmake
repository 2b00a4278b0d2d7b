# What the README shows of a file must be the file, a leading licence comment apart.
# usage: cmake -D FILE=smooth_cloud.cpp -D README=README.md -P check_readme.cmake
file(READ "${FILE}" text)
file(READ "${README}" readme)
string(REGEX REPLACE "^// SPDX[^\n]*\n" "" text "${text}")
string(FIND "${readme}" "\n${text}```\n" at)
if(at EQUAL -1)
  message(FATAL_ERROR "${README} does not show ${FILE} as it is: copy it there, in a fenced block.")
endif()
