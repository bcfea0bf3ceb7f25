#include "gltf/Primitive.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <numeric>
#include <tiny_gltf.h>
#include <utility>

namespace limn
{

namespace
{

/// The place of an accessor's elements, each of which is inside its buffer.
struct Elements
{
    const unsigned char* first = nullptr;
    std::size_t count = 0;
    std::size_t stride = 0;
    int components = 0;
    int componentType = 0;
    std::size_t componentSize = 0;
    bool normalized = false;
};

template <typename T>
const T* At(const std::vector<T>& items, int index)
{
    return index >= 0 && static_cast<std::size_t>(index) < items.size()
               ? &items[static_cast<std::size_t>(index)]
               : nullptr;
}

[[noreturn]] void Fail(int accessor, const std::string& problem)
{
    throw GltfProblem("accessor " + std::to_string(accessor) + ": " + problem);
}

bool Fits(const Elements& elements, std::size_t available)
{
    const std::size_t size = elements.componentSize * static_cast<std::size_t>(elements.components);
    return elements.count == 0 ||
           (size <= available && elements.count - 1 <= (available - size) / elements.stride);
}

Elements Locate(const tinygltf::Model& model, int index)
{
    const tinygltf::Accessor* accessor = At(model.accessors, index);
    if (!accessor)
    {
        Fail(index, "does not exist; the file has " + std::to_string(model.accessors.size()));
    }
    const tinygltf::BufferView* view = At(model.bufferViews, accessor->bufferView);
    if (!view || accessor->sparse.isSparse)
    {
        Fail(index, "is sparse or names no buffer view, which limn does not read; export it dense");
    }
    const tinygltf::Buffer* buffer = At(model.buffers, view->buffer);
    const int stride = accessor->ByteStride(*view);
    if (!buffer || stride < 1)
    {
        Fail(index, "its buffer or its component type is invalid");
    }
    Elements elements;
    elements.count = accessor->count;
    elements.stride = static_cast<std::size_t>(stride);
    elements.componentType = accessor->componentType;
    elements.components =
        tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor->type));
    elements.componentSize = static_cast<std::size_t>(
        tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor->componentType)));
    elements.normalized = accessor->normalized;

    const std::size_t size = buffer->data.size();
    if (view->byteOffset > size || view->byteLength > size - view->byteOffset ||
        accessor->byteOffset > view->byteLength ||
        !Fits(elements, view->byteLength - accessor->byteOffset))
    {
        Fail(index, "its elements leave the buffer of " + std::to_string(size) + " bytes");
    }
    elements.first = buffer->data.data() + view->byteOffset + accessor->byteOffset;
    return elements;
}

template <typename T>
T Load(const unsigned char* bytes)
{
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
}

template <typename T>
float LoadInteger(const unsigned char* bytes, bool normalized)
{
    const auto value = static_cast<float>(Load<T>(bytes));
    const auto limit = static_cast<float>(std::numeric_limits<T>::max());
    return normalized ? std::max(value / limit, -1.0f) : value;
}

