# The pages of all public headers, by Doxygen: `cmake --build build/release --target api_pages` writes
# them to <build folder>/api/html/index.html. A warning of Doxygen's fails the target.
find_package(Doxygen QUIET)
if(NOT DOXYGEN_FOUND)
    return()
endif()
set(DOXYGEN_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/api)
set(DOXYGEN_FILE_PATTERNS *.h)
set(DOXYGEN_RECURSIVE YES)
set(DOXYGEN_EXCLUDE_PATTERNS */src/*)
set(DOXYGEN_EXCLUDE_SYMBOLS limn::detail*)
set(DOXYGEN_STRIP_FROM_PATH ${PROJECT_SOURCE_DIR})
# Doxygen 1.9.4 finds no scope for a specialisation that is written as std::hash.
set(DOXYGEN_FILTER_PATTERNS "*/ShaderId.h=sed s/std::hash/hash/")
set(DOXYGEN_JAVADOC_AUTOBRIEF YES)
set(DOXYGEN_EXTRACT_ALL YES)
set(DOXYGEN_ALIASES [[lifetime=@par Lifetime^^]] [[source=@par Source^^]])
set(DOXYGEN_HAVE_DOT NO)
set(DOXYGEN_QUIET YES)
set(DOXYGEN_WARN_IF_INCOMPLETE_DOC NO) # comments describe the parameters whose names do not
set(DOXYGEN_WARN_AS_ERROR FAIL_ON_WARNINGS)
doxygen_add_docs(api_pages shaderlab core volume features editor_stub/include
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} COMMENT "Writing the pages of the public headers")
