# SPDX-License-Identifier: BSD-3-Clause

# Installation in components, of each of which packaging/debian makes a package:
#   program  perilymph          both programs and what they need
#   sdk      perilymph-dev      the header of device plug-ins and its CMake package
#   python   python3-perilymph  the Python package, with its examples
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
install(FILES packaging/man/perilymph.1 packaging/man/perilymph-cli.1 DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT program)

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
# Devices of laboratories, built by the user against the maker's library.
install(DIRECTORY plugins/devices/common plugins/devices/novint plugins/devices/haply plugins/devices/3dsystems
  plugins/devices/force-dimension DESTINATION "${share}/doc/perilymph-dev/examples" COMPONENT sdk)

# The Python package; app/python installs its module.
if(TARGET perilymph_python)
  install(DIRECTORY resources/examples/python/ DESTINATION "${share}/doc/python3-perilymph/examples" COMPONENT python
    PATTERN __pycache__ EXCLUDE)
endif()
