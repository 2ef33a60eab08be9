# SPDX-License-Identifier: BSD-3-Clause

# Installation of the programs, and the Debian packages built by `packaging/deb`:
#   perilymph          both programs and what they need
#   perilymph-dev      the header of device plug-ins and its CMake package
#   python3-perilymph  the Python package, with its examples
#   perilymph-doc      the guide as HTML, where PERILYMPH_SITE names the folder that packaging/site wrote
include(CMakePackageConfigHelpers)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME program)
set(share "${CMAKE_INSTALL_DATADIR}")

# Data of the programs, without the pictures of the documents.
install(DIRECTORY resources DESTINATION "${share}/perilymph" COMPONENT program
  PATTERN "*.md" EXCLUDE PATTERN OFL.txt EXCLUDE PATTERN pictures EXCLUDE PATTERN icons EXCLUDE PATTERN guide EXCLUDE PATTERN examples EXCLUDE)
install(DIRECTORY plugins DESTINATION "${share}/perilymph" COMPONENT program FILES_MATCHING PATTERN "*.toml"
  PATTERN example EXCLUDE PATTERN devices/common EXCLUDE PATTERN novint EXCLUDE PATTERN haply EXCLUDE PATTERN 3dsystems EXCLUDE
  PATTERN force-dimension EXCLUDE)
# udev rule: the user at the machine may open the haptic devices known by number.
install(FILES packaging/udev/70-perilymph.rules DESTINATION lib/udev/rules.d COMPONENT program)

# Desktop menu entry.
install(FILES packaging/desktop/org.perilymph.perilymph.desktop DESTINATION "${share}/applications" COMPONENT program)
install(FILES packaging/desktop/org.perilymph.perilymph.metainfo.xml DESTINATION "${share}/metainfo" COMPONENT program)
install(FILES packaging/desktop/perilymph.thumbnailer DESTINATION "${share}/thumbnailers" COMPONENT program)
install(FILES packaging/desktop/org.perilymph.perilymph.xml DESTINATION "${share}/mime/packages" COMPONENT program)
foreach(size IN ITEMS 48 64 128 256)
  install(FILES resources/icons/perilymph-${size}.png RENAME perilymph.png COMPONENT program
    DESTINATION "${share}/icons/hicolor/${size}x${size}/apps")
endforeach()
install(FILES resources/icons/perilymph.svg DESTINATION "${share}/icons/hicolor/scalable/apps" COMPONENT program)

# Manual pages and shell completions.
install(FILES packaging/completions/perilymph packaging/completions/perilymph-cli COMPONENT program
  DESTINATION "${share}/bash-completion/completions")
find_program(PERILYMPH_GZIP gzip REQUIRED)
# compressed(<file> <name> <folder> <component>): installs the file as <name>.gz, the same bytes every time.
function(compressed file name folder component)
  set(packed "${CMAKE_BINARY_DIR}/packaging/${component}/${name}.gz")
  get_filename_component(place "${packed}" DIRECTORY)
  file(MAKE_DIRECTORY "${place}")
  add_custom_command(OUTPUT "${packed}" DEPENDS "${CMAKE_SOURCE_DIR}/${file}"
    COMMAND "${PERILYMPH_GZIP}" -9nc "${CMAKE_SOURCE_DIR}/${file}" > "${packed}" VERBATIM)
  add_custom_target(compress_${component}_${name} ALL DEPENDS "${packed}")
  install(FILES "${packed}" DESTINATION "${folder}" COMPONENT ${component})
endfunction()
foreach(page IN ITEMS perilymph.1 perilymph-cli.1)
  compressed(packaging/man/${page} ${page} "${CMAKE_INSTALL_MANDIR}/man1" program)
endforeach()
compressed(packaging/debian/changelog changelog "${share}/doc/perilymph" program)

# The documents, in the structure of the tree, so that their links work.
install(FILES LICENSE DESTINATION "${share}/doc/perilymph" COMPONENT program)
file(GLOB documents RELATIVE "${CMAKE_SOURCE_DIR}" CONFIGURE_DEPENDS README.md packaging/*.md plugins/*.md
  plugins/devices/*/README.md modules/README.md
  modules/*/README.md app/*/README.md resources/fonts/README.md)
foreach(document IN LISTS documents)
  get_filename_component(place "${document}" DIRECTORY)
  install(FILES "${document}" DESTINATION "${share}/doc/perilymph/${place}" COMPONENT program)
endforeach()
install(DIRECTORY resources/pictures resources/guide resources/schemas DESTINATION "${share}/doc/perilymph/resources" COMPONENT program
  PATTERN make-pictures EXCLUDE PATTERN make-reference EXCLUDE PATTERN make-film EXCLUDE PATTERN make-start EXCLUDE)

