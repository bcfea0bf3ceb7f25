#pragma once

#include "commands/CommandRun.h"
#include "vulkan/GpuTestDevice.h"

#include <gmock/gmock.h>
#include <limn/core/Image.h>

namespace limn::test
{

/// An orthographic camera that sees a square of two metres.
inline std::string CameraAt(const std::string& id, const std::string& name, float x,
                            const std::string& background, const std::string& more)
{
    return "--- !u!1 &" + id + "\nGameObject: {m_Name: " + name + ", m_IsActive: 1}\n--- !u!4 &" +
           id + "4\nTransform:\n  m_GameObject: {fileID: " + id +
           "}\n  m_LocalPosition: {x: " + std::to_string(x) +
           ", y: 0, z: -5}\n  m_Father: {fileID: 0}\n--- !u!20 &" + id +
           "5\nCamera:\n  m_GameObject: {fileID: " + id +
           "}\n  m_ClearFlags: 2\n  m_BackGroundColor: {" + background +
           "}\n  orthographic: 1\n  orthographic size: 1\n" + more;
}

/// Returns the line of a list of materials for the one of this guid.
inline std::string MaterialLine(const std::string& guid)
{
    return "  - {fileID: 2100000, guid: " + guid + ", type: 2}\n";
}

/// A quad in front of the cameras.
/// @param materials  lines
inline std::string QuadAt(const std::string& id, float x, float y, float width, float height,
                          const std::string& materials)
{
    return "--- !u!1 &" + id + "\nGameObject: {m_Name: Quad, m_IsActive: 1}\n--- !u!4 &" + id +
           "4\nTransform:\n  m_GameObject: {fileID: " + id +
           "}\n  m_LocalPosition: {x: " + std::to_string(x) + ", y: " + std::to_string(y) +
           ", z: 0}\n  m_LocalScale: {x: " + std::to_string(width) +
           ", y: " + std::to_string(height) + ", z: 1}\n  m_Father: {fileID: 0}\n--- !u!33 &" + id +
           "3\nMeshFilter:\n  m_GameObject: {fileID: " + id +
           "}\n  m_Mesh: {fileID: 10210, guid: 0000000000000000e000000000000000, type: 0}\n"
           "--- !u!23 &" +
           id + "2\nMeshRenderer:\n  m_GameObject: {fileID: " + id +
           "}\n  m_Enabled: 1\n  m_Materials:\n" + materials;
}
/// @param material  its guid
inline std::string QuadAt(const std::string& id, float x, float y, float size,
                          const std::string& material)
{
    return QuadAt(id, x, y, size, size, MaterialLine(material));
}

/// A Unity project in a folder of its own, whose scene is drawn.
class GpuTestOfAProject : public GpuTest
{
protected:
    void Write(const std::string& name, const std::string& text, const std::string& guid)
    {
        m_Folder.Write(name, text);
        m_Folder.Write(name + ".meta", "guid: " + guid + "\n");
    }
    void WriteAsset(const std::string& name, const std::string& text, const std::string& guid)
    {
        Write(name, "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n" + text, guid);
    }

    /// @return what limn says
    std::string Draw(const std::string& scene)
    {
        m_Folder.Write("Assets/Main.unity", "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n" + scene);
        const CommandRun run =
            RunCommand({"render", m_Folder / "Assets/Main.unity", "-o", m_Folder / "out.png",
                        "--size", m_Size + "x" + m_Size, "--validate"});
        EXPECT_EQ(0, run.exitCode) << run.err;
        m_Picture = ReadPng(m_Folder / "out.png");
        return run.err;
    }
    /// Returns the colour of a pixel: "0 255 0". 0, 0 is at the bottom left.
    std::string Pixel(int x, int y) const
    {
        const auto texel =
            static_cast<std::size_t>((m_Picture.height - 1 - y) * m_Picture.width + x);
        std::string color;
        for (std::size_t i = 0; i < 3; ++i)
        {
            color += (i ? " " : "") +
                     std::to_string(std::to_integer<int>(m_Picture.texels[4 * texel + i]));
        }
        return color;
    }
    /// Returns the colour in the middle of a quarter of a picture of 16x16 pixels.
    std::string Quarter(int x, int y) const { return Pixel(x * 8 + 4, y * 8 + 3); }

    TemporaryFolder m_Folder;
    Image m_Picture;
    std::string m_Size = "16"; ///< of the picture, in pixels either way
};

} // namespace limn::test
