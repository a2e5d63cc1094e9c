# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# Makes RESULT, a C++ source, from the viewer in SOURCE_DIR, with packages that NPM puts into BUILD_DIR; an empty one,
# with a warning, where that fails. Nothing is written into SOURCE_DIR.

function(make_none reason)
  message(WARNING "Reports .html will have still pictures, and no mesh in 3D: ${reason}")
  file(WRITE ${RESULT} "#include \"page/viewer_bundle.h\"\n\nconst char viewer_bundle[] = \"\";\n")
endfunction()

file(MAKE_DIRECTORY ${BUILD_DIR})
if(NOT NPM OR NOT NODE)
  make_none("npm was not found, or is not to be used (TUBULAR_MESHING_WITH_VIEWER).")
  return()
endif()

file(COPY ${SOURCE_DIR}/src ${SOURCE_DIR}/build.mjs ${SOURCE_DIR}/package.json ${SOURCE_DIR}/package-lock.json
          ${SOURCE_DIR}/.npmrc DESTINATION ${BUILD_DIR})
file(SHA256 ${SOURCE_DIR}/package-lock.json lock)
set(mark ${BUILD_DIR}/node_modules/.installed_${lock})
if(NOT EXISTS ${mark})
  execute_process(
    COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --prefer-offline --fetch-retries=1 --fetch-timeout=60000
    WORKING_DIRECTORY ${BUILD_DIR}
    RESULT_VARIABLE failed
    OUTPUT_VARIABLE said
    ERROR_VARIABLE said
    TIMEOUT 300)
  if(NOT failed EQUAL 0)
    make_none("npm ci failed.\n${said}")
    return()
  endif()
  file(WRITE ${mark} "")
endif()
execute_process(
  COMMAND ${NODE} build.mjs viewer.js ${RESULT}
  WORKING_DIRECTORY ${BUILD_DIR}
  RESULT_VARIABLE failed
  OUTPUT_VARIABLE said
  ERROR_VARIABLE said
  TIMEOUT 120)
if(NOT failed EQUAL 0)
  make_none("the viewer could not be bundled.\n${said}")
endif()