# The development files of device plug-ins.
set(sdk "${CMAKE_INSTALL_DATADIR}/cmake/Perilymph")
install(FILES modules/device/include/perilymph/device/PluginApi.h COMPONENT sdk
  DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/perilymph/device")
configure_package_config_file(packaging/sdk/PerilymphConfig.cmake.in "${CMAKE_BINARY_DIR}/packaging/PerilymphConfig.cmake"
  INSTALL_DESTINATION "${sdk}" PATH_VARS CMAKE_INSTALL_INCLUDEDIR)
# The releases differ in more than the interface of plug-ins, whose version 1 every release keeps (PluginApi.h): a project
# that was made for one release is built with each later one.
write_basic_package_version_file("${CMAKE_BINARY_DIR}/packaging/PerilymphConfigVersion.cmake"
  COMPATIBILITY AnyNewerVersion ARCH_INDEPENDENT)
install(FILES "${CMAKE_BINARY_DIR}/packaging/PerilymphConfig.cmake"
  "${CMAKE_BINARY_DIR}/packaging/PerilymphConfigVersion.cmake" DESTINATION "${sdk}" COMPONENT sdk)
install(DIRECTORY plugins/devices/example plugins/devices/paddle packaging/sdk/template
  DESTINATION "${share}/doc/perilymph-dev/examples" COMPONENT sdk)
compressed(packaging/debian/changelog changelog "${share}/doc/perilymph-dev" sdk)
install(FILES packaging/debian/copyright DESTINATION "${share}/doc/perilymph" COMPONENT program)
install(FILES packaging/debian/lintian-overrides RENAME perilymph DESTINATION "${share}/lintian/overrides" COMPONENT program)
install(FILES packaging/debian/copyright DESTINATION "${share}/doc/perilymph-dev" COMPONENT sdk)
# Devices of laboratories, built by the user against the maker's library.
install(DIRECTORY plugins/devices/common plugins/devices/novint plugins/devices/haply plugins/devices/3dsystems
  plugins/devices/force-dimension DESTINATION "${share}/doc/perilymph-dev/examples" COMPONENT sdk)

# The Python package; app/python installs its module.
if(TARGET perilymph_python)
  install(DIRECTORY resources/examples/python/ DESTINATION "${share}/doc/python3-perilymph/examples" COMPONENT python
    PATTERN __pycache__ EXCLUDE)
  install(FILES packaging/debian/copyright DESTINATION "${share}/doc/python3-perilymph" COMPONENT python)
  compressed(packaging/debian/changelog changelog "${share}/doc/python3-perilymph" python)
endif()

# The guide as HTML.
set(PERILYMPH_SITE "" CACHE PATH "Folder of the guide as HTML, written by packaging/site")
if(PERILYMPH_SITE)
  install(DIRECTORY "${PERILYMPH_SITE}/" DESTINATION "${share}/doc/perilymph-doc/html" COMPONENT guide)
  install(FILES packaging/debian/perilymph-doc.doc-base RENAME perilymph-doc COMPONENT guide DESTINATION "${share}/doc-base")
  install(FILES packaging/debian/perilymph-doc.lintian-overrides RENAME perilymph-doc COMPONENT guide
    DESTINATION "${share}/lintian/overrides")
  install(FILES packaging/debian/copyright DESTINATION "${share}/doc/perilymph-doc" COMPONENT guide)
  compressed(packaging/debian/changelog changelog "${share}/doc/perilymph-doc" guide)
endif()

# dpkg takes 0.3.0~dev for older than 0.3.0.
string(REPLACE "-" "~" CPACK_PACKAGE_VERSION "${PROJECT_VERSION}${PERILYMPH_VERSION_SUFFIX}")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME perilymph)
set(CPACK_PACKAGE_CONTACT "The Perilymph authors <maintainers@perilymph.example>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL program sdk)
if(TARGET perilymph_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
if(PERILYMPH_SITE)
  list(APPEND CPACK_COMPONENTS_ALL guide)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME perilymph)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "fonts-inter, fonts-dejavu-core, libgl1-mesa-dri, libqt5multimedia5-plugins")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_CONTROL_EXTRA
  "${CMAKE_SOURCE_DIR}/packaging/debian/postinst" "${CMAKE_SOURCE_DIR}/packaging/debian/postrm")
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "Perilymph builds the scala tympani from three measures of a patient, computes
how an electrode array bends, touches the wall and slides along it a thousand
times a second, and gives the force back to the hand, the screen and a
recording. The published experiment it is measured against comes with it.
.
For research and training. It is not a medical device.")
set(CPACK_DEBIAN_SDK_PACKAGE_NAME perilymph-dev)
set(CPACK_DEBIAN_SDK_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_SDK_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_SDK_PACKAGE_SUGGESTS "perilymph, cmake")
set(CPACK_DEBIAN_SDK_DESCRIPTION "The C header of Perilymph's device plug-ins, a CMake package that finds it, and
an example: a shared library built with these lets the workstation use a haptic
device of a kind it does not know.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-perilymph)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
# The module is for one version of Python; scenarios, arrays and patients are in the package perilymph.
if(Python_FOUND)
  math(EXPR next "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "perilymph (= ${CPACK_PACKAGE_VERSION}), python3-numpy, \
python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}), python3 (<< ${Python_VERSION_MAJOR}.${next})")
endif()
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-matplotlib")
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "Perilymph's computations for Python 3 with NumPy: cochleae from a patient's
measures, electrode arrays, simulated insertions, plans, and the reading of
studies and recordings.
.
For research and training. It is not a medical device.")
set(CPACK_DEBIAN_GUIDE_PACKAGE_NAME perilymph-doc)
set(CPACK_DEBIAN_GUIDE_PACKAGE_SECTION doc)
set(CPACK_DEBIAN_GUIDE_PACKAGE_ARCHITECTURE all)
# Scripts of the search, of the Sphinx that wrote the index.
if(PERILYMPH_SITE)
  execute_process(COMMAND dpkg-query -W -f "\${Version}" libjs-sphinxdoc OUTPUT_VARIABLE sphinx COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCH "^[0-9]+" sphinx "${sphinx}")
  math(EXPR next "${sphinx} + 1")
  set(CPACK_DEBIAN_GUIDE_PACKAGE_DEPENDS "libjs-sphinxdoc (>= ${sphinx}), libjs-sphinxdoc (<< ${next}~)")
endif()
set(CPACK_DEBIAN_GUIDE_PACKAGE_SUGGESTS "perilymph, www-browser")
set(CPACK_DEBIAN_GUIDE_DESCRIPTION "Perilymph's guide for a browser, without a network: tutorials in English and
German, glossary, methods, the reference of all keys and columns, and a search.")
include(CPack)
