# What `cmake --install` puts where, and the Debian package made of it. Relocatable: the program finds its helper and its
# parts from its own place.
include(GNUInstallDirs)
# What is not the Python module is the program's.
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME moldlight)

install(TARGETS moldlight RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
if(TARGET moldlight_step)
  install(TARGETS moldlight_step RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/moldlight)
endif()
foreach(folder parts revisions)
  install(DIRECTORY assets/${folder}/ DESTINATION ${CMAKE_INSTALL_DATADIR}/moldlight/${folder} FILES_MATCHING PATTERN "*.stl")
endforeach()
install(PROGRAMS assets/batch/moldlight-slurm assets/batch/moldlight-ssh DESTINATION ${CMAKE_INSTALL_BINDIR})
install(FILES assets/package/moldlight.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES assets/package/moldlight.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
install(FILES assets/package/moldlight.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages)

# Manual page and completion are what the program says of itself.
set(package_folder ${CMAKE_BINARY_DIR}/package)
file(MAKE_DIRECTORY ${package_folder})
set(package_files ${package_folder}/moldlight.1.gz ${package_folder}/moldlight.bash ${package_folder}/_moldlight
    ${package_folder}/changelog.gz)
add_custom_command(
  OUTPUT ${package_files}
  COMMAND sh -c "\"$<TARGET_FILE:moldlight>\" manual | gzip -9n > moldlight.1.gz"
  COMMAND $<TARGET_FILE:moldlight> manual --form bash > moldlight.bash
  COMMAND $<TARGET_FILE:moldlight> manual --form zsh > _moldlight
  COMMAND sh -c "gzip -9n < \"${CMAKE_SOURCE_DIR}/CHANGELOG.md\" > changelog.gz"
  WORKING_DIRECTORY ${package_folder}
  DEPENDS moldlight ${CMAKE_SOURCE_DIR}/CHANGELOG.md
  COMMENT "Writing manual page and completion"
  VERBATIM)
add_custom_target(package_files ALL DEPENDS ${package_files})
install(FILES ${package_folder}/moldlight.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${package_folder}/moldlight.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
        RENAME moldlight)
install(FILES ${package_folder}/_moldlight DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
install(FILES ${package_folder}/changelog.gz DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
install(DIRECTORY docs/schemas DESTINATION ${CMAKE_INSTALL_DATADIR}/moldlight FILES_MATCHING PATTERN "*.json")
if(TARGET docs)
  install(DIRECTORY ${CMAKE_BINARY_DIR}/share/doc/moldlight/html DESTINATION ${CMAKE_INSTALL_DOCDIR})
endif()

# Where Debian's Python looks: its packages share a folder, what is installed by hand has one of its version.
if(TARGET moldlight_python)
  install(CODE "if(CMAKE_INSTALL_PREFIX STREQUAL /usr/local)
    set(python_folder lib/python${MOLDLIGHT_PYTHON_VERSION}/dist-packages/moldlight)
  else()
    set(python_folder lib/python3/dist-packages/moldlight)
  endif()" COMPONENT python)
  install(TARGETS moldlight_python LIBRARY DESTINATION "\${python_folder}" COMPONENT python)
  install(FILES ${MOLDLIGHT_PYTHON_TEXTS} DESTINATION "\${python_folder}" COMPONENT python)
  set(python_doc ${CMAKE_INSTALL_DATADIR}/doc/python3-moldlight)
  install(FILES ${package_folder}/changelog.gz DESTINATION ${python_doc} COMPONENT python)
  install(FILES LICENSE DESTINATION ${python_doc} RENAME copyright COMPONENT python)
  install(DIRECTORY src/python/examples DESTINATION ${python_doc} COMPONENT python FILES_MATCHING PATTERN "*.py")
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()

# A package of the program, one of the module, which needs the program's reader of STEP files, and one of the workbench.
set(CPACK_GENERATOR DEB)
list(PREPEND CPACK_COMPONENTS_ALL moldlight)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_MOLDLIGHT_PACKAGE_NAME moldlight)
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-moldlight)
set(CPACK_PACKAGE_CONTACT "the moldlight authors <moldlight@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "mold-piece regions of injection-molded parts")
set(CPACK_DEBIAN_MOLDLIGHT_DESCRIPTION
    "If a mold opens along a direction, which surface of the part is formed by\nthe core, which by the cavity, which by either, and which is an undercut?\nmoldlight computes these regions exactly, shows them live, and finds the\nbest direction; in a window and from scripts.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
    WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Opened at run time, so that no linker knows them.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libegl1, libgl1-mesa-dri, fonts-dejavu-core")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "fonts-inter, libosmesa6")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "moldlight (= ${PROJECT_VERSION}), ${MOLDLIGHT_PYTHON_DEPENDS}, python3-numpy, libegl1, libgl1-mesa-dri, fonts-dejavu-core")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "fonts-inter, libosmesa6")
set(CPACK_DEBIAN_PYTHON_DESCRIPTION
    "The figures of moldlight for scripts and for programs that Python extends:\nparts from files or NumPy arrays, regions and their areas, the best parting\ndirections, side actions, parting lines and mold halves.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    "${CMAKE_SOURCE_DIR}/assets/package/python/postinst;${CMAKE_SOURCE_DIR}/assets/package/python/prerm")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(${CMAKE_CURRENT_LIST_DIR}/freecad.cmake)
include(CPack)
