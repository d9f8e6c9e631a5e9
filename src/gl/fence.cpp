#include "gl/fence.h"

namespace havs {

Fence::Fence() : sync_(glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0)) { glFlush(); }

Fence::~Fence() { glDeleteSync(sync_); }

void Fence::wait() const { glClientWaitSync(sync_, GL_SYNC_FLUSH_COMMANDS_BIT, GL_TIMEOUT_IGNORED); }

}  // namespace havs
