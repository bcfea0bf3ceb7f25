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
class PendingReadback;

/// A copy from the device to the CPU that frames do not wait for. Copies of the request are the
/// same one; it may outlive its device, which finishes it at its end.
/// @source Unity: AsyncGPUReadbackRequest (2022.3)
class AsyncGPUReadbackRequest
{
public:
    explicit AsyncGPUReadbackRequest(std::shared_ptr<PendingReadback> pending);

    /// Whether it is over, as of the last frame that was executed, Update() or WaitForCompletion().
    bool done() const;
    /// Whether it is over without a result: the device was lost.
    bool hasError() const;
    /// Looks whether it is over, and calls the callback if so. A device does that before each
    /// frame.
    void Update();
    /// Returns when it is over and the callback has been called. Nothing is stopped but this
    /// thread.
    void WaitForCompletion();

    /// Returns the texels of a texture as it stores them, the bottom row of its picture first, or a
    /// buffer's elements. They live as long as a copy of the request.
    /// @throws ContractError if it is not over, or has an error, or is no whole number of elements
    template <typename Element>
    std::span<const Element> GetData() const
    {
        static_assert(std::is_trivially_copyable_v<Element>);
        const std::span<const std::byte> bytes = Bytes(sizeof(Element));
        return {reinterpret_cast<const Element*>(bytes.data()), bytes.size() / sizeof(Element)};
    }
    int width() const;                 ///< texels; of a buffer its bytes
    int height() const;                ///< texels; of a buffer 1
    std::size_t layerDataSize() const; ///< bytes; 0 before it is over

private:
    std::span<const std::byte> Bytes(std::size_t elementSize) const;

    std::shared_ptr<PendingReadback> m_Pending;
};

/// Begins copies of what the last frame left. Unity's knows the device by itself.
/// @source Unity: AsyncGPUReadback (2022.3)
class AsyncGPUReadback
{
public:
    using Callback = std::function<void(const AsyncGPUReadbackRequest&)>;

    /// @param texture  an output of the last frame
    /// @param callback called once, in a call of the device or of the request, also on an error
    /// @throws ContractError if it was none
    static AsyncGPUReadbackRequest Request(GraphicsDevice& device, const RenderTexture& texture,
                                           Callback callback = {});
    /// @throws ContractError if no frame has used the buffer
    static AsyncGPUReadbackRequest Request(GraphicsDevice& device, const GraphicsBuffer& buffer,
                                           Callback callback = {});
};

/// The device's side of an AsyncGPUReadbackRequest, which each device implements.
class PendingReadback : public std::enable_shared_from_this<PendingReadback>
{
public:
    /// @param shape  size and format of the result; of a buffer one row of R8_UNorm
    explicit PendingReadback(Image shape) : m_Result(std::move(shape)) {}
    virtual ~PendingReadback() = default;
    PendingReadback(const PendingReadback&) = delete;
    PendingReadback& operator=(const PendingReadback&) = delete;

    /// Takes the result if it is there, or if `waits` when it is, and calls the callback then. What
    /// goes wrong on the device ends it with hasError(); what the callback throws goes to
    /// Debug::LogException, as in Unity.
    void Finish(bool waits);

    bool isDone() const { return m_IsDone; }
    bool hasError() const { return m_HasError; }
    /// Why there are no texels; empty without an error.
    const std::string& error() const { return m_Error; }
    /// Without texels before it is done.
    const Image& result() const { return m_Result; }

    AsyncGPUReadback::Callback callback; ///< may be empty

protected:
    virtual bool isReady() = 0; ///< whether the result is there
    virtual void Wait() = 0;    ///< until it is
    /// @pre it is
    virtual std::vector<std::byte> Take() = 0;
    /// Comes last, so that a device can free what the copy holds.
    virtual void Release() noexcept {}

private:
    Image m_Result;
    bool m_IsDone = false;
    bool m_HasError = false;
    std::string m_Error;
};

} // namespace limn
