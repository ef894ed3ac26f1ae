# Puts JSON files into a program, so that it needs no file of ours at run time to know what is allowed.
#
# windlass_embed_json(TARGET FILE...): for config/schema/ship.schema.json the target can include
# "embedded/ship_schema.hpp", with `inline constexpr std::string_view windlass::embedded::ship_schema`.

function(windlass_embed_json target)
  set(dir ${CMAKE_CURRENT_BINARY_DIR}/${target}-json)
  set(script ${PROJECT_SOURCE_DIR}/cmake/EmbedJsonFile.cmake)
  foreach(file IN LISTS ARGN)
    get_filename_component(name ${file} NAME)
    string(REGEX REPLACE "\\.json$" "" name ${name})
    string(REPLACE "." "_" name ${name})
    set(header ${dir}/embedded/${name}.hpp)
    add_custom_command(OUTPUT ${header}
      COMMAND ${CMAKE_COMMAND} -DFILE=${file} -DNAME=${name} -DHEADER=${header} -P ${script}
      DEPENDS ${file} ${script} VERBATIM)
    target_sources(${target} PRIVATE ${header})
  endforeach()
  target_include_directories(${target} PRIVATE ${dir})
endfunction()
