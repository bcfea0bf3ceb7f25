#include <limn/core/GraphicsDevice.h>

#include <limn/core/AsyncGPUReadback.h>

namespace limn
{

namespace
{

/// A read-back whose data was there already.
class FinishedReadback final : public PendingReadback
{
public:
    explicit FinishedReadback(Image image)
        : PendingReadback({image.width, image.height, image.format, {}}),
          m_Texels(std::move(image.texels))
    {
    }

private:
    bool isReady() override { return true; }
    void Wait() override {}
    std::vector<std::byte> Take() override { return std::move(m_Texels); }

    std::vector<std::byte> m_Texels;
};

} // namespace

std::shared_ptr<PendingReadback> GraphicsDevice::BeginReadBack(const RenderTexture& texture)
{
    Image image = ReadBack(texture);
    if (!texture.descriptor().isTopRowFirst)
    {
        image.texels = FlipRows(image.texels, image.height);
    }
    return std::make_shared<FinishedReadback>(std::move(image));
}

std::shared_ptr<PendingReadback> GraphicsDevice::BeginReadBack(const GraphicsBuffer& buffer)
{
    std::vector<std::byte> bytes = ReadBackBuffer(buffer);
    return std::make_shared<FinishedReadback>(
        Image{static_cast<int>(bytes.size()), 1, GraphicsFormat::R8_UNorm, std::move(bytes)});
}

std::vector<std::byte> GraphicsDevice::ReadBackBuffer(const GraphicsBuffer& buffer)
{
    throw ContractError("this device runs no kernels, so buffer '" + buffer.name() +
                        "' has no contents to read back");
}

} // namespace limn
