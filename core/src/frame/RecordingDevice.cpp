#include <limn/core/RecordingDevice.h>
#include <limn/shaderlab/Diagnostic.h>

namespace limn
{

Image RecordingDevice::ReadBack(const RenderTexture& texture)
{
    throw ContractError("RecordingDevice draws nothing, so '" + texture.name() +
                        "' has no texels to read back");
}

} // namespace limn
