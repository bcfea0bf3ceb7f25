#pragma once

#include "report/measure/StudyScene.h"
#include "report/measure/UntidyMesh.h"

#include <limn/core/PrimitiveMesh.h>

namespace limn::test
{

/// A black, outlined object of one kind of mesh, 100 pixels and more across, seen by a camera with
/// perspective. StrokeOutlineGpuTest.cpp has the same view of it.
inline SceneAsset UntidyScene(PrimitiveType type, study::Untidiness untidiness,
                              AssetContext& assets)
{
    SceneAsset asset = study::EmptyPicture(200, 190);
    asset.camera.orthographic = false;
    asset.camera.nearClipPlane = 0.1f;
    asset.camera.fieldOfView = 40.0f;
    asset.camera.transform.localPosition = {0.1f, -0.05f, -3.6f};
    const auto mesh = study::MakeUntidy(*CreatePrimitive(type), untidiness);
    for (int i = 0; i < (untidiness == study::Untidiness::TwoObjects ? 2 : 1); ++i)
    {
        study::AddOutlined(asset, "object", mesh, assets).transform.localRotation =
            EulerToRotation({25.0f, 31.0f, 8.0f});
    }
    return asset;
}

/// The same scene of the mesh that the kind looks like: the tidy one, but for the last two kinds,
/// which have another silhouette.
inline SceneAsset TidyScene(PrimitiveType type, study::Untidiness untidiness, AssetContext& assets)
{
    const bool looksTidy = untidiness < study::Untidiness::Open;
    return UntidyScene(type, looksTidy ? study::Untidiness::None : untidiness, assets);
}

} // namespace limn::test
