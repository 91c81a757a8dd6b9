#include "app/device_triangulator.h"

#include <utility>

namespace app {

base::Result<DeviceTriangulator> DeviceTriangulator::open() {
    base::Result<render::gpu::Instance> instance = render::gpu::Instance::create({});
    if (!instance) {
        return instance.error();
    }
    base::Result<render::gpu::Device> device = render::gpu::Device::create(*instance);
    if (!device) {
        return device.error();
    }
    return DeviceTriangulator(std::move(*instance), std::move(*device));
}

DeviceTriangulator::DeviceTriangulator(render::gpu::Instance instance, render::gpu::Device device)
    : m_instance(std::make_unique<render::gpu::Instance>(std::move(instance))),
      m_device(std::make_unique<render::gpu::Device>(std::move(device))),
      m_triangulator(std::make_unique<tri::gpu::Triangulator>(*m_device)) {}

}  // namespace app
