# cmake --install: the program, its sample board and guide, what a desktop knows of it, licences. The manual is added by app/manual.cmake.
# Places are those of GNUInstallDirs. The program finds sample and guide beside itself, so the whole tree may be moved.
include(GNUInstallDirs)
set(COPPERSCOPE_RELEASE_DATE "2026-11-24" CACHE STRING "The day of this version, as AppStream shows it")
set(COPPERSCOPE_HOMEPAGE "" CACHE STRING "Where the project is to be found, for AppStream and packages")
set(COPPERSCOPE_HOMEPAGE_TAG "")
if(COPPERSCOPE_HOMEPAGE)
    set(COPPERSCOPE_HOMEPAGE_TAG "\n  <url type=\"homepage\">${COPPERSCOPE_HOMEPAGE}</url>")
endif()
set(desktop ${CMAKE_CURRENT_LIST_DIR})
set(id org.copperscope.Copperscope)

install(TARGETS copperscope RUNTIME)
install(FILES ${PROJECT_SOURCE_DIR}/resources/sample/ocp_tap_sa45_odb.tgz ${PROJECT_SOURCE_DIR}/resources/sample/ATTRIBUTION.md
    DESTINATION ${CMAKE_INSTALL_DATADIR}/copperscope/sample)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/guide DESTINATION ${CMAKE_INSTALL_DATADIR}/copperscope)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/resources/packages/copyright
    DESTINATION ${CMAKE_INSTALL_DOCDIR})

add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/changelog.gz DEPENDS ${PROJECT_SOURCE_DIR}/CHANGELOG.md
    COMMAND sh -c "\"$0\" -9nc \"$1\" > \"$2\"" ${GZIP} ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${PROJECT_BINARY_DIR}/changelog.gz VERBATIM)
add_custom_target(changelog ALL DEPENDS ${PROJECT_BINARY_DIR}/changelog.gz)
install(FILES ${PROJECT_BINARY_DIR}/changelog.gz DESTINATION ${CMAKE_INSTALL_DOCDIR})

if(COPPERSCOPE_GUI)
    configure_file(${desktop}/${id}.metainfo.xml.in ${PROJECT_BINARY_DIR}/desktop/${id}.metainfo.xml @ONLY)
    install(FILES ${desktop}/${id}.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
    install(FILES ${PROJECT_BINARY_DIR}/desktop/${id}.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
    install(FILES ${desktop}/${id}.mime.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages RENAME ${id}.xml)
    install(FILES ${desktop}/icons/copperscope.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
    foreach(size IN ITEMS 16 22 24 32 48 64 128 256)
        install(FILES ${desktop}/icons/copperscope-${size}.png
            DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/${size}x${size}/apps RENAME copperscope.png)
    endforeach()
endif()
