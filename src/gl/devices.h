#pragma once
// The makers that the table of devices (device.cpp) is made of; each in a file of its own.
#include <memory>

#include "gl/device.h"

namespace havs {

std::unique_ptr<Device> makeOsmesaDevice();
std::unique_ptr<Device> makeEglDevice();
std::unique_ptr<Device> makeGlfwDevice();

}  // namespace havs
