# Sets `page_scripts_source` to a file with the scripts of the report's page as strings: uPlot and three.js from npm, each
# with one file of ours (plots.js, view3d.js). npm installs what package-lock.json names into the build folder; nothing of
# it stands in this repository. Where npm, its registry or a Node that runs the bundler is absent, the strings are empty
# and the page keeps its drawings and pictures.
option(TWINWAKE_PAGE_SCRIPTS "the report's plots tell values and its water can be turned, where npm brings uPlot and three.js" ON)

set(page_source ${CMAKE_CURRENT_LIST_DIR})
set(page_build ${PROJECT_BINARY_DIR}/page)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
             ${page_source}/plots.js ${page_source}/view3d.js ${page_source}/bundle.mjs ${page_source}/package-lock.json)

# Sets `without` in the caller to the reason why there are no scripts, or to nothing.
function(make_page_scripts)
  set(without "" PARENT_SCOPE)
  find_program(NPM npm)
  find_program(NODE node)
  if(NOT TWINWAKE_PAGE_SCRIPTS)
    set(without "TWINWAKE_PAGE_SCRIPTS is OFF" PARENT_SCOPE)
    return()
  elseif(NOT NPM OR NOT NODE)
    set(without "npm is not installed" PARENT_SCOPE)
    return()
  endif()
  file(SHA256 ${page_source}/package-lock.json wanted)
  set(installed "")
  if(EXISTS ${page_build}/installed)
    file(READ ${page_build}/installed installed)
  endif()
  if(NOT installed STREQUAL wanted)
    file(COPY ${page_source}/package.json ${page_source}/package-lock.json DESTINATION ${page_build})
    # Scripts of packages are not run.
    execute_process(COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --no-update-notifier --prefer-offline
                                   --fetch-retries=0 --fetch-timeout=20000
                    WORKING_DIRECTORY ${page_build} TIMEOUT 120 RESULT_VARIABLE failed OUTPUT_QUIET ERROR_VARIABLE said)
    if(failed)
      string(REGEX MATCH "npm [^\n]*" said "${said}")
      set(without "npm cannot bring uPlot and three.js (${said})" PARENT_SCOPE)
      return()
    endif()
    file(WRITE ${page_build}/installed ${wanted})
  endif()
  execute_process(COMMAND ${NODE} ${page_source}/bundle.mjs ${page_build} RESULT_VARIABLE failed ERROR_VARIABLE said)
  if(failed)
    string(REGEX MATCH "[^\n]*Error[^\n]*" said "${said}")
    set(without "the scripts cannot be bundled (${said})" PARENT_SCOPE)
  endif()
endfunction()

make_page_scripts()
set(TWINWAKE_PLOTS_JS "")
set(TWINWAKE_VIEW3D_JS "")
if(without STREQUAL "")
  file(READ ${page_build}/plots.js TWINWAKE_PLOTS_JS)
  file(READ ${page_build}/view3d.js TWINWAKE_VIEW3D_JS)
  file(STRINGS ${page_build}/LICENSES.txt libraries REGEX "^[a-z]+ [0-9.]+$")
  # For the bill of materials (package/).
  set_property(GLOBAL PROPERTY TWINWAKE_PAGE_LIBRARIES ${libraries})
  list(JOIN libraries ", " libraries)
  message(STATUS "The report's page: with ${libraries}")
else()
  message(STATUS "The report's page: drawings and pictures without scripts, since ${without}")
endif()
set(page_scripts_source ${PROJECT_BINARY_DIR}/generated/compare/report/page_scripts.cpp)
configure_file(${page_source}/page_scripts.cpp.in ${page_scripts_source} @ONLY)
# A unit of its own, that alone is compiled when a script changes.
set_source_files_properties(${page_scripts_source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
