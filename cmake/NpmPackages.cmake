# Installs the npm packages of a folder as its package-lock.json has them, unless they are there already: another
# build folder may have done so. Called while building: cmake -DNPM= -DFOLDER= -DSTAMP= -P NpmPackages.cmake
set(there ${FOLDER}/node_modules/.package-lock.json)
if(NOT EXISTS ${there} OR NOT ${there} IS_NEWER_THAN ${FOLDER}/package-lock.json)
  execute_process(COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund WORKING_DIRECTORY ${FOLDER}
    RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "npm could not install the packages of ${FOLDER} (its message is above). Is the registry of npm "
      "within reach? cmake -DWINDLASS_PAGES=OFF builds the stations in their terminal forms.")
  endif()
endif()
file(TOUCH ${STAMP})
