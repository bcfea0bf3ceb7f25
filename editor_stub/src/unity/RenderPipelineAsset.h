#pragma once

#include <limn/editor_stub/AssetContext.h>

namespace limn
{

/// The m_MSAA of a render pipeline asset as Unity saves it: 1, 2, 4 or 8 samples a pixel.
/// Unity: UnityEngine.Rendering.Universal.UniversalRenderPipelineAsset (URP 14).
/// @throws AssetError if the file is no such asset, or the number none of these
int LoadUnityMsaaSampleCount(const std::filesystem::path& path, AssetContext& assets);

} // namespace limn
