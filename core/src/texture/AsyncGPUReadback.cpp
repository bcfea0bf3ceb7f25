#include <limn/core/AsyncGPUReadback.h>

#include <limn/core/Debug.h>
#include <limn/core/GraphicsBuffer.h>
#include <limn/core/GraphicsDevice.h>
#include <limn/core/RenderTexture.h>
#include <new>
#include <utility>

namespace limn
{

AsyncGPUReadbackRequest::AsyncGPUReadbackRequest(std::shared_ptr<PendingReadback> pending)
    : m_Pending(std::move(pending))
{
}

bool AsyncGPUReadbackRequest::done() const
{
    return m_Pending->isDone();
}

bool AsyncGPUReadbackRequest::hasError() const
{
    return m_Pending->hasError();
}

void AsyncGPUReadbackRequest::Update()
{
    m_Pending->Finish(false);
}

void AsyncGPUReadbackRequest::WaitForCompletion()
{
    m_Pending->Finish(true);
}

int AsyncGPUReadbackRequest::width() const
{
    return m_Pending->result().width;
}

int AsyncGPUReadbackRequest::height() const
{
    return m_Pending->result().height;
}

std::size_t AsyncGPUReadbackRequest::layerDataSize() const
{
    return m_Pending->result().texels.size();
}

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

namespace
{

AsyncGPUReadbackRequest Begin(std::shared_ptr<PendingReadback> pending,
                              AsyncGPUReadback::Callback callback)
{
    pending->callback = std::move(callback);
    return AsyncGPUReadbackRequest(std::move(pending));
}

} // namespace

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

} // namespace limn
