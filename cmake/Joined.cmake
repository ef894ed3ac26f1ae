# Files compiled together. Our mean file has 84 lines, behind which the compiler reads tens of thousands of Eigen,
# GoogleTest and the standard library, and makes the same templates of them once more: that is where most of a build's
# time goes. So the files of a target are compiled some at a time, as one file that includes them.
#
# CMake's own UNITY_BUILD writes absolute paths into these files, and ccache would find nothing in another work tree.
#
# windlass_join(SIZE n FOLDER...): the targets of these folders, n files at a time, once the folders are added. A file
# that is to be compiled by itself has SKIP_UNITY_BUILD_INCLUSION, or COMPILE_OPTIONS of its own; a target whose files
# all are, UNITY_BUILD OFF.
#
# Names without linkage must differ within a target then. Every file includes what it uses all the same: the presets
# debug and clang compile each by itself (WINDLASS_JOIN=OFF), and clang-tidy goes by debug's commands.

option(WINDLASS_JOIN "Compile several files of a target together" ON)

function(windlass_join)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "SIZE" "FOLDER")
  if(NOT WINDLASS_JOIN)
    return()
  endif()
  foreach(folder IN LISTS arg_FOLDER)
    get_property(targets DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} PROPERTY BUILDSYSTEM_TARGETS)
    foreach(target IN LISTS targets)
      get_target_property(wanted ${target} UNITY_BUILD)
      if(wanted STREQUAL "OFF")
        continue()
      endif()
      get_target_property(sources ${target} SOURCES)
      get_target_property(dir ${target} BINARY_DIR)
      set(kept)
      set(joined)
      foreach(source IN LISTS sources)
        cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} NORMALIZE)
        cmake_path(IS_PREFIX CMAKE_BINARY_DIR ${source} made)
        get_source_file_property(alone ${source} TARGET_DIRECTORY ${target} SKIP_UNITY_BUILD_INCLUSION)
        get_source_file_property(options ${source} TARGET_DIRECTORY ${target} COMPILE_OPTIONS)
        if(source MATCHES "\\.cpp$" AND NOT made AND NOT alone AND NOT options)
          cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
          list(APPEND joined ${source})
        else()
          list(APPEND kept ${source})
        endif()
      endforeach()
      # As many files in each, neighbours together: files of one folder read the same headers.
      list(SORT joined)
      list(LENGTH joined count)
      math(EXPR parts "(${count} + ${arg_SIZE} - 1) / ${arg_SIZE}")
      foreach(part RANGE 1 ${parts})
        if(count LESS 2)
          break()
        endif()
        math(EXPR begin "(${part} - 1) * ${count} / ${parts}")
        math(EXPR length "${part} * ${count} / ${parts} - ${begin}")
        list(SUBLIST joined ${begin} ${length} files)
        list(TRANSFORM files REPLACE "(.+)" "#include \"\\1\"\n")
        list(JOIN files "" text)
        set(file ${dir}/${target}-joined/${part}.cpp)
        file(GENERATE OUTPUT ${file} CONTENT "${text}")
        list(APPEND kept ${file})
      endforeach()
      if(count GREATER 1)
        set_target_properties(${target} PROPERTIES SOURCES "${kept}")
        target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
        # A type of one file may have members of that file's own types.
        target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
      endif()
    endforeach()
  endforeach()
endfunction()
