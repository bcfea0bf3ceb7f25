#pragma once

#include <limn/shaderlab/PassProgram.h>
#include <limn/shaderlab/ShaderProgram.h>

#include "includes/IncludeResolver.h"
#include <limn/base/ByteStream.h>

#include <vector>

namespace limn
{

// Converts the data of the cache and of messages between processes to bytes, for this version of
// limn on this machine. Reading throws std::out_of_range if the bytes are invalid.

void Transfer(ByteWriter& stream, const ShaderProgram& program);
void Transfer(ByteReader& stream, ShaderProgram& program);

void Transfer(ByteWriter& stream, const PassProgram& program);
void Transfer(ByteReader& stream, PassProgram& program);

void Transfer(ByteWriter& stream, const std::vector<IncludeDependency>& dependencies);
void Transfer(ByteReader& stream, std::vector<IncludeDependency>& dependencies);

void Transfer(ByteWriter& stream, const FilesBeside& files);
void Transfer(ByteReader& stream, FilesBeside& files);

} // namespace limn
