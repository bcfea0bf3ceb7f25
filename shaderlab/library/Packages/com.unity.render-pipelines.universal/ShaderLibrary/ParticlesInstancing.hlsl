// limn draws particles as meshes, never instanced from a buffer of particles.
#pragma once

void ParticleInstancingSetup() {}
void vertInstancingSetup() {}
