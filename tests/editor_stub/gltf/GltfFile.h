#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace limn::test
{

/// Puts together the text of a small glTF file whose only buffer is embedded.
class GltfFile
{
public:
    /// Each adds an accessor with a buffer view of its own and returns the accessor's number.
    int AddFloats(const std::string& type, const std::vector<float>& values)
    {
        return Add(type, 5126, values, values.size() / ComponentsOf(type), "");
    }

    template <typename T>
    int AddIntegers(const std::string& type, const std::vector<T>& values, bool normalized = false)
    {
        const int component = sizeof(T) == 1 ? 5121 : sizeof(T) == 2 ? 5123 : 5125;
        return Add(type, component, values, values.size() / ComponentsOf(type),
                   normalized ? R"(, "normalized": true)" : "");
    }

    template <typename T>
    int AddIndices(const std::vector<T>& values)
    {
        return AddIntegers("SCALAR", values);
    }

    /// @param rest  further members of the root object: meshes, nodes, scenes
    std::string Text(const std::string& rest) const
    {
        return Json(R"("uri": "data:application/octet-stream;base64,)" + Base64() + R"(", )", rest);
    }

    /// The same file in the binary container.
    std::string Binary(const std::string& rest) const
    {
        std::string json = Json("", rest);
        json.resize((json.size() + 3) / 4 * 4, ' ');
        std::string file = "glTF";
        file += Word(2) + Word(12 + 8 + json.size() + 8 + m_Bytes.size());
        file += Word(json.size()) + "JSON" + json;
        file += Word(m_Bytes.size()) + std::string("BIN\0", 4) + m_Bytes;
        return file;
    }

private:
    static std::size_t ComponentsOf(const std::string& type)
    {
        return type == "SCALAR" ? 1 : static_cast<std::size_t>(type.back() - '0');
    }

    static std::string Word(std::size_t value)
    {
        std::string bytes;
        for (int shift = 0; shift < 32; shift += 8)
        {
            bytes += static_cast<char>((value >> shift) & 0xFF);
        }
        return bytes;
    }

    template <typename T>
    int Add(const std::string& type, int component, const std::vector<T>& values, std::size_t count,
            const std::string& more)
    {
        const std::string number = std::to_string(m_Count);
        const std::size_t size = values.size() * sizeof(T);
        const std::string separator = m_Count == 0 ? "" : ", ";
        m_Views += separator + R"({"buffer": 0, "byteOffset": )" + std::to_string(m_Bytes.size()) +
                   R"(, "byteLength": )" + std::to_string(size) + "}";
        m_Accessors += separator + R"({"bufferView": )" + number + R"(, "componentType": )" +
                       std::to_string(component) + R"(, "count": )" + std::to_string(count) +
                       R"(, "type": ")" + type + '"' + more + "}";
        const std::size_t offset = m_Bytes.size();
        m_Bytes.resize((offset + size + 3) / 4 * 4);
        std::memcpy(m_Bytes.data() + offset, values.data(), size);
        return m_Count++;
    }

    std::string Json(const std::string& uri, const std::string& rest) const
    {
        return R"({"asset": {"version": "2.0"}, "buffers": [{)" + uri + R"("byteLength": )" +
               std::to_string(m_Bytes.size()) + R"(}], "bufferViews": [)" + m_Views +
               R"(], "accessors": [)" + m_Accessors + "], " + rest + "}";
    }

    std::string Base64() const
    {
        constexpr std::string_view digits =
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        std::string text;
        for (std::size_t i = 0; i < m_Bytes.size(); i += 3)
        {
            std::uint32_t group = 0;
            for (std::size_t k = 0; k < 3; ++k)
            {
                const std::size_t at = i + k;
                group = group << 8 |
                        (at < m_Bytes.size() ? static_cast<std::uint8_t>(m_Bytes[at]) : 0u);
            }
            for (std::size_t k = 0; k < 4; ++k)
            {
                const bool isPadding = i + k > m_Bytes.size();
                text += isPadding ? '=' : digits[group >> (18 - 6 * k) & 63];
            }
        }
        return text;
    }

    std::string m_Bytes;
    std::string m_Views;
    std::string m_Accessors;
    int m_Count = 0;
};

/// One mesh of one primitive, shown by one node that says `node` besides.
inline std::string OnePrimitive(const std::string& primitive, const std::string& node = "")
{
    return R"("meshes": [{"name": "shape", "primitives": [{)" + primitive +
           R"(}]}], "nodes": [{"mesh": 0)" + node + R"(}], "scenes": [{"nodes": [0]}], "scene": 0)";
}

} // namespace limn::test
