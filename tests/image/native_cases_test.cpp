#include "image/native_scene.h"
