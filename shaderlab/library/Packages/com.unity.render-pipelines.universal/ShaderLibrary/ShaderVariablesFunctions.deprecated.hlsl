// Names of earlier versions of the library.
#pragma once

uint GetMeshRenderingLightLayer() { return GetMeshRenderingLayer(); }
