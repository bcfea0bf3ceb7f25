#include <limn/core/AsyncGPUReadback.h>

#include <limn/core/Debug.h>
#include <limn/core/GraphicsBuffer.h>
#include <limn/core/GraphicsDevice.h>
#include <limn/core/RenderTexture.h>
#include <new>
#include <utility>

namespace limn
{

namespace
{

AsyncGPUReadbackRequest Begin(std::shared_ptr<PendingReadback> pending,
                              AsyncGPUReadback::Callback callback)
{
    pending->callback = std::move(callback);
    return AsyncGPUReadbackRequest(std::move(pending));
}

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

std::span<const std::byte> AsyncGPUReadbackRequest::Bytes(std::size_t elementSize) const
{
    if (!done() || hasError())
    {
        throw ContractError(done() ? "the read-back has no data: " + m_Pending->error()
                                   : "the read-back is not over; ask done() before, or call "
                                     "WaitForCompletion()");
    }
    const std::span<const std::byte> bytes = m_Pending->result().texels;
    if (bytes.size() % elementSize != 0)
    {
        throw ContractError("the read-back has " + std::to_string(bytes.size()) +
                            " bytes, which are no whole number of elements of " +
                            std::to_string(elementSize));
    }
    return bytes;
}

AsyncGPUReadbackRequest AsyncGPUReadback::Request(GraphicsDevice& device,
                                                  const RenderTexture& texture, Callback callback)
{
    return Begin(device.BeginReadBack(texture), std::move(callback));
}

AsyncGPUReadbackRequest AsyncGPUReadback::Request(GraphicsDevice& device,
                                                  const GraphicsBuffer& buffer, Callback callback)
{
    return Begin(device.BeginReadBack(buffer), std::move(callback));
}

void PendingReadback::Finish(bool waits)
{
    try
    {
        if (m_IsDone || (!waits && !isReady()))
        {
            return;
        }
        Wait();
        m_Result.texels = Take();
    }
    catch (const std::bad_alloc&)
    {
        m_Error = "there is not enough memory for a copy of it";
        m_HasError = true;
    }
    catch (const std::exception& error)
    {
        m_Error = error.what();
        m_HasError = true;
    }
    m_IsDone = true;
    Release();
    if (const auto call = std::exchange(callback, {}))
    {
        try
        {
            call(AsyncGPUReadbackRequest(shared_from_this()));
        }
        catch (const std::exception& error) // which is no fault of the frame that this happens in
        {
            Debug::LogException(error);
        }
    }
}

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
