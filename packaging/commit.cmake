# Writes HEADER with the commit of the sources, where it is not there already.
# usage: cmake -DSOURCES=DIR -DHEADER=FILE -P commit.cmake
execute_process(COMMAND git -C ${SOURCES} describe --always --dirty --exclude=*
  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
configure_file(${SOURCES}/resources/commit.h.in ${HEADER} @ONLY)
