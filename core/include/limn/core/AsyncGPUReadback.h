#pragma once

#include <cstddef>
#include <functional>
#include <limn/core/Image.h>
#include <memory>
#include <span>
#include <type_traits>

namespace limn
{

class GraphicsBuffer;
class GraphicsDevice;
class RenderTexture;
class AsyncGPUReadbackRequest;

/// The device's side of an AsyncGPUReadbackRequest, which each device implements.
class PendingReadback : public std::enable_shared_from_this<PendingReadback>
{
public:
    /// @param shape  size and format of the result; of a buffer one row of R8_UNorm
    explicit PendingReadback(Image shape) : m_Result(std::move(shape)) {}
    virtual ~PendingReadback() = default;
    PendingReadback(const PendingReadback&) = delete;
    PendingReadback& operator=(const PendingReadback&) = delete;

    /// Takes the result and calls the callback if the result is there; if `waits`, waits for it
    /// first. A failure of the device ends the readback with hasError(). An exception of the
    /// callback goes to Debug::LogException, as in Unity.
    void Finish(bool waits);

    bool isDone() const { return m_IsDone; }
    bool hasError() const { return m_HasError; }
    /// Returns why there are no texels; empty without an error.
    const std::string& error() const { return m_Error; }
    /// Returns the result, which has no texels before the readback is done.
    const Image& result() const { return m_Result; }

    std::function<void(const AsyncGPUReadbackRequest&)> callback; ///< may be empty

protected:
    virtual bool isReady() = 0; ///< returns whether the result is there
    virtual void Wait() = 0;    ///< waits until the result is there
    /// Returns the bytes of the result.
    /// @pre the result is there
    virtual std::vector<std::byte> Take() = 0;
    /// Frees what the copy holds. It is called last.
    virtual void Release() noexcept {}

private:
    Image m_Result;
    bool m_IsDone = false;
    bool m_HasError = false;
    std::string m_Error;
};

/// A copy from the device to the CPU that frames do not wait for. Copies of the request stand for
/// the same readback. A request may outlive its device, which finishes it when it is destroyed.
/// @source Unity: AsyncGPUReadbackRequest (2022.3)
class AsyncGPUReadbackRequest
{
public:
    explicit AsyncGPUReadbackRequest(std::shared_ptr<PendingReadback> pending)
        : m_Pending(std::move(pending))
    {
    }

    /// Returns whether the readback is over, as of the last executed frame, Update() or
    /// WaitForCompletion().
    bool done() const { return m_Pending->isDone(); }
    /// Returns whether the readback is over without a result because the device was lost.
    bool hasError() const { return m_Pending->hasError(); }
    /// Checks whether the readback is over, and calls the callback if so. A device does that before
    /// each frame.
    void Update() { m_Pending->Finish(false); }
    /// Waits until the readback is over and the callback has been called. Only this thread is
    /// blocked.
    void WaitForCompletion() { m_Pending->Finish(true); }

    /// Returns the texels of a texture as it stores them, the bottom row of its picture first, or
    /// the elements of a buffer. They live as long as a copy of the request.
    /// @throws ContractError if the readback is not over, has an error, or is no whole number of
    ///     elements
    template <typename Element>
    std::span<const Element> GetData() const
    {
        static_assert(std::is_trivially_copyable_v<Element>);
        const std::span<const std::byte> bytes = Bytes(sizeof(Element));
        return {reinterpret_cast<const Element*>(bytes.data()), bytes.size() / sizeof(Element)};
    }
    int width() const { return m_Pending->result().width; }   ///< texels; bytes of a buffer
    int height() const { return m_Pending->result().height; } ///< texels; 1 for a buffer
    /// bytes; 0 before the readback is over
    std::size_t layerDataSize() const { return m_Pending->result().texels.size(); }

private:
    std::span<const std::byte> Bytes(std::size_t elementSize) const;

    std::shared_ptr<PendingReadback> m_Pending;
};

/// Starts copies of what the last frame left. Unity's class knows the device by itself.
/// @source Unity: AsyncGPUReadback (2022.3)
class AsyncGPUReadback
{
public:
    using Callback = std::function<void(const AsyncGPUReadbackRequest&)>;

    /// @param texture  an output of the last frame
    /// @param callback called once, in a call of the device or of the request, also on an error
    /// @throws ContractError if the texture was no output of the last frame
    static AsyncGPUReadbackRequest Request(GraphicsDevice& device, const RenderTexture& texture,
                                           Callback callback = {});
    /// @throws ContractError if no frame has used the buffer
    static AsyncGPUReadbackRequest Request(GraphicsDevice& device, const GraphicsBuffer& buffer,
                                           Callback callback = {});
};

} // namespace limn
