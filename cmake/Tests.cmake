# How cases of GoogleTest become tests of ctest. Most take less time than the start of a process, so all cases of an
# executable share one, but for those that are named:
#
# windlass_tests(TARGET [LABEL label] [EACH suite...] [TOGETHER suite...] [LONG suite...] [NOT_FAST])
#   EACH      a process and a test for every case of the suite: slow ones, to spread over the cores
#   TOGETHER  one for the suite, whose cases look at one and the same run
#   LONG      as TOGETHER, for the long run only (label "long")
#   NOT_FAST  what remains takes too long for ./check --fast (label "fast") as well
# A suite may be any filter of GoogleTest: FoulAnchor.CableLaid*. These tests compute: a core each, and behind those
# that wait.
#
# windlass_wire_tests(TARGET [SERIAL suite...] TIMEOUT s COST s)
#   Over real DDS: a process for every case (label "wire"). They mostly wait, many at a time.
#   SERIAL    those that need the machine to themselves
#   COST      how long its cases take, about: the slowest start first
#
# ./check gives ctest four places for every core: a test that computes takes three of them, one that waits one. So
# every core has something to compute, and beside it others wait.
include(GoogleTest)

set(WINDLASS_PLACES_TO_COMPUTE 3)

# s, for a program that has just been linked to list its cases: a machine that has other work needs more than the 5
# that are usual, and its build would fail.
set(WINDLASS_LISTED_WITHIN DISCOVERY_TIMEOUT 300)

# windlass_filter(OUT suite...): the suites as one filter; Suite without a dot stands for Suite.*
function(windlass_filter out)
  set(filters)
  foreach(suite IN LISTS ARGN)
    if(NOT suite MATCHES "\\.")
      string(APPEND suite ".*")
    endif()
    list(APPEND filters ${suite})
  endforeach()
  list(JOIN filters ":" filters)
  set(${out} "${filters}" PARENT_SCOPE)
endfunction()

function(windlass_tests target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "NOT_FAST" "LABEL" "EACH;TOGETHER;LONG")
  # Not across any border: it is ctest's way of putting a word before a command, here one that lets the tests that
  # wait for each other have the core when they wake.
  set_target_properties(${target} PROPERTIES CROSSCOMPILING_EMULATOR "nice")
  set(compute PROCESSORS ${WINDLASS_PLACES_TO_COMPUTE})

  # First those of one process for a suite, then each by itself, then all the rest.
  foreach(suite IN LISTS arg_TOGETHER arg_LONG)
    windlass_filter(filter ${suite})
    string(REGEX REPLACE "\\*|\\.$" "" name ${suite})
    add_test(NAME ${name} COMMAND ${target} --gtest_filter=${filter})
    set(labels ${arg_LABEL})
    if(suite IN_LIST arg_LONG)
      list(APPEND labels long)
    endif()
    set_tests_properties(${name} PROPERTIES LABELS "${labels}" COST 60 TIMEOUT 3600 ${compute})
  endforeach()
  windlass_filter(without ${arg_TOGETHER} ${arg_LONG})
  if(arg_EACH)
    windlass_filter(filter ${arg_EACH})
    gtest_discover_tests(${target} ${WINDLASS_LISTED_WITHIN} TEST_FILTER "${filter}:-${without}" NO_PRETTY_VALUES
      PROPERTIES LABELS "${arg_LABEL}" COST 30 ${compute})
  endif()
  windlass_filter(without ${arg_EACH} ${arg_TOGETHER} ${arg_LONG})
  add_test(NAME ${target} COMMAND ${target} "--gtest_filter=-${without}")
  set(labels ${arg_LABEL})
  if(NOT arg_NOT_FAST)
    list(APPEND labels fast)
    add_dependencies(fast_tests ${target})
  endif()
  set_tests_properties(${target} PROPERTIES LABELS "${labels}" COST 20 ${compute})
endfunction()

function(windlass_wire_tests target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "TIMEOUT;COST" "SERIAL")
  # One label: gtest_discover_tests makes properties of what comes behind the first of several.
  set(properties LABELS wire TIMEOUT ${arg_TIMEOUT} COST ${arg_COST})
  windlass_filter(serial ${arg_SERIAL})
  gtest_discover_tests(${target} ${WINDLASS_LISTED_WITHIN} TEST_FILTER "-${serial}" NO_PRETTY_VALUES PROPERTIES ${properties})
  if(serial)
    gtest_discover_tests(${target} ${WINDLASS_LISTED_WITHIN} TEST_FILTER "${serial}" NO_PRETTY_VALUES PROPERTIES ${properties} RUN_SERIAL ON)
  endif()
endfunction()

# What ./check --fast, --long and --lab build beside or instead of all.
add_custom_target(fast_tests)
add_custom_target(long_tests)
add_custom_target(lab) # benchmarks, the rival methods and their tests
