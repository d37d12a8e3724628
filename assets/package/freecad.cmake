# The FreeCAD workbench: Python and icons, where FreeCAD of Debian looks for its workbenches; a package of its own.
file(STRINGS ${CMAKE_SOURCE_DIR}/src/freecad/package.xml freecad_version REGEX "<version>")
if(NOT freecad_version MATCHES ">${PROJECT_VERSION}<")
  message(FATAL_ERROR "src/freecad/package.xml tells another version than ${PROJECT_VERSION}")
endif()
set(freecad_folder ${CMAKE_INSTALL_DATADIR}/freecad/Mod/Moldlight)
install(DIRECTORY src/freecad/ DESTINATION ${freecad_folder} COMPONENT freecad
        PATTERN "__pycache__" EXCLUDE PATTERN "icons/moldlight.svg" EXCLUDE)
# In the source tree it is a link to the program's own.
install(FILES assets/package/moldlight.svg DESTINATION ${freecad_folder}/icons COMPONENT freecad)
install(FILES LICENSE DESTINATION ${freecad_folder} COMPONENT freecad)
set(freecad_doc ${CMAKE_INSTALL_DATADIR}/doc/freecad-moldlight)
install(FILES ${package_folder}/changelog.gz DESTINATION ${freecad_doc} COMPONENT freecad)
install(FILES LICENSE DESTINATION ${freecad_doc} RENAME copyright COMPONENT freecad)
# It is nothing without the module.
if(TARGET moldlight_python)
  list(APPEND CPACK_COMPONENTS_ALL freecad)
endif()
set(CPACK_DEBIAN_FREECAD_PACKAGE_NAME freecad-moldlight)
set(CPACK_DEBIAN_FREECAD_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_FREECAD_PACKAGE_DEPENDS "freecad (>= 0.20), python3-moldlight (>= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_FREECAD_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_FREECAD_DESCRIPTION
    "A workbench of FreeCAD for moldlight: mold-piece regions of a body in colours,\nthe best parting directions, slides and lifters, the parting line and the\nmold's halves, as objects of the document that follow the body.")
