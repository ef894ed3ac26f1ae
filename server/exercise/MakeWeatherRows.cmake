# The rows of weather_table.hpp: the figures of config/schema/exercise.schema.json below "environment", as a constexpr
# array; called while building: cmake -DSCHEMA= -DHEADER= -P MakeWeatherRows.cmake
cmake_minimum_required(VERSION 3.25)
file(READ "${SCHEMA}" schema)
string(JSON figures GET "${schema}" properties environment properties)
string(JSON count LENGTH "${figures}")
math(EXPR last "${count} - 1")
set(rows "")
set(size 0)
foreach(k RANGE ${last})
  string(JSON name MEMBER "${figures}" ${k})
  string(JSON low ERROR_VARIABLE none GET "${figures}" ${name} minimum)
  if(none)
    continue() # a list, or another file
  endif()
  string(JSON high GET "${figures}" ${name} maximum)
  string(JSON default GET "${figures}" ${name} default)
  string(JSON about GET "${figures}" ${name} description)
  string(REGEX MATCH "^(m/s|deg/s|deg|m|s|h)([ ,;]|$)" unit "${about}")
  string(APPEND rows "    {R\"(${name})\", R\"(${CMAKE_MATCH_1})\", ${low}, ${high}, ${default}, R\"(${about})\"},\n")
  math(EXPR size "${size} + 1")
endforeach()
file(WRITE "${HEADER}" "#pragma once
// Made of config/schema/exercise.schema.json.

namespace windlass::exercise {
inline constexpr std::array<WeatherRow, ${size}> kWeatherRows{{
${rows}}};
} // namespace windlass::exercise
")
