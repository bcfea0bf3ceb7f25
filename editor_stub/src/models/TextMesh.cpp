#include "models/TextMesh.h"

#include "unity/UnityFields.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <limits>
#include <map>
#include <span>

namespace limn
{

namespace
{

template <typename T>
T NumberAt(const std::byte* bytes)
{
    T value;
    std::memcpy(&value, bytes, sizeof(value));
    return value;
}

template <typename T>
float PlainAt(const std::byte* bytes)
{
    return static_cast<float>(NumberAt<T>(bytes));
}

template <typename T>
float NormalizedAt(const std::byte* bytes)
{
    return std::max(PlainAt<T>(bytes) / static_cast<float>(std::numeric_limits<T>::max()), -1.0f);
}

float HalfAt(const std::byte* bytes)
{
    return glm::unpackHalf1x16(NumberAt<std::uint16_t>(bytes));
}

/// The way in which a component of a vertex is saved.
struct VertexFormat
{
    std::size_t bytes;
    float (*read)(const std::byte* bytes);
};

/// Unity: UnityEngine.Rendering.VertexAttributeFormat (2022.3).
constexpr VertexFormat k_Formats[] = {
    {4, PlainAt<float>},
    {2, HalfAt},
    {1, NormalizedAt<std::uint8_t>},
    {1, NormalizedAt<std::int8_t>},
    {2, NormalizedAt<std::uint16_t>},
    {2, NormalizedAt<std::int16_t>},
    {1, PlainAt<std::uint8_t>},
    {1, PlainAt<std::int8_t>},
    {2, PlainAt<std::uint16_t>},
    {2, PlainAt<std::int16_t>},
    {4, PlainAt<std::uint32_t>},
    {4, PlainAt<std::int32_t>},
};

/// The place of the numbers of one array.
struct VertexChannel
{
    std::size_t stream = 0;
    std::size_t offset = 0;
    VertexFormat format = k_Formats[0];
    std::size_t components = 0; ///< 0 = the mesh has no such array
};

class TextMeshReader : public UnityFields
{
public:
    TextMeshReader(const UnityNode& fields, const std::string& file) : UnityFields(fields, file) {}

    SkinnableMesh Read()
    {
        RequireReadable();
        const UnityNode vertices = m_Fields["m_VertexData"];
        m_Count = Number(vertices["m_VertexCount"], k_MostVertices);
        m_Bytes = Bytes(vertices["_typelessdata"]);
        ReadChannels(vertices["m_Channels"]);
        MeshData data;
        ReadArrays(data);
        ReadTriangles(data);
        MeshSkin skin = ReadSkin();
        try
        {
            const std::string_view name = m_Fields["m_Name"].text();
            return {std::make_shared<const Mesh>(std::string(name), std::move(data)),
                    std::move(skin)};
        }
        catch (const ContractError& error)
        {
            Fail(m_Fields, error.what());
        }
    }

private:
    static constexpr std::size_t k_MostVertices = std::size_t{1} << 28;
    static constexpr std::size_t k_MostBytes = std::size_t{1} << 30;

    void RequireReadable() const
    {
        for (const UnityNode part : m_Fields["m_CompressedMesh"])
        {
            const std::string_view items = part["m_NumItems"].text();
            if (!items.empty() && items != "0")
            {
                Fail(part, "the mesh is compressed, which limn does not read; set Mesh Compression "
                           "to Off in Unity and save it again");
            }
        }
        if (!m_Fields["m_StreamData"]["path"].text().empty())
        {
            Fail(m_Fields["m_StreamData"],
                 "the mesh's data lie in another file, which limn does not read");
        }
    }

