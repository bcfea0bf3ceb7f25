// For #include_with_pragmas: the variants of fog, by Unity 6's file.
#pragma once

#pragma multi_compile_fog
