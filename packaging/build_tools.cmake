# The compiler cache and the linker. Both are optional: a build without them gives the same programs.

option(GLISSADE_COMPILER_CACHE "Take what was compiled before from ccache, where it is installed" ON)
if(GLISSADE_COMPILER_CACHE)
  find_program(GLISSADE_CCACHE ccache)
  if(GLISSADE_CCACHE)
    # Paths below the checkout are hashed relative to it, so that a clone in another folder finds what this one left.
    # The language of messages, which packaging/test.sh sets and people do not, changes no program.
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=true
      CCACHE_SLOPPINESS=pch_defines,time_macros,locale CCACHE_MAXSIZE=20G ${GLISSADE_CCACHE})
    # The macro __FILE__, which GoogleTest's assertions hold, would differ between two clones.
    add_compile_options(-fmacro-prefix-map=${CMAKE_SOURCE_DIR}/=)
    # The cache knows a compilation with a precompiled header only by this option.
    add_compile_options($<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
  endif()
endif()

# mold links the test programs in a tenth of the time of GNU ld.
find_program(GLISSADE_MOLD mold)
if(GLISSADE_MOLD)
  add_link_options(-fuse-ld=mold)
endif()
