#pragma once

#include <cstddef>
#include <cstdint>
#include <limn/base/Diagnostic.h>
#include <limn/core/Flags.h>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace limn
{

class GraphicsDevice;

namespace detail
{

/// A vector, an array or a span: elements that are contiguous in memory.
template <typename Data>
concept Contiguous = requires(const Data& data)
{
    std::span(std::data(data), std::size(data));
};

} // namespace detail

/// A buffer of elements that shaders read and kernels write. Like a Texture it is a description:
/// the device makes its buffer, all zeros, when a frame first uses it, and frees it some frames
/// after the last owner is gone. It must not be used by several threads at once.
/// Unity: UnityEngine.GraphicsBuffer (2022.3).
class GraphicsBuffer
{
public:
    /// The uses that a buffer can be bound to; bit flags with Unity's values.
    /// Unity: GraphicsBuffer.Target.
    enum class Target
    {
        Vertex = 1,
        Index = 2,
        CopySource = 4,
        CopyDestination = 8,
        Structured = 16, ///< StructuredBuffer, RWStructuredBuffer
        Raw = 32,        ///< ByteAddressBuffer, RWByteAddressBuffer
        Append = 64,     ///< AppendStructuredBuffer, ConsumeStructuredBuffer
        Counter = 128,   ///< RWStructuredBuffer with IncrementCounter and DecrementCounter
        /// Arguments of draws and dispatches; kernels may write them like those above.
        IndirectArguments = 256,
        Constant = 512 ///< cbuffer
    };

    /// @param stride  the bytes of one element: the size of a kernel's struct without padding
    ///     between its members
    /// @throws ContractError if count or stride is not positive, the stride of structured elements
    ///     is no multiple of 4 or above 2048, that of raw ones is not 4, or the target is none of
    ///     those that limn binds: Structured, Raw, Append, Counter, IndirectArguments, Constant
    GraphicsBuffer(Target target, int count, int stride);
    GraphicsBuffer(const GraphicsBuffer&) = delete;
    GraphicsBuffer& operator=(const GraphicsBuffer&) = delete;

    std::uint64_t id() const { return m_Id; } ///< unique in the process, never used again
    const std::string& name() const { return m_Name; }
    void SetName(std::string name) { m_Name = std::move(name); } ///< for messages and captures
    Target target() const { return m_Target; }
    int count() const { return m_Count; }
    int stride() const { return m_Stride; }
    /// bytes of all elements
    std::size_t size() const
    {
        return static_cast<std::size_t>(m_Count) * static_cast<std::size_t>(m_Stride);
    }
    bool Has(Target flag) const;

    /// Sets the elements from the first on, before anything that is executed next; the elements
    /// behind them stay. It overwrites what a kernel wrote there before.
    /// @throws ContractError if `data` has more elements than the buffer, or the buffer is released
    template <detail::Contiguous Data>
    void SetData(const Data& data)
    {
        Set(PartOf(data));
    }
    /// @param managedBufferStartIndex, count  the elements of `data` to copy
    /// @param graphicsBufferStartIndex        their place in the buffer, in elements of `data`
    template <detail::Contiguous Data>
    void SetData(const Data& data, int managedBufferStartIndex, int graphicsBufferStartIndex,
                 int count)
    {
        Set(PartOf(data, managedBufferStartIndex, graphicsBufferStartIndex, count));
    }
    /// Sets the counter of a buffer that is appended to or counts.
    /// @throws ContractError if the buffer has no counter
    void SetCounterValue(std::uint32_t counterValue);

    /// Copies the first elements into `data` as the last frame on the device left them, and waits
    /// for that frame. Unity's function knows the device by itself.
    /// @throws ContractError if `data` is longer, or no frame on the device has used the buffer
    template <typename Element>
    void GetData(GraphicsDevice& device, std::span<Element> data) const
    {
        static_assert(std::is_trivially_copyable_v<Element>);
        GetBytes(device, std::as_writable_bytes(data));
    }
    template <typename Element>
    void GetData(GraphicsDevice& device, std::vector<Element>& data) const
    {
        GetData(device, std::span<Element>(data));
    }
    /// Returns the counter, as GetData does. Unity: GraphicsBuffer.CopyCount into a buffer to read.
    /// @throws ContractError if the buffer has no counter
    std::uint32_t GetCounterValue(GraphicsDevice& device) const;

    /// Releases the buffer, which cannot be bound any more.
    void Release();
    void Dispose() { Release(); }
    bool IsValid() const { return !m_IsReleased; }

    /// The bytes that SetData sets.
    struct Part
    {
        std::span<const std::byte> bytes; ///< bytes of `data`
        std::size_t offset = 0;           ///< bytes of the buffer
    };
    template <detail::Contiguous Data>
    static Part PartOf(const Data& data)
    {
        return {std::as_bytes(Elements(data)), 0};
    }
    /// @throws ContractError if a number is negative, or `data` has too few elements
    template <detail::Contiguous Data>
    static Part PartOf(const Data& data, int managedBufferStartIndex, int graphicsBufferStartIndex,
                       int count)
    {
        const auto elements = Elements(data);
        ExpectPart(managedBufferStartIndex, graphicsBufferStartIndex, count, elements.size());
        const auto part = elements.subspan(static_cast<std::size_t>(managedBufferStartIndex),
                                           static_cast<std::size_t>(count));
        return {std::as_bytes(part), static_cast<std::size_t>(graphicsBufferStartIndex) *
                                         sizeof(typename decltype(elements)::value_type)};
    }
    /// @throws ContractError as SetData does
    void Set(const Part& part);

    // These are for devices:

    /// A range of bytes that SetData has set.
    struct Change
    {
        std::uint64_t version = 0; ///< the version that they came with
        std::size_t offset = 0;    ///< offset in bytes()
        std::size_t size = 0;
    };
    /// Returns the changes, the oldest first; those that later ones cover are removed.
    const std::vector<Change>& changes() const { return m_Changes; }
    /// Returns a number that grows with each change.
    std::uint64_t version() const { return m_Version; }
    /// Returns the bytes that SetData has set so far, and 0 elsewhere; the counter, if there is
    /// one, is at counterOffset().
    std::span<const std::byte> bytes() const { return m_Bytes; }
    std::size_t counterOffset() const;
    bool hasCounter() const { return Has(Target::Append) || Has(Target::Counter); }

private:
    template <typename Data>
    static auto Elements(const Data& data)
    {
        const std::span elements(std::data(data), std::size(data));
        static_assert(std::is_trivially_copyable_v<typename decltype(elements)::value_type>);
        return elements;
    }
    static void ExpectPart(int from, int to, int count, std::size_t available);
    void Put(std::span<const std::byte> bytes, std::size_t offset);
    void GetBytes(GraphicsDevice& device, std::span<std::byte> bytes) const;

    std::uint64_t m_Id;
    std::string m_Name = "GraphicsBuffer";
    Target m_Target;
    int m_Count;
    int m_Stride;
    std::vector<std::byte> m_Bytes;
    std::vector<Change> m_Changes;
    std::uint64_t m_Version = 0;
    bool m_IsReleased = false;
};

template <>
inline constexpr bool k_IsFlags<GraphicsBuffer::Target> = true;

inline bool GraphicsBuffer::Has(Target flag) const
{
    return (static_cast<int>(m_Target) & static_cast<int>(flag)) != 0;
}

/// The kinds of a ComputeBuffer that limn has, with Unity's values.
/// Unity: UnityEngine.ComputeBufferType (2022.3).
enum class ComputeBufferType
{
    Default = 0, ///< Structured
    Raw = 1,
    Append = 2,
    Counter = 4,
    Constant = 8,
    Structured = 16,
    IndirectArguments = 256
};

/// A GraphicsBuffer for code that uses the older name. Unity: UnityEngine.ComputeBuffer (2022.3).
class ComputeBuffer final : public GraphicsBuffer
{
public:
    /// @throws ContractError as GraphicsBuffer does
    ComputeBuffer(int count, int stride, ComputeBufferType type = ComputeBufferType::Default);
};

/// A buffer as the value of a property: the whole of it, or a part of a cbuffer's.
struct BufferRange
{
    std::shared_ptr<const GraphicsBuffer> buffer; ///< null = none
    std::uint32_t offset = 0;                     ///< bytes
    std::uint32_t size = 0;                       ///< bytes; 0 = up to the end

    bool operator==(const BufferRange&) const = default;
};

} // namespace limn
