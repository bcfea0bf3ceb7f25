# cmake -DLIST=FILE -DHEADER=FILE -P HashHeaders.cmake
# Writes a header with LIMN_HEADERS_HASH, a number that hangs on the text of all files that LIST
# names, one a line.
file(STRINGS ${LIST} files)
set(text "")
foreach(path ${files})
    file(SHA256 ${path} hash)
    string(APPEND text "${hash}\n")
endforeach()
string(SHA256 hash "${text}")
string(SUBSTRING ${hash} 0 16 hash)
file(WRITE ${HEADER} "#pragma once

/// Of the text of all public headers of limn that these belong to.
#define LIMN_HEADERS_HASH 0x${hash}ull
")