float LoadFloat(const Elements& elements, const unsigned char* bytes, int accessor)
{
    switch (elements.componentType)
    {
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return Load<float>(bytes);
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return LoadInteger<std::int8_t>(bytes, elements.normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return LoadInteger<std::uint8_t>(bytes, elements.normalized);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return LoadInteger<std::int16_t>(bytes, elements.normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return LoadInteger<std::uint16_t>(bytes, elements.normalized);
    default:
        Fail(accessor, "component type " + std::to_string(elements.componentType) +
                           " cannot be vertex data; 5120 to 5123 or 5126 (float) is expected");
    }
}

/// Returns the accessor's elements as vertex indices.
/// @throws GltfProblem as ReadAttribute, or if they are no unsigned integers
std::vector<std::uint32_t> ReadGltfIndices(const tinygltf::Model& model, int accessor)
{
    const Elements elements = Locate(model, accessor);
    std::vector<std::uint32_t> indices;
    indices.reserve(elements.count);
    for (std::size_t i = 0; i < elements.count; ++i)
    {
        const unsigned char* element = elements.first + i * elements.stride;
        switch (elements.componentType)
        {
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            indices.push_back(*element);
            break;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            indices.push_back(Load<std::uint16_t>(element));
            break;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            indices.push_back(Load<std::uint32_t>(element));
            break;
        default:
            Fail(accessor, "component type " + std::to_string(elements.componentType) +
                               " cannot be indices; 5121, 5123 or 5125 (unsigned) is expected");
        }
    }
    return indices;
}

/// Returns the attribute's elements as floats, missing components 1 (an RGB colour is opaque);
/// empty without it. Normalized integers become 0...1 or -1...1.
/// @throws GltfProblem if the accessor does not exist, leaves its buffer, is sparse, or its
///     elements have less than `minComponents` numbers or more than a Vector
template <typename Vector>
std::vector<Vector> ReadAttribute(const tinygltf::Model& model,
                                  const tinygltf::Primitive& primitive, const char* name,
                                  int minComponents)
{
    const auto found = primitive.attributes.find(name);
    if (found == primitive.attributes.end())
    {
        return {};
    }
    const Elements elements = Locate(model, found->second);
    constexpr int k_MostComponents = Vector::length();
    if (elements.components < minComponents || elements.components > k_MostComponents)
    {
        Fail(found->second,
             "each element has " + std::to_string(elements.components) + " numbers; " +
                 std::to_string(minComponents) +
                 (k_MostComponents > minComponents ? " to " + std::to_string(k_MostComponents)
                                                   : "") +
                 " are expected here");
    }
    std::vector<Vector> result(elements.count, Vector(1.0f));
    for (std::size_t i = 0; i < result.size(); ++i)
    {
        const unsigned char* element = elements.first + i * elements.stride;
        for (int c = 0; c < elements.components; ++c, element += elements.componentSize)
        {
            result[i][c] = LoadFloat(elements, element, found->second);
        }
    }
    return result;
}

std::vector<glm::vec2> ReadCoordinates(const tinygltf::Model& model,
                                       const tinygltf::Primitive& primitive, const char* name)
{
    auto coordinates = ReadAttribute<glm::vec2>(model, primitive, name, 2);
    for (glm::vec2& uv : coordinates)
    {
        uv.y = 1.0f - uv.y; // glTF counts v from the top of the picture, a mesh from the bottom
    }
    return coordinates;
}

/// The index list of a strip or fan written out as separate triangles, each as its first one is
/// oriented.
std::vector<std::uint32_t> ToTriangleList(const std::vector<std::uint32_t>& indices, int mode)
{
    if (mode == TINYGLTF_MODE_TRIANGLES)
    {
        return indices;
    }
    std::vector<std::uint32_t> list;
    for (std::size_t i = 0; i + 2 < indices.size(); ++i)
    {
        std::array<std::size_t, 3> corners = {i, i + 1, i + 2};
        if (mode == TINYGLTF_MODE_TRIANGLE_FAN)
        {
            corners = {i + 1, i + 2, 0};
        }
        else if (i % 2 == 1)
        {
            corners = {i, i + 2, i + 1};
        }
        for (const std::size_t corner : corners)
        {
            list.push_back(indices[corner]);
        }
    }
    return list;
}

std::vector<std::uint32_t> ReadTriangles(const tinygltf::Model& model,
                                         const tinygltf::Primitive& primitive,
                                         std::size_t vertexCount)
{
    std::vector<std::uint32_t> indices;
    if (primitive.indices >= 0)
    {
        indices = ReadGltfIndices(model, primitive.indices);
    }
    else
    {
        indices.resize(vertexCount);
        std::iota(indices.begin(), indices.end(), 0u);
    }
    for (const std::uint32_t index : indices)
    {
        if (index >= vertexCount)
        {
            throw GltfProblem("index " + std::to_string(index) + " is too large for " +
                              std::to_string(vertexCount) + " vertices");
        }
    }
    std::vector<std::uint32_t> triangles = ToTriangleList(indices, primitive.mode);
    if (triangles.size() % 3 != 0)
    {
        throw GltfProblem("it has " + std::to_string(triangles.size()) +
                          " indices; their number must be a multiple of three");
    }
    return triangles;
}

template <typename Vector>
std::vector<Vector> Gather(const std::vector<Vector>& array, const std::vector<std::uint32_t>& from)
{
    std::vector<Vector> result;
    for (const std::uint32_t index : from)
    {
        if (!array.empty())
        {
            result.push_back(array.at(index));
        }
    }
    return result;
}

/// A direction of unit length; up for one of no length, as of a triangle without area.
glm::vec3 Direction(const glm::dvec3& vector)
{
    const double length = glm::length(vector);
    return length > 0.0 ? glm::vec3(vector / length) : glm::vec3(0.0f, 1.0f, 0.0f);
}

/// Gives each triangle vertices of its own, so that each can have its own normal. Tangents that
/// came without normals mean nothing and go.
void MakeFlat(MeshData& part)
{
    part.vertices = Gather(part.vertices, part.triangles);
    part.colors = Gather(part.colors, part.triangles);
    part.uv = Gather(part.uv, part.triangles);
    part.uv2 = Gather(part.uv2, part.triangles);
    part.tangents.clear();
    std::iota(part.triangles.begin(), part.triangles.end(), 0u);
    for (std::size_t i = 0; i + 2 < part.vertices.size(); i += 3)
    {
        const glm::dvec3 a = part.vertices[i];
        const glm::dvec3 toB = glm::dvec3(part.vertices[i + 1]) - a;
        const glm::dvec3 toC = glm::dvec3(part.vertices[i + 2]) - a;
        part.normals.insert(part.normals.end(), 3, Direction(glm::cross(toB, toC)));
    }
}

void RequireLength(const char* name, std::size_t length, std::size_t vertexCount)
{
    if (length != 0 && length != vertexCount)
    {
        throw GltfProblem(std::string(name) + " has " + std::to_string(length) + " elements for " +
                          std::to_string(vertexCount) + " vertices");
    }
}

} // namespace

MeshData ReadGltfPrimitive(const tinygltf::Model& model, const tinygltf::Primitive& primitive)
{
    MeshData part;
    if (primitive.mode < TINYGLTF_MODE_TRIANGLES || primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN)
    {
        return part;
    }
    part.vertices = ReadAttribute<glm::vec3>(model, primitive, "POSITION", 3);
    part.normals = ReadAttribute<glm::vec3>(model, primitive, "NORMAL", 3);
    part.tangents = ReadAttribute<glm::vec4>(model, primitive, "TANGENT", 4);
    part.colors = ReadAttribute<glm::vec4>(model, primitive, "COLOR_0", 3);
    part.uv = ReadCoordinates(model, primitive, "TEXCOORD_0");
    for (const glm::vec2& uv : ReadCoordinates(model, primitive, "TEXCOORD_1"))
    {
        part.uv2.emplace_back(uv, 0.0f, 0.0f);
    }
    RequireLength("NORMAL", part.normals.size(), part.vertices.size());
    RequireLength("TANGENT", part.tangents.size(), part.vertices.size());
    RequireLength("COLOR_0", part.colors.size(), part.vertices.size());
    RequireLength("TEXCOORD_0", part.uv.size(), part.vertices.size());
    RequireLength("TEXCOORD_1", part.uv2.size(), part.vertices.size());
    part.triangles = ReadTriangles(model, primitive, part.vertices.size());
    if (part.normals.empty())
    {
        MakeFlat(part);
    }
    return part;
}

void TransformPart(MeshData& part, const glm::dmat4& matrix)
{
    const glm::dmat3 linear(matrix);
    const bool mirrors = glm::determinant(linear) < 0.0;
    const double sign = mirrors ? -1.0 : 1.0;
    // The cofactors are the inverse transpose up to a factor, and exist for a flattening matrix
    // too.
    const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                               glm::cross(linear[0], linear[1]));
    for (glm::vec3& vertex : part.vertices)
    {
        vertex = glm::vec3(matrix * glm::dvec4(glm::dvec3(vertex), 1.0));
    }
    for (glm::vec3& normal : part.normals)
    {
        normal = Direction(sign * (cofactors * glm::dvec3(normal)));
    }
    for (glm::vec4& tangent : part.tangents)
    {
        const glm::vec3 direction = Direction(linear * glm::dvec3(tangent));
        tangent = glm::vec4(direction, static_cast<float>(sign) * tangent.w);
    }
    for (std::size_t i = 0; mirrors && i + 2 < part.triangles.size(); i += 3)
    {
        std::swap(part.triangles[i + 1], part.triangles[i + 2]);
    }
}

} // namespace limn
