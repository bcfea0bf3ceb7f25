#pragma once

#include "unity/UnityTree.h"

#include <cstddef>
#include <string>
#include <vector>

namespace limn
{

/// Reads the numbers and bytes of an object that Unity saved as text. What is wrong throws
/// AssetError, which names the file and the line.
class UnityFields
{
public:
    /// @param fields  the map below the class's name
    /// @param file    the file's name in errors; it must outlive this object
    UnityFields(const UnityNode& fields, const std::string& file) : m_Fields(fields), m_File(file)
    {
    }

protected:
    [[noreturn]] void Fail(const UnityNode& node, const std::string& message) const;
    /// Reads a whole number from 0 to `most`; 0 if it is not there.
    std::size_t Number(const UnityNode& node, std::size_t most) const;
    /// Reads bytes of two hexadecimal digits each.
    std::vector<std::byte> Bytes(const UnityNode& node) const;

    const UnityNode m_Fields;

private:
    const std::string& m_File;
};

} // namespace limn