    void ReadChannels(const UnityNode& list)
    {
        for (const UnityNode item : list)
        {
            VertexChannel channel;
            channel.stream = Number(item["stream"], 3);
            channel.offset = Number(item["offset"], 255);
            channel.format = k_Formats[Number(item["format"], std::size(k_Formats) - 1)];
            channel.components = Number(item["dimension"], 255) & 15;
            if (channel.components > 4)
            {
                Fail(item, "a vertex channel has " + std::to_string(channel.components) +
                               " components; 0 to 4 are expected");
            }
            m_Channels.push_back(channel);
        }
        constexpr std::size_t k_Channels = 14;
        if (m_Channels.size() != k_Channels)
        {
            Fail(list, "the mesh has " + std::to_string(m_Channels.size()) +
                           " vertex channels; 14 are expected, as Unity 2018 and later save them");
        }
        for (const VertexChannel& channel : m_Channels)
        {
            const std::size_t end = channel.offset + channel.components * channel.format.bytes;
            std::size_t& stride = m_Strides[channel.stream];
            stride = channel.components > 0 ? std::max(stride, (end + 3) / 4 * 4) : stride;
        }
        std::size_t at = 0;
        for (auto& [stream, stride] : m_Strides)
        {
            at = (at + 15) / 16 * 16; // one begins where sixteen bytes do
            m_Starts[stream] = at;
            at += stride * m_Count;
        }
        if (at > m_Bytes.size())
        {
            Fail(m_Fields["m_VertexData"],
                 "the vertex data have " + std::to_string(m_Bytes.size()) + " bytes; " +
                     std::to_string(m_Count) + " vertices take " + std::to_string(at));
        }
    }

    /// Calls `add` with the components of each vertex; a component that is missing or no number is
    /// 0.
    template <typename Add>
    void ForEach(std::size_t index, const Add& add) const
    {
        const VertexChannel& channel = m_Channels[index];
        if (channel.components == 0 || m_Count == 0)
        {
            return;
        }
        const std::size_t stride = m_Strides.at(channel.stream);
        const std::byte* vertex = m_Bytes.data() + m_Starts.at(channel.stream) + channel.offset;
        for (std::size_t i = 0; i < m_Count; ++i, vertex += stride)
        {
            glm::vec4 value(0.0f);
            for (std::size_t c = 0; c < channel.components; ++c)
            {
                const float number = channel.format.read(vertex + c * channel.format.bytes);
                // Only a place must be a number. ProBuilder saves tangents that are none.
                value[static_cast<int>(c)] =
                    index == k_Positions || std::isfinite(number) ? number : 0.0f;
            }
            add(value);
        }
    }

    void ReadArrays(MeshData& data) const
    {
        std::size_t channel = k_Positions;
        const auto read = [&](auto& values)
        {
            ForEach(channel++, [&](const glm::vec4& value) { values.emplace_back(value); });
        };
        const auto readAll = [&](auto&... arrays)
        {
            (read(arrays), ...);
        };
        readAll(data.vertices, data.normals, data.tangents, data.colors, data.uv, data.uv2,
                data.uv3, data.uv4, data.uv5, data.uv6, data.uv7);
    }

    void ReadTriangles(MeshData& data) const
    {
        const std::vector<std::byte> bytes = Bytes(m_Fields["m_IndexBuffer"]);
        const std::size_t width = m_Fields["m_IndexFormat"].text() == "1" ? 4 : 2;
        for (const UnityNode item : m_Fields["m_SubMeshes"])
        {
            const std::size_t first = Number(item["firstByte"], k_MostBytes);
            const std::size_t count = Number(item["indexCount"], k_MostBytes);
            const std::size_t base = Number(item["baseVertex"], k_MostVertices);
            const std::size_t topology = Number(item["topology"], 5);
            if (first > bytes.size() || count > (bytes.size() - first) / width)
            {
                Fail(item, "a sub-mesh has " + std::to_string(count) + " indices from byte " +
                               std::to_string(first) + " on; the index buffer has " +
                               std::to_string(bytes.size()) + " bytes");
            }
            const auto add = [&](std::size_t i)
            {
                const std::byte* index = bytes.data() + first + i * width;
                const std::size_t vertex =
                    base + (width == 4 ? NumberAt<std::uint32_t>(index)
                                       : std::size_t{NumberAt<std::uint16_t>(index)});
                data.triangles.push_back(static_cast<std::uint32_t>(
                    std::min<std::size_t>(vertex, std::numeric_limits<std::uint32_t>::max())));
            };
            const auto start = static_cast<std::uint32_t>(data.triangles.size());
            AddTriangles(topology, count, add);
            data.subMeshes.push_back(
                {start, static_cast<std::uint32_t>(data.triangles.size()) - start});
            if (data.triangles.size() > k_MostBytes)
            {
                Fail(item, "the sub-meshes have more indices than limn takes");
            }
        }
    }

