# Run by CPack on each package's files before they are packed: what Debian wants of a package beyond what is
# installed anywhere (Debian Policy 12). Errors: where a package has no files.
set(here ${CMAKE_CURRENT_LIST_DIR})
set(debian_version ${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})

# The licences as Debian reads them, with the MIT licence as spaces/LICENSE has it.
function(write_copyright folder)
  file(STRINGS ${here}/../../spaces/LICENSE COPYRIGHT REGEX "^Copyright" LIMIT_COUNT 1)
  string(REGEX REPLACE "^Copyright \\(c\\) " "" COPYRIGHT "${COPYRIGHT}")
  file(READ ${here}/../../spaces/LICENSE EXPAT)
  string(REGEX REPLACE "^MIT License\n\nCopyright[^\n]*\n\n" "" EXPAT "${EXPAT}")
  string(STRIP "${EXPAT}" EXPAT)
  string(REPLACE "\n\n" "\n.\n" EXPAT "${EXPAT}")
  string(REPLACE "\n" "\n " EXPAT " ${EXPAT}")
  configure_file(${here}/copyright.in ${folder}/copyright @ONLY)
endfunction()

# CHANGELOG.md, and Debian's own, which says what the package was made of.
function(write_changelogs folder package)
  string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
  file(WRITE ${folder}/changelog.Debian "${package} (${debian_version}) unstable; urgency=medium

  * Version ${CPACK_PACKAGE_VERSION}; its changes are in changelog.gz.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
  configure_file(${here}/../../CHANGELOG.md ${folder}/changelog COPYONLY)
  execute_process(COMMAND gzip -9 --no-name ${folder}/changelog.Debian ${folder}/changelog
    COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# A manual page of what the program says of itself, where help2man is there.
function(write_manual usr)
  find_program(HELP2MAN help2man)
  if(NOT HELP2MAN)
    message(STATUS "clipscope has no manual page, which needs help2man")
    return()
  endif()
  file(MAKE_DIRECTORY ${usr}/share/man/man1)
  execute_process(
    COMMAND ${HELP2MAN} --no-info --no-discard-stderr --name "judge of triangle clippers"
      --output ${usr}/share/man/man1/clipscope.1 ${usr}/bin/clipscope
    COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND gzip -9 --no-name ${usr}/share/man/man1/clipscope.1 COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# Debian's Python looks for packages in lib/python3/dist-packages.
function(move_python_package usr)
  file(GLOB packages ${usr}/lib/python3.*/site-packages)
  list(LENGTH packages count)
  if(NOT count EQUAL 1)
    message(FATAL_ERROR "python3-clipscope: expected one folder of Python packages below ${usr}, found: ${packages}")
  endif()
  cmake_path(GET packages PARENT_PATH versioned)
  file(MAKE_DIRECTORY ${usr}/lib/python3)
  file(RENAME ${packages} ${usr}/lib/python3/dist-packages)
  file(REMOVE_RECURSE ${versioned})
endfunction()

function(finish group package)
  set(usr ${CPACK_TEMPORARY_DIRECTORY}/${group}${CPACK_PACKAGING_INSTALL_PREFIX})
  if(NOT IS_DIRECTORY ${usr})
    message(FATAL_ERROR "${package} has no files: ${usr} is missing")
  endif()
  # The texts of the licences are in `copyright`; but for the program's there is nothing else there.
  if(group STREQUAL tool)
    file(REMOVE ${usr}/share/doc/clipscope/LICENSE)
  else()
    file(REMOVE_RECURSE ${usr}/share/doc)
  endif()
  set(folder ${usr}/share/doc/${package})
  file(MAKE_DIRECTORY ${folder})
  write_copyright(${folder})
  write_changelogs(${folder} ${package})
  if(group STREQUAL tool)
    write_manual(${usr})
  elseif(group STREQUAL module)
    move_python_package(${usr})
  endif()
endfunction()

foreach(group tool headers module)
  string(TOUPPER ${group} GROUP)
  if(CPACK_DEBIAN_${GROUP}_PACKAGE_NAME)
    finish(${group} ${CPACK_DEBIAN_${GROUP}_PACKAGE_NAME})
  endif()
endforeach()
