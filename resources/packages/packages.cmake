# cpack -G DEB (scripts/package.sh calls it): the .deb of Debian and Ubuntu, its dependencies told by the libraries the program is linked with.
# Caches of menus, icons and file types are rebuilt by triggers of their own packages: there are no scripts in ours.
set(COPPERSCOPE_PACKAGER "Copperscope contributors <contributors@copperscope.invalid>" CACHE STRING "Who made the package")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME copperscope)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "${COPPERSCOPE_PACKAGER}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "viewer for printed circuit boards")
set(CPACK_DEBIAN_PACKAGE_HOMEPAGE "${COPPERSCOPE_HOMEPAGE}")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SECTION electronics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "mesa-vulkan-drivers | vulkan-icd, hicolor-icon-theme")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "qt6-wayland")
set(CPACK_PACKAGE_DESCRIPTION "Opens ODB++ jobs, IPC-2581 files, boards of KiCad and Gerber jobs, and shows
every copper layer, solder mask, hole and pour at its true thickness, in 2D
and in 3D. Reviews stackups, follows nets, measures exactly, checks clearances
and design rules in a window and on the command line, and exports STEP, GLB,
DXF, SVG and PDF.")
# Everything in the package has the day of SOURCE_DATE_EPOCH, so that the same sources give the same bits.
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/same_day.cmake)
include(CPack)
