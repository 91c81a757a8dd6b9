#include "app/common/device_triangulator.h"

#include <utility>

namespace app {

base::Result<DeviceTriangulator> DeviceTriangulator::open() {
    ASSIGN_OR_RETURN(HeadlessDevice device, HeadlessDevice::open());
    return DeviceTriangulator(std::move(device));
}

DeviceTriangulator::DeviceTriangulator(HeadlessDevice device)
    : m_device(std::move(device)), m_triangulator(std::make_unique<tri::gpu::Triangulator>(*m_device.device)) {}

}  // namespace app
