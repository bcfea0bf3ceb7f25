// No target of limn has regions of lower resolution: as in Unity without such a device, there is
// nothing here.
#pragma once
#ifndef UNITY_FOVEATED_RENDERING_INCLUDED
#define UNITY_FOVEATED_RENDERING_INCLUDED

#endif
