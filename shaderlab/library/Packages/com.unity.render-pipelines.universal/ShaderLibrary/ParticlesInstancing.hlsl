// limn draws particles as meshes, never instanced from a buffer of particles.
#pragma once
#ifndef UNIVERSAL_PARTICLESINSTANCING_INCLUDED
#define UNIVERSAL_PARTICLESINSTANCING_INCLUDED

void ParticleInstancingSetup() {}
void vertInstancingSetup() {}
#endif
