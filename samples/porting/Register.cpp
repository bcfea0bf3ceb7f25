#include "blurred_glass/BlurredGlassFeature.h"
#include "blurred_glass/BlurredGlassUnity6Feature.h"
#include "distance_outline/DistanceOutlineFeature.h"
#include "distance_outline/DistanceOutlineUnity6Feature.h"
#include "height_fog/HeightFogFeature.h"
#include "height_fog/HeightFogUnity6Feature.h"
#include "ink_lines/InkLinesFeature.h"
#include "ink_lines/InkLinesUnity6Feature.h"
#include "selection_glow/SelectionGlowFeature.h"
#include "selection_glow/SelectionGlowUrp14Feature.h"
#include "xray/XRayFeature.h"
#include "xray/XRayUnity6Feature.h"

#include <limn/features/Features.h>
#include <limn/features/Plugin.h>

LIMN_PLUGIN(features, components)
{
    features.Register<porting::BlurredGlassFeature>("BlurredGlassFeature");
    features.Register<porting::BlurredGlassUnity6Feature>("BlurredGlassUnity6Feature");
    features.Register<porting::DistanceOutlineFeature>("DistanceOutlineFeature");
    features.Register<porting::DistanceOutlineUnity6Feature>("DistanceOutlineUnity6Feature");
    features.Register<porting::HeightFogFeature>("HeightFogFeature");
    features.Register<porting::HeightFogUnity6Feature>("HeightFogUnity6Feature");
    features.Register<porting::InkLinesFeature>("InkLinesFeature");
    features.Register<porting::InkLinesUnity6Feature>("InkLinesUnity6Feature");
    features.Register<porting::SelectionGlowFeature>("SelectionGlowFeature");
    features.Register<porting::SelectionGlowUrp14Feature>("SelectionGlowUrp14Feature");
    features.Register<porting::XRayFeature>("XRayFeature");
    features.Register<porting::XRayUnity6Feature>("XRayUnity6Feature");
    components.Register<porting::HeightFog>("HeightFog");
}
