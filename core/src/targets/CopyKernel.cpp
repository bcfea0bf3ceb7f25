#include "targets/RenderTargetResolver.h"

#include "record/RecordedCommands.h"
#include "resolve/DrawRecorder.h"

#include <algorithm>

namespace limn
{

namespace
{

constexpr std::uint32_t k_Threads = 64;       // of a group
constexpr std::uint32_t k_MostInARow = 65535; // in a row

constexpr const char* k_Text = R"(#pragma kernel CopyWords
ByteAddressBuffer _From;
RWByteAddressBuffer _To;
uint _FirstFrom; // words
uint _FirstTo;
uint _WordCount;
uint _RowLength; // threads

[numthreads(64, 1, 1)]
void CopyWords(uint3 id : SV_DispatchThreadID)
{
    uint word = id.y * _RowLength + id.x;
    if (word < _WordCount)
    {
        _To.Store((_FirstTo + word) * 4, _From.Load((_FirstFrom + word) * 4));
    }
}
)";

const ShaderPropertyId _From{"_From"};
const ShaderPropertyId _To{"_To"};
const ShaderPropertyId _FirstFrom{"_FirstFrom"};
const ShaderPropertyId _FirstTo{"_FirstTo"};
const ShaderPropertyId _WordCount{"_WordCount"};
const ShaderPropertyId _RowLength{"_RowLength"};

std::uint32_t DivideUp(std::uint32_t value, std::uint32_t by)
{
    return (value + by - 1) / by;
}

} // namespace

std::shared_ptr<const ComputeShader> MakeCopyKernel(std::shared_ptr<ShaderCompiler> compiler)
{
    return ComputeShader::FromText(k_Text, "CopyBuffer.compute", std::move(compiler));
}

void DrawRecorder::Copy(const CopyBufferCommand& command,
                        const std::shared_ptr<const ComputeShader>& kernel)
{
    const std::uint32_t groups = DivideUp(command.count, k_Threads);
    RecordedDispatch dispatch;
    dispatch.shader = kernel;
    dispatch.groups = {std::min(groups, k_MostInARow), DivideUp(groups, k_MostInARow), 1};
    m_CopyParams.SetBuffer(_From, command.source);
    m_CopyParams.SetBuffer(_To, command.dest);
    m_CopyParams.SetInt(_FirstFrom, static_cast<int>(command.from));
    m_CopyParams.SetInt(_FirstTo, static_cast<int>(command.to));
    m_CopyParams.SetInt(_WordCount, static_cast<int>(command.count));
    m_CopyParams.SetInt(_RowLength, static_cast<int>(dispatch.groups[0] * k_Threads));
    PropertySources sources{&m_CopyParams, nullptr, &m_Globals, kernel.get()};
    sources.isCopy = true;
    Dispatch(dispatch, sources);
    m_CopyParams.Clear(); // the buffers are not kept for longer than the frame has them
}

} // namespace limn
