// For #include_with_pragmas: the variant whose fragment function writes the rendering layers of what
// it draws as well.
#pragma once
#ifndef UNIVERSAL_RENDERING_LAYERS_INCLUDED
#define UNIVERSAL_RENDERING_LAYERS_INCLUDED

#pragma multi_compile_fragment _ _WRITE_RENDERING_LAYERS
#endif
