/*
 * The plans that makeblock builds by. In all of them parts intersect, rest on
 * each other, nearly touch, and hang on small connecting pieces; hulls have
 * tessellated walls. A plan reaches the block's goals: 25 to 280 parts and
 * 2,500 to 6,000 triangles.
 */
#ifndef TESSERA_BLOCK_PLANS_H
#define TESSERA_BLOCK_PLANS_H

#include "block_parts.h"

/* A hall with a colonnade, a railing before it, and a gable roof. */
void plan_hall(struct block *block);
/* A house with balconies, inset windows, outer stairs and a parapet. */
void plan_terrace(struct block *block);
/* A round pavilion: columns of three pieces, beams, a cone with a finial. */
void plan_pavilion(struct block *block);
/* A tower with a curtain wall, floors that stick out, and a tank on legs. */
void plan_tower(struct block *block);

#endif
