#pragma once
// All the objects of OpenGL that the renderer is made of: move-only owners, named for debuggers.
#include "gl/buffer.h"
#include "gl/check.h"
#include "gl/framebuffer.h"
#include "gl/limits.h"
#include "gl/program.h"
#include "gl/program_cache.h"
#include "gl/texture.h"
#include "gl/vertex_array.h"
