#pragma once

#include <functional>
#include <limn/limn.h>
#include <string>
#include <vector>

namespace limn::test
{

/// That members differ as porting.txt says. Expectations of GoogleTest's say where they do not.
struct DiffersCheck
{
    std::vector<std::string> keys; ///< "Type.Member"
    std::function<void()> check;
};
using DiffersChecks = std::vector<DiffersCheck>;

// By what they are about.
DiffersChecks CommandDiffers();
DiffersChecks MaterialDiffers();
DiffersChecks ShaderDiffers();
DiffersChecks TargetDiffers();
DiffersChecks CameraDiffers();
DiffersChecks GraphDiffers();
DiffersChecks PipelineDiffers();

/// "Type.a", "Type.b" …
inline std::vector<std::string> Members(const std::string& type,
                                        std::initializer_list<const char*> members)
{
    std::vector<std::string> keys;
    for (const char* member : members)
    {
        keys.push_back(type + "." + member);
    }
    return keys;
}
inline std::vector<std::string> OfEach(std::initializer_list<const char*> types,
                                       std::initializer_list<const char*> members)
{
    std::vector<std::string> keys;
    for (const char* type : types)
    {
        const std::vector<std::string> more = Members(type, members);
        keys.insert(keys.end(), more.begin(), more.end());
    }
    return keys;
}

const std::shared_ptr<ShaderCompiler>& DiffersCompiler();
/// Without a device and without textures, of one pass; with a _Width of 2 in its Properties.
std::shared_ptr<const Shader> DiffersShader();

/// What a command buffer comes to while a camera is rendered.
class RecordedFrame
{
public:
    explicit RecordedFrame(const std::function<void(CommandBuffer&)>& record,
                           const std::function<void()>& beforeExecute = {});

    std::vector<DrawCommand> draws() const;
    template <typename Command>
    std::vector<Command> Of() const
    {
        std::vector<Command> found;
        for (const FrameCommand& command : commands.commands)
        {
            if (const auto* wanted = std::get_if<Command>(&command))
            {
                found.push_back(*wanted);
            }
        }
        return found;
    }

    FrameCommands commands;
    RenderReport report;
    RTHandle color; ///< the camera's, 8x4
    RTHandle depth;
};

} // namespace limn::test
