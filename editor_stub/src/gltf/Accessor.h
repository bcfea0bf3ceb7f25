#pragma once

#include <cstdint>
#include <stdexcept>
#include <vector>

namespace tinygltf
{
class Model;
}

namespace limn
{

/// A part of a glTF file that cannot be used; the loader collects them into one AssetError.
class GltfProblem : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

/// Elements of equal size, one after the other.
struct GltfFloats
{
    int components = 0;
    std::vector<float> values;

    std::size_t count() const { return values.size() / static_cast<std::size_t>(components); }
};

/// Returns the accessor's elements as floats; normalized integers become 0...1 or -1...1.
/// @throws GltfProblem if the accessor does not exist, leaves its buffer, is sparse, or its
///     elements have less than `minComponents` or more than `maxComponents` numbers
GltfFloats ReadGltfFloats(const tinygltf::Model& model, int accessor, int minComponents,
                          int maxComponents);

/// Returns the accessor's elements as vertex indices.
/// @throws GltfProblem as above, or if they are no unsigned integers
std::vector<std::uint32_t> ReadGltfIndices(const tinygltf::Model& model, int accessor);

} // namespace limn
