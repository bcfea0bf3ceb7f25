// Lights are looped over one after another; nothing sorts them into tiles.
#pragma once
#ifndef UNIVERSAL_CLUSTERING_INCLUDED
#define UNIVERSAL_CLUSTERING_INCLUDED

#ifndef USE_FORWARD_PLUS
#define USE_FORWARD_PLUS 0
#endif
#define USE_CLUSTER_LIGHT_LOOP 0
#define FORWARD_PLUS_SUBTRACTIVE_LIGHT_CHECK
#define CLUSTER_LIGHT_LOOP_SUBTRACTIVE_LIGHT_CHECK
#endif
