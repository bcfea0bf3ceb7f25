#pragma once
#error limn has no tessellation and needs a mesh with enough vertices
