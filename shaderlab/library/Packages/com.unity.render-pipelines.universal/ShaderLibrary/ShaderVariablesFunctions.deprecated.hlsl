// Names of earlier versions of the library.
#pragma once

uint GetMeshRenderingLightLayer() { return GetMeshRenderingLayer(); }
// URP 12: all of the layers that a light can have.
#define RENDERING_LIGHT_LAYERS_MASK 0xFF
#define RENDERING_LIGHT_LAYERS_MASK_SHIFT 0
#define DEFAULT_LIGHT_LAYERS (RENDERING_LIGHT_LAYERS_MASK >> RENDERING_LIGHT_LAYERS_MASK_SHIFT)
