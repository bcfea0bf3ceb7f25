#include "gltf/Accessor.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <tiny_gltf.h>

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

} // namespace

GltfFloats ReadGltfFloats(const tinygltf::Model& model, int accessor, int minComponents,
                          int maxComponents)
{
    const Elements elements = Locate(model, accessor);
    if (elements.components < minComponents || elements.components > maxComponents)
    {
        Fail(accessor,
             "each element has " + std::to_string(elements.components) + " numbers; " +
                 std::to_string(minComponents) +
                 (maxComponents > minComponents ? " to " + std::to_string(maxComponents) : "") +
                 " are expected here");
    }
    GltfFloats floats;
    floats.components = elements.components;
    floats.values.reserve(elements.count * static_cast<std::size_t>(elements.components));
    for (std::size_t i = 0; i < elements.count; ++i)
    {
        const unsigned char* element = elements.first + i * elements.stride;
        for (int c = 0; c < elements.components; ++c)
        {
            const std::size_t offset = static_cast<std::size_t>(c) * elements.componentSize;
            floats.values.push_back(LoadFloat(elements, element + offset, accessor));
        }
    }
    return floats;
}

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

} // namespace limn
