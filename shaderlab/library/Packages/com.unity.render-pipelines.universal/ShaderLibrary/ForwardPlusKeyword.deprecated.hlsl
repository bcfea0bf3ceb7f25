// The keyword as Unity 6.1 calls it. No light is sorted into clusters either way.
#pragma once
#ifndef UNIVERSAL_FORWARD_PLUS_KEYWORD_DEPRECATED_INCLUDED
#define UNIVERSAL_FORWARD_PLUS_KEYWORD_DEPRECATED_INCLUDED

#if defined(_FORWARD_PLUS) && !defined(_CLUSTER_LIGHT_LOOP)
#define _CLUSTER_LIGHT_LOOP 1
#endif
#endif
