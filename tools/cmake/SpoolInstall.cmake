# cmake --install: programs and their driver set in lib/spoolsight, links to them in bin, the sample, the
# desktop's entry and icon. A driver of a camera's maker is dropped into lib/spoolsight/openni2/OpenNI2/Drivers.
set(SPOOL_HOME lib/spoolsight)
set(SPOOL_INSTALLED spoolsight spoolsight-inspect spoolsight-convert spoolsight-job spoolsight-record)

install(TARGETS ${SPOOL_INSTALLED} spoolsight-oni-check RUNTIME DESTINATION ${SPOOL_HOME}/bin)
if(SPOOL_OPENNI)
  # Links to the system's library and drivers; the simulated camera is for tests and stays behind.
  install(DIRECTORY ${CMAKE_BINARY_DIR}/openni2 DESTINATION ${SPOOL_HOME} USE_SOURCE_PERMISSIONS
    PATTERN "libSpoolSim*" EXCLUDE)
endif()
# A program finds what belongs to it beside itself, through the link.
install(CODE "
  set(bin \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/bin\")
  file(MAKE_DIRECTORY \"\${bin}\")
  foreach(program ${SPOOL_INSTALLED})
    file(CREATE_LINK ../${SPOOL_HOME}/bin/\${program} \"\${bin}/\${program}\" SYMBOLIC)
  endforeach()")

install(DIRECTORY assets/sample DESTINATION share/spoolsight)
install(FILES assets/report.schema.json assets/ncr.schema.json DESTINATION share/spoolsight)
install(FILES assets/desktop/spoolsight.desktop DESTINATION share/applications)
install(FILES assets/desktop/spoolsight.svg DESTINATION share/icons/hicolor/scalable/apps)
install(FILES assets/desktop/spoolsight-mime.xml DESTINATION share/mime/packages RENAME spoolsight.xml)
install(FILES README.md LICENSE DESTINATION share/doc/spoolsight)
