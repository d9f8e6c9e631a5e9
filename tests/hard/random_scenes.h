#pragma once
// Random scenes: a mesh and its field, a transfer function, a camera, what is drawn of it, and by which method.
#include "hard/random_case.h"
#include "hard/random_dice.h"

namespace havs::test {

RandomCase randomCase(Dice& dice);

}  // namespace havs::test
