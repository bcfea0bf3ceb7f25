#pragma once

#include <limn/volume/AnimationCurveParameter.h>
#include <limn/volume/BoolParameter.h>
#include <limn/volume/ColorParameter.h>
#include <limn/volume/EnumParameter.h>
#include <limn/volume/FloatParameter.h>
#include <limn/volume/FloatRangeParameter.h>
#include <limn/volume/IntParameter.h>
#include <limn/volume/LayerMaskParameter.h>
#include <limn/volume/MaterialParameter.h>
#include <limn/volume/ObjectParameter.h>
#include <limn/volume/TextureCurveParameter.h>
#include <limn/volume/TextureParameter.h>
#include <limn/volume/VectorParameter.h>
