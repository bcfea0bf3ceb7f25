#!/usr/bin/env bash
# Makes the Debian package of a release build, unpacks it into an empty folder and looks at what is
# there. Usage: package.sh BUILD_TREE
set -euo pipefail
folder=$1/packaged
trap 'rm -rf "$folder"' EXIT
rm -rf "$folder"
cpack --config "$1/CPackConfig.cmake" -G DEB -B "$folder" >/dev/null
package=$(echo "$folder"/limn_*.deb)
for depends in libvulkan1 libpng16-16 libyaml-cpp; do
    dpkg-deb -f "$package" Depends | grep -q "$depends" ||
        { echo "package.sh: the package does not depend on $depends" >&2; exit 1; }
done
dpkg-deb -x "$package" "$folder/root"
[ -f "$folder/root/usr/share/zsh/vendor-completions/_limn" ]
"$(dirname "$0")/installed.sh" "$folder/root/usr"