    template <typename Add>
    static void AddTriangles(std::size_t topology, std::size_t count, const Add& add)
    {
        constexpr std::size_t k_Triangles = 0;
        constexpr std::size_t k_Quads = 2;
        constexpr std::size_t k_Corners[] = {0, 1, 2, 0, 2, 3}; // a triangle has the first three
        const std::size_t corners = topology == k_Triangles ? 3 : topology == k_Quads ? 4 : 0;
        for (std::size_t i = 0; corners > 0 && i + corners <= count; i += corners)
        {
            for (const std::size_t corner : std::span(k_Corners).first(corners == 4 ? 6 : 3))
            {
                add(i + corner);
            }
        }
    }

    MeshSkin ReadSkin() const
    {
        MeshSkin skin;
        for (const UnityNode pose : m_Fields["m_BindPose"])
        {
            skin.bindPoses.push_back(Matrix(pose));
        }
        if (skin.bindPoses.empty() || m_Channels[k_Bones].components == 0)
        {
            return {};
        }
        skin.weights.resize(m_Count);
        // A mesh whose vertices follow one bone each has no weights.
        const bool isWeighted = m_Channels[k_Weights].components > 0;
        std::size_t vertex = 0;
        ForEach(k_Weights,
                [&](const glm::vec4& value)
                {
                    for (int i = 0; i < 4; ++i)
                    {
                        skin.weights[vertex][static_cast<std::size_t>(i)].weight = value[i];
                    }
                    ++vertex;
                });
        vertex = 0;
        ForEach(k_Bones,
                [&](const glm::vec4& value)
                {
                    BoneWeights& weights = skin.weights[vertex++];
                    weights[0].weight = isWeighted ? weights[0].weight : 1.0f;
                    for (int i = 0; i < 4; ++i)
                    {
                        weights[static_cast<std::size_t>(i)].bone = Bone(value[i], skin);
                    }
                    Normalize(weights);
                });
        return skin;
    }

    std::uint32_t Bone(float number, const MeshSkin& skin) const
    {
        if (!(number >= 0.0f && number < static_cast<float>(skin.bindPoses.size())))
        {
            Fail(m_Fields["m_BindPose"],
                 "a vertex follows bone " +
                     std::to_string(std::lround(std::clamp(number, -1.0f, 1e9f))) +
                     "; the mesh has " + std::to_string(skin.bindPoses.size()) + " bind poses");
        }
        return static_cast<std::uint32_t>(number);
    }

    glm::mat4 Matrix(const UnityNode& node) const
    {
        glm::mat4 matrix(1.0f);
        for (int row = 0; row < 4; ++row)
        {
            for (int column = 0; column < 4; ++column)
            {
                const std::string key = "e" + std::to_string(row) + std::to_string(column);
                float& value = matrix[column][row];
                value = NumberOf(node[key], std::numeric_limits<float>::quiet_NaN());
                if (!std::isfinite(value))
                {
                    Fail(node, "a bind pose has no number " + key);
                }
            }
        }
        return matrix;
    }

    static constexpr std::size_t k_Positions = 0; ///< the channel
    static constexpr std::size_t k_Weights = 12;
    static constexpr std::size_t k_Bones = 13;
    std::size_t m_Count = 0; ///< of vertices
    std::vector<std::byte> m_Bytes;
    std::vector<VertexChannel> m_Channels;
    std::map<std::size_t, std::size_t> m_Strides; ///< bytes of a vertex, by stream
    std::map<std::size_t, std::size_t> m_Starts;  ///< of the streams
};

} // namespace

SkinnableMesh ReadTextMesh(const UnityNode& fields, const std::string& file)
{
    return TextMeshReader(fields, file).Read();
}

} // namespace limn
