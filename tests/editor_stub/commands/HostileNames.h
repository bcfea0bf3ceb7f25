#pragma once

#include "TemporaryFolder.h"

#include <gtest/gtest.h>
#include <sstream>

namespace limn::test
{

/// A name that clears a screen, begins a line as limn's errors do, goes back to its begin, turns
/// the direction of writing and more; raw, and as YAML and ShaderLab have it between quotes.
inline const std::string k_Hostile = "a\x1B[2J\nFORGED: error: \r\x7F\xE2\x80\xAE\xC2\x85z";
inline const std::string k_HostileYaml = R"("a\e[2J\nFORGED: error: \r\x7F\u202E\x85z")";
inline const std::string k_HostileFile = "f\x1B[2J\xE2\x80\xAE\x7F"; // no line's end: see #line

/// Nothing but lines of limn's own with characters that can be seen.
inline void ExpectHarmless(const std::string& text, const std::string& what)
{
    for (const unsigned char c : text)
    {
        EXPECT_TRUE((c >= 0x20 && c != 0x7F) || c == '\n' || c == '\t') << what << ": " << int{c};
    }
    for (const char* code : {"\xE2\x80\xAE", "\xC2\x85"})
    {
        EXPECT_EQ(std::string::npos, text.find(code)) << what;
    }
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
    {
        EXPECT_FALSE(line.starts_with("FORGED")) << what << ": " << text;
    }
}

/// A scene, a profile and a shader with such names wherever there are names.
inline void WriteHostileProject(const TemporaryFolder& folder)
{
    const std::string raw = "a\x1B[2J\r\x7F\xE2\x80\xAE\xC2\x85z"; // ShaderLab's end at a line's
    folder.Write(k_HostileFile + ".shader",
                 "Shader \"" + raw + "\" { Properties { _T (\"" + raw + "\", 2D) = \"" + raw +
                     "\" {} }\nSubShader { Tags { \"" + raw + "\" = \"" + raw +
                     "\" } Pass { Name \"" + raw + "\" Tags { \"LightMode\" = \"" + raw +
                     "\" }\nHLSLPROGRAM\n#pragma vertex V\n#pragma fragment F\n"
                     "#pragma multi_compile _ K\x1B[2J\n"
                     "float4 V(float4 p : POSITION) : SV_POSITION { return p; }\n"
                     "float4 F() : SV_Target { return 1; }\nENDHLSL } }\nFallback \"" +
                     raw + "\" }");
    folder.Write("plain.shader", "Shader \"" + raw + "\" { SubShader { Pass { Name \"" + raw +
                                     "\"\nHLSLPROGRAM\n#pragma vertex V\n#pragma fragment F\n"
                                     "float4 V(float4 p : POSITION) : SV_POSITION { return p; }\n"
                                     "float4 F() : SV_Target { return 1; }\nENDHLSL } } }");
    folder.Write(k_HostileFile + ".profile.yaml", "ScreenSpaceOutline: {m_OutlineWidth: 4}\n");
    folder.Write("s.scene.yaml",
                 "size: [16, 9]\ncamera: {position: [0, 0, -4]}\nlayers: {6: " + k_HostileYaml +
                     "}\nrenderingLayers: {8: " + k_HostileYaml +
                     "}\nrenderer:\n  features:\n    - type: ScreenSpaceOutlineRenderFeature\n"
                     "      name: " +
                     k_HostileYaml + "\n      m_LayerMask: [" + k_HostileYaml +
                     "]\n      m_RenderingLayerMask: " + k_HostileYaml +
                     "\nvolumes: [{name: " + k_HostileYaml +
                     ", profile: \"f\\e[2J\\u202E\\x7F.profile.yaml\"}]\n"
                     "materials: {" +
                     k_HostileYaml + ": {shader: plain.shader}}\nobjects:\n  - {name: " +
                     k_HostileYaml + ", mesh: cube, material: " + k_HostileYaml +
                     "}\n  - {name: b, mesh: cube, material: " + k_HostileYaml + "}\n");
}

} // namespace limn::test
