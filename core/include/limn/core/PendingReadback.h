#pragma once

#include <limn/core/AsyncGPUReadback.h>

namespace limn
{

/// What a device does for an AsyncGPUReadbackRequest.
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
    /// Nothing is asked of it any more.
    virtual void Release() noexcept {}

private:
    Image m_Result;
    bool m_IsDone = false;
    bool m_HasError = false;
    std::string m_Error;
};

} // namespace limn
