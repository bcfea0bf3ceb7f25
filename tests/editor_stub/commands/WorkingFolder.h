#pragma once

#include "TemporaryFolder.h"

namespace limn::test
{

/// A new, empty folder that is the working folder until the object goes away.
class WorkingFolder
{
public:
    WorkingFolder() { std::filesystem::current_path(folder / ""); }
    ~WorkingFolder()
    {
        std::error_code ignored;
        std::filesystem::current_path(m_Before, ignored);
    }
    WorkingFolder(const WorkingFolder&) = delete;
    WorkingFolder& operator=(const WorkingFolder&) = delete;

private:
    std::filesystem::path m_Before = std::filesystem::current_path();

public:
    TemporaryFolder folder;
};

/// Shader, profile, scene and expectations that refer to each other by bare names, written into
/// `folder`.
inline void WriteProject(const TemporaryFolder& folder)
{
    folder.Write("a.shader", "Shader \"A\"\n"
                             "{\n"
                             "    SubShader\n"
                             "    {\n"
                             "        Pass\n"
                             "        {\n"
                             "            HLSLPROGRAM\n"
                             "            #pragma vertex V\n"
                             "            #pragma fragment F\n"
                             "            #pragma multi_compile _ RED\n"
                             "            #include \"a.hlsl\"\n"
                             "            ENDHLSL\n"
                             "        }\n"
                             "    }\n"
                             "    Fallback \"B\"\n"
                             "}\n");
    folder.Write("a.hlsl", "float4 V(float4 p : POSITION) : SV_POSITION { return p; }\n"
                           "float4 F() : SV_Target { return 1; }\n");
    folder.Write("b.shader", "Shader \"B\" { SubShader { Pass { } } }\n");
    folder.Write("p.profile.yaml", "ScreenSpaceOutline:\n  m_OutlineWidth: 4\n");
    folder.Write("s.scene.yaml", "size: [16, 9]\n"
                                 "camera: {position: [0, 0, -4]}\n"
                                 "volumes: [{name: All, profile: p.profile.yaml}]\n"
                                 "materials: {m: {shader: a.shader}}\n"
                                 "objects: [{name: Piece, mesh: cube, material: m}]\n");
    folder.Write("e.yaml", "order: [Draw Opaque Objects, Draw Transparent Objects, Final Blit]\n");
}

} // namespace limn::test
