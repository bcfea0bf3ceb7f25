#!/usr/bin/env bash
# The figures of samples/porting/README.md are what share.py prints, and no worse than they were.
# Usage: share.sh REPOSITORY
set -euo pipefail
cd "$1/samples/porting"
printed=$(./share.py)
quoted=$(sed -n '/share.py$/,/^    all /p' README.md | sed '1d; s/^    //')
[ "$printed" = "$quoted" ] || { printf 'README.md says\n%s\nshare.py says\n%s\n' "$quoted" "$printed" >&2; exit 1; }
awk '$4 < 90 { exit 1 }' <<<"$printed" || { echo "of one of the features less than 90 % goes over" >&2; exit 1; }
# A file with each call of URP 14 once, however seldom a feature makes it.
each=../../tests/editor_stub/data/port/ToolboxFeature
share=$(./share.py $each.cs $each.h | sed -n 's/^all .* \([0-9.]*\) %.*/\1 %/p')
grep -qF "it is $share:" README.md || { echo "of ToolboxFeature.cs it is $share; README.md says otherwise" >&2; exit 1; }
# It is the same of a port in one header and of the same port split into a header and a source.
split=$(mktemp -d)
trap 'rm -rf "$split"' EXIT
for header in */*Feature.h $each.h; do
    python3 -B ../../tests/porting/split.py "$header" "$split"
    name=$(basename "$header" .h)
    whole=$(./share.py "${header%.h}.cs" "$header")
    parts=$(./share.py "${header%.h}.cs" "$split/$name.h" "$split/$name.cpp")
    [ "$whole" = "$parts" ] || { printf '%s as one header:\n%s\nsplit:\n%s\n' "$name" "$whole" "$parts" >&2; exit 1; }
done
# So it is of a pass whose class stands in the source, and of C# with a byte-order mark, a namespace,
# a region and lines for the editor.
printf '\xef\xbb\xbfusing UnityEngine;\nnamespace Own\n{\n#region Passes\nclass A : Feature\n{\n    class P : Pass\n    {\n        void Run()\n        {\n            m_Copy?.Release();\n        }\n    }\n#if UNITY_EDITOR\n    int m_Shown;\n#endif\n    P m_P;\n}\n#endregion\n}\n' >"$split/A.cs"
printf 'namespace Own\n{\nclass A : public Feature\n{\n    class P;\n    P m_P;\n};\n}\n' >"$split/A.h"
printf 'namespace Own\n{\nclass A::P final : public Pass\n{\n    void Run() { m_Copy.Release(); }\n};\n}\n' >"$split/A.cpp"
nested=$(./share.py "$split/A.cs" "$split/A.h" "$split/A.cpp" | sed -n '$p')
[ "$nested" = "all                             5 lines, 100.0 % as they are" ] || { echo "a pass in the source counts as '$nested'" >&2; exit 1; }
# Several files of C# and of C++ are one port, and what is missing is said.
cat blurred_glass/BlurredGlassFeature.cs xray/XRayFeature.cs >"$split/Both.cs"
cat blurred_glass/BlurredGlassFeature.h xray/XRayFeature.h >"$split/Both.h"
one=$(./share.py "$split/Both.cs" "$split/Both.h" | sed -n '$p')
several=$(./share.py blurred_glass/BlurredGlassFeature.cs xray/XRayFeature.cs blurred_glass/BlurredGlassFeature.h xray/XRayFeature.h | sed -n '$p')
[ "$one" = "$several" ] || { echo "'$one' of one file is '$several' of several" >&2; exit 1; }
if ./share.py xray/XRayFeature.cs 2>"$split/said"; then echo "a port without C++ is counted" >&2; exit 1; fi
grep -q "its C++ is expected behind it" "$split/said"
