#pragma once

#include <limn/volume/AssetParameters.h>
#include <limn/volume/CurveParameters.h>
#include <limn/volume/NumberParameters.h>
#include <limn/volume/ValueParameters.h>
