// Keywords of 2D lights, which limn does not have: none of these is on by itself.
#pragma once
#ifndef SHAPE_LIGHT_PRAGMAS
#define SHAPE_LIGHT_PRAGMAS

#pragma multi_compile __ USE_SHAPE_LIGHT_TYPE_0
#pragma multi_compile __ USE_SHAPE_LIGHT_TYPE_1
#pragma multi_compile __ USE_SHAPE_LIGHT_TYPE_2
#pragma multi_compile __ USE_SHAPE_LIGHT_TYPE_3
#endif
