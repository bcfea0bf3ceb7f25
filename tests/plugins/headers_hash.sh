#!/usr/bin/env bash
# The number that plug-ins are checked by changes with what no size shows: virtual functions in
# another order. Usage: headers_hash.sh CMAKE HASH_HEADERS.cmake
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
hash()
{
    "$1" -DLIST="$folder/list" -DHEADER="$folder/hash.h" -P "$2"
    grep -oE '0x[0-9a-f]{16}ull' "$folder/hash.h"
}
printf '%s\n' "$folder/a b.h" "$folder/c.h" >"$folder/list"
echo 'struct A { virtual void F(); virtual void G(); };' >"$folder/a b.h"
echo 'int c;' >"$folder/c.h"
first=$(hash "$@")
[ "$(hash "$@")" = "$first" ]
echo 'struct A { virtual void G(); virtual void F(); };' >"$folder/a b.h"
second=$(hash "$@")
[ "$second" != "$first" ]
echo 'int cc;' >"$folder/c.h"
[ "$(hash "$@")" != "$second" ]
